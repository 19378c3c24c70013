//! Thickness and thickening by segment, from values per vertex however they were found.

use super::{Level, Segment};

/// Mean thickness of a segment or level at end-diastole and end-systole.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GroupThickening {
    /// At end-diastole, in the unit of the values.
    pub end_diastole: f64,
    /// At end-systole.
    pub end_systole: f64,
}

impl GroupThickening {
    /// (ES − ED) / ED in percent; `None` where there is no thickness at end-diastole.
    pub fn percent(self) -> Option<f64> {
        let share = (self.end_systole - self.end_diastole) / self.end_diastole;
        // Of no thickness at end-diastole a percentage says nothing.
        share.is_finite().then_some(100.0 * share)
    }
}

/// Thickness of each segment at end-diastole and end-systole: means weighted by the areas at
/// end-diastole over the vertices whose thickness is known at both, so that a part that one phase does not
/// tell makes no thickening. `None` for a segment without such vertices.
///
/// Thickening of a segment is that of its means, not the mean of its vertices' thickenings, in which
/// thin places would weigh more.
pub fn segment_thickening(
    segments: &[Option<Segment>],
    weights: &[f64],
    end_diastole: &[Option<f64>],
    end_systole: &[Option<f64>],
) -> [Option<GroupThickening>; Segment::COUNT] {
    let [ed, es] = known_at_both(end_diastole, end_systole);
    paired(
        super::segment_means(segments, weights, &ed),
        super::segment_means(segments, weights, &es),
    )
}

/// [`segment_thickening`] of levels, for subjects whose orientation is not known.
pub fn level_thickening(
    levels: &[Option<Level>],
    weights: &[f64],
    end_diastole: &[Option<f64>],
    end_systole: &[Option<f64>],
) -> [Option<GroupThickening>; Level::ALL.len()] {
    let [ed, es] = known_at_both(end_diastole, end_systole);
    paired(
        super::level_means(levels, weights, &ed),
        super::level_means(levels, weights, &es),
    )
}

/// Values of both phases where both are known, not a number elsewhere.
fn known_at_both(ed: &[Option<f64>], es: &[Option<f64>]) -> [Vec<f64>; 2] {
    let finite = |value: Option<f64>| value.filter(|value| value.is_finite());
    let (ed, es) = (ed.iter().zip(es))
        .map(|(&ed, &es)| match (finite(ed), finite(es)) {
            (Some(ed), Some(es)) => (ed, es),
            // Means leave out what is not a number, so both phases average the same vertices.
            _ => (f64::NAN, f64::NAN),
        })
        .unzip();
    [ed, es]
}

fn paired<const N: usize>(
    ed: [Option<f64>; N],
    es: [Option<f64>; N],
) -> [Option<GroupThickening>; N] {
    std::array::from_fn(|group| {
        Some(GroupThickening {
            end_diastole: ed[group]?,
            end_systole: es[group]?,
        })
    })
}

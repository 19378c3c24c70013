//! The words of the deformation map, and how well it fits.

use crate::analysis::deformations::DeformationMap;
use crate::engine::{DeformationMapQuery, Topic};
use crate::panes::scatter_map::{MapWords, play_command};

/// The words of the map.
pub static DEFORMATION_MAP: MapWords = MapWords {
    job: Topic::of::<DeformationMapQuery>(),
    name: "Deformation map",
    item: "Deformation",
    empty: "No deformations",
    what: "Every subject is one point here; subjects that deform alike lie near each other, whatever their shape unless \
           that is compared, too.",
    none: "The deformation map could not be computed",
    hints: &["Click to play this subject"],
    command: play_command,
};

/// What the map keeps of the deformations, and how well.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DeformationFit {
    /// Size of the neighbourhoods that the map keeps.
    pub neighbours: Option<usize>,
    /// How far points are from what their neighbours say of them; no unit.
    pub reconstruction_error: Option<f64>,
    /// Kruskal's stress where the map is one of the distances by stress majorisation; no unit.
    pub stress: Option<f64>,
    /// How much of the map's unit one cycle counts for.
    pub time_weight: Option<f64>,
}

impl DeformationFit {
    /// That of a map.
    pub fn of(map: &DeformationMap) -> Self {
        let embedding = &map.embedding;
        Self {
            neighbours: embedding.neighbours,
            reconstruction_error: embedding.reconstruction_error,
            stress: embedding.stress,
            time_weight: map.time_weight,
        }
    }
}

/// What the choices of the header mean.
pub(super) const COMPARISONS: &str = "Deformation: motion relative to the own end-diastole, transported onto the mean shape. \
                           Shape: the end-diastolic pose, size normalised. Both: squared distances, each over its median. \
                           Curves of poses: poses with their shape, as on the pose map.";

/// What the note of the header means.
pub(super) const EXPLANATION: &str = "Locally linear embedding: the motion of every subject is reconstructed \
                           from its neighbours, and is embedded where these reconstructions fit \
                           best. Error: reconstruction error relative to the variance of the \
                           motions. Where neighbourhoods fall into separate parts, the map is one of the distances \
                           themselves, by stress majorisation, and has a stress instead. Time, where curves of poses are compared, has this weight, in units of \
                           the pose map per cycle.";

/// "neighbours 8", "reconstruction error 0.012", "time × 1.4", as far as they are known; "SMACOF", "stress 0.12" where the map
/// is one of distances.
pub(super) fn fit_parts(fit: &DeformationFit, [neighbours, error]: [&str; 2]) -> Vec<String> {
    let [neighbours, error] = match fit.stress {
        Some(stress) => [
            Some("SMACOF".to_owned()),
            Some(format!("stress {}", significant(stress))),
        ],
        None => [
            fit.neighbours.map(|count| format!("{neighbours} {count}")),
            (fit.reconstruction_error).map(|value| format!("{error} {}", significant(value))),
        ],
    };
    let time = fit.time_weight;
    let time = time.map(|weight| format!("time × {}", significant(weight)));
    [neighbours, error, time].into_iter().flatten().collect()
}

/// Two figures: what an error or a weight deserves; one where it is very small.
fn significant(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let first_digit = -value.abs().log10().floor() as i32;
    if first_digit > 5 {
        return "< 0.00001".to_owned();
    }
    let digits = first_digit + i32::from(first_digit < 3);
    format!("{value:.*}", digits.max(0) as usize)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_two_figures() {
        assert_eq!(significant(0.01234), "0.012");
        assert_eq!(significant(1.416), "1.4");
        assert_eq!(significant(23.4), "23");
        assert_eq!(significant(0.0), "0");
        assert_eq!(significant(8.7e-5), "0.00009");
        assert_eq!(significant(1.2e-7), "< 0.00001");
    }
}

//! The pose map of the medial shape space: paths of one subject after the other, then their map.

use crate::analysis::embedding::MapMethod;
use crate::analysis::medial_map::{MedialMap, SubjectPaths, medial_map, subject_paths};
use crate::analysis::thickening::ThickeningSettings;
use crate::engine::queries::pose_map::method_words;
use crate::engine::queries::thickening::WallThickeningQuery;
use crate::engine::store::{Answered, Context, Interrupted, Memory, Query};
use crate::progress::Stopped;
use crate::report::thickening_words;

/// Share of the map's time that the walls take; the rest is scaling.
const WALLS_SHARE: f32 = 0.97;

/// Settings of the map, from the surfaces on.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MedialMapQuery {
    /// How walls are assessed, and what is akinetic.
    pub thickening: ThickeningSettings,
    /// How distances become a map.
    pub method: MapMethod,
}

/// Per subject of a study, its paths in the medial shape space, or why it has none.
pub type StudyPaths = Vec<Result<SubjectPaths, String>>;

/// The paths of all subjects in the medial shape space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MedialPathsQuery {
    /// How walls are assessed, and what is akinetic.
    pub thickening: ThickeningSettings,
}

impl Query for MedialPathsQuery {
    type Answer = StudyPaths;
    const TITLE: &'static str = "Paths of akinetic regions";

    fn parameters(&self) -> String {
        thickening_words(&self.thickening)
    }

    /// A subject whose wall cannot be assessed is no error.
    fn run(&self, cx: &Context<'_>) -> Result<StudyPaths, Interrupted> {
        let count = cx.study().subjects.len();
        let paths = (0..count)
            .map(|subject| {
                let [from, to] = [subject, subject + 1].map(|done| done as f32 / count as f32);
                let part = cx.part("assessing walls", from, to);
                let settings = self.thickening;
                paths_of(&part.get(&WallThickeningQuery { subject, settings }))
            })
            .collect::<Result<_, Stopped>>()?;
        Ok(paths)
    }

    fn memory(paths: &StudyPaths, memory: &mut Memory) {
        memory.own(paths_bytes(paths));
    }

    fn replaces(&self, _: &Self) -> bool {
        true
    }
}

/// The paths that the answer about one wall holds. What is measured in a wall that is not resolved would be blur or noise.
///
/// # Errors
/// If that was stopped.
pub fn paths_of(
    answer: &Answered<WallThickeningQuery>,
) -> Result<Result<SubjectPaths, String>, Stopped> {
    match answer {
        Ok(wall) => {
            if let Some(reason) = &wall.not_assessed {
                return Ok(Err(reason.to_string()));
            }
            let paths = subject_paths(&wall.beat, &wall.thickening, wall.axis.as_ref());
            Ok(paths.map_err(|reason| reason.to_string()))
        }
        Err(Interrupted::Stopped) => Err(Stopped),
        Err(Interrupted::Failed(failure)) => Ok(Err(failure.to_string())),
    }
}

impl Query for MedialMapQuery {
    type Answer = MedialMap;
    const TITLE: &'static str = "Medial map";

    fn parameters(&self) -> String {
        let walls = thickening_words(&self.thickening);
        format!("{walls}; {}", method_words(self.method))
    }

    fn run(&self, cx: &Context<'_>) -> Result<MedialMap, Interrupted> {
        let paths = MedialPathsQuery {
            thickening: self.thickening,
        };
        // Another method of mapping finds the paths known.
        let (paths, share) = cx.first("assessing walls", &paths, WALLS_SHARE)?;
        let part = cx.part("embedding poses", share, 1.0);
        Ok(medial_map(&paths, self.method, part.progress())?)
    }

    fn memory(map: &MedialMap, memory: &mut Memory) {
        memory.own(map_bytes(map));
    }

    fn replaces(&self, _: &Self) -> bool {
        true
    }
}

/// Memory that paths hold.
fn paths_bytes(paths: &StudyPaths) -> usize {
    let of_subject = |paths: &Result<SubjectPaths, String>| match paths {
        Ok(paths) => paths
            .paths
            .iter()
            .map(|path| size_of_val(&*path.steps))
            .sum(),
        Err(reason) => reason.len(),
    };
    size_of_val(&**paths) + paths.iter().map(of_subject).sum::<usize>()
}

/// Memory that a map holds.
fn map_bytes(map: &MedialMap) -> usize {
    size_of_val(&*map.poses)
        + size_of_val(map.distances.upper())
        + size_of_val(&*map.embedding.coordinates)
        + size_of_val(&*map.spreads)
}

#[cfg(test)]
mod tests;

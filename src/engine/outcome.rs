//! What comes back from a question to a study: shared plain results.

use std::sync::Arc;

use crate::analysis::classification::Classes;
use crate::analysis::deformations::DeformationMap;
use crate::analysis::geodesics::GeodesicPath;
use crate::analysis::measures::SubjectMeasures;
use crate::analysis::medial::MedialBeat;
use crate::analysis::medial_map::MedialMap;
use crate::analysis::pose_distances::PoseDistances;
use crate::analysis::verdicts::Verdicts;
use crate::engine::medial_map::{StudyPaths, map_bytes, paths_bytes};
use crate::engine::request::PoseMap;
use crate::engine::thickening::SubjectThickening;
use crate::engine::thickness::FrameThickness;
use crate::mesh::Point3;
use crate::study::MeshSequence;

/// One answer; results are shared, never changed.
#[derive(Clone, Debug)]
pub enum AnalysisOutcome {
    /// One per subject of the study.
    Measures(Arc<Vec<SubjectMeasures>>),
    /// Distances of all poses.
    PoseDistances(Arc<PoseDistances>),
    /// The map of all poses.
    PoseMap(Arc<PoseMap>),
    /// The map of whole deformations.
    DeformationMap(Arc<DeformationMap>),
    /// What is said of classes; rows are those of the map of deformations.
    Classes(Arc<Classes>),
    /// One path per interval of the beat; see [`AnalysisRequest::InBetweens`](super::AnalysisRequest::InBetweens).
    InBetweens(Arc<Vec<Arc<GeodesicPath>>>),
    /// The path of one interval.
    Interval(Arc<GeodesicPath>),
    /// The beat of one heart on another, in the coordinates of the other.
    Transfer(Arc<MeshSequence>),
    /// Share of each face in the squared distance, surfaces one after the other.
    Contribution(Arc<Vec<f64>>),
    /// The middle of one heart's wall over the beat.
    MedialBeat(Arc<MedialBeat>),
    /// How one heart's wall thickens.
    Thickening(Arc<SubjectThickening>),
    /// What is said of all hearts of the study.
    Verdicts(Arc<Verdicts>),
    /// The paths of all hearts in the medial shape space.
    MedialPaths(Arc<StudyPaths>),
    /// The map of them.
    MedialMap(Arc<MedialMap>),
    /// Thickness of one wall at a frame in all ways of measuring it.
    FrameThickness(Arc<FrameThickness>),
}

impl AnalysisOutcome {
    /// Memory that it holds, near enough to bound a cache by it, without atoms that other answers share.
    pub fn bytes(&self) -> usize {
        let matrix = |distances: &PoseDistances| {
            size_of_val(distances.distances.upper()) + size_of_val(&*distances.poses)
        };
        match self {
            Self::Measures(subjects) => subjects
                .iter()
                .map(|subject| size_of_val(subject) + size_of_val(&*subject.frames))
                .sum(),
            Self::PoseDistances(distances) => matrix(distances),
            // Its distances are usually kept under their own key too; counting them twice
            // only makes the bound stricter.
            Self::PoseMap(map) => matrix(&map.distances) + size_of_val(&*map.embedding.coordinates),
            Self::DeformationMap(map) => {
                let curves: usize = map.curves.iter().map(|curve| size_of_val(&**curve)).sum();
                curves + size_of_val(&*map.embedding.coordinates)
            }
            Self::Classes(classes) => {
                size_of_val(&*classes.of_row) + size_of_val(&*classes.clustering.clusters)
            }
            Self::InBetweens(paths) => paths.iter().map(|path| path_bytes(path)).sum(),
            Self::Interval(path) => path_bytes(path),
            Self::Transfer(sequence) => {
                sequence.frame_count() * sequence.vertex_count() * size_of::<Point3>()
            }
            Self::Contribution(shares) => size_of_val(&***shares),
            Self::MedialBeat(_) => 0,
            Self::Thickening(found) => found.own_bytes(),
            Self::Verdicts(found) => size_of_val(&*found.subjects),
            Self::MedialPaths(paths) => paths_bytes(paths),
            Self::MedialMap(map) => map_bytes(map),
            Self::FrameThickness(found) => size_of_val(&*found.answers),
        }
    }

    /// The atoms that it holds; answers with other settings of thickening hold the same.
    pub(super) fn shared_beat(&self) -> Option<&Arc<MedialBeat>> {
        match self {
            Self::MedialBeat(beat) => Some(beat),
            Self::Thickening(found) => Some(&found.beat),
            _ => None,
        }
    }

    /// The measures, if that is what it is.
    pub fn measures(&self) -> Option<&Arc<Vec<SubjectMeasures>>> {
        match self {
            Self::Measures(measures) => Some(measures),
            _ => None,
        }
    }

    /// The distances, if that is what it is.
    pub fn pose_distances(&self) -> Option<&Arc<PoseDistances>> {
        match self {
            Self::PoseDistances(distances) => Some(distances),
            _ => None,
        }
    }

    /// The map, if that is what it is.
    pub fn pose_map(&self) -> Option<&Arc<PoseMap>> {
        match self {
            Self::PoseMap(map) => Some(map),
            _ => None,
        }
    }

    /// The map of deformations, if that is what it is.
    pub fn deformation_map(&self) -> Option<&Arc<DeformationMap>> {
        match self {
            Self::DeformationMap(map) => Some(map),
            _ => None,
        }
    }

    /// What is said of classes, if that is what it is.
    pub fn classes(&self) -> Option<&Arc<Classes>> {
        match self {
            Self::Classes(classes) => Some(classes),
            _ => None,
        }
    }

    /// The paths of a beat, if that is what it is.
    pub fn in_betweens(&self) -> Option<&Arc<Vec<Arc<GeodesicPath>>>> {
        match self {
            Self::InBetweens(paths) => Some(paths),
            _ => None,
        }
    }

    /// The path of one interval, if that is what it is.
    pub fn interval(&self) -> Option<&Arc<GeodesicPath>> {
        match self {
            Self::Interval(path) => Some(path),
            _ => None,
        }
    }

    /// The transferred beat, if that is what it is.
    pub fn transfer(&self) -> Option<&Arc<MeshSequence>> {
        match self {
            Self::Transfer(sequence) => Some(sequence),
            _ => None,
        }
    }

    /// The shares of faces, if that is what it is.
    pub fn contribution(&self) -> Option<&Arc<Vec<f64>>> {
        match self {
            Self::Contribution(shares) => Some(shares),
            _ => None,
        }
    }

    /// The atoms over the beat, if that is what it is.
    pub fn medial_beat(&self) -> Option<&Arc<MedialBeat>> {
        match self {
            Self::MedialBeat(beat) => Some(beat),
            _ => None,
        }
    }

    /// The verdicts, if that is what it is.
    pub fn verdicts(&self) -> Option<&Arc<Verdicts>> {
        match self {
            Self::Verdicts(found) => Some(found),
            _ => None,
        }
    }

    /// The paths of all hearts, if that is what it is.
    pub fn medial_paths(&self) -> Option<&Arc<StudyPaths>> {
        match self {
            Self::MedialPaths(paths) => Some(paths),
            _ => None,
        }
    }

    /// The medial map, if that is what it is.
    pub fn medial_map(&self) -> Option<&Arc<MedialMap>> {
        match self {
            Self::MedialMap(map) => Some(map),
            _ => None,
        }
    }

    /// Thickness in all ways, if that is what it is.
    pub fn frame_thickness(&self) -> Option<&Arc<FrameThickness>> {
        match self {
            Self::FrameThickness(found) => Some(found),
            _ => None,
        }
    }

    /// The thickening of a heart, if that is what it is.
    pub fn thickening(&self) -> Option<&Arc<SubjectThickening>> {
        match self {
            Self::Thickening(found) => Some(found),
            _ => None,
        }
    }
}

fn path_bytes(path: &GeodesicPath) -> usize {
    path.poses.iter().map(|pose| size_of_val(&**pose)).sum()
}

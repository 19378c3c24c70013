//! Stops: no answer, no failure, nothing kept.

use super::*;
use crate::analysis::classification::ClassifyError;
use crate::analysis::deformations::DeformationMapError;
use crate::analysis::embedding::EmbeddingError;
use crate::analysis::experiments::ExperimentError;
use crate::analysis::medial::MedialError;
use crate::analysis::medial_map::MedialMapError;
use crate::analysis::pose_distances::{PairError, PoseDistanceError};
use crate::analysis::thickening::ThickeningError;
use crate::analysis::thickness_methods::ThicknessError;
use crate::analysis::transport::TransportError;
use crate::analysis::verdicts::VerdictError;
use crate::progress::Stopped;

#[test]
fn no_question_is_answered_once_stopped_and_nothing_is_kept() {
    let (study, store) = (study(), store());
    assert!(is_stopped(&store, &study, &MeasuresQuery));
    assert!(is_stopped(&store, &study, &map(MapMethod::Smacof)));
    assert!(is_stopped(&store, &study, &DeformationMapQuery::default()));
    assert!(is_stopped(&store, &study, &classes()));
    assert!(is_stopped(&store, &study, &interpolated_poses()));
    assert!(is_stopped(&store, &study, &interval(0)));
    assert!(is_stopped(&store, &study, &transfer()));
    assert!(is_stopped(&store, &study, &contribution()));
    assert_eq!(store.answers::<PoseDistancesQuery>(), 0);
}

#[test]
fn a_stopped_path_is_no_answer() {
    let (study, store) = (study(), store());
    let endless = IntervalQuery {
        subject: 1,
        interval: 0,
        params: GeodesicParams {
            interpolated_poses: 127,
            tolerance: 0.0,
            max_iterations: u32::MAX,
            ..GeodesicParams::default()
        },
    };
    let progress = Progress::default();
    std::thread::scope(|scope| {
        let work = scope.spawn(|| store.answer(&study, &endless, &progress));
        while progress.phase().is_empty() {
            std::thread::yield_now();
        }
        std::thread::sleep(std::time::Duration::from_millis(50));
        progress.stop();
        assert!(matches!(work.join().unwrap(), Err(Interrupted::Stopped)));
    });
    while store.busy() {
        std::thread::yield_now();
    }
    assert_eq!(store.answers::<IntervalQuery>(), 0);
}

#[test]
fn a_stop_is_a_stop_however_an_analysis_wraps_it() {
    let stops: [Interrupted; 14] = [
        Stopped.into(),
        ClassifyError::Stopped(Stopped).into(),
        DeformationMapError::Stopped(Stopped).into(),
        EmbeddingError::Stopped(Stopped).into(),
        ExperimentError::Stopped(Stopped).into(),
        MedialError::Stopped(Stopped).into(),
        MedialMapError::Stopped(Stopped).into(),
        PairError::Stopped(Stopped).into(),
        PoseDistanceError::Stopped(Stopped).into(),
        ThickeningError::Stopped(Stopped).into(),
        ThicknessError::Stopped(Stopped).into(),
        TransportError::Stopped(Stopped).into(),
        VerdictError::Stopped(Stopped).into(),
        ClassifyError::Embedding(EmbeddingError::Stopped(Stopped)).into(),
    ];
    for stop in stops {
        assert!(matches!(stop, Interrupted::Stopped), "{stop:?}");
    }
    let failure = Interrupted::from(EmbeddingError::Neighbours {
        neighbours: 3,
        items: 2,
    });
    let Interrupted::Failed(error) = failure else {
        panic!("it failed");
    };
    assert!(error.is::<EmbeddingError>());
}

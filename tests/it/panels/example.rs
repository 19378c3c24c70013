//! A cohort made up for pictures and layouts: ids, labels and numbers that look like a study's.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use cardiomorph::analysis::deformations::{Comparison, DeformationMapParams};
use cardiomorph::document::State;
use cardiomorph::engine::PoseMapQuery;
use cardiomorph::mesh::phantom;
use cardiomorph::panes::*;
use cardiomorph::picture::Quantity;
use cardiomorph::study::{LabelClass, MeshSequence, Study, Subject, SurfaceKind, SurfaceSequence};
use cardiomorph::ui::LabelMark;
use cardiomorph::units::LengthUnit;

/// What panels show.
pub struct Example {
    pub rows: Vec<CohortRow>,
    pub points: Vec<ScatterPoint>,
    pub deformations: Vec<ScatterPoint>,
    pub classifiers: Vec<ClassifierView>,
    pub volumes: Vec<f64>,
    pub outer: Vec<f64>,
    pub shares: Vec<f64>,
    pub state: State,
}

impl Example {
    pub fn new() -> Self {
        let groups = [
            ("NOR", LabelClass::Normal, 9, 0.62),
            ("MINF", LabelClass::Abnormal, 8, 0.36),
            ("DCM", LabelClass::Abnormal, 4, 0.22),
            ("RV", LabelClass::Neither, 2, 0.55),
        ];
        let (mut rows, mut points) = (Vec::new(), Vec::new());
        for (label, class, count, ef) in groups {
            for _ in 0..count {
                let subject = rows.len();
                let wobble = (subject as f64 * 2.399).sin();
                let ejection_fraction = Some(ef + 0.06 * wobble);
                rows.push(CohortRow {
                    id: format!("P-{:03}", 41 + subject),
                    label: Some(label.to_owned()),
                    class,
                    mark: match label {
                        "NOR" => LabelMark::Normal,
                        "DCM" => LabelMark::Label(0),
                        "MINF" => LabelMark::Label(1),
                        _ => LabelMark::Label(2),
                    },
                    ejection_fraction,
                    verdict: Some(verdict(label, wobble)),
                    frame_count: 8,
                    warning_count: usize::from(subject == 5),
                    correspondence: 0,
                    excluded: false,
                    place: 0,
                    filtered_out: false,
                });
                for frame in 0..8 {
                    let turn = (1.0 - (TAU * frame as f64 / 8.0).cos()) / 2.0;
                    let aside = (TAU * frame as f64 / 8.0).sin() * 0.16;
                    let start = [wobble, 0.8 * (subject as f64 * 1.7).cos()];
                    let phase = PosePhase::of(frame, (Some(0), Some(4)));
                    points.push(ScatterPoint {
                        subject,
                        frames: Some([frame, frame]),
                        start_frame: frame,
                        share: frame as f64 / 8.0,
                        at: [
                            start[0] + ef * 4.0 * turn + aside * wobble,
                            start[1] + ef * 2.0 * turn * (0.4 + 0.5 * wobble) + aside,
                        ],
                        phase,
                        label: match phase {
                            PosePhase::EndDiastole => Some("ED"),
                            PosePhase::EndSystole => Some("ES"),
                            _ => None,
                        },
                        ..ScatterPoint::default()
                    });
                }
            }
        }
        let deformations = deformations(&rows);
        let shares: Vec<f64> = (0..8).map(|frame| frame as f64 / 8.0).collect();
        let volumes = shares
            .iter()
            .map(|s| 104.0 - 38.0 * (PI * s).sin().powi(2))
            .collect();
        let outer = shares
            .iter()
            .map(|s| 196.0 - 34.0 * (PI * s).sin().powi(2))
            .collect();
        Self {
            rows,
            points,
            deformations,
            classifiers: classifiers(),
            volumes,
            outer,
            shares,
            state: state(),
        }
    }

    fn scatter<'a>(
        &'a self,
        words: &'static MapWords,
        points: &'a [ScatterPoint],
        state: WorkState,
    ) -> ScatterView<'a> {
        ScatterView {
            state,
            selected: Some(9),
            ..ScatterView::new(words, &self.rows, points)
        }
    }

    pub fn deformation_map(&self, state: WorkState) -> DeformationMapView<'_> {
        DeformationMapView {
            map: ScatterView {
                compared: Some(2),
                shows_clusters: true,
                ..self.scatter(&DEFORMATION_MAP, &self.deformations, state)
            },
            comparison: Comparison::default(),
            fit: DeformationFit {
                neighbours: Some(5),
                reconstruction_error: Some(0.0123),
                stress: None,
                time_weight: Some(1.42),
            },
            classes: ClassesView::Ready(&self.classifiers),
            classes_by: None,
        }
    }

    pub fn space_time(&self, state: WorkState) -> ScatterView<'_> {
        ScatterView {
            compared: Some(2),
            ..self.scatter(&SPACE_TIME, &self.points, state)
        }
    }

    pub fn actions(&self) -> ActionState<'_> {
        ActionState {
            state: &self.state,
            hidden_panes: Vec::new(),
        }
    }

    pub fn metric(&self) -> MetricPanelView<'_> {
        MetricPanelView {
            poses: PoseMapQuery::default(),
            deformations: DeformationMapParams::default(),
            shares: None,
            subjects: &self.rows,
            selected: Some(9),
            neighbours: Some(5),
            time_weight: Some(1.42),
        }
    }

    pub fn axis(&self) -> CycleAxis {
        CycleAxis {
            frame_shares: self.shares.clone(),
        }
    }

    pub fn map(&self, state: WorkState) -> ScatterView<'_> {
        let part = |axis: usize| {
            let (from, to) = (&self.points[9 * 8 + 2], &self.points[9 * 8 + 3]);
            from.at[axis] + 0.4 * (to.at[axis] - from.at[axis])
        };
        let [note, explanation] = pose_map_note(Some(0.083), None);
        ScatterView {
            current: vec![[part(0), part(1)]],
            note,
            explanation,
            ..self.scatter(&POSE_MAP, &self.points, state)
        }
    }
}

/// A study of one subject with both surfaces, after a first change.
fn state() -> State {
    let surface = |kind, radius| SurfaceSequence::new(kind, vec![phantom::sphere(1, radius)]);
    let surfaces = [
        (SurfaceKind::Endocardium, 25.0),
        (SurfaceKind::Epicardium, 34.0),
    ];
    let surfaces = surfaces.map(|(kind, radius)| surface(kind, radius).unwrap());
    let sequence = MeshSequence::new(surfaces.to_vec()).unwrap();
    let subject = Subject::new("P-041", sequence, LengthUnit::Millimetre);
    let study = Study {
        name: "A study with quite a long name, as folders often have".to_owned(),
        subjects: vec![Arc::new(subject)],
        ..Study::default()
    };
    let mut state = State::default();
    state.show_study(Arc::new(study), Default::default());
    let before = state.document.clone();
    state.history.record(before, None, false, 0.0);
    state.document.quantity = Quantity::AreaRatio;
    state
}

/// What a study's hearts of that label are usually found to have.
fn verdict(label: &str, wobble: f64) -> CohortVerdict {
    let (mark, share, probability) = match label {
        "NOR" => (VerdictMark::NoAbnormality, None, 0.05 + 0.04 * wobble),
        "MINF" => (VerdictMark::Patch, Some(0.28 + 0.2 * wobble), 0.97),
        "DCM" => (VerdictMark::GlobalHypokinesia, None, 0.93),
        _ => (VerdictMark::NotAssessed, None, 0.0),
    };
    CohortVerdict {
        mark,
        share,
        probability: (mark != VerdictMark::NotAssessed).then_some(probability),
        words: String::new(),
    }
}

/// One point per heart, normal ones apart from the others but for two.
fn deformations(subjects: &[CohortRow]) -> Vec<ScatterPoint> {
    let places: Vec<[f64; 2]> = (0..subjects.len())
        .map(|subject| {
            let turn = subject as f64 * 2.399;
            let reach = 0.25 + 0.35 * ((subject * 7 % 11) as f64 / 11.0);
            let aside = match subjects[subject].class {
                LabelClass::Normal if subject != 4 => -0.9,
                LabelClass::Neither => 0.0,
                _ => 0.7,
            };
            [aside + reach * turn.cos(), 0.8 * reach * turn.sin()]
        })
        .collect();
    let apart =
        |a: usize, b: usize| (places[a][0] - places[b][0]).hypot(places[a][1] - places[b][1]);
    (0..subjects.len())
        .map(|subject| {
            let mut nearest: Vec<usize> = (0..subjects.len()).filter(|o| *o != subject).collect();
            nearest.sort_by(|a, b| apart(subject, *a).total_cmp(&apart(subject, *b)));
            nearest.truncate(3);
            ScatterPoint {
                subject,
                at: places[subject],
                phase: PosePhase::WholeMotion,
                label: Some(""),
                cluster: Some(usize::from(places[subject][0] > -0.2)),
                nearest,
                ..ScatterPoint::default()
            }
        })
        .collect()
}

fn classifiers() -> Vec<ClassifierView> {
    [
        ("Nearest neighbour", 20, 12.4, 0.002),
        ("Linear classifier", 19, 12.1, 0.006),
        ("Classifier on 2-D embedding", 18, 12.2, 0.013),
        ("Cluster agreement τ", 21, 13.8, 0.0004),
    ]
    .into_iter()
    .map(
        |(name, correct, permutation_mean, p_value)| ClassifierView {
            name,
            what: "",
            correct,
            of: 21,
            permutation_mean,
            p_value,
        },
    )
    .collect()
}

//! Known answers on a cohort of hemispheres whose thickness is a function.

use std::sync::Arc;

use crate::analysis::measures::{PhaseSource, SubjectMeasures};
use crate::analysis::medial::{Atom, MedialBeat, MedialSurface};
use crate::analysis::thickening::{AKINETIC_PT, Thickening, ThickeningParams, thickening};
use crate::mesh::{Point3, Vector3, phantom};
use crate::progress::Progress;
use crate::study::{MeshSequence, Study, Subject, SurfaceKind, SurfaceSequence};
use crate::units::LengthUnit;

use super::*;

mod copies;
mod damage;
mod rules;

/// Share of its thickening that the wall has at each of four poses; end-systole is pose 2.
const CURVE: [f64; 4] = [0.0, 0.6, 1.0, 0.3];

type Heart = (MedialBeat, Thickening);

/// A hemisphere, pole at −z, of a wall 8 thick whose ln r grows by what `grows` says of each direction, and
/// that shrinks as much as keeps the volume of a wall that thickens by `shrinks` everywhere.
fn heart(grows: impl Fn(&Vector3) -> f64, shrinks: f64) -> Heart {
    let bowl = phantom::bowl(30.0, 14, 28);
    let directions: Vec<Vector3> = (bowl.vertices().iter())
        .map(|point| point.coords.normalize())
        .collect();
    let frames = (CURVE.iter())
        .map(|&c| MedialSurface {
            atoms: (directions.iter())
                .map(|d| Atom {
                    position: Point3::from(d * 30.0 * (-0.5 * c * shrinks).exp()),
                    radius: 4.0 * (c * grows(d)).exp(),
                    spokes: [-d, *d],
                })
                .collect(),
            normals: directions.clone(),
            end: vec![None; directions.len()],
        })
        .collect();
    let rim = bowl.faces().boundary_vertices();
    measured(MedialBeat {
        surface: SurfaceKind::Endocardium,
        vertices: (0..directions.len() as u32).collect(),
        faces: Arc::clone(bowl.faces()),
        frames,
        regular: rim.iter().map(|rim| !rim).collect(),
    })
}

fn measured(beat: MedialBeat) -> Heart {
    let measures = SubjectMeasures {
        unit: LengthUnit::Millimetre,
        frames: Vec::new(),
        end_diastole: Some(0),
        end_systole: Some(2),
        phase_source: PhaseSource::Stated,
        edv: None,
        esv: None,
        sv: None,
        ef: None,
        mass: None,
        notes: Vec::new(),
    };
    let params = ThickeningParams::default().check().unwrap();
    let found = thickening(&beat, &measures, None, &params, &Progress::default()).unwrap();
    (beat, found)
}

/// A wall that thickens everywhere, subjects differing a little.
fn healthy(number: u32) -> Heart {
    let amount = 0.42 + 0.011 * f64::from(number);
    heart(move |d| amount * (1.0 + 0.08 * d.x), amount)
}

/// Angle from the middle of a patch to its border.
fn radius_rad(number: u32) -> f64 {
    0.55 + 0.05 * f64::from(number % 5)
}

/// The same with a part that does not, of different sizes in different places.
fn ill(number: u32) -> Heart {
    let amount = 0.42 + 0.013 * f64::from(number);
    let angle = f64::from(number);
    let centre = Vector3::new(0.8 * angle.cos(), 0.8 * angle.sin(), -0.6);
    let limit = radius_rad(number).cos();
    let grows = move |d: &Vector3| {
        if d.dot(&centre) > limit {
            0.0
        } else {
            amount * (1.0 + 0.08 * d.x)
        }
    };
    heart(grows, 0.8 * amount)
}

/// A wall of which nothing thickens.
fn failing() -> Heart {
    heart(|d| 0.04 * (1.0 + 0.1 * d.y), 0.0)
}

fn study(labels: &[Option<&str>]) -> Study {
    let subject = |(index, label): (usize, &Option<&str>)| {
        // Meshes of its own: the same ones would be one subject listed often.
        let ball = phantom::sphere(1, 30.0 + index as f64);
        let surface = SurfaceSequence::new(SurfaceKind::Cavity, vec![ball]).unwrap();
        let sequence = MeshSequence::new(vec![surface]).unwrap();
        let mut subject = Subject::new(format!("H{index}"), sequence, LengthUnit::Millimetre);
        subject.label = label.map(str::to_owned);
        Arc::new(subject)
    };
    Study {
        subjects: labels.iter().enumerate().map(subject).collect(),
        ..Study::default()
    }
}

fn classified(hearts: &[Heart], labels: &[Option<&str>]) -> Verdicts {
    let hearts: Vec<_> = hearts.iter().map(input).collect();
    let params = VerdictParams {
        permutations: 19,
        ..VerdictParams::default()
    };
    let params = params.check().unwrap();
    verdicts(&study(labels), &hearts, &params, None, &Progress::default()).unwrap()
}

fn input((beat, thickening): &Heart) -> Result<Examined, NotAssessed> {
    let params = VerdictParams::default().check().unwrap();
    examine(&VerdictInput { beat, thickening }, &params)
}

/// Seven healthy subjects, seven with a patch, and without labels one of each and one that fails as a whole.
fn cohort() -> (Vec<Heart>, Vec<Option<&'static str>>) {
    let mut hearts: Vec<Heart> = (0..7).map(healthy).chain((0..7).map(ill)).collect();
    hearts.extend([healthy(9), ill(9), failing()]);
    let mut labels = [vec![Some("normal"); 7], vec![Some("abnormal"); 7]].concat();
    labels.extend([None; 3]);
    (hearts, labels)
}

fn assessed(verdicts: &Verdicts, subject: usize) -> &Verdict {
    verdicts.subjects[subject].as_ref().unwrap()
}

#[test]
fn subjects_with_a_patch_are_classified_with_and_without_labels() {
    let (hearts, labels) = cohort();
    let found = classified(&hearts, &labels);
    assert_eq!(
        found.classifier,
        ClassifierSource::Cohort {
            normal: 7,
            abnormal: 7
        }
    );
    let findings: Vec<Finding> = (0..17).map(|i| assessed(&found, i).finding).collect();
    assert_eq!(findings[..7], [Finding::Nothing; 7]);
    assert_eq!(findings[7..14], [Finding::AbnormalPatch; 7]);
    assert_eq!(
        findings[14..],
        [
            Finding::Nothing,
            Finding::AbnormalPatch,
            Finding::GlobalHypokinesia
        ]
    );
    let quality = found.quality.unwrap();
    assert_eq!((quality.accuracy.correct, quality.accuracy.of), (14, 14));
    assert_eq!(
        (
            quality.false_positives,
            quality.false_negatives,
            quality.auc
        ),
        (0, 0, 1.0)
    );
    assert!(quality.accuracy.baseline < 0.7 && quality.auc_baseline < 0.7);
    assert!(quality.accuracy.p_value <= 0.1 && quality.auc_p_value <= 0.1);
    for index in 0..14 {
        let verdict = assessed(&found, index);
        // Seven of each do not make it certain.
        assert!(verdict.probability > 1e-3 && verdict.probability < 1.0);
        assert_eq!(
            (verdict.similar_normal.len(), verdict.similar_abnormal.len()),
            (3, 3)
        );
        assert!(
            !verdict.similar_normal.contains(&index) && !verdict.similar_abnormal.contains(&index)
        );
        assert!(verdict.similar_normal.iter().all(|&other| other < 7));
        assert!(
            verdict
                .similar_abnormal
                .iter()
                .all(|other| (7..14).contains(other))
        );
    }
}

#[test]
fn features_are_what_was_built_in() {
    let (hearts, labels) = cohort();
    let found = classified(&hearts, &labels);
    let of = |subject: usize, feature| assessed(&found, subject).features.get(feature).unwrap();
    assert_eq!(of(0, Feature::AkineticShare), 0.0);
    assert!((of(0, Feature::Median) - 0.42).abs() < 0.01);
    assert_eq!(
        (of(0, Feature::Compactness), of(0, Feature::PatchThickening)),
        (0.0, 1.0)
    );
    // A cap of angle a is 1 − cos a of the hemisphere; averaging takes its rim away.
    let cap = 1.0 - radius_rad(4).cos();
    assert!(of(11, Feature::AkineticShare) < cap && of(11, Feature::AkineticShare) > 0.6 * cap);
    assert!(of(11, Feature::Compactness) > 0.7 && of(11, Feature::Confidence) == 1.0);
    assert!(of(11, Feature::NormalSpread) < 0.1 && of(11, Feature::MeanPoseDistance) < 0.2);
    let reach = of(11, Feature::Remote) + 2.0 * of(11, Feature::Spread);
    assert_eq!(of(11, Feature::UpperRange), reach);
}

/// A wall between balls, whose cavity ejects as its thickening says.
fn wall(subject: &mut Arc<Subject>, index: usize) {
    let ejected = match index {
        16 => 0.02,
        7..=13 | 15 => 0.14,
        _ => 0.27,
    };
    let surface = |kind, radius: f64, kept: f64| {
        let radius = radius + 0.01 * index as f64;
        let poses = [radius, radius * kept].map(|radius| phantom::sphere(2, radius));
        SurfaceSequence::new(kind, poses.into()).unwrap()
    };
    let sequence = MeshSequence::new(vec![
        surface(SurfaceKind::Endocardium, 30.0, 1.0 - ejected),
        surface(SurfaceKind::Epicardium, 38.0, 1.0 - 0.5 * ejected),
    ]);
    Arc::make_mut(subject).sequence = sequence.unwrap();
}

#[test]
fn the_akinetic_share_is_of_what_thickens_by_less_than_ten_percent() {
    let shares = [0.9, 1.1].map(|factor| {
        let (beat, thickening) = heart(|_| factor * AKINETIC_PT.ln(), 0.0);
        let heart = VerdictInput {
            beat: &beat,
            thickening: &thickening,
        };
        Features::new(&heart).get(Feature::AkineticShare)
    });
    assert_eq!(shares, [Some(1.0), Some(0.0)]);
    assert!((AKINETIC_PT - 1.1).abs() < 1e-15);
    let default = ThickeningParams::default();
    assert_eq!(default.akinetic_threshold, AKINETIC_PT.ln());
    assert_eq!(default.min_thickening, AKINETIC_PT.ln());
}

#[test]
fn without_enough_labels_the_built_in_rule_speaks_and_says_so() {
    let (hearts, mut labels) = cohort();
    let inputs: Vec<_> = hearts.iter().map(input).collect();
    for (case, labelled) in [
        ("one class", [7, 0]),
        ("no label", [0, 0]),
        ("too few", [1, 7]),
    ] {
        match case {
            "one class" => labels[7..14].fill(None),
            "no label" => labels.fill(None),
            _ => {
                labels[0] = Some("normal");
                labels[7..14].fill(Some("abnormal"));
            }
        }
        let mut study = study(&labels);
        for (index, subject) in study.subjects.iter_mut().enumerate() {
            wall(subject, index);
        }
        let params = VerdictParams::default().check().unwrap();
        let found = verdicts(&study, &inputs, &params, None, &Progress::default()).unwrap();
        let ClassifierSource::OtherStudy(rule) = &found.classifier else {
            panic!("{case}: {:?}", found.classifier);
        };
        assert_eq!((rule.labelled, found.quality), (Some(labelled), None));
        for index in 0..17 {
            let expected = match index {
                0..7 | 14 => Finding::Nothing,
                16 => Finding::GlobalHypokinesia,
                _ => Finding::AbnormalPatch,
            };
            assert_eq!(assessed(&found, index).finding, expected, "{case}: {index}");
        }
    }
}

#[test]
fn a_heart_unlike_any_that_was_seen_is_said_to_be_so() {
    let (hearts, labels) = cohort();
    let found = classified(&hearts, &labels);
    let [near, far] = [14, 16].map(|index| assessed(&found, index).training_set_distance.unwrap());
    assert!(
        far.distance > 2.0 * near.distance && far.median == near.median,
        "{near:?} {far:?}"
    );
    assert_eq!(far.as_far, 0.0);
}

#[test]
fn labels_that_have_nothing_to_do_with_the_hearts_give_a_useless_classifier() {
    let hearts: Vec<Heart> = (0..12).map(healthy).collect();
    // Neither more nor less thickening than the others, nor more or less spread.
    let labels = [0, 1, 1, 0, 1, 0, 0, 1, 0, 1, 1, 0].map(|i| Some(["normal", "abnormal"][i]));
    let quality = classified(&hearts, &labels).quality.unwrap();
    assert!(quality.accuracy.p_value > 0.05, "{quality:?}");
    assert!((quality.accuracy.share() - quality.accuracy.baseline).abs() < 0.35);
}

#[test]
fn equal_hearts_are_neither_normal_nor_abnormal() {
    let hearts = vec![healthy(0); 10];
    let labels: Vec<_> = (0..10)
        .map(|i| Some(["normal", "abnormal"][i % 2]))
        .collect();
    let found = classified(&hearts, &labels);
    for index in 0..10 {
        let p = assessed(&found, index).probability;
        assert!((p - 0.5).abs() < 0.2, "{p}");
    }
}

#[test]
fn what_cannot_be_told_is_not_assessed_and_takes_no_part() {
    let (mut hearts, labels) = cohort();
    // A wall that shrinks without thickening has lost half of its volume.
    hearts[3] = heart(|_| 0.02, 0.7);
    let mut rough = healthy(1).0;
    for (index, frame) in rough.frames.iter_mut().enumerate() {
        for (atom, place) in frame.atoms.iter_mut().zip(1..) {
            let x = 2.0
                * (f64::from(place + 7919 * index as u32) * 0.754_877_666_246_692_8).fract()
                - 1.0;
            atom.radius *= (3.0 * x).exp();
        }
    }
    hearts[8] = measured(rough);
    let mut inputs: Vec<_> = hearts.iter().map(input).collect();
    inputs[0] = Err(NotAssessed::NoThickening("no wall".to_owned()));
    let params = VerdictParams {
        permutations: 3,
        ..VerdictParams::default()
    };
    let params = params.check().unwrap();
    let found = verdicts(
        &study(&labels),
        &inputs,
        &params,
        None,
        &Progress::default(),
    )
    .unwrap();
    assert_eq!(
        found.subjects[0],
        Err(NotAssessed::NoThickening("no wall".to_owned()))
    );
    let lost = found.subjects[3].as_ref().unwrap_err();
    assert!(matches!(lost, NotAssessed::WallNotResolved { share } if (0.4..0.6).contains(share)));
    assert!(
        lost.to_string()
            .starts_with("the wall is not resolved: at end-systole it has 5")
    );
    let noisy = found.subjects[8].as_ref().unwrap_err();
    assert!(
        matches!(
            noisy,
            NotAssessed::Noise { .. } | NotAssessed::WallNotResolved { .. }
        ),
        "{noisy}"
    );
    assert_eq!(
        found.classifier,
        ClassifierSource::Cohort {
            normal: 5,
            abnormal: 6
        }
    );
    let nearest_rows = &assessed(&found, 1).similar_normal;
    assert!(!nearest_rows.contains(&0) && !nearest_rows.contains(&3));
}

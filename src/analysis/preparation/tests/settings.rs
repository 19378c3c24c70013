//! Settings in files, and what is asked for.

use std::sync::Arc;

use super::phantom::{counts, labels};
use crate::analysis::preparation::*;
use crate::analysis::walls_from_masks::MaskLabels;
use crate::image::{Contour, ContourPart, Modality, VolumeEdit};
use crate::mesh::{Point3, Vector3};

fn full() -> Preparation {
    let mut full = Preparation::of_road(Road::Masks(MaskLabels {
        cavity: 5,
        wall: 7,
        right: None,
    }));
    full.spacing_mm = Some([1.5, 1.5, 8.0]);
    full.times = Some(TypedTimes::Each(vec![0.0, 100.0]));
    full.threshold = Some(0.4);
    full.edits = vec![
        VolumeEdit::CutPlane {
            point: Point3::new(1.0, 2.0, 3.0),
            normal: Vector3::z(),
        },
        VolumeEdit::LargestComponent,
    ];
    full.points.apex = Some(Point3::new(-1.0, 0.5, 0.1));
    full.contours = Arc::new(vec![Contour {
        instant: 1,
        part: ContourPart::Epicardium,
        points: vec![
            Point3::origin(),
            Point3::new(1.0, 0.0, 0.0),
            Point3::new(0.0, 1.0, 0.0),
        ],
    }]);
    full.base = BaseEnd::Closed;
    full.correct_shifts = false;
    full
}

#[test]
fn settings_survive_a_file() {
    for settings in [
        full(),
        Preparation::of_road(Road::Spect),
        Preparation::default(),
    ] {
        let text = serde_json::to_string(&settings).unwrap();
        assert_eq!(
            serde_json::from_str::<Preparation>(&text).unwrap(),
            settings,
            "{text}"
        );
    }
}

#[test]
fn a_misspelt_name_or_a_setting_out_of_range_is_refused() {
    let read = |text: &str| serde_json::from_str::<Preparation>(text).map_err(|e| e.to_string());
    assert_eq!(
        read(r#"{"road": "spect"}"#),
        Ok(Preparation::of_road(Road::Spect))
    );
    for (text, reason) in [
        (r#"{"road": "spekt"}"#, "unknown variant"),
        (r#"{"road": "spect", "blurr_mm": 1}"#, "unknown field"),
        (r#"{"road": "spect", "blur_mm": -1}"#, "blur of -1 mm"),
        (r#"{"road": "spect", "threshold": 1.5}"#, "between 0 and 1"),
        (
            r#"{"road": "spect", "spacing_mm": [1, 1, 0]}"#,
            "distance 0 mm",
        ),
        (r#"{"road": "spect", "cycle_ms": 5}"#, "beat of 5 ms"),
        (r#"{"road": "spect", "times_ms": [5, 5]}"#, "increasing"),
        (
            r#"{"road": "spect", "times_ms": [0], "cycle_ms": 800}"#,
            "exclude",
        ),
        (
            r#"{"road": "spect", "labels": {"cavity": 1, "wall": 2}}"#,
            "masks alone",
        ),
        (r#"{"road": "masks", "vertices": 3}"#, "3 vertices"),
        (
            r#"{"road": "contours", "contours": [{"instant": 0, "part": "endocardium", "points": [[0, 0, 0]]}]}"#,
            "fewer than three corners",
        ),
    ] {
        let error = read(text).unwrap_err();
        assert!(error.contains(reason), "{text}: {error}");
    }
}

#[test]
fn what_is_set_wins_and_the_rest_stays() {
    let over = Overrides {
        blur_mm: Some(6.0),
        labels: Some(MaskLabels {
            cavity: 1,
            wall: 2,
            right: None,
        }),
        ..Overrides::default()
    };
    let spect = Preparation::of_road(Road::Spect);
    let set = over.over(spect.clone());
    assert_eq!(set.road, Road::Masks(over.labels.unwrap()));
    assert_eq!((set.blur_mm, set.vertices), (6.0, spect.vertices));
    // The labels of the settings are kept by the word for their road.
    let road = Overrides {
        road: Some(Road::ALL[0]),
        ..Overrides::default()
    };
    assert_eq!(road.over(full()).road, full().road);
    assert_eq!(Overrides::default().over(full()), full());
}

#[test]
fn the_road_follows_from_what_the_image_is() {
    let road = |facts: &ImageFacts| {
        let proposal = proposed(facts);
        (proposal.preparation.road.name(), proposal.suitable)
    };
    let of_labels = facts(&labels(), None);
    assert_eq!(of_labels.labels, Some(vec![2, 3]));
    assert_eq!(road(&of_labels), ("masks", true));
    // Counts that are few whole numbers are no labels where a machine made them.
    let of_counts = facts(
        &super::phantom::image([4.0, 4.0], |p, _| p.x as f32 + 0.25),
        None,
    );
    assert_eq!(of_counts.labels, None);
    assert_eq!(road(&of_counts), ("spect", true));
    let machine = |modality| ImageFacts {
        modality: Some(modality),
        ..of_counts.clone()
    };
    assert_eq!(road(&machine(Modality::NuclearMedicine)), ("spect", true));
    assert_eq!(road(&machine(Modality::MagneticResonance)), ("cine", true));
    assert!(!road(&machine(Modality::Ultrasound)).1);
    let stack = ImageFacts {
        spacing_mm: [1.5, 1.5, 8.0],
        ..of_counts.clone()
    };
    assert_eq!(road(&stack), ("cine", true));
    let planar = ImageFacts {
        size: [64, 64, 1],
        ..machine(Modality::NuclearMedicine)
    };
    assert!(!road(&planar).1);
    let drawn = ImageFacts {
        contours: 4,
        ..machine(Modality::MagneticResonance)
    };
    assert_eq!(road(&drawn), ("contours", true));
}

#[test]
fn few_whole_counts_are_no_labels() {
    let few = facts(&counts(), Some(Modality::NuclearMedicine));
    assert_eq!(few.labels, Some(vec![5, 100, 120]));
    assert_eq!(proposed(&few).preparation.road, Road::Spect);
    // Noise of few counts, of a file that names no machine.
    let noise = super::phantom::image([4.0, 4.0], |p, instant| {
        let hash = (p.x * 12.9 + p.y * 78.2 + p.z * 37.7 + instant as f64).sin() * 43_758.5;
        (hash.fract().abs() * 12.0).floor() as f32
    });
    assert_eq!(facts(&noise, None).labels, None);
}

#[test]
fn what_the_files_do_not_say_is_asked_for() {
    let unknown = ImageFacts {
        spacing_known: false,
        ..facts(&labels(), None)
    };
    let mut settings = Preparation::default();
    assert_eq!(asked(&unknown, &settings), [Asked::Spacing, Asked::Times]);
    settings.spacing_mm = Some([1.5, 1.5, 8.0]);
    settings.times = Some(TypedTimes::Cycle(800.0));
    assert!(asked(&unknown, &settings).is_empty());
    settings.road = Road::Masks(MaskLabels {
        cavity: 1,
        wall: 2,
        right: None,
    });
    assert_eq!(asked(&unknown, &settings), [Asked::Labels]);
    settings.road = Road::Cine;
    assert_eq!(
        asked(&unknown, &settings),
        [Asked::Apex, Asked::Base, Asked::Blood]
    );
    settings.points.blood = Some(Point3::origin());
    assert_eq!(asked(&unknown, &settings), [Asked::Apex, Asked::Base]);
    settings.road = Road::Contours;
    assert_eq!(asked(&unknown, &settings), [Asked::Outlines]);
    assert!(!Asked::Times.is_needed() && Asked::Spacing.is_needed());
}

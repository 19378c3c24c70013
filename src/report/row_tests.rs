//! Every value of a row stands in its own column: rows of values that all differ, read back by the keys of their columns.

use std::collections::HashMap;

use super::measures::{FrameRow, SubjectRow};
use super::medial_atoms::MedialAtomRow;
use super::*;
use crate::analysis::experiments::{
    ComparisonRow, InterpolationCase, LocalisationRow, MeanAccuracy, MedialMethod, MedialNoiseCell,
    Motion, NoiseFamily, NoiseReference, ObjectKind, PartnerRanks, PartnerRow, TransportCase,
};
use crate::analysis::medial::Atom;
use crate::mesh::{Point3, Vector3};

/// Keys of columns with the cells of one row.
fn cells<R: Row>(row: R) -> HashMap<String, String> {
    let table = csv(&[row]);
    let mut reader = ::csv::Reader::from_reader(table.as_bytes());
    let keys = reader.headers().unwrap().clone();
    let row = reader.records().next().unwrap().unwrap();
    let pairs = keys.iter().zip(row.iter());
    pairs
        .map(|(key, cell)| (key.to_owned(), cell.to_owned()))
        .collect()
}

/// That a row holds these cells and no others.
fn holds<R: Row>(row: R, expected: &[(&str, &str)]) {
    let found = cells(row);
    for (key, cell) in expected {
        assert_eq!(found.get(*key).map(String::as_str), Some(*cell), "{key}");
    }
    assert_eq!(found.len(), expected.len(), "{found:?}");
}

#[test]
fn measures_and_sizes_stand_in_their_columns() {
    let row = SubjectRow {
        subject: "a".to_owned(),
        label: Some("b".to_owned()),
        end_diastole: Some(1),
        end_systole: Some(2),
        edv: Some(3.0),
        esv: Some(4.0),
        sv: Some(5.0),
        ef: Some(6.0),
        mass_g: Some(7.0),
        phases_stated: true,
        outside_range: "8".to_owned(),
        notes: "9".to_owned(),
        ..SubjectRow::default()
    };
    let unit = row.unit.volume_symbol();
    holds(
        row,
        &[
            ("subject", "a"),
            ("label", "b"),
            ("end_diastole", "1"),
            ("end_systole", "2"),
            ("edv", "3"),
            ("esv", "4"),
            ("sv", "5"),
            ("ef", "6"),
            ("mass_g", "7"),
            ("volume_unit", unit),
            ("phase_source", "stated"),
            ("outside_range", "8"),
            ("notes", "9"),
        ],
    );
    let row = FrameRow {
        subject: "a".to_owned(),
        frame: 1,
        endo_volume: Some(2.0),
        epi_volume: Some(3.0),
        wall_volume: Some(4.0),
        endo_area: Some(5.0),
        epi_area: Some(6.0),
        ..FrameRow::default()
    };
    let found = cells(row);
    let sizes = [
        ("frame", "1"),
        ("endo_volume", "2"),
        ("epi_volume", "3"),
        ("wall_volume", "4"),
        ("endo_area", "5"),
        ("epi_area", "6"),
    ];
    for (key, cell) in sizes {
        assert_eq!(found[key], cell, "{key}");
    }
}

#[test]
fn places_stand_in_the_columns_of_their_maps() {
    let place = [Some(5.0), Some(6.0)];
    let (subject, at) = ("a".to_owned(), [("x", "5"), ("y", "6"), ("subject", "a")]);
    let pose = PoseRow {
        subject: subject.clone(),
        frame: 1,
        place,
    };
    holds(pose, &[&at[..], &[("frame", "1")]].concat());
    let step = MedialPoseRow {
        subject,
        step_from: 1,
        step_to: 2,
        patch: Some(3),
        place,
    };
    let step_cells = [("step_from", "1"), ("step_to", "2"), ("patch", "3")];
    holds(step, &[&at[..], &step_cells].concat());
}

#[test]
fn spokes_and_normal_of_an_atom_stand_axis_by_axis() {
    let row = MedialAtomRow {
        vertex: 1,
        atom: Atom {
            position: Point3::new(2.0, 3.0, 4.0),
            radius: 5.0,
            spokes: [Vector3::new(6.0, 7.0, 8.0), Vector3::new(9.0, 10.0, 11.0)],
        },
        normal: Vector3::new(12.0, 13.0, 14.0),
        end: true,
    };
    let keys = [
        "vertex", "x", "y", "z", "r", "s0x", "s0y", "s0z", "s1x", "s1y", "s1z", "nx", "ny", "nz",
    ];
    let found = cells(row);
    for (place, key) in keys.into_iter().enumerate() {
        assert_eq!(found[key], (place + 1).to_string(), "{key}");
    }
    assert_eq!(found["end"], "1");
}

#[test]
fn experiments_on_deformations_stand_in_their_columns() {
    let noise = NoiseRow {
        method: "a",
        family: "b",
        percent: 1.0,
        reference: NoiseReference::Displacement,
        object: "c",
        tau: 0.02,
        standard_error: Some(0.03),
        baseline: Some(0.04),
        published: Some(0.05),
    };
    holds(
        noise,
        &[
            ("method", "a"),
            ("family", "b"),
            ("percent", "1"),
            ("percent_of", "displacement"),
            ("object", "c"),
            ("tau_percent", "2"),
            ("standard_error", "3"),
            ("baseline", "4"),
            ("published", "5"),
        ],
    );
    let accuracy = |first: f64| MeanAccuracy {
        share: 0.01 * first,
        standard_error: 0.01 * (first + 1.0),
        baseline: 0.01 * (first + 2.0),
    };
    let comparison = ComparisonRow {
        method: "a",
        percent: 1.0,
        copies: 2,
        labelled: 3,
        nearest_neighbour: accuracy(10.0),
        linear_classifier: accuracy(20.0),
        plane_classifier: accuracy(30.0),
        tau: accuracy(40.0),
    };
    let found = cells(comparison);
    assert_eq!([&found["method"], &found["noise_percent"]], ["a", "1"]);
    assert_eq!([&found["copies"], &found["labelled"]], ["2", "3"]);
    let names = ["nearest_neighbour", "linear_rule", "plane_rule", "tau"];
    for (first, name) in [10, 20, 30, 40].into_iter().zip(names) {
        for (more, part) in ["percent", "standard_error", "baseline"].iter().enumerate() {
            assert_eq!(found[&format!("{name}_{part}")], (first + more).to_string());
        }
    }
    let partners = PartnerRow {
        method: "a",
        transport: "b",
        ranks: PartnerRanks {
            pairs: 1,
            nearer_than_median: 2,
            nearest: 3,
            mean_rank: 4.5,
            nearest_by_chance: 5.5,
            mean_rank_by_chance: 6.5,
            mean_distance: 7.5,
        },
    };
    holds(
        partners,
        &[
            ("transfer", "b"),
            ("method", "a"),
            ("pairs", "1"),
            ("nearer_than_median", "2"),
            ("nearest", "3"),
            ("mean_rank", "4.5"),
            ("nearest_by_chance", "5.5"),
            ("mean_rank_by_chance", "6.5"),
            ("mean_distance", "7.5"),
        ],
    );
}

#[test]
fn transported_and_interpolated_deformations_stand_in_their_columns() {
    let transported = TransportCase {
        object: ObjectKind::ALL[1],
        target: "a",
        motion: Motion::Twist,
        relative_error: 1.5,
        cosine: 2.5,
        norm_ratio: 3.5,
        flipped_faces: 4,
        followed: true,
    };
    holds(
        transported,
        &[
            ("source", ObjectKind::ALL[1].name()),
            ("target", "a"),
            ("motion", "twist"),
            ("relative_error", "1.5"),
            ("cosine", "2.5"),
            ("norm_ratio", "3.5"),
            ("flipped_faces", "4"),
            ("followed", "true"),
        ],
    );
    let interpolated = InterpolationCase {
        object: ObjectKind::ALL[1],
        motion: Motion::Bend,
        energy_ratio: 1.5,
        step_ratio: 2.5,
        volume_ratios: [3.5, 4.5],
        midpoint_error: 5.5,
        self_intersections: 6,
        poses: Vec::new(),
    };
    holds(
        interpolated,
        &[
            ("object", ObjectKind::ALL[1].name()),
            ("motion", "bend"),
            ("energy_over_linear", "1.5"),
            ("longest_over_shortest_step", "2.5"),
            ("least_volume_ratio", "3.5"),
            ("greatest_volume_ratio", "4.5"),
            ("midpoint_error", "5.5"),
            ("self_intersections", "6"),
        ],
    );
}

#[test]
fn experiments_on_medial_surfaces_stand_in_their_columns() {
    let noise = MedialNoiseCell {
        method: MedialMethod::Paths,
        family: Some(NoiseFamily::Gaussian),
        percent: 1.0,
        tau: 0.02,
        standard_error: 0.03,
        baseline: 0.04,
        specificity: 0.05,
        sensitivity: 0.06,
        published: Some(0.07),
    };
    holds(
        noise,
        &[
            ("method", MedialMethod::Paths.name()),
            ("family", "Gaussian"),
            ("percent", "1"),
            ("tau_percent", "2"),
            ("standard_error", "3"),
            ("baseline", "4"),
            ("specificity_percent", "5"),
            ("sensitivity_percent", "6"),
            ("published", "7"),
        ],
    );
    let localisation = LocalisationRow {
        patches: 1,
        share: 0.02,
        family: None,
        percent: 3.0,
        sheets: 4,
        found: Some((0.05, 0.06)),
        false_patches: (7.0, 8.0),
        dice: Some((9.0, 10.0)),
        centroid_mm: Some((11.0, 12.0)),
        segments: Some((0.13, 0.14)),
        main_segment: Some((0.15, 0.16)),
        gaps_percent: [Some(17.0), Some(18.0)],
        normal_spreads_rad: [Some(19.0), Some(20.0)],
    };
    let found = cells(localisation);
    assert_eq!(found["family"], "clean");
    let keys = [
        "patches",
        "patch_percent",
        "percent",
        "sheets",
        "found_percent",
        "found_percent_standard_error",
        "false_patches",
        "false_patches_standard_error",
        "dice",
        "dice_standard_error",
        "centroid_mm",
        "centroid_mm_standard_error",
        "segments_agreeing_percent",
        "segments_agreeing_percent_standard_error",
        "main_segment_percent",
        "main_segment_percent_standard_error",
        "gap_of_all_percent",
        "gap_of_patch_percent",
        "normal_spread_of_all_rad",
        "normal_spread_of_patch_rad",
    ];
    for (place, key) in keys.into_iter().enumerate() {
        assert_eq!(found[key], (place + 1).to_string(), "{key}");
    }
}

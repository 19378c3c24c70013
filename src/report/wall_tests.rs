//! Columns that scripts rely on, and numbers told by hand.

use std::sync::Arc;

use nalgebra::Vector3;

use super::wall_json::wall_json;
use super::{AssessedWall, AtomRow, PatchRow};
use crate::analysis::medial::{Atom, MedialBeat, MedialSurface};
use crate::analysis::segments::{LongAxis, Segment};
use crate::analysis::thickening::{
    Patch, PatchSegment, TemporalConsistency, Thickening, WallThickening,
};
use crate::mesh::{Faces, Point3};
use crate::report::SegmentRow;
use crate::report::{csv, csv_header, csv_rows};
use crate::study::SurfaceKind;
use crate::units::LengthUnit;

/// Four atoms on a square of 10 × 10 in two frames; the left pair stays 4 and 6 thick, the others become half as
/// thick again. Atom 3 is the 7th vertex of its surface.
fn beat() -> MedialBeat {
    let places = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]];
    let frame = |radii: [f64; 4]| MedialSurface {
        atoms: (places.iter().zip(radii))
            .map(|([x, y], radius)| Atom {
                position: Point3::new(*x, *y, 0.5),
                radius,
                spokes: [-Vector3::z(), Vector3::z()],
            })
            .collect(),
        normals: vec![Vector3::z(); 4],
        end: vec![None; 4],
    };
    MedialBeat {
        surface: SurfaceKind::Endocardium,
        vertices: vec![0, 1, 2, 7],
        faces: Arc::new(Faces::new(4, vec![[0, 1, 2], [0, 2, 3]]).unwrap()),
        frames: vec![frame([2.0, 4.0, 4.0, 3.0]), frame([2.0, 6.0, 6.0, 3.0])],
        regular: vec![true; 4],
    }
}

/// No two columns of a table may hold the same, so that exchanged ones are seen.
fn found(unit: LengthUnit) -> Thickening {
    let segment = |number: u8, of_patch: f64| PatchSegment {
        segment: Segment::new(number).unwrap(),
        of_segment: 0.5,
        of_patch,
    };
    Thickening {
        end_diastole: 0,
        end_systole: 1,
        tolerance: 0.05,
        noise: 0.01,
        steps: Vec::new(),
        temporal_consistency: TemporalConsistency::default(),
        ed_to_es: vec![1.0, 1.5, 1.5, 1.0],
        averaged: vec![0.0, 0.4, 0.4, 0.0],
        at_edge: Vec::new(),
        remote: 0.4,
        remote_curve: vec![0.0, 0.4],
        min_share: 0.02,
        averaged_share: 0.01,
        averaged_noise: 0.01,
        regular_area: 100.0,
        size: 10.0,
        wall_thickening: WallThickening::AllButPatches,
        smallest: None,
        patches: vec![Patch {
            atoms: vec![0, 3],
            area: 50.0,
            area_cm2: (unit == LengthUnit::Millimetre).then_some(0.5),
            share: 0.45,
            segments: vec![segment(8, 0.75), segment(7, 0.25)],
            centroid: Point3::new(-1.0, 5.0, 0.25),
            border: Vec::new(),
            thickening: 0.25,
            stability: 0.98,
            path: Vec::new(),
            temporal_consistency: TemporalConsistency::default(),
        }],
    }
}

fn with_wall<T>(
    unit: LengthUnit,
    axis: Option<LongAxis>,
    ask: impl Fn(&AssessedWall<'_>) -> T,
) -> T {
    let (beat, thickening) = (beat(), found(unit));
    let segments = [8, 7, 7, 8].map(Segment::new);
    ask(&AssessedWall {
        subject: "P, \"1\"",
        unit,
        beat: &beat,
        thickening: &thickening,
        axis: axis.as_ref(),
        segments: &segments,
    })
}

#[test]
fn atoms_have_the_columns_that_scripts_rely_on() {
    let text = with_wall(LengthUnit::Millimetre, None, |wall| {
        csv_header::<AtomRow>()
            + &csv_rows(&AtomRow::of_frame(wall, 0))
            + &csv_rows(&AtomRow::of_frame(wall, 1))
    });
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(
        lines[0],
        "subject,frame,vertex,x,y,z,r,pt,in_patch,regular,patch"
    );
    assert_eq!(lines.len(), 9);
    assert_eq!(lines[4], "\"P, \"\"1\"\"\",0,7,0,10,0.5,3,1,1,1,0");
    assert_eq!(lines[6], "\"P, \"\"1\"\"\",1,1,10,0,0.5,6,1.5,0,1,");
}

#[test]
fn patches_have_the_columns_that_scripts_rely_on() {
    let table = |unit| with_wall(unit, None, |wall| csv(&PatchRow::of_wall(wall)));
    let text = table(LengthUnit::Millimetre);
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(
        lines[0],
        "subject,patch,area_cm2,share,segments,x,y,z,confidence,segment_shares,area,area_unit,atoms,pt,thickening_percent"
    );
    assert_eq!(
        lines[1],
        format!(
            "\"P, \"\"1\"\"\",0,0.5,0.45,8 7,-1,5,0.25,0.98,0.75 0.25,0.5,cm²,2,{},{}",
            0.25_f64.exp(),
            100.0 * (0.25_f64.exp() - 1.0)
        )
    );
    let of_unknown_size = table(LengthUnit::FileUnit);
    assert!(
        of_unknown_size.contains("\",0,,0.45,8 7,-1,5,0.25,0.98,0.75 0.25,50,units²,2,"),
        "{of_unknown_size}"
    );
}

#[test]
fn segments_tell_what_was_put_into_them() {
    let [apex, base] = [[5.0, 5.0, -40.0], [5.0, 5.0, 40.0]].map(Point3::from);
    let oriented = LongAxis::oriented(apex, base, -Vector3::x(), Vector3::y());
    let table = |axis| {
        with_wall(LengthUnit::Millimetre, axis, |wall| {
            csv(&SegmentRow::of_wall(wall))
        })
    };
    let text = table(oriented);
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    assert_eq!(
        reader.headers().unwrap().iter().collect::<Vec<_>>(),
        [
            "subject",
            "segment",
            "name",
            "thickness_ed",
            "thickness_es",
            "length_unit",
            "thickening_percent",
            "pt",
            "patch_share"
        ]
    );
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    assert_eq!(rows.len(), 17);
    let cells = |row: usize| rows[row].iter().skip(1).collect::<Vec<_>>();
    assert_eq!(cells(0), ["1", "basal anterior", "", "", "mm", "", "", ""]);
    let numbers = |row: usize| [3, 4, 6, 7, 8].map(|cell| rows[row][cell].parse::<f64>().unwrap());
    let near = |a: [f64; 5], b: [f64; 5]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-12);
    assert!(
        near(numbers(6), [8.0, 12.0, 50.0, 1.5, 0.0]),
        "{:?}",
        rows[6]
    );
    // Atom 0 has two faces and twice the area of atom 3: (2 · 4 + 6) / 3.
    let still = 14.0 / 3.0;
    assert!(
        near(numbers(7), [still, still, 0.0, 1.0, 1.0]),
        "{:?}",
        rows[7]
    );
    // Without directions there are levels; all four atoms lie halfway.
    let text = table(LongAxis::new(apex, base, Vector3::x()));
    let lines: Vec<&str> = text.lines().skip(1).collect();
    assert_eq!(lines.len(), 4);
    assert!(lines[0].ends_with(",,basal,,,mm,,,"), "{}", lines[0]);
    let mid: Vec<&str> = lines[1].rsplit(',').collect();
    assert!((mid[0].parse::<f64>().unwrap() - 0.5).abs() < 1e-12);
    assert!((mid[1].parse::<f64>().unwrap() - 1.5_f64.sqrt()).abs() < 1e-12);
    assert_eq!(table(None).lines().count(), 1);
}

#[test]
fn the_summary_says_the_same_of_a_heart() {
    let said = with_wall(LengthUnit::Millimetre, None, wall_json);
    assert_eq!(said["assessed"], true);
    assert_eq!(said["extent"], "thickens but for patches");
    assert_eq!(said["patches"][0]["area_cm2"], 0.5);
    assert_eq!(
        said["patches"][0]["segments"][0]["name"],
        "mid anteroseptal"
    );
    assert_eq!(said["regular_area"], 1.0);
    assert_eq!(said["oriented"], false);
    assert!(said["well_share_contraction"].is_null());
}

//! What is under the pointer, and what is said of it.

use egui::{Rect, pos2, vec2};

use super::plot::Plot;
use super::*;

fn plot() -> Plot {
    Plot::new(Rect::from_min_size(pos2(10.0, 20.0), vec2(300.0, 240.0)))
}

fn values() -> [String; Segment::COUNT] {
    std::array::from_fn(|index| {
        if index == 1 {
            "42 %".to_owned()
        } else {
            String::new()
        }
    })
}

fn view(oriented: bool, values: &[String; Segment::COUNT]) -> BullsEyeView<'_> {
    BullsEyeView {
        fill: BullsEyeFill::Segments(&[None; Segment::COUNT]),
        oriented,
        quantity: "Thickening",
        values,
        selected: None,
        outlined: &[],
    }
}

#[test]
fn up_is_anterior_left_is_septal_and_the_middle_is_the_apex() {
    let plot = plot();
    let number = |x: f32, y: f32| {
        let pointer = plot.centre + plot.radius * vec2(x, y);
        plot.pick(pointer, true)
            .and_then(|pick| pick.segment)
            .map(Segment::number)
    };
    assert_eq!(number(0.0, -0.9), Some(1));
    assert_eq!(number(0.0, 0.9), Some(4));
    assert_eq!(number(-0.4, 0.0), Some(14));
    assert_eq!(number(0.4, 0.0), Some(16));
    assert_eq!(number(0.0, 0.1), Some(17));
    assert_eq!(number(0.8, 0.8), None);
}

#[test]
fn without_orientation_a_place_has_a_level_and_no_segment() {
    let plot = plot();
    let pick = plot
        .pick(plot.centre - vec2(0.0, 0.6 * plot.radius), false)
        .unwrap();
    assert_eq!((pick.level, pick.segment), (Level::Mid, None));
    assert!((pick.at[1] - 0.6).abs() < 1e-6);
}

#[test]
fn the_hover_text_names_segment_quantity_and_value() {
    let values = values();
    let pick = |number: u8| BullsEyePick {
        level: Segment::new(number).unwrap().level(),
        segment: Segment::new(number),
        at: [0.0, 0.0],
    };
    assert_eq!(
        hover_text(&view(true, &values), pick(2)),
        "2 · basal anteroseptal: thickening 42 %"
    );
    assert_eq!(
        hover_text(&view(true, &values), pick(9)),
        "9 · mid inferoseptal: thickening not told"
    );
    let level = BullsEyePick {
        segment: None,
        ..pick(12)
    };
    assert_eq!(
        hover_text(&view(false, &values), level),
        "mid: thickening not told"
    );
}

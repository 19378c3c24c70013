//! Maps on a page: places, names, what is selected and what is pale.

use super::*;
use crate::picture::page::{FigureFonts, Page};
use crate::picture::tokens::PictureTheme;

const LOOK: MapLook = MapLook {
    mark: 6.0,
    path: 1.0,
    name: 12.0,
    air: 30.0,
};

fn path(name: &str, places: &[[f64; 2]]) -> MapPath {
    let point = |at: &[f64; 2]| MapPoint {
        at: *at,
        look: PointLook::Small,
        joined: true,
    };
    MapPath {
        name: name.to_owned(),
        mark: LabelMark::Normal,
        points: places.iter().map(point).collect(),
        cyclic: false,
        selected: false,
        dimmed: false,
    }
}

fn drawn(plot: &MapPlot) -> (Page, [usize; 2]) {
    let fonts = FigureFonts::load().unwrap();
    let mut page = Page::new([400.0, 300.0], None);
    let mut pen = Pen {
        page: &mut page,
        fonts: &fonts,
        theme: &PictureTheme::LIGHT,
        text: 15.0,
    };
    let area = [[50.0, 50.0], [350.0, 250.0]];
    let without = draw_map(&mut pen, plot, area, LOOK);
    (page, without)
}

#[test]
fn equal_distances_of_the_map_are_equal_on_the_page_in_every_direction() {
    let plot = MapPlot {
        paths: vec![path("P1", &[[0.0, 0.0], [4.0, 0.0], [0.0, 1.0]])],
        legend: Vec::new(),
    };
    let frame = MapFrame::of(&plot, [[0.0, 0.0], [300.0, 300.0]], 10.0);
    let [origin, right, up] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(|at| frame.place(at));
    assert!((right[0] - origin[0] - 70.0).abs() < 1e-3);
    assert!((origin[1] - up[1] - 70.0).abs() < 1e-3);
    let [across, _] = frame.axes();
    assert!((frame.place([across.low, 0.0])[0]).abs() < 1e-3);
    assert!((frame.place([across.high, 0.0])[0] - 300.0).abs() < 1e-3);
}

#[test]
fn subjects_are_named_and_the_selected_one_in_a_colour_of_its_own() {
    let mut selected = path("P05", &[[1.0, 0.0]]);
    selected.selected = true;
    let mut dimmed = path("P07", &[[2.0, 0.5]]);
    dimmed.dimmed = true;
    let plot = MapPlot {
        paths: vec![selected, path("N01", &[[0.0, 1.0]]), dimmed],
        legend: Vec::new(),
    };
    let (page, without) = drawn(&plot);
    assert_eq!(without, [0, 2]);
    let words = page.marks.iter().filter_map(|mark| match mark {
        Mark::Text { words, colour, .. } => Some((words.as_str(), *colour)),
        _ => None,
    });
    let theme = PictureTheme::LIGHT;
    assert_eq!(
        words.collect::<Vec<_>>(),
        [("P05", theme.emphasis), ("N01", theme.text)]
    );
}

#[test]
fn the_name_of_the_selected_subject_does_not_lie_on_its_path() {
    let mut selected = path("P05", &[[0.0, 0.0], [9.0, 0.0]]);
    selected.selected = true;
    let paths = vec![selected, path("N01", &[[-5.0, 4.0]])];
    let (page, _) = drawn(&MapPlot {
        paths,
        legend: Vec::new(),
    });
    let at = page.marks.iter().find_map(|mark| match mark {
        Mark::Text { words, at, .. } if words == "P05" => Some(*at),
        _ => None,
    });
    let first = page.marks.iter().find_map(|mark| match mark {
        Mark::Line { points, .. } if points.len() == 2 => Some(points[0]),
        _ => None,
    });
    let (at, first) = (at.unwrap(), first.unwrap());
    assert!(at[0] + 10.0 < first[0] || (at[1] - first[1]).abs() > 8.0);
}

#[test]
fn a_gap_in_a_path_is_dashed_and_a_map_of_one_place_has_a_middle() {
    let mut gap = path("P1", &[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]]);
    gap.points[2].joined = false;
    let plot = MapPlot {
        paths: vec![gap],
        legend: Vec::new(),
    };
    let lines = |page: &Page| {
        let lines = page.marks.iter().filter_map(|mark| match mark {
            Mark::Line { points, width, .. } if *width == LOOK.path => Some(points.len()),
            _ => None,
        });
        lines.count()
    };
    assert!(lines(&drawn(&plot).0) > 10);
    let one = MapPlot {
        paths: vec![path("P1", &[[7.0, 7.0]])],
        legend: Vec::new(),
    };
    let frame = MapFrame::of(&one, [[0.0, 0.0], [100.0, 100.0]], 10.0);
    assert_eq!(frame.place([7.0, 7.0]), [50.0, 50.0]);
}

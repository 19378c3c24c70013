//! The maps of the study: a mark for every heart, shape and colour by its label, as in the window.

use crate::picture::figure::Pen;
use crate::picture::label_marks::LabelMark;
use crate::picture::page::{Anchor, FigureFonts, Page};
use crate::picture::plot::{
    LegendEntry, LegendPlace, MapLook, MapPath, MapPlot, MapPoint, PointLook, draw_label_legend,
    draw_map,
};
use crate::picture::report::order::ReportOrder;
use crate::picture::report::sheet::{LINE, MARGIN, SIZE, TEXT, THEME, pen, sheet};
use crate::study::Study;

/// Side of a plot.
const SIDE: f32 = 640.0;
/// Half the size of a mark.
const MARK: f32 = 6.0;
/// Sizes of the maps.
const LOOK: MapLook = MapLook {
    mark: MARK,
    path: 1.0,
    name: 0.7 * TEXT,
    air: 30.0,
};

/// A plot: points of hearts, joined where they are of one beat.
struct Plot {
    title: &'static str,
    note: String,
    map: MapPlot,
}

/// Both maps on one sheet; none where there is none.
pub(super) fn map_page(order: &ReportOrder<'_>, fonts: &FigureFonts) -> Option<Page> {
    let marks = LabelMark::of_subjects(order.study);
    let plots: Vec<Plot> = [pose_plot(order, &marks), deformation_plot(order, &marks)]
        .into_iter()
        .flatten()
        .collect();
    if plots.is_empty() {
        return None;
    }
    let mut page = sheet();
    let mut pen = pen(&mut page, fonts);
    let mut top = MARGIN;
    for plot in &plots {
        draw(&mut pen, plot, top);
        top += SIDE + 4.0 * LINE;
    }
    legend(&mut pen, order.study, top + 0.3 * LINE);
    Some(page)
}

fn pose_plot(order: &ReportOrder<'_>, marks: &[LabelMark]) -> Option<Plot> {
    let map = order.poses?;
    let mut paths: Vec<(usize, Vec<[f64; 2]>)> = Vec::new();
    for (row, pose) in map.distances.poses.iter().enumerate() {
        let &[x, y, ..] = map.embedding.point(row) else {
            continue;
        };
        match paths.last_mut() {
            Some((subject, path)) if *subject == pose.subject => path.push([x, y]),
            _ => paths.push((pose.subject, vec![[x, y]])),
        }
    }
    let stress = map.embedding.stress;
    Some(Plot {
        title: "Poses",
        note: stress.map_or_else(String::new, |stress| {
            format!("Classical MDS, stress {stress:.2}; axes have no unit; the large mark is the first frame")
        }),
        map: map_plot(order.study, marks, paths),
    })
}

fn deformation_plot(order: &ReportOrder<'_>, marks: &[LabelMark]) -> Option<Plot> {
    let map = order.deformations?;
    let paths = map
        .subjects
        .iter()
        .enumerate()
        .filter_map(|(row, &subject)| {
            let &[x, y, ..] = map.embedding.point(row) else {
                return None;
            };
            Some((subject, vec![[x, y]]))
        });
    Some(Plot {
        title: "Deformations",
        note: "Locally linear embedding (LLE) of whole motions; axes have no unit".to_owned(),
        map: map_plot(order.study, marks, paths),
    })
}

/// Paths of subjects as they are drawn: the first frame is marked large.
fn map_plot(
    study: &Study,
    marks: &[LabelMark],
    paths: impl IntoIterator<Item = (usize, Vec<[f64; 2]>)>,
) -> MapPlot {
    let look = |step| match step {
        0 => PointLook::Filled,
        _ => PointLook::Small,
    };
    let point = |(step, at)| MapPoint {
        at,
        look: look(step),
        joined: true,
    };
    let paths = paths.into_iter().map(|(subject, places)| MapPath {
        name: (study.subjects.get(subject)).map_or_else(String::new, |subject| subject.id.clone()),
        mark: marks.get(subject).copied().unwrap_or_default(),
        points: places.into_iter().enumerate().map(point).collect(),
        cyclic: false,
        selected: false,
        dimmed: false,
    });
    MapPlot {
        paths: paths.collect(),
        legend: Vec::new(),
    }
}

fn draw(pen: &mut Pen<'_>, plot: &Plot, top: f32) {
    let heading = pen.strong(THEME.text, 1.2 * TEXT);
    pen.write(plot.title, heading, Anchor::Start, [MARGIN, top + TEXT]);
    let mut muted = pen.regular(THEME.muted);
    let below = [MARGIN, top + TEXT + LINE];
    pen.write(&plot.note, muted, Anchor::Start, below);
    let low = [MARGIN, top + 1.8 * LINE + TEXT];
    let high = [SIZE[0] - MARGIN, low[1] + SIDE];
    let frame = [low, [high[0], low[1]], high, [low[0], high[1]]];
    pen.page.line(&frame, true, 1.0, THEME.line);
    let [without, count] = draw_map(pen, &plot.map, [low, high], LOOK);
    if without > 0 {
        let note = format!("{without} of {count} names are left out for lack of room");
        muted.size = LOOK.name;
        pen.write(&note, muted, Anchor::End, [high[0], high[1] + LINE]);
    }
}

/// What the marks mean, with the number of subjects, from the line at `base` on.
fn legend(pen: &mut Pen<'_>, study: &Study, base: f32) {
    let entries = LegendEntry::of(study, 0..study.subjects.len());
    let place = LegendPlace {
        left: MARGIN,
        right: SIZE[0] - MARGIN,
        base,
        last: SIZE[1] - MARGIN - LINE,
        mark: MARK,
    };
    draw_label_legend(pen, &entries, place);
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::mesh::phantom;
    use crate::picture::page::Mark;
    use crate::study::{MeshSequence, Subject, SurfaceKind, SurfaceSequence};
    use crate::units::LengthUnit;

    fn study(labels: &[Option<&str>]) -> Study {
        let subject = |label: &Option<&str>| {
            let meshes = vec![phantom::sphere(1, 20.0)];
            let surface = SurfaceSequence::new(SurfaceKind::Cavity, meshes).unwrap();
            let sequence = MeshSequence::new(vec![surface]).unwrap();
            let mut subject = Subject::new("P", sequence, LengthUnit::Millimetre);
            subject.label = label.map(str::to_owned);
            Arc::new(subject)
        };
        Study {
            subjects: labels.iter().map(subject).collect(),
            ..Study::default()
        }
    }

    #[test]
    fn the_legend_has_a_shape_and_a_colour_for_every_label_with_its_count() {
        let labels = ["MINF", "DCM", "normal", "MINF"].map(Some);
        let study = study(&[&labels[..], &[None]].concat());
        let fonts = FigureFonts::load().unwrap();
        let mut page = sheet();
        legend(&mut pen(&mut page, &fonts), &study, 100.0);
        let words = page.marks.iter().filter_map(|mark| match mark {
            Mark::Text { words, .. } => Some(words.as_str()),
            _ => None,
        });
        let words: Vec<&str> = words.collect();
        assert_eq!(words, ["normal 1", "DCM 1", "MINF 2", "no label 1"]);
        // A disc, a triangle, two lines, a square: a cross would say that they are ill.
        let colours = page.marks.iter().filter_map(|mark| match mark {
            Mark::Line { colour, .. } | Mark::Fill { colour, .. } => Some(*colour),
            _ => None,
        });
        let [dcm, minf] = [1, 2].map(|place| LabelMark::Label(place).on_paper());
        let [normal, none] = [LabelMark::Normal, LabelMark::Unlabelled].map(LabelMark::on_paper);
        assert_eq!(colours.collect::<Vec<_>>(), [normal, dcm, minf, minf, none]);
    }

    #[test]
    fn many_labels_stand_on_several_lines_within_the_margins() {
        let names: Vec<String> = (0..20)
            .map(|place| format!("diagnosis {place:02}"))
            .collect();
        let labels: Vec<Option<&str>> = names.iter().map(|name| Some(name.as_str())).collect();
        let study = study(&labels);
        let fonts = FigureFonts::load().unwrap();
        let mut page = sheet();
        let base = SIZE[1] - MARGIN - 3.5 * LINE;
        legend(&mut pen(&mut page, &fonts), &study, base);
        let mut lines = std::collections::BTreeSet::new();
        let mut last = String::new();
        for mark in &page.marks {
            if let Mark::Text { at, words, .. } = mark {
                assert!((MARGIN..SIZE[0] - MARGIN).contains(&at[0]));
                assert!(at[1] < SIZE[1] - MARGIN);
                lines.insert(at[1] as i32);
                last.clone_from(words);
            }
        }
        assert_eq!(lines.len(), 3, "{lines:?}");
        assert!(last.ends_with(" more"), "{last}");
    }
}

//! The maps of the study: a mark for every heart, shape and colour by its label, as in the window.

use std::collections::BTreeMap;

use crate::picture::figure::Pen;
use crate::picture::label_marks::{LabelMark, MarkShape};
use crate::picture::page::{Anchor, FigureFonts, Page};
use crate::picture::report::map_names::{Name, placed};
use crate::picture::report::order::ReportOrder;
use crate::picture::report::sheet::{LINE, MARGIN, SIZE, TEXT, THEME, pen, sheet};
use crate::study::Study;

/// Side of a plot.
const SIDE: f32 = 640.0;
/// Half the size of a mark.
const MARK: f32 = 6.0;
/// Width of the arms of a mark, in radii.
const ARM: f32 = 0.4;
/// Width of paths.
const PATH: f32 = 1.0;
/// Size of names relative to running text.
const NAME: f32 = 0.7;
/// Widest name.
const NAME_WIDTH: f32 = 200.0;
/// Paths lie behind marks.
const PALE: f32 = 0.55;

/// A plot: points of hearts, joined where they are of one beat.
struct Plot {
    title: &'static str,
    note: String,
    paths: Vec<(usize, Vec<[f64; 2]>)>,
}

/// Both maps on one sheet; none where there is none.
pub(super) fn map_page(order: &ReportOrder<'_>, fonts: &FigureFonts) -> Option<Page> {
    let plots: Vec<Plot> = [pose_plot(order), deformation_plot(order)]
        .into_iter()
        .flatten()
        .collect();
    if plots.is_empty() {
        return None;
    }
    let marks = LabelMark::of_subjects(order.study);
    let mut page = sheet();
    let mut pen = pen(&mut page, fonts);
    let mut top = MARGIN;
    for plot in &plots {
        draw(&mut pen, order, plot, &marks, top);
        top += SIDE + 4.0 * LINE;
    }
    legend(&mut pen, order.study, &marks, top + 0.3 * LINE);
    Some(page)
}

fn pose_plot(order: &ReportOrder<'_>) -> Option<Plot> {
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
        paths,
    })
}

fn deformation_plot(order: &ReportOrder<'_>) -> Option<Plot> {
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
        paths: paths.collect(),
    })
}

fn draw(pen: &mut Pen<'_>, order: &ReportOrder<'_>, plot: &Plot, marks: &[LabelMark], top: f32) {
    let heading = pen.strong(THEME.text, 1.2 * TEXT);
    pen.write(plot.title, heading, Anchor::Start, [MARGIN, top + TEXT]);
    let muted = pen.regular(THEME.muted);
    pen.write(
        &plot.note,
        muted,
        Anchor::Start,
        [MARGIN, top + TEXT + LINE],
    );
    let (left, upper) = (MARGIN, top + 1.8 * LINE + TEXT);
    let width = SIZE[0] - 2.0 * MARGIN;
    let frame = [
        [left, upper],
        [left + width, upper],
        [left + width, upper + SIDE],
        [left, upper + SIDE],
    ];
    pen.page.line(&frame, true, 1.0, THEME.line);
    let points = || plot.paths.iter().flat_map(|(_, path)| path);
    let bound = |axis: usize, pick: fn(f64, f64) -> f64, start: f64| {
        points().map(|point| point[axis]).fold(start, pick)
    };
    let low = [0, 1].map(|axis| bound(axis, f64::min, f64::INFINITY));
    let high = [0, 1].map(|axis| bound(axis, f64::max, f64::NEG_INFINITY));
    let room = [width - 60.0, SIDE - 60.0].map(f64::from);
    let reach = [0, 1].map(|axis| (high[axis] - low[axis]).max(1e-12));
    // One scale for both axes: distances on the map mean the same in every direction.
    let scale = (room[0] / reach[0]).min(room[1] / reach[1]);
    let middle = [left + 0.5 * width, upper + 0.5 * SIDE];
    let place = |point: &[f64; 2]| {
        let from = [0, 1].map(|axis| scale * (point[axis] - 0.5 * (low[axis] + high[axis])));
        [middle[0] + from[0] as f32, middle[1] - from[1] as f32]
    };
    for (subject, path) in &plot.paths {
        let colour = mark_of(marks, *subject).on_paper();
        let line: Vec<[f32; 2]> = path.iter().map(place).collect();
        let pale = colour.map(|channel| 1.0 - PALE * (1.0 - channel));
        pen.page.line(&line, false, PATH, pale);
    }
    write_names(pen, order, plot, place, frame);
    for (subject, path) in &plot.paths {
        let label = mark_of(marks, *subject);
        for (step, point) in path.iter().enumerate() {
            let size = if step == 0 { MARK } else { 0.5 * MARK };
            mark(pen.page, label, place(point), size);
        }
    }
}

/// The subjects beside their large marks, and below the frame how many of them have no room.
fn write_names(
    pen: &mut Pen<'_>,
    order: &ReportOrder<'_>,
    plot: &Plot,
    place: impl Fn(&[f64; 2]) -> [f32; 2],
    frame: [[f32; 2]; 4],
) {
    let mut small = pen.regular(THEME.text);
    small.size *= NAME;
    let named: Vec<(&str, [f32; 2])> = (plot.paths.iter())
        .filter_map(|(subject, path)| {
            let subject = order.study.subjects.get(*subject)?;
            Some((&*subject.id, place(path.first()?)))
        })
        .collect();
    let words: Vec<String> = (named.iter())
        .map(|(id, _)| {
            pen.fonts
                .shortened(id, small.weight, small.size, NAME_WIDTH)
        })
        .collect();
    let names: Vec<Name> = (named.iter().zip(&words))
        .map(|((_, at), words)| Name {
            at: *at,
            size: [pen.fonts.width(words, small.weight, small.size), small.size],
        })
        .collect();
    let marks: Vec<[f32; 2]> = named.iter().map(|(_, at)| *at).collect();
    let places = placed(&names, &marks, 1.5 * MARK, [frame[0], frame[2]]);
    for (words, at) in words.iter().zip(&places) {
        if let Some(at) = at {
            pen.write(words, small, Anchor::Start, *at);
        }
    }
    let without = places.iter().filter(|place| place.is_none()).count();
    if without > 0 {
        let note = format!(
            "{without} of {} names are left out for lack of room",
            places.len()
        );
        let mut muted = pen.regular(THEME.muted);
        muted.size *= NAME;
        pen.write(&note, muted, Anchor::End, [frame[2][0], frame[2][1] + LINE]);
    }
}

fn mark_of(marks: &[LabelMark], subject: usize) -> LabelMark {
    marks.get(subject).copied().unwrap_or_default()
}

/// The shape of a label in its colour.
fn mark(page: &mut Page, label: LabelMark, [x, y]: [f32; 2], size: f32) {
    let colour = label.on_paper();
    let at = |[right, down]: [f32; 2]| [x + size * right, y + size * down];
    match label.shape() {
        // A line without length has round ends: a disc.
        MarkShape::Disc => page.line(&[[x, y], [x + 0.01, y]], false, 2.0 * size, colour),
        MarkShape::Square(side) => page.rectangle(at([-side; 2]), at([side; 2]), colour),
        MarkShape::Arms(arms) => {
            for ends in arms {
                page.line(&ends.map(at), false, ARM * size, colour);
            }
        }
        MarkShape::Polygons(polygons) => {
            for corners in polygons {
                let corners: Vec<[f32; 2]> = corners.into_iter().map(at).collect();
                page.fill(&corners, colour);
            }
        }
    }
}

/// What the marks mean, with the number of subjects: normal first, without a label last; from the line at `base` on as many
/// lines as there is room for.
fn legend(pen: &mut Pen<'_>, study: &Study, marks: &[LabelMark], base: f32) {
    let mut entries: BTreeMap<LabelMark, (String, usize)> = BTreeMap::new();
    for (subject, label) in study.subjects.iter().zip(marks) {
        let name = || (label.name(subject.label.as_deref()), 0);
        entries.entry(*label).or_insert_with(name).1 += 1;
    }
    let set = pen.regular(THEME.muted);
    let (mut x, mut base) = (MARGIN + MARK, base);
    let last = SIZE[1] - MARGIN - LINE;
    let all = entries.len();
    for (place, (label, (name, count))) in entries.into_iter().enumerate() {
        let words = format!("{name} {count}");
        let words = pen
            .fonts
            .shortened(&words, set.weight, set.size, NAME_WIDTH);
        let width = pen.fonts.width(&words, set.weight, set.size);
        // The end of the last line is for the number of those that have no room.
        let end = if base + LINE > last {
            2.0 * MARGIN
        } else {
            MARGIN
        };
        if x + 2.0 * MARK + width > SIZE[0] - end {
            if base + LINE > last {
                let more = format!("and {} more", all - place);
                pen.write(&more, set, Anchor::Start, [x, base]);
                return;
            }
            (x, base) = (MARGIN + MARK, base + LINE);
        }
        mark(pen.page, label, [x, base - 0.35 * TEXT], MARK);
        x += 2.0 * MARK;
        x += pen.write(&words, set, Anchor::Start, [x, base]) + 4.0 * MARK;
    }
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
        let marks = LabelMark::of_subjects(&study);
        let fonts = FigureFonts::load().unwrap();
        let mut page = sheet();
        legend(&mut pen(&mut page, &fonts), &study, &marks, 100.0);
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
        let marks = LabelMark::of_subjects(&study);
        let base = SIZE[1] - MARGIN - 3.5 * LINE;
        legend(&mut pen(&mut page, &fonts), &study, &marks, base);
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

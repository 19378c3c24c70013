//! The maps of the study: a mark for every heart, shape and colour by its label.

use crate::picture::figure::Pen;
use crate::picture::page::{Anchor, FigureFonts, Page};
use crate::picture::report::map_names::{Name, placed};
use crate::picture::report::order::ReportOrder;
use crate::picture::report::sheet::{LINE, MARGIN, SIZE, TEXT, THEME, pen, sheet};
use crate::picture::tokens::srgb;
use crate::study::LabelRole;

/// Side of a plot.
const SIDE: f32 = 640.0;
/// Half the size of a mark.
const MARK: f32 = 6.0;
/// Widths of marks and of paths.
const STROKES: [f32; 2] = [2.4, 1.0];
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
    let mut page = sheet();
    let mut pen = pen(&mut page, fonts);
    let mut top = MARGIN;
    for plot in &plots {
        draw(&mut pen, order, plot, top);
        top += SIDE + 4.0 * LINE;
    }
    legend(&mut pen, SIZE[1] - MARGIN - 1.2 * LINE);
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

fn draw(pen: &mut Pen<'_>, order: &ReportOrder<'_>, plot: &Plot, top: f32) {
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
        let colour = role_colour(role_of(order, *subject));
        let line: Vec<[f32; 2]> = path.iter().map(place).collect();
        let pale = colour.map(|channel| 1.0 - PALE * (1.0 - channel));
        pen.page.line(&line, false, STROKES[1], pale);
    }
    write_names(pen, order, plot, place, frame);
    for (subject, path) in &plot.paths {
        let role = role_of(order, *subject);
        for (step, point) in path.iter().enumerate() {
            let size = if step == 0 { MARK } else { 0.5 * MARK };
            mark(pen.page, role, place(point), size);
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

fn role_of(order: &ReportOrder<'_>, subject: usize) -> LabelRole {
    let subject = order.study.subjects.get(subject);
    subject.map_or(LabelRole::Unknown, |subject| order.study.role(subject))
}

fn role_colour(role: LabelRole) -> [f32; 3] {
    match role {
        LabelRole::Normal => srgb(0x1f_6fb5),
        LabelRole::Abnormal => srgb(0xc2_571f),
        LabelRole::Unknown => THEME.muted,
    }
}

/// A disc, a cross or a square, as in the window.
fn mark(page: &mut Page, role: LabelRole, [x, y]: [f32; 2], size: f32) {
    let colour = role_colour(role);
    match role {
        LabelRole::Normal => {
            // A line without length has round ends: a disc.
            page.line(&[[x, y], [x + 0.01, y]], false, 2.0 * size, colour);
        }
        LabelRole::Abnormal => {
            for turn in [1.0, -1.0] {
                let ends = [[x - size, y - turn * size], [x + size, y + turn * size]];
                page.line(&ends, false, STROKES[0], colour);
            }
        }
        LabelRole::Unknown => {
            let side = 0.9 * size;
            page.rectangle([x - side, y - side], [x + side, y + side], colour);
        }
    }
}

fn legend(pen: &mut Pen<'_>, base: f32) {
    let mut x = MARGIN + MARK;
    for (role, name) in [
        (LabelRole::Normal, "normal"),
        (LabelRole::Abnormal, "abnormal"),
        (LabelRole::Unknown, "other or no label"),
    ] {
        mark(pen.page, role, [x, base - 0.35 * TEXT], MARK);
        let set = pen.regular(THEME.muted);
        x += 2.0 * MARK;
        x += pen.write(name, set, Anchor::Start, [x, base]) + 4.0 * MARK;
    }
}

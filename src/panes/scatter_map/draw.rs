//! Draws points and paths of every map, flat or in 3D: shape and colour by label, size by phase, the
//! selection on top.

use std::ops::Range;

use egui::{Color32, Painter, Pos2, Rect, Shape, Stroke, Ui, vec2};

use crate::ui::label_marks::label_shape;
use crate::ui::theme::{Colours, colours, line};

use super::labels::Labels;
use super::path::paths;
use super::point::PosePhase;
use super::view::ScatterView;

/// How places of a map come onto the screen.
pub trait Projection {
    /// Whether some points lie behind others.
    const HAS_DEPTH: bool;

    /// The part of the screen that is drawn on.
    fn rect(&self) -> Rect;

    /// Where a place at a share of the cycle is on screen, and its depth; nearer is less.
    fn see(&self, at: [f64; 2], share: f64) -> (Pos2, f32);

    /// How much of its colour something keeps at a depth.
    fn fade(&self, depth: f32) -> f32;
}

/// What the pointer or the keyboard is on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Pointed {
    /// The point.
    pub point: Option<usize>,
    /// The subject, which may be pointed at in another map.
    pub subject: Option<usize>,
}

/// Draws all points; `current` are the places of the present position, with their colours.
pub fn draw_points(
    ui: &Ui,
    view: &ScatterView,
    projection: &impl Projection,
    current: &[(Pos2, Color32)],
    pointed: Pointed,
) {
    let points = view.points.iter();
    let canvas = Canvas {
        painter: ui.painter_at(projection.rect()),
        colours: colours(ui),
        view,
        projection,
        seen: points.map(|p| projection.see(p.at, p.share)).collect(),
    };
    canvas.resting();
    canvas.links();
    let [selected, compared] = [
        (view.selected, canvas.colours.selection),
        (view.compared, canvas.colours.strong),
    ];
    // The selection lies on top, and its labels choose their places first.
    for (subject, colour) in [compared, selected] {
        canvas
            .of(subject)
            .for_each(|path| canvas.chosen(path, colour));
    }
    let mut labels = Labels::new(&canvas.painter, projection.rect(), canvas.colours.pane);
    for (at, _) in current {
        labels.keep_free(Rect::from_center_size(*at, vec2(14.0, 14.0)));
    }
    for path in canvas.of(view.selected).chain(canvas.of(view.compared)) {
        if path.len() == 1 {
            let at = canvas.seen[path.start].0;
            labels.keep_free(Rect::from_center_size(at, vec2(20.0, 20.0)));
        }
    }
    for (subject, colour) in [selected, compared] {
        canvas
            .of(subject)
            .for_each(|path| canvas.names(path, colour, &mut labels));
    }
    for (at, colour) in current {
        canvas.current(*at, *colour);
    }
    canvas.pointed(pointed);
}

/// Strength of marks that are not selected: each label stands out from the pane by a contrast of 3.
const RESTING: f32 = 0.85;

/// Strength of subjects that the filter leaves out: seen as where the others lie, and no more.
const FILTERED_OUT: f32 = 0.16;

/// Radius at rest and when selected, and whether the mark is filled: end-diastole is filled and large,
/// end-systole open and large, other poses small.
fn mark(phase: PosePhase) -> (f32, f32, bool) {
    match phase {
        PosePhase::EndDiastole => (4.0, 5.4, true),
        PosePhase::EndSystole => (4.0, 5.4, false),
        PosePhase::Between => (2.0, 2.7, true),
        PosePhase::WholeMotion => (4.5, 5.5, true),
    }
}

/// Places that a line goes through, how far away, and whether it is dashed.
struct Run {
    places: Vec<Pos2>,
    depth: f32,
    dashed: bool,
}

impl Run {
    fn shape(self, width: f32, colour: Color32) -> Shape {
        if self.dashed {
            let stroke = Stroke::new(width, colour.gamma_multiply(0.7));
            Shape::Vec(Shape::dashed_line(&self.places, stroke, 2.0, 3.0))
        } else {
            Shape::line(self.places, Stroke::new(width, colour))
        }
    }
}

struct Canvas<'a, P> {
    painter: Painter,
    colours: &'static Colours,
    view: &'a ScatterView<'a>,
    projection: &'a P,
    /// Place and depth of each point.
    seen: Vec<(Pos2, f32)>,
}

impl<P: Projection> Canvas<'_, P> {
    /// Paths of one subject.
    fn of(&self, subject: Option<usize>) -> impl Iterator<Item = Range<usize>> {
        paths(self.view.points)
            .filter(move |path| Some(self.view.points[path.start].subject) == subject)
    }

    /// Lines of a path, dashed where nothing is known between two points and from the last point
    /// back to the first at the end of the cycle. `split` keeps each line for itself.
    fn runs(&self, path: &Range<usize>, split: bool) -> Vec<Run> {
        let mut runs: Vec<Run> = Vec::new();
        for index in path.start + 1..path.end {
            let (from, to) = (self.seen[index - 1], self.seen[index]);
            let dashed = !self.view.points[index - 1].leads_to(&self.view.points[index]);
            match runs.last_mut() {
                Some(run) if !(split || dashed || run.dashed) => run.places.push(to.0),
                _ => runs.push(Run {
                    places: vec![from.0, to.0],
                    depth: 0.5 * (from.1 + to.1),
                    dashed,
                }),
            }
        }
        if path.len() > 2 {
            let (end, depth) = self.projection.see(self.view.points[path.start].at, 1.0);
            runs.push(Run {
                places: vec![self.seen[path.end - 1].0, end],
                depth,
                dashed: true,
            });
        }
        runs
    }

    /// What is not selected, from back to front; marks lie on their lines.
    fn resting(&self) {
        let mut pieces: Vec<(f32, Shape)> = Vec::new();
        let others = || {
            paths(self.view.points)
                .filter(|path| !self.view.is_chosen(self.view.points[path.start].subject))
        };
        for path in others() {
            let subject = self.view.points[path.start].subject;
            for run in self.runs(&path, P::HAS_DEPTH) {
                let colour = self.resting_colour(subject, 0.30, run.depth);
                pieces.push((run.depth, run.shape(line::THIN, colour)));
            }
        }
        for index in others().flatten() {
            let point = &self.view.points[index];
            let (at, depth) = self.seen[index];
            let colour = self.resting_colour(point.subject, RESTING, depth);
            let (radius, _, filled) = mark(point.phase);
            if self.projection.rect().expand(8.0).contains(at) {
                let label = self.view.mark(point.subject);
                let shape = label_shape(at, radius, label, colour, filled);
                pieces.push((depth - 0.01, shape));
            }
        }
        pieces.sort_by(|a, b| b.0.total_cmp(&a.0));
        self.painter
            .extend(pieces.into_iter().map(|(_, shape)| shape));
    }

    /// The label's colour, nearer to that of the pane the weaker it is.
    fn resting_colour(&self, subject: usize, strength: f32, depth: f32) -> Color32 {
        let filtered = if self.view.is_filtered_out(subject) {
            FILTERED_OUT
        } else {
            1.0
        };
        let dimmed = if self.view.out_of_date() {
            0.45 * filtered
        } else {
            filtered
        };
        let strength = (strength * dimmed * self.projection.fade(depth)).clamp(0.0, 1.0);
        let colour = self.view.mark(subject).colour(self.colours);
        self.colours.pane.lerp_to_gamma(colour, strength)
    }

    /// Dashes from points of the selected subject to those of the subjects nearest to it.
    fn links(&self) {
        let stroke = Stroke::new(line::THIN, self.colours.selection.gamma_multiply(0.55));
        for index in self.of(self.view.selected).flatten() {
            for other in &self.view.points[index].nearest {
                let ends = self.of(Some(*other)).flatten().next();
                if let Some(end) = ends.map(|end| self.seen[end].0) {
                    let ends = [self.seen[index].0, end];
                    self.painter
                        .extend(Shape::dashed_line(&ends, stroke, 3.0, 3.0));
                }
            }
        }
    }

    fn chosen(&self, path: Range<usize>, colour: Color32) {
        for run in self.runs(&path, false) {
            self.painter.add(run.shape(line::STRONG, colour));
        }
        for index in path {
            let point = &self.view.points[index];
            let at = self.seen[index].0;
            let (_, radius, filled) = mark(point.phase);
            let label = self.view.mark(point.subject);
            let shape = label_shape(at, radius, label, colour, filled);
            if point.phase == PosePhase::WholeMotion {
                // A single point has no path that stands out: it gets a ring.
                self.painter.circle_filled(at, 8.5, self.colours.pane);
                self.painter.add(shape);
                let ring = Stroke::new(line::MARK, colour);
                self.painter.circle_stroke(at, 9.5, ring);
            } else {
                self.painter.add(shape);
            }
        }
    }

    /// Names the points of a path that have a label, where there is room.
    fn names(&self, path: Range<usize>, colour: Color32, labels: &mut Labels) {
        let single = path.len() == 1;
        // The label of a single point hides as little as can be of all points.
        let around = if single {
            0..self.seen.len()
        } else {
            path.clone()
        };
        let around: Vec<Pos2> = self.seen[around].iter().map(|seen| seen.0).collect();
        for index in path {
            let at = self.seen[index].0;
            if let Some(text) = self.view.label(&self.view.points[index]) {
                let gap = if single { 14.0 } else { 9.0 };
                labels.beside(at, gap, text, colour, &around);
            }
        }
    }

    fn current(&self, at: Pos2, colour: Color32) {
        self.painter.circle_filled(at, 6.5, self.colours.pane);
        self.painter.circle_filled(at, 4.5, colour);
        let stroke = Stroke::new(line::MARK, colour);
        self.painter.circle_stroke(at, 6.5, stroke);
    }

    /// A ring around the point, and the path of its subject.
    fn pointed(&self, pointed: Pointed) {
        let ring = Stroke::new(line::MARK, self.colours.strong);
        let unchosen = |subject: &usize| !self.view.is_chosen(*subject);
        for path in self.of(pointed.subject.filter(unchosen)) {
            if path.len() == 1 {
                let at = self.seen[path.start].0;
                self.painter.circle_stroke(at, 9.0, ring);
            }
            for run in self.runs(&path, false) {
                self.painter
                    .add(run.shape(line::STRONG, self.colours.strong));
            }
        }
        if let Some(point) = pointed.point.and_then(|index| self.view.points.get(index)) {
            let at = self.projection.see(point.at, point.share).0;
            let radius = match point.phase {
                PosePhase::WholeMotion => 11.5,
                PosePhase::EndDiastole | PosePhase::EndSystole | PosePhase::Between => 9.0,
            };
            self.painter.circle_stroke(at, radius, ring);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ui::LabelMark;
    use crate::ui::theme::{DARK, LIGHT, contrast};

    #[test]
    fn marks_that_are_not_selected_are_seen_in_both_themes() {
        let labels = (0..8).map(LabelMark::Label);
        let marks = labels.chain([LabelMark::Normal, LabelMark::Unlabelled]);
        for mark in marks {
            for theme in [DARK, LIGHT] {
                let resting = theme.pane.lerp_to_gamma(mark.colour(&theme), RESTING);
                let found = contrast(resting, theme.pane);
                assert!(found >= 3.0, "{mark:?}: {found:.2}");
            }
        }
    }
}

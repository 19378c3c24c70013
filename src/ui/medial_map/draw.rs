//! Draws the map: a light grid, the paths of still parts, their steps, and the selection on top.

use egui::{Color32, Painter, Pos2, Rect, Sense, Shape, Stroke, Ui, UiBuilder, vec2};

use crate::study::LabelRole;
use crate::ui::map_ground::{Ground, Labels, MapState, role_counts_ui};
use crate::ui::marks::role_mark;
use crate::ui::medial_map::{MedialMapView, MedialPoint};
use crate::ui::pose_map::PosePhase;
use crate::ui::style::note;
use crate::ui::theme::{Colours, colours, line, space};

/// Draws everything within the pane; `hovered` is a point under the pointer.
pub fn draw_map(ui: &Ui, view: &MedialMapView, ground: &Ground, hovered: Option<usize>) {
    let painter = ui.painter_at(ground.rect);
    let colours = colours(ui);
    ground.draw_grid(ui);
    let canvas = Canvas {
        painter: &painter,
        ground,
        colours,
        dimmed: !matches!(view.state, MapState::Ready | MapState::Empty),
    };
    let of = |subject: Option<usize>| {
        paths(view.points).filter(move |path| Some(path[0].subject) == subject)
    };
    let chosen = |path: &&[MedialPoint]| {
        let subject = Some(path[0].subject);
        subject == view.selected || subject == view.compared
    };
    for path in paths(view.points).filter(|path| !chosen(path)) {
        canvas.path(path, canvas.resting(role_of(view, path), 0.30), line::THIN);
    }
    let strength = if view.selected.is_some() { 0.72 } else { 0.95 };
    for path in paths(view.points).filter(|path| !chosen(path)) {
        let role = role_of(view, path);
        for point in path {
            let faded = match point.phase {
                PosePhase::Between => 0.55 * strength,
                _ => strength,
            };
            canvas.point(point, role, canvas.resting(role, faded), 1.0);
        }
    }
    // The selected paths lie on top, and their names choose their places first.
    of(view.compared).for_each(|path| canvas.chosen(view, path, colours.strong));
    of(view.selected).for_each(|path| canvas.chosen(view, path, colours.selection));
    let mut labels = Labels::new(&painter, ground.rect, colours.pane);
    for at in &view.current {
        labels.keep_free(Rect::from_center_size(canvas.place(*at), vec2(14.0, 14.0)));
    }
    let several = |subject: Option<usize>| of(subject).count() > 1;
    for (subject, colour) in [
        (view.selected, colours.selection),
        (view.compared, colours.strong),
    ] {
        let numbered = several(subject);
        of(subject).for_each(|path| canvas.name(view, path, numbered, colour, &mut labels));
    }
    view.current.iter().for_each(|at| canvas.current(*at));
    if let Some(point) = hovered.and_then(|index| view.points.get(index)) {
        let at = ground.on_screen(point.at);
        painter.circle_stroke(at, 9.0, Stroke::new(line::MARK, colours.strong));
    }
}

/// Runs of steps of one path.
fn paths(points: &[MedialPoint]) -> impl Iterator<Item = &[MedialPoint]> {
    points.chunk_by(MedialPoint::shares_path)
}

fn role_of(view: &MedialMapView, path: &[MedialPoint]) -> LabelRole {
    let subject = view.subjects.get(path[0].subject);
    subject.map(|subject| subject.role).unwrap_or_default()
}

struct Canvas<'a> {
    painter: &'a Painter,
    ground: &'a Ground,
    colours: &'a Colours,
    dimmed: bool,
}

impl Canvas<'_> {
    fn place(&self, at: [f64; 2]) -> Pos2 {
        self.ground.on_screen(at)
    }

    /// Colour of what is not selected.
    fn resting(&self, role: LabelRole, strength: f32) -> Color32 {
        let strength = if self.dimmed {
            0.45 * strength
        } else {
            strength
        };
        self.colours
            .pane
            .lerp_to_gamma(self.colours.role(role), strength)
    }

    /// Lines from step to step; dashes where steps between tell nothing, and back to the first.
    fn path(&self, path: &[MedialPoint], colour: Color32, width: f32) {
        let closing = (path.len() > 2).then(|| (path[path.len() - 1], path[0]));
        for (from, to) in path
            .windows(2)
            .map(|both| (both[0], both[1]))
            .chain(closing)
        {
            let ends = [self.place(from.at), self.place(to.at)];
            let follows = from.to == to.from && to.from > from.from;
            if follows {
                let stroke = Stroke::new(width, colour);
                self.painter.line_segment(ends, stroke);
            } else {
                let stroke = Stroke::new(width, colour.gamma_multiply(0.7));
                self.painter
                    .extend(Shape::dashed_line(&ends, stroke, 2.0, 3.0));
            }
        }
    }

    /// A step from end-diastole is filled and large, from end-systole open and large, others are small.
    fn point(&self, point: &MedialPoint, role: LabelRole, colour: Color32, grow: f32) {
        let at = self.place(point.at);
        if !self.ground.rect.expand(8.0).contains(at) {
            return;
        }
        let (radius, filled) = match point.phase {
            PosePhase::EndDiastole => (4.0, true),
            PosePhase::EndSystole => (4.0, false),
            PosePhase::Between => (2.0, true),
        };
        role_mark(self.painter, at, radius * grow, role, colour, filled);
    }

    fn chosen(&self, view: &MedialMapView, path: &[MedialPoint], colour: Color32) {
        let role = role_of(view, path);
        self.path(path, colour, line::STRONG);
        for point in path {
            self.point(point, role, colour, 1.35);
        }
    }

    /// Names a path beside its first step.
    fn name(
        &self,
        view: &MedialMapView,
        path: &[MedialPoint],
        numbered: bool,
        colour: Color32,
        labels: &mut Labels,
    ) {
        let id = view
            .subjects
            .get(path[0].subject)
            .map_or("", |subject| &subject.id);
        let text = match path[0].patch {
            Some(patch) if numbered => format!("{id} patch {}", patch + 1),
            Some(_) => format!("{id} patch"),
            None => id.to_owned(),
        };
        let places: Vec<Pos2> = path.iter().map(|point| self.place(point.at)).collect();
        labels.beside(places[0], 9.0, text, colour, &places);
    }

    fn current(&self, current: [f64; 2]) {
        let at = self.place(current);
        self.painter.circle_filled(at, 6.5, self.colours.pane);
        self.painter.circle_filled(at, 4.5, self.colours.selection);
        self.painter
            .circle_stroke(at, 6.5, Stroke::new(line::MARK, self.colours.selection));
    }
}

/// Counts of roles on the left, how far the map can be trusted on the right.
pub fn legend_ui(ui: &mut Ui, view: &MedialMapView, height: f32) {
    let (strip, _) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::hover());
    let inner = strip.shrink2(vec2(space::LARGE, 0.0));
    let mut row = ui.new_child(UiBuilder::new().max_rect(inner));
    row.set_height(height);
    let wide = inner.width() > 330.0;
    egui::Sides::new()
        .height(height)
        .shrink_right()
        .truncate()
        .show(
            &mut row,
            |ui| role_counts_ui(ui, view.mapped, wide),
            |ui| {
                if ui.available_width() < 70.0 {
                    return;
                }
                ui.label(note(trust_text(view)))
                    .on_hover_text(explanation(view));
            },
        );
}

const WHAT: &str = "A point is a step of the beat: mean position, mean ratio of thickness and mean normal \
                    of the atoms that stand still in it, of each patch or, without one, of the whole wall. \
                    Kruskal's stress 1 tells how far distances on the map are from those: below 0.1 is good, \
                    above 0.2 the map misleads. Filled marks begin at end-diastole, open ones at end-systole; \
                    the axes have no unit.";

/// "stress 0.09 · 3 not on the map".
pub fn trust_text(view: &MedialMapView) -> String {
    let stress = view.stress.map(|stress| format!("stress {stress:.2}"));
    let rest = match view.left_out_count {
        0 => "axes have no unit".to_owned(),
        count => format!("{count} not on the map"),
    };
    let parts = stress.into_iter().chain([rest]);
    parts.collect::<Vec<_>>().join(" · ")
}

/// Lines of the hover that are shown of hearts that are not on the map.
const MOST_LINES: usize = 12;

fn explanation(view: &MedialMapView) -> String {
    let mut text = format!("{WHAT}\nCompared by {}.", view.frame);
    if view.left_out_count > 0 {
        let lines = view.left_out.lines().take(MOST_LINES);
        text += "\nNot on the map:";
        lines.for_each(|line| text += &format!("\n{line}"));
        if view.left_out_count > MOST_LINES {
            text += &format!("\nand {} more", view.left_out_count - MOST_LINES);
        }
    }
    text
}

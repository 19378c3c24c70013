//! Draws the map: a light grid, paths, points, and the selection on top.

use egui::{Color32, Painter, Pos2, Rect, Sense, Shape, Stroke, Ui, UiBuilder, vec2};

use crate::study::LabelRole;
use crate::ui::map_ground::{Ground, Labels, MapState, role_counts_ui};
use crate::ui::marks::role_mark;
use crate::ui::pose_map::{MapPoint, PoseMapView, PosePhase};
use crate::ui::style::note;
use crate::ui::theme::{Colours, colours, line, space};

/// Draws everything within the pane; `hovered` is a point under the pointer.
pub fn draw_map(ui: &Ui, view: &PoseMapView, ground: &Ground, hovered: Option<usize>) {
    let painter = ui.painter_at(ground.rect);
    let colours = colours(ui);
    ground.draw_grid(ui);
    let dimmed = !matches!(view.state, MapState::Ready | MapState::Empty);
    let canvas = Canvas {
        painter: &painter,
        ground,
        colours,
        dimmed,
    };
    let chosen = |subject: usize| Some(subject) == view.selected || Some(subject) == view.compared;
    for path in paths(view.points).filter(|path| !chosen(path[0].subject)) {
        canvas.path(path, canvas.resting(role_of(view, path), 0.30), line::THIN);
    }
    for point in view.points.iter().filter(|point| !chosen(point.subject)) {
        let role = view
            .subjects
            .get(point.subject)
            .map(|s| s.role)
            .unwrap_or_default();
        let strength = if view.selected.is_some() { 0.72 } else { 0.95 };
        let strength = match point.phase {
            PosePhase::Between => 0.55 * strength,
            _ => strength,
        };
        canvas.point(point, role, canvas.resting(role, strength), 1.0);
    }
    // The selected path lies on top, and its names choose their places first.
    let compared = || paths(view.points).filter(|path| Some(path[0].subject) == view.compared);
    let selected = || paths(view.points).filter(|path| Some(path[0].subject) == view.selected);
    compared().for_each(|path| canvas.chosen(view, path, colours.strong));
    selected().for_each(|path| canvas.chosen(view, path, colours.selection));
    let mut labels = Labels::new(&painter, ground.rect, colours.pane);
    if let Some(at) = view.current {
        labels.keep_free(Rect::from_center_size(canvas.place(at), vec2(14.0, 14.0)));
    }
    selected().for_each(|path| canvas.names(view, path, colours.selection, &mut labels));
    compared().for_each(|path| canvas.names(view, path, colours.strong, &mut labels));
    if let Some(current) = view.current {
        canvas.current(current);
    }
    if let Some(point) = hovered.and_then(|index| view.points.get(index)) {
        let at = ground.on_screen(point.at);
        painter.circle_stroke(at, 9.0, Stroke::new(line::MARK, colours.strong));
    }
}

/// Runs of points of one subject.
fn paths(points: &[MapPoint]) -> impl Iterator<Item = &[MapPoint]> {
    points.chunk_by(|a, b| a.subject == b.subject)
}

fn role_of(view: &PoseMapView, path: &[MapPoint]) -> LabelRole {
    view.subjects
        .get(path[0].subject)
        .map(|subject| subject.role)
        .unwrap_or_default()
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

    fn path(&self, path: &[MapPoint], colour: Color32, width: f32) {
        let places: Vec<Pos2> = path.iter().map(|point| self.place(point.at)).collect();
        if places.len() > 2 {
            // The last pose runs into the first.
            let closing = [places[places.len() - 1], places[0]];
            let stroke = Stroke::new(width, colour.gamma_multiply(0.7));
            self.painter
                .extend(Shape::dashed_line(&closing, stroke, 2.0, 3.0));
        }
        if places.len() > 1 {
            self.painter
                .add(Shape::line(places, Stroke::new(width, colour)));
        }
    }

    /// End-diastole is filled and large, end-systole open and large, other poses small.
    fn point(&self, point: &MapPoint, role: LabelRole, colour: Color32, grow: f32) {
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

    fn chosen(&self, view: &PoseMapView, path: &[MapPoint], colour: Color32) {
        let role = role_of(view, path);
        self.path(path, colour, line::STRONG);
        for point in path {
            self.point(point, role, colour, 1.35);
        }
    }

    /// Names end-diastole and end-systole of a path, where there is room.
    fn names(&self, view: &PoseMapView, path: &[MapPoint], colour: Color32, labels: &mut Labels) {
        let id = view
            .subjects
            .get(path[0].subject)
            .map_or("", |subject| &subject.id);
        let places: Vec<Pos2> = path.iter().map(|point| self.place(point.at)).collect();
        for point in path {
            let text = match point.phase {
                PosePhase::EndDiastole => format!("{id} ED"),
                PosePhase::EndSystole => format!("{id} ES"),
                PosePhase::Between => continue,
            };
            labels.beside(self.place(point.at), 9.0, text, colour, &places);
        }
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
pub fn legend_ui(ui: &mut Ui, view: &PoseMapView, height: f32) {
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
            |ui| role_counts_ui(ui, view.subjects, wide),
            |ui| {
                if ui.available_width() < 70.0 {
                    return;
                }
                let text = trust_text(view);
                ui.label(note(text.clone()))
                    .on_hover_text(format!("{text}. {WHAT}"));
            },
        );
}

const WHAT: &str = "Kruskal's stress 1 tells how far distances on the map are from those between \
                    poses: below 0.1 is good, above 0.2 the map misleads. Only distances between \
                    points mean something; the axes have no unit. Filled marks are end-diastole, \
                    open ones end-systole.";

fn trust_text(view: &PoseMapView) -> String {
    let stress = view.stress.map(|stress| format!("stress {stress:.2}"));
    let neighbours = view
        .neighbours
        .map(|neighbours| format!("{neighbours} neighbours"));
    let rest = if view.left_out.is_empty() {
        "axes have no unit"
    } else {
        view.left_out
    };
    let parts = stress.into_iter().chain(neighbours);
    parts
        .chain([rest.to_owned()])
        .collect::<Vec<_>>()
        .join(" · ")
}

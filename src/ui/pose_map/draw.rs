//! Draws the map: a light grid, paths, points, and the selection on top.

use egui::{Align2, Color32, Painter, Pos2, Rect, Sense, Shape, Stroke, Ui, UiBuilder, pos2, vec2};

use crate::picture::nice_floor;
use crate::study::LabelRole;
use crate::ui::marks::{role_mark, role_name};
use crate::ui::pose_map::lens::Lens;
use crate::ui::pose_map::{MapPoint, MapState, PoseMapView, PosePhase};
use crate::ui::style::{medium_note_font, note, note_font};
use crate::ui::theme::{Colours, colours, line, space};

/// Draws everything within the pane; `hovered` is a point under the pointer.
pub fn draw_map(ui: &Ui, view: &PoseMapView, rect: Rect, lens: &Lens, hovered: Option<usize>) {
    let painter = ui.painter_at(rect);
    let colours = colours(ui);
    draw_grid(&painter, rect, lens, colours);
    let dimmed = !matches!(view.state, MapState::Ready | MapState::Empty);
    let canvas = Canvas {
        painter: &painter,
        rect,
        lens,
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
    let mut taken: Vec<Rect> = Vec::new();
    taken.extend(
        view.current
            .map(|at| Rect::from_center_size(canvas.place(at), vec2(14.0, 14.0))),
    );
    selected().for_each(|path| canvas.names(view, path, colours.selection, &mut taken));
    compared().for_each(|path| canvas.names(view, path, colours.strong, &mut taken));
    if let Some(current) = view.current {
        canvas.current(current);
    }
    if let Some(point) = hovered.and_then(|index| view.points.get(index)) {
        let at = lens.on_screen(rect, point.at);
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
    rect: Rect,
    lens: &'a Lens,
    colours: &'a Colours,
    dimmed: bool,
}

impl Canvas<'_> {
    fn place(&self, at: [f64; 2]) -> Pos2 {
        self.lens.on_screen(self.rect, at)
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
        if !self.rect.expand(8.0).contains(at) {
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
    fn names(&self, view: &PoseMapView, path: &[MapPoint], colour: Color32, taken: &mut Vec<Rect>) {
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
            self.label(self.place(point.at), text, colour, &places, taken);
        }
    }

    /// Writes beside a point, inside the pane, where it hides least of the path.
    fn label(&self, at: Pos2, text: String, colour: Color32, path: &[Pos2], taken: &mut Vec<Rect>) {
        let galley = self
            .painter
            .layout_no_wrap(text, medium_note_font(), colour);
        let size = galley.size();
        let (gap, middle) = (9.0, -0.5 * size.y);
        let left = -gap - size.x;
        let places = [
            vec2(gap, -size.y - 3.0),
            vec2(gap, 3.0),
            vec2(left, -size.y - 3.0),
            vec2(left, 3.0),
            vec2(gap, middle),
            vec2(left, middle),
            vec2(-0.5 * size.x, -size.y - gap),
            vec2(-0.5 * size.x, gap),
        ]
        .map(|offset| Rect::from_min_size(at + offset, size));
        let inside = self.rect.shrink(4.0);
        let free = |rect: &Rect| {
            inside.contains_rect(*rect) && taken.iter().all(|other| !other.intersects(*rect))
        };
        let hidden = |rect: &Rect| hidden_length(path, *rect) as i32;
        let Some(rect) = places.into_iter().filter(free).min_by_key(hidden) else {
            return;
        };
        let behind = self.colours.pane.gamma_multiply(0.7);
        self.painter
            .rect_filled(rect.expand2(vec2(3.0, 0.0)), 3.0, behind);
        self.painter.galley(rect.min, galley, colour);
        taken.push(rect);
    }

    fn current(&self, current: [f64; 2]) {
        let at = self.place(current);
        self.painter.circle_filled(at, 6.5, self.colours.pane);
        self.painter.circle_filled(at, 4.5, self.colours.selection);
        self.painter
            .circle_stroke(at, 6.5, Stroke::new(line::MARK, self.colours.selection));
    }
}

/// How much of a path, in points, lies within a rectangle; the path is closed.
fn hidden_length(path: &[Pos2], rect: Rect) -> f32 {
    let mut hidden = 0.0;
    for (index, from) in path.iter().enumerate() {
        let to = path[(index + 1) % path.len()];
        let steps = ((to - *from).length() / 2.0).ceil().clamp(1.0, 400.0);
        let inside = (0..steps as usize)
            .filter(|step| rect.contains(from.lerp(to, *step as f32 / steps)))
            .count();
        hidden += 2.0 * inside as f32;
    }
    hidden
}

fn draw_grid(painter: &Painter, rect: Rect, lens: &Lens, colours: &Colours) {
    let step = nice_floor(110.0 / lens.points_per_unit) * lens.points_per_unit;
    if !(step.is_finite() && step > 12.0) {
        return;
    }
    let origin = lens.on_screen(rect, [0.0, 0.0]);
    let stroke = Stroke::new(line::THIN, colours.grid);
    let step = step as f32;
    let mut x = rect.left() + (origin.x - rect.left()).rem_euclid(step);
    while x < rect.right() {
        painter.vline(x, rect.y_range(), stroke);
        x += step;
    }
    let mut y = rect.top() + (origin.y - rect.top()).rem_euclid(step);
    while y < rect.bottom() {
        painter.hline(rect.x_range(), y, stroke);
        y += step;
    }
}

/// Counts of roles on the left, what the axes are on the right.
pub fn legend_ui(ui: &mut Ui, view: &PoseMapView, height: f32) {
    let (strip, _) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::hover());
    let inner = strip.shrink2(vec2(space::LARGE, 0.0));
    let mut row = ui.new_child(UiBuilder::new().max_rect(inner));
    row.set_height(height);
    let wide = inner.width() > 240.0;
    egui::Sides::new().height(height).shrink_right().truncate().show(
        &mut row,
        |ui| {
            for role in [LabelRole::Normal, LabelRole::Abnormal, LabelRole::Unknown] {
                let count = view.subjects.iter().filter(|subject| subject.role == role).count();
                if count > 0 {
                    legend_entry_ui(ui, role, count, wide);
                }
            }
        },
        |ui| {
            if ui.available_width() < 80.0 {
                return;
            }
            let text = if view.left_out.is_empty() { "axes have no unit" } else { view.left_out };
            let what = "Only distances between points mean something: they stand for the distances \
                        between poses. Filled marks are end-diastole, open ones end-systole.";
            ui.label(note(text)).on_hover_text(format!("{text}. {what}"));
        },
    );
}

fn legend_entry_ui(ui: &mut Ui, role: LabelRole, count: usize, wide: bool) {
    let colours = colours(ui);
    ui.spacing_mut().item_spacing.x = space::SMALL;
    let (mark, _) = ui.allocate_exact_size(vec2(10.0, 12.0), Sense::hover());
    role_mark(
        ui.painter(),
        mark.center(),
        4.0,
        role,
        colours.role(role),
        role != LabelRole::Unknown,
    );
    let name = format!("{} {count}", role_name(role));
    let text = if wide {
        name.clone()
    } else {
        count.to_string()
    };
    let galley = ui
        .painter()
        .layout_no_wrap(text, note_font(), colours.muted);
    let (rect, response) = ui.allocate_exact_size(galley.size(), Sense::hover());
    let at = Align2::LEFT_CENTER
        .align_size_within_rect(galley.size(), rect)
        .min;
    ui.painter().galley(pos2(at.x, at.y), galley, colours.muted);
    response.on_hover_text(name);
    ui.add_space(space::MEDIUM);
}

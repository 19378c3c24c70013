//! What follows a picture of points, flat or in 3D: names for those who do not see it, the click, the
//! hover card, and what is said over a map that is out of date.

use egui::{Rect, Response, Role, Sense, Ui, WidgetInfo, vec2};

use crate::panes::commands::Command;
use crate::ui::marks::class_name;
use crate::ui::named_parts::{named_part, names_are_read};

use super::brush::brush;
use super::draw::{Pointed, Projection};
use super::hover::hover_ui;
use super::path::paths;
use super::state::over_map_ui;
use super::view::ScatterView;

/// What stands out: the point under the pointer or the keyboard, and its subject on all maps.
pub fn pointed_at(
    ui: &Ui,
    view: &ScatterView,
    response: &Response,
    point: Option<usize>,
) -> Pointed {
    let subject = point.and_then(|index| view.points.get(index));
    let subject = subject.map(|point| point.subject);
    Pointed {
        point,
        subject: brush(ui, response.id, subject),
    }
}

/// Answers to the pointer on a picture that is drawn; `hovered` and `clicked` are the points there.
pub fn respond_ui(
    ui: &mut Ui,
    view: &ScatterView,
    projection: &impl Projection,
    response: Response,
    hovered: Option<usize>,
    clicked: Option<usize>,
    commands: &mut Vec<Command>,
) {
    if let Some(point) = clicked.and_then(|index| view.points.get(index)) {
        commands.push((view.words.command)(point));
    }
    name_paths(ui, view, projection, &response);
    if names_are_read(&response) {
        name_points(ui, view, projection, &response, commands);
    }
    over_map_ui(ui, view, projection.rect(), commands);
    hover_ui(response, view, hovered);
}

/// With more points than these, only those of the chosen subjects have names of their own: nobody listens to a thousand
/// names, and a frame would wait for them.
const NAMED_POINTS: usize = 1000;

/// Names points for whoever does not see them; asked to click one, it does what a click does.
fn name_points(
    ui: &Ui,
    view: &ScatterView,
    projection: &impl Projection,
    canvas: &Response,
    commands: &mut Vec<Command>,
) {
    let many = view.points.len() > NAMED_POINTS;
    for point in view
        .points
        .iter()
        .filter(|point| !many || view.is_chosen(point.subject))
    {
        // A path of one point has the name of the path.
        if point.frames.is_none() {
            continue;
        }
        let (place, _) = projection.see(point.at, point.share);
        let rect = Rect::from_center_size(place, vec2(8.0, 8.0));
        let id = canvas.id.with(("point", point.key()));
        let chosen = view.selected == Some(point.subject);
        if named_part(ui, id, rect, chosen, &view.title(point)) {
            commands.push((view.words.command)(point));
        }
    }
}

/// Names paths for whoever does not see them, each in the middle of its cycle.
fn name_paths(ui: &Ui, view: &ScatterView, projection: &impl Projection, canvas: &Response) {
    for path in paths(view.points) {
        let point = &view.points[path.start + path.len() / 2];
        let Some(subject) = view.subjects.get(point.subject) else {
            continue;
        };
        let (place, _) = projection.see(point.at, point.share);
        let rect = Rect::from_center_size(place, vec2(8.0, 8.0));
        let id = canvas.id.with(("path", point.subject, point.patch));
        let chosen = view.selected == Some(point.subject);
        ui.interact(rect, id, Sense::hover()).widget_info(|| {
            let item = view.words.item;
            let path = view.path_name(&subject.id, point);
            let name = format!("{item} of {path}, {}", class_name(subject.class));
            WidgetInfo::selected(Role::ListItem, true, chosen, name)
        });
    }
}

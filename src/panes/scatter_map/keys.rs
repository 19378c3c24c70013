//! The keyboard on a map: arrows go from point to point, Enter does what a click does.

use egui::{Key, Response, Role, Ui, Vec2, WidgetInfo};

use crate::panes::commands::Command;

use super::input::pressed_arrows;
use super::point::ScatterPoint;
use super::view::ScatterView;

/// The place in the list of points of the one that the keyboard was on last.
#[derive(Clone, Copy, Debug)]
pub(super) struct OnKey(usize);

/// The point that the keyboard is on, while the map has it.
pub fn step(
    ui: &Ui,
    view: &ScatterView,
    response: &Response,
    commands: &mut Vec<Command>,
) -> Option<usize> {
    if !response.has_focus() {
        return None;
    }
    let id = response.id.with("on key");
    let kept: Option<OnKey> = ui.data(|data| data.get_temp(id));
    let mut points = view.points.iter();
    let selected = points.position(|point| Some(point.subject) == view.selected);
    let mut here = kept
        .map(|OnKey(index)| index)
        .filter(|index| *index < view.points.len())
        .or(selected)
        .unwrap_or(0);
    for arrow in pressed_arrows(ui, response) {
        here = next(view.points, here, arrow).unwrap_or(here);
    }
    ui.data_mut(|data| data.insert_temp(id, OnKey(here)));
    let point = view.points.get(here)?;
    if ui.input(|input| input.key_pressed(Key::Enter)) {
        commands.push((view.words.command)(point));
    }
    response.widget_info(|| {
        let mut info = WidgetInfo::labeled(Role::Canvas, true, view.words.name);
        info.current_text_value = Some(view.title(point));
        info
    });
    Some(here)
}

/// The nearest point on one side: what lies aside counts twice, so that steps go where the arrow
/// points. `None` where nothing lies on that side.
fn next(points: &[ScatterPoint], here: usize, arrow: Vec2) -> Option<usize> {
    let from = points.get(here)?.at;
    // The map's second axis points up, that of the screen down.
    let direction = [f64::from(arrow.x), f64::from(-arrow.y)];
    points
        .iter()
        .map(|point| point.at)
        .enumerate()
        .filter(|(index, _)| *index != here)
        .filter_map(|(index, place)| {
            let offset = [place[0] - from[0], place[1] - from[1]];
            let ahead = offset[0] * direction[0] + offset[1] * direction[1];
            let aside = offset[0] * direction[1] - offset[1] * direction[0];
            (ahead > 0.0 && ahead.is_finite() && aside.abs() <= 2.0 * ahead)
                .then(|| (index, ahead + 2.0 * aside.abs()))
        })
        .min_by(|a, b| a.1.total_cmp(&b.1))
        .map(|(index, _)| index)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arrows_go_to_the_nearest_point_on_their_side() {
        let places = [[0.0, 0.0], [1.0, 0.1], [3.0, 0.0], [0.0, 2.0], [-1.0, 5.0]];
        let points = places.map(|at| ScatterPoint {
            at,
            ..ScatterPoint::default()
        });
        let go = |from, arrow: [f32; 2]| next(&points, from, arrow.into());
        assert_eq!(go(0, [1.0, 0.0]), Some(1));
        assert_eq!(go(1, [1.0, 0.0]), Some(2));
        assert_eq!(go(0, [0.0, -1.0]), Some(3));
        assert_eq!(go(2, [1.0, 0.0]), None);
    }
}

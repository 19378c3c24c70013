//! Names for parts of a picture that are no controls: points of a map, segments of a plot. Who cannot see the picture has
//! them read aloud; where nothing listens they cost nothing.

use egui::accesskit::Action;
use egui::{Id, Rect, Response, Role, Sense, Ui, WidgetInfo};

/// Whether anything listens to names in this frame, such as a screen reader; `picture` has one itself.
pub fn names_are_read(picture: &Response) -> bool {
    picture.ctx.has_accesskit_node(picture.id)
}

/// Names a part of a picture; whether it was asked to be clicked.
pub fn named_part(ui: &Ui, id: Id, rect: Rect, selected: bool, name: &str) -> bool {
    // The pointer goes through to the picture.
    let response = ui.interact(rect, id, Sense::hover());
    response.widget_info(|| WidgetInfo::selected(Role::ListItem, true, selected, name));
    ui.ctx()
        .accesskit_node_builder(id, |node| node.add_action(Action::Click));
    ui.input(|input| input.has_accesskit_action_request(id, Action::Click))
}

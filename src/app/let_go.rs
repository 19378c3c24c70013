//! What is let go of: what belonged to another list of subjects, and the keyboard after a click.

use egui::Context;

/// Another list of subjects is on screen, opened, edited or brought back by undo: what the pointer holds, what an open menu
/// is about and where a map was looked at belong to the one before.
pub fn let_go_of_study(ctx: &Context) {
    egui::DragAndDrop::clear_payload(ctx);
    egui::Popup::close_all(ctx);
    crate::panes::leave_study(ctx);
}

/// After a click the keys belong to the window again, unless the click went into a text: Space
/// plays and arrows step frames whatever was clicked before.
pub fn give_keyboard_back(ctx: &Context) {
    if !ctx.text_edit_focused()
        && let Some(focused) = ctx.memory(|memory| memory.focused())
    {
        ctx.memory_mut(|memory| memory.surrender_focus(focused));
    }
}

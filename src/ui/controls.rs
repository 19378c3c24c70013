//! The few controls that panels share: pane headers, tabs, icon buttons, choosers, progress.

use egui::{
    Align, Align2, Button, Color32, Context, Key, Layout, Margin, Order, Rect, Response, RichText,
    Role, ScrollArea, Sense, Stroke, StrokeKind, Ui, WidgetInfo, vec2,
};

use crate::ui::marks::{Icon, icon};
use crate::ui::style::{heading_font, medium, medium_font};
use crate::ui::theme::{colours, line, radius, space};

/// The strip on top of a pane: what it is on the left, its choices on the right.
///
/// The right side is drawn first and keeps its width; the left side gets what remains.
pub fn pane_header_ui(ui: &mut Ui, left: impl FnOnce(&mut Ui), right: impl FnOnce(&mut Ui)) {
    let (whole, _) = ui.allocate_exact_size(
        vec2(ui.available_width(), space::PANE_HEADER),
        Sense::hover(),
    );
    ui.painter().hline(
        whole.x_range(),
        whole.bottom(),
        Stroke::new(line::THIN, colours(ui).line),
    );
    let inner = whole.shrink2(vec2(space::LARGE, 0.0));
    ends_ui(ui, inner, right, |ui| {
        ui.spacing_mut().item_spacing.x = space::LARGE;
        ui.shrink_clip_rect(ui.max_rect().expand2(vec2(2.0, 2.0)));
        left(ui);
    });
}

/// The same with the title as plain words.
pub fn named_header_ui(ui: &mut Ui, title: &str, right: impl FnOnce(&mut Ui)) {
    let title = egui::Label::new(medium(title)).truncate();
    let left = |ui: &mut Ui| {
        ui.add(title);
    };
    pane_header_ui(ui, left, right);
}

/// Draws `right` at the right end of a row, then `left` into what remains of it.
pub fn ends_ui<R>(
    ui: &mut Ui,
    row: Rect,
    right: impl FnOnce(&mut Ui) -> R,
    left: impl FnOnce(&mut Ui),
) -> R {
    let end = |rect, layout: Layout| egui::UiBuilder::new().max_rect(rect).layout(layout);
    let mut right_ui = ui.new_child(end(row, Layout::right_to_left(Align::Center)));
    let answer = right(&mut right_ui);
    let edge = right_ui.min_rect().left() - space::MEDIUM;
    let rest = row.with_max_x(edge.max(row.left()));
    left(&mut ui.new_child(end(rest, Layout::left_to_right(Align::Center))));
    answer
}

/// Whether a click is the second of a double click or one right after it, which egui counts as a third.
pub fn clicked_twice(response: &Response) -> bool {
    response.double_clicked() || response.triple_clicked()
}

/// Whether a drag goes on that began on the widget itself: egui also gives a widget what is pressed a few points beside
/// it, such as in the header above.
pub fn dragged_from_within(ui: &Ui, response: &Response) -> bool {
    let began = ui.input(|input| input.pointer.press_origin());
    response.dragged() && began.is_some_and(|at| response.interact_rect.contains(at))
}

/// The content of a pane that scrolls, within its margin.
pub fn scrolled_ui(ui: &mut Ui, salt: &str, margin: Margin, add: impl FnOnce(&mut Ui)) {
    let area = ScrollArea::vertical().id_salt(salt).auto_shrink(false);
    area.show(ui, |ui| {
        egui::Frame::new().inner_margin(margin).show(ui, |ui| {
            ui.spacing_mut().item_spacing.y = 2.0;
            add(ui);
        });
    });
}

/// A tab; the one in front is underlined in the accent colour.
pub fn tab_ui(ui: &mut Ui, name: &str, in_front: bool) -> Response {
    let colours = colours(ui);
    let galley =
        (ui.painter()).layout_no_wrap(name.to_owned(), medium_font(), Color32::PLACEHOLDER);
    let size = vec2(galley.size().x, space::PANE_HEADER);
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    response.widget_info(|| WidgetInfo::selected(Role::Tab, true, in_front, name));
    let colour = if in_front || response.hovered() {
        colours.strong
    } else {
        colours.muted
    };
    let at = Align2::LEFT_CENTER.align_size_within_rect(galley.size(), rect);
    ui.painter().galley(at.min, galley, colour);
    if in_front {
        let y = rect.bottom() - 0.5 * line::STRONG;
        let stroke = Stroke::new(line::STRONG, colours.accent);
        ui.painter().hline(rect.x_range(), y, stroke);
    }
    focus_ring(ui, &response);
    response
}

/// Shows which control the keyboard is on.
pub fn focus_ring(ui: &Ui, response: &Response) {
    if response.has_focus() {
        ui.painter().rect_stroke(
            response.rect.expand2(vec2(3.0, -2.0)),
            f32::from(radius::CONTROL),
            Stroke::new(line::MARK, colours(ui).accent),
            StrokeKind::Inside,
        );
    }
}

/// A square button with a drawn symbol; `name` is read aloud and shown on hover.
pub fn icon_button_ui(ui: &mut Ui, symbol: Icon, name: &str, hint: &str, on: bool) -> Response {
    let side = ui.spacing().interact_size.y;
    let (rect, response) = ui.allocate_exact_size(vec2(side, side), Sense::click());
    let enabled = ui.is_enabled();
    response.widget_info(|| WidgetInfo::labeled(Role::Button, enabled, name));
    let colours = colours(ui);
    if response.hovered() && enabled {
        ui.painter()
            .rect_filled(rect, f32::from(radius::CONTROL), colours.control_hovered);
    }
    let colour = match (enabled, on) {
        (false, _) => colours.line,
        (true, true) => colours.accent,
        (true, false) => colours.text,
    };
    icon(ui.painter(), rect.center(), 0.42 * side, symbol, colour);
    focus_ring(ui, &response);
    response.on_hover_text(hint)
}

/// A plain button that opens a menu; `name` is what is chosen, `shown` the choice.
pub fn chooser_ui<R>(
    ui: &mut Ui,
    name: &str,
    shown: impl Into<String>,
    menu: impl FnOnce(&mut Ui) -> R,
) -> Response {
    let shown = shown.into();
    let padding = 14.0;
    let colour = colours(ui).muted;
    let text = RichText::new(shown.clone());
    let gap = " ".repeat(4);
    let button = Button::new((text, gap)).gap(0.0).truncate();
    let (response, _) = egui::containers::menu::MenuButton::from_button(button).ui(ui, |ui| {
        ui.set_min_width(180.0);
        menu(ui)
    });
    let enabled = ui.is_enabled();
    response
        .widget_info(|| WidgetInfo::labeled(Role::ComboBox, enabled, format!("{name}: {shown}")));
    let at = response.rect.right_center() - vec2(padding - 2.0, 0.0);
    icon(ui.painter(), at, 8.0, Icon::Open, colour);
    response.on_hover_text(name)
}

/// One choice in a menu; closes it.
pub fn choice_ui(ui: &mut Ui, name: &str, chosen: bool) -> bool {
    let clicked = ui.radio(chosen, name).clicked();
    if clicked {
        ui.close();
    }
    clicked
}

/// Choices in a menu by name; the one that was clicked.
pub fn choices_ui<T: Copy + PartialEq>(
    ui: &mut Ui,
    choices: impl IntoIterator<Item = (T, impl AsRef<str>)>,
    now: T,
) -> Option<T> {
    let mut clicked = None;
    for (choice, name) in choices {
        if choice_ui(ui, name.as_ref(), choice == now) {
            clicked = Some(choice);
        }
    }
    clicked
}

/// A thin bar that fills from the left.
pub fn progress_bar_ui(ui: &mut Ui, width: f32, fraction: f32, name: &str) -> Response {
    let colours = colours(ui);
    let height = 5.0;
    let (rect, response) =
        ui.allocate_exact_size(vec2(width, ui.spacing().interact_size.y), Sense::hover());
    response.widget_info(|| {
        let mut info = WidgetInfo::labeled(Role::ProgressIndicator, true, name);
        info.value = Some(f64::from(fraction));
        info
    });
    let bar = Rect::from_center_size(rect.center(), vec2(width, height));
    ui.painter().rect_filled(bar, 0.5 * height, colours.line);
    let mut filled = bar;
    filled.set_width(width * fraction.clamp(0.0, 1.0));
    ui.painter()
        .rect_filled(filled, 0.5 * height, colours.accent);
    response
}

/// An empty pane: a heading, what would fill it, and room for a button below.
pub fn empty_pane_ui(ui: &mut Ui, heading: &str, what: &str, buttons: impl FnOnce(&mut Ui)) {
    let height = 96.0;
    ui.vertical_centered(|ui| {
        ui.add_space(((ui.available_height() - height) * 0.4).max(space::LARGE));
        ui.label(medium(heading));
        ui.add(egui::Label::new(RichText::new(what).weak()).wrap());
        ui.add_space(space::MEDIUM);
        buttons(ui);
    });
}

/// What a pane about the selected subject says where none is selected.
pub fn no_subject_ui(ui: &mut Ui, what: &str) {
    empty_pane_ui(ui, "No subject selected", what, |_| {});
}

/// Whether Esc was pressed and closes nothing that lies over the window.
pub fn escaped(ui: &Ui) -> bool {
    let over = |order| matches!(order, Order::Middle | Order::Foreground);
    let covered = ui.memory(|memory| {
        let layers = memory.areas().visible_layer_ids();
        layers.iter().any(|layer| over(layer.order))
    });
    !covered && ui.input(|input| input.key_pressed(Key::Escape))
}

/// A small window over the middle of the program, with its own cross; true when Esc or the cross
/// asks to close it.
pub fn dialog_ui(
    ctx: &Context,
    title: &str,
    size: egui::Vec2,
    resizable: bool,
    add: impl FnOnce(&mut Ui),
) -> bool {
    let room = ctx.content_rect().shrink(space::LARGE);
    let size = size.min(room.size());
    let mut close = false;
    egui::Window::new(title)
        .title_bar(false)
        .resizable(resizable)
        .default_size(size)
        .default_pos(room.center() - 0.5 * size)
        .constrain_to(room)
        .show(ctx, |ui| {
            egui::Sides::new().show(
                ui,
                |ui| ui.label(RichText::new(title).font(heading_font())),
                |ui| {
                    close =
                        icon_button_ui(ui, Icon::Close, "Close", "Close (Esc)", false).clicked();
                },
            );
            ui.add_space(space::SMALL);
            add(ui);
        });
    let escaped = !ctx.any_popup_open() && ctx.input(|input| input.key_pressed(Key::Escape));
    close || escaped
}

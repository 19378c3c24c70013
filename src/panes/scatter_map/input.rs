//! What wheel, pinch and keys ask of a map, flat or in 3D, while it has the pointer or the keyboard.

use egui::{EventFilter, Key, Response, Ui, Vec2, vec2};

/// How much nearer scrolling and pinching bring what is under the pointer; 1 changes nothing.
pub fn pointer_zoom(ui: &Ui, response: &Response) -> f32 {
    if !response.contains_pointer() {
        return 1.0;
    }
    let (scroll, pinch) = ui.input(|input| (input.smooth_scroll_delta().y, input.zoom_delta()));
    pinch * (scroll * 0.004).exp()
}

/// How much nearer plus and minus bring the middle; 1 changes nothing.
pub fn key_zoom(ui: &Ui, response: &Response) -> f32 {
    let keys = [(Key::Plus, 1.25), (Key::Equals, 1.25), (Key::Minus, 0.8)];
    keys.into_iter()
        .filter(|(key, _)| response.has_focus() && ui.input(|input| input.key_pressed(*key)))
        .map(|(_, factor)| factor)
        .product()
}

/// Where arrows point that were pressed, on screen; keeps them from moving the keyboard elsewhere.
pub fn pressed_arrows(ui: &Ui, response: &Response) -> Vec<Vec2> {
    if !response.has_focus() {
        return Vec::new();
    }
    let arrows = EventFilter {
        horizontal_arrows: true,
        vertical_arrows: true,
        ..EventFilter::default()
    };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, arrows));
    [
        (Key::ArrowRight, vec2(1.0, 0.0)),
        (Key::ArrowLeft, vec2(-1.0, 0.0)),
        (Key::ArrowUp, vec2(0.0, -1.0)),
        (Key::ArrowDown, vec2(0.0, 1.0)),
    ]
    .into_iter()
    .filter(|(key, _)| ui.input(|input| input.key_pressed(*key)))
    .map(|(_, direction)| direction)
    .collect()
}

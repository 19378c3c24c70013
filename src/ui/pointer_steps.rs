//! A press, a move and a release that reach the window in one frame are passed on one after the other, and so are a
//! key or a click that gives the keyboard to something else and what is typed after it.

use egui::{Context, Event, Key, Plugin, RawInput};

/// Cuts the input of a frame so that the press, the way and the release of a drag are seen in one frame each, and that
/// what is typed after a click or after a key such as Ctrl+K goes to what they opened.
///
/// egui asks which widget lies under the last place of a frame's input. Where a frame takes long, a whole quick drag
/// arrives in one frame, and the widget that was reached would take the press that another one was meant by: the
/// motion of another subject would be transported, and onto another one. What follows the cut waits for the next
/// frame, in its order.
#[derive(Debug, Default)]
pub struct PointerSteps {
    waiting: Vec<Event>,
    /// Whether a button is down after the events that went by.
    held: bool,
}

impl Plugin for PointerSteps {
    fn debug_name(&self) -> &'static str {
        "pointer steps"
    }

    fn input_hook(&mut self, ctx: &Context, input: &mut RawInput) {
        let mut events = std::mem::take(&mut self.waiting);
        events.append(&mut input.events);
        let (cut, held) = cut(&events, self.held);
        self.held = held;
        self.waiting = events.split_off(cut);
        input.events = events;
        if !self.waiting.is_empty() {
            ctx.request_repaint();
        }
    }
}

/// The first event that must wait, and whether a button is down before it.
fn cut(events: &[Event], mut held: bool) -> (usize, bool) {
    // Where a button went down or up in this frame; whether the pointer moved on with a button down.
    let (mut button_at, mut dragged) = (None, false);
    // Whether something else may have the keyboard in the next frame.
    let mut handed_on = false;
    for (index, event) in events.iter().enumerate() {
        if (handed_on || button_at.is_some()) && types(event) && !is_text_of(events, index) {
            return (index, held);
        }
        handed_on |= hands_keyboard_on(event);
        match event {
            Event::PointerButton { pos, pressed, .. } => {
                // A button elsewhere, without a way to it, would take the first one's widget along.
                if dragged || button_at.is_some_and(|at| at != *pos) {
                    return (index, held);
                }
                (button_at, held) = (Some(*pos), *pressed);
            }
            Event::PointerMoved(to) => {
                if button_at.is_some_and(|at| at != *to) {
                    return (index, held);
                }
                dragged |= held && button_at.is_none();
            }
            Event::PointerGone if button_at.is_some() => return (index, held),
            _ => {}
        }
    }
    (events.len(), held)
}

/// Whether an event is for whatever has the keyboard. A key that is held down does not count: its repeats would wait
/// in a row that grows where frames take longer than they come.
fn types(event: &Event) -> bool {
    match event {
        Event::Key {
            pressed, repeat, ..
        } => *pressed && !repeat,
        Event::Text(_) | Event::Paste(_) | Event::Cut | Event::Copy | Event::Ime(_) => true,
        _ => false,
    }
}

/// Whether a key may open a field or a sheet, or move the keyboard elsewhere.
fn hands_keyboard_on(event: &Event) -> bool {
    let Event::Key { key, modifiers, .. } = event else {
        return false;
    };
    let moves = matches!(
        key,
        Key::Enter | Key::Escape | Key::Tab | Key::F6 | Key::Questionmark
    );
    types(event) && (moves || modifiers.command)
}

/// Whether an event is the letter of the key that stands just before it.
fn is_text_of(events: &[Event], index: usize) -> bool {
    let before = index.checked_sub(1).and_then(|before| events.get(before));
    let typed =
        matches!(before, Some(Event::Key { pressed: true, modifiers, .. }) if !modifiers.command);
    typed && matches!(events.get(index), Some(Event::Text(_)))
}

#[cfg(test)]
mod tests {
    use egui::{Modifiers, PointerButton, Pos2, pos2};

    use super::*;

    fn button(pos: Pos2, pressed: bool) -> Event {
        Event::PointerButton {
            pos,
            button: PointerButton::Primary,
            pressed,
            modifiers: Modifiers::NONE,
        }
    }

    /// The events of each frame, when all arrive in the first.
    fn frames(events: Vec<Event>) -> Vec<Vec<Event>> {
        let ctx = Context::default();
        let mut steps = PointerSteps::default();
        let mut input = RawInput {
            events,
            ..RawInput::default()
        };
        let mut frames = Vec::new();
        loop {
            steps.input_hook(&ctx, &mut input);
            frames.push(std::mem::take(&mut input.events));
            if steps.waiting.is_empty() {
                return frames;
            }
        }
    }

    #[test]
    fn a_quick_drag_is_a_press_a_move_and_a_release() {
        let (from, onto, away) = (pos2(10.0, 10.0), pos2(10.0, 90.0), pos2(10.0, 120.0));
        let events = vec![
            Event::PointerMoved(from),
            button(from, true),
            Event::PointerMoved(pos2(10.0, 50.0)),
            Event::PointerMoved(onto),
            button(onto, false),
            Event::PointerMoved(away),
        ];
        let expected = [&events[..2], &events[2..4], &events[4..5], &events[5..]];
        assert_eq!(frames(events.clone()), expected);
    }

    #[test]
    fn a_click_and_moves_without_buttons_stay_in_one_frame() {
        let at = pos2(4.0, 4.0);
        let events = vec![
            Event::PointerMoved(pos2(1.0, 1.0)),
            Event::PointerMoved(at),
            button(at, true),
            Event::PointerMoved(at),
            button(at, false),
            button(at, true),
            button(at, false),
        ];
        assert_eq!(frames(events.clone()), [events]);
    }

    fn key(key: Key, modifiers: Modifiers, repeat: bool) -> Event {
        Event::Key {
            key,
            physical_key: None,
            pressed: true,
            repeat,
            modifiers,
        }
    }

    fn text(letter: &str) -> Event {
        Event::Text(letter.to_owned())
    }

    #[test]
    fn what_is_typed_after_a_click_or_a_key_that_opens_something_waits() {
        let none = Modifiers::NONE;
        let at = pos2(4.0, 4.0);
        let events = vec![
            key(Key::A, none, false),
            text("a"),
            button(at, true),
            button(at, false),
            key(Key::Num5, none, false),
            text("5"),
            key(Key::K, Modifiers::COMMAND, false),
            text("w"),
            key(Key::Questionmark, none, false),
            text("?"),
            key(Key::W, none, false),
        ];
        let expected = [&events[..4], &events[4..7], &events[7..10], &events[10..]];
        assert_eq!(frames(events.clone()), expected);
    }

    #[test]
    fn a_key_that_is_held_down_does_not_make_a_row_of_frames() {
        let tab = |repeat| key(Key::Tab, Modifiers::NONE, repeat);
        let events = vec![tab(false), tab(true), tab(true), tab(true)];
        assert_eq!(frames(events.clone()), [events]);
    }

    #[test]
    fn a_pointer_that_leaves_after_its_press_leaves_in_the_next_frame() {
        let at = pos2(4.0, 4.0);
        let events = vec![button(at, true), Event::PointerGone, button(at, false)];
        let expected = [&events[..1], &events[1..]];
        assert_eq!(frames(events.clone()), expected);
    }
}

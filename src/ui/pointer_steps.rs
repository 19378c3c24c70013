//! A press, a move and a release that reach the window in one frame are passed on one after the other.

use egui::{Context, Event, Plugin, RawInput};

/// Cuts the input of a frame so that the press, the way and the release of a drag are seen in one frame each.
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
    for (index, event) in events.iter().enumerate() {
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
            Event::Text("k".to_owned()),
        ];
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

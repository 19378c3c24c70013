//! Drag of a subject: dropped on another one, its motion is transported there.

use egui::{
    Align2, Context, DragAndDrop, Id, LayerId, Order, Rect, Response, Stroke, StrokeKind, Ui, vec2,
};

use crate::panes::commands::{Command, TransportCommand};
use crate::study::Study;
use crate::ui::style::text_font;
use crate::ui::theme::{colours, line, radius, space};

/// The dragged subject, kept by egui from the press to the drop.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DraggedSubject {
    /// Index into the study's subjects.
    pub subject: usize,
    /// Pseudonym.
    pub id: String,
    /// Subjects whose vertices correspond have the same number.
    pub correspondence: usize,
}

/// The subject that the pointer holds, if any.
pub fn dragged_subject(ui: &Ui) -> Option<DraggedSubject> {
    DragAndDrop::payload::<DraggedSubject>(ui.ctx()).map(|dragged| DraggedSubject::clone(&dragged))
}

/// Lets go of the dragged subject if another one stands in its place by now, such as one that was read since.
pub fn let_go_if_moved(ctx: &Context, study: &Study) {
    if let Some(dragged) = DragAndDrop::payload::<DraggedSubject>(ctx) {
        let there = study.subject(dragged.subject);
        if there.is_none_or(|subject| subject.id != dragged.id) {
            DragAndDrop::clear_payload(ctx);
        }
    }
}

/// Where a dragged subject can be dropped: another subject's row or picture.
#[derive(Clone, Copy, Debug)]
pub struct SubjectTarget<'a> {
    /// Where it is.
    pub rect: Rect,
    /// Index of the subject that is there.
    pub subject: usize,
    /// Its pseudonym.
    pub id: &'a str,
    /// Whether its vertices correspond with those of the subject that is dragged.
    pub corresponds: bool,
}

/// Highlights the target under a dragged subject, and takes the drop.
/// `response` is the widget that the target is part of.
pub fn subject_target_ui(
    ui: &Ui,
    response: &Response,
    target: &SubjectTarget,
    commands: &mut Vec<Command>,
) {
    let Some(dragged) = dragged_subject(ui).filter(|dragged| dragged.subject != target.subject)
    else {
        return;
    };
    let pointer = ui.input(|input| input.pointer.latest_pos());
    let over = response.contains_pointer() && pointer.is_some_and(|at| target.rect.contains(at));
    if target.corresponds {
        let colours = colours(ui);
        let colour = if over {
            colours.accent
        } else {
            colours.accent.gamma_multiply(0.35)
        };
        let width = if over { line::STRONG } else { line::THIN };
        ui.painter().rect_stroke(
            target.rect.shrink(1.0),
            f32::from(radius::CONTROL),
            Stroke::new(width, colour),
            StrokeKind::Inside,
        );
    }
    if !over {
        return;
    }
    if ui.input(|input| input.pointer.any_released()) {
        DragAndDrop::take_payload::<DraggedSubject>(ui.ctx());
        // Without correspondence the command is given all the same: its refusal says why.
        commands.push(
            TransportCommand::TransportMotion {
                from: dragged.subject,
                onto: target.subject,
            }
            .into(),
        );
        return;
    }
    let words = if target.corresponds {
        format!("Transport motion: {} → {}", dragged.id, target.id)
    } else {
        format!("No vertex correspondence: {}, {}", dragged.id, target.id)
    };
    ui.ctx()
        .data_mut(|data| data.insert_temp(words_id(), words));
}

fn words_id() -> Id {
    Id::unique("dragged subject words")
}

/// Draws what the pointer holds beside it. Call once a frame, after all targets.
pub fn dragged_subject_ui(ui: &Ui) {
    let over: Option<String> = ui.ctx().data_mut(|data| data.remove_temp(words_id()));
    let Some(dragged) = dragged_subject(ui) else {
        return;
    };
    let Some(at) = ui.input(|input| input.pointer.latest_pos()) else {
        return;
    };
    let words =
        over.unwrap_or_else(|| format!("Transport motion of {}: drop on a subject", dragged.id));
    let colours = colours(ui);
    let layer = LayerId::new(Order::Tooltip, Id::unique("dragged subject"));
    let painter = ui.ctx().layer_painter(layer);
    let galley = painter.layout_no_wrap(words, text_font(), colours.strong);
    let size = galley.size() + vec2(2.0 * space::MEDIUM, space::MEDIUM);
    let area = ui.ctx().content_rect().shrink(space::SMALL);
    let mut card = Align2::LEFT_TOP.anchor_size(at + vec2(14.0, 12.0), size);
    card = card.translate(vec2(
        (area.right() - card.right()).min(0.0),
        (area.bottom() - card.bottom()).min(0.0),
    ));
    painter.rect(
        card,
        f32::from(radius::CONTROL),
        colours.control.gamma_multiply(0.94),
        (line::THIN, colours.accent),
        StrokeKind::Inside,
    );
    let text_at = card.min + vec2(space::MEDIUM, 0.5 * space::MEDIUM);
    painter.galley(text_at, galley, colours.strong);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::testing::{study_of, subject_with_frames};

    #[test]
    fn a_drag_ends_where_another_subject_has_come_into_its_place() {
        let ctx = Context::default();
        let study =
            |ids: &[&str]| study_of(ids.iter().map(|id| subject_with_frames(id, 2)).collect());
        let dragged = DraggedSubject {
            subject: 1,
            id: "b".to_owned(),
            correspondence: 0,
        };
        DragAndDrop::set_payload(&ctx, dragged);
        let_go_if_moved(&ctx, &study(&["a", "b"]));
        let_go_if_moved(&ctx, &study(&["a", "b", "c"]));
        assert!(DragAndDrop::has_payload_of_type::<DraggedSubject>(&ctx));
        let_go_if_moved(&ctx, &study(&["a", "aa", "b"]));
        assert!(!DragAndDrop::has_payload_of_type::<DraggedSubject>(&ctx));
    }
}

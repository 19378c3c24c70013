//! Error cards: each error once, beside the content and not over it.

use egui::{
    Align2, Area, CollapsingHeader, Frame, Margin, Order, RichText, ScrollArea, Stroke, Ui,
};

use crate::document::ErrorCard;
use crate::panes::buttons::command_button_ui;
use crate::panes::commands::{Command, WorkCommand};
use crate::ui::controls::icon_button_ui;
use crate::ui::marks::Icon;
use crate::ui::style::medium;
use crate::ui::theme::{colours, line, space};

/// Height of the bars at the foot of the window.
const BARS: f32 = 116.0;

/// Draws the cards over the lower right corner of `ui.max_rect()`, latest lowest.
pub fn error_cards_ui(ui: &mut Ui, cards: &[ErrorCard], commands: &mut Vec<Command>) {
    if cards.is_empty() {
        return;
    }
    let mut room = ui.max_rect().shrink(space::LARGE);
    // Over the whole window the cards stay clear of the time bar and the status bar.
    room.max.y = room.max.y.min(ui.ctx().content_rect().bottom() - BARS);
    let width = 380f32.min(room.width());
    Area::new(ui.scope_id().with("error cards"))
        .order(Order::Foreground)
        .pivot(Align2::RIGHT_BOTTOM)
        .fixed_pos(room.max)
        .show(ui.ctx(), |ui| {
            ui.set_width(width);
            ui.spacing_mut().item_spacing.y = space::MEDIUM;
            for (index, card) in cards.iter().enumerate() {
                ui.push_id(index, |ui| card_ui(ui, index, card, commands));
            }
        });
}

fn card_ui(ui: &mut Ui, index: usize, card: &ErrorCard, commands: &mut Vec<Command>) {
    let colours = colours(ui);
    let frame = Frame::popup(ui.style())
        .inner_margin(Margin::same(space::LARGE as i8))
        .stroke(Stroke::new(line::THIN, colours.error.gamma_multiply(0.7)));
    frame.show(ui, |ui| {
        ui.set_width(ui.available_width());
        egui::Sides::new().shrink_left().truncate().show(
            ui,
            |ui| ui.label(medium(&card.title).color(colours.error)),
            |ui| {
                if icon_button_ui(ui, Icon::Close, "Dismiss", "Dismiss", false).clicked() {
                    commands.push(WorkCommand::DismissError(index).into());
                }
            },
        );
        ui.add(egui::Label::new(&card.message).wrap().selectable(true));
        if !card.details.is_empty() {
            CollapsingHeader::new(RichText::new("Details").small()).show(ui, |ui| {
                ScrollArea::vertical().max_height(140.0).show(ui, |ui| {
                    let text = RichText::new(&card.details).small();
                    ui.add(egui::Label::new(text).wrap().selectable(true));
                });
            });
        }
        if let Some(topic) = card.retry {
            command_button_ui(ui, "Retry", WorkCommand::Retry(topic), commands);
        }
    });
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::Topic;
    use egui_kittest::{Harness, kittest::Queryable as _};

    #[test]
    fn a_card_can_be_read_dismissed_and_retried() {
        let cards = [ErrorCard {
            title: "1 file could not be read".to_owned(),
            message: "line 812: face refers to vertex 9041".to_owned(),
            details: "heart/endo_03.obj".to_owned(),
            retry: Some(Topic::OPENING),
        }];
        let mut harness = Harness::builder()
            .with_context_setup(|ctx| crate::ui::style::apply(ctx, true))
            .build_ui_state(
                |ui, commands: &mut Vec<Command>| error_cards_ui(ui, &cards, commands),
                Vec::new(),
            );
        harness.run();
        assert!(harness.query_by_label("heart/endo_03.obj").is_none());
        harness.get_by_label("Details").click();
        harness.run();
        harness.get_by_label("heart/endo_03.obj");
        harness.get_by_label("Retry").click();
        harness.run();
        harness.get_by_label("Dismiss").click();
        harness.run();
        assert_eq!(
            harness.into_state(),
            [
                Command::Work(WorkCommand::Retry(Topic::OPENING)),
                Command::Work(WorkCommand::DismissError(0))
            ]
        );
    }
}

//! The verdict in words, the predicted probability, and the distance to the training set.

use egui::{Label, Rect, Role, Sense, Stroke, Ui, WidgetInfo, vec2};

use crate::panes::verdict::{VerdictReport, pair_ui};
use crate::panes::verdict_marks::{VerdictMark, verdict_mark};
use crate::ui::style::{medium, note};
use crate::ui::theme::{colours, line, space};

/// Shown with every verdict.
const RESEARCH: &str = "Research use, not for diagnosis";

/// Draws the verdict.
pub(super) fn verdict_ui(ui: &mut Ui, report: &VerdictReport) {
    let colours = colours(ui);
    ui.horizontal_top(|ui| {
        ui.spacing_mut().item_spacing.x = space::SMALL;
        let (area, _) = ui.allocate_exact_size(vec2(14.0, 18.0), Sense::hover());
        let colour = report.mark.colour(colours);
        verdict_mark(ui.painter(), area.center(), 5.5, report.mark, colour);
        let colour = match report.mark {
            VerdictMark::NoAbnormality | VerdictMark::NotAssessed => colours.strong,
            mark => mark.colour(colours),
        };
        ui.add(Label::new(medium(report.heading.as_str()).color(colour)).wrap());
    });
    ui.add(Label::new(note(report.sentence.as_str())).wrap());
    if let Some(probability) = report.probability {
        probability_ui(ui, report, probability);
    }
    labels_ui(ui, report);
    if !report.reasons.is_empty() {
        ui.add_space(space::SMALL);
        ui.add(Label::new(note(report.reasons.as_str())).wrap())
            .on_hover_text("Model features that add most to the log odds of the predicted class");
    }
    if let Some(training_distance) = &report.training_distance {
        ui.add_space(space::SMALL);
        let text = note(training_distance.words.as_str());
        let text = if training_distance.outside {
            text.color(colours.warning)
        } else {
            text
        };
        ui.add(Label::new(text).wrap()).on_hover_text(
            "Distance to the nearest training subject in the model features, or of a classifier from a file to their \
             mean, relative to the median of that distance among the training subjects",
        );
    }
    ui.add_space(space::SMALL);
    ui.add(Label::new(note(RESEARCH)).wrap());
    ui.add_space(space::MEDIUM);
}

/// The two most probable labels.
fn labels_ui(ui: &mut Ui, report: &VerdictReport) {
    if report.labels.is_empty() {
        return;
    }
    ui.add_space(space::SMALL);
    for (rank, (label, probability)) in report.labels.iter().take(2).enumerate() {
        let name = if rank == 0 {
            format!("Most probable label: {label}")
        } else {
            format!("Next: {label}")
        };
        let response = pair_ui(ui, &name, probability);
        let words = format!("{name}, {probability}");
        response.widget_info(|| WidgetInfo::labeled(Role::Label, true, words.as_str()));
        response.on_hover_text(
            "One label against the rest, calibrated, scaled so that all labels add up to 100 %",
        );
    }
}

/// "> 99 %": a small cohort supports no more digits.
pub(super) fn percent(probability: f64) -> String {
    if probability > 0.99 {
        "> 99 %".to_owned()
    } else if probability < 0.01 {
        "< 1 %".to_owned()
    } else {
        format!("{:.0} %", 100.0 * probability)
    }
}

fn probability_ui(ui: &mut Ui, report: &VerdictReport, probability: f64) {
    let colours = colours(ui);
    ui.add_space(space::SMALL);
    let (name, value) = ("Predicted probability of abnormal", percent(probability));
    let what = "Predicted probability of class abnormal, with equal prior probabilities of both classes; above 50 % the \
                subject is classified as abnormal";
    let words = format!("{name}: {value}");
    let response = pair_ui(ui, name, &value);
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, words.as_str()));
    response.on_hover_text(what);
    let height = 5.0;
    let (area, _) = ui.allocate_exact_size(vec2(ui.available_width(), 9.0), Sense::hover());
    let bar = Rect::from_center_size(area.center(), vec2(area.width(), height));
    let painter = ui.painter();
    painter.rect_filled(bar, 0.5 * height, colours.line);
    let mut filled = bar;
    filled.set_width(bar.width() * probability.clamp(0.0, 1.0) as f32);
    let colour = match report.mark {
        VerdictMark::NoAbnormality => colours.normal,
        mark => mark.colour(colours),
    };
    painter.rect_filled(filled, 0.5 * height, colour);
    // The threshold of class abnormal.
    let stroke = Stroke::new(line::THIN, colours.text);
    painter.vline(bar.center().x, area.y_range(), stroke);
    ui.add(Label::new(note(report.source)).wrap());
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn probabilities_near_0_and_1_are_given_as_bounds() {
        assert_eq!(percent(0.9999), "> 99 %");
        assert_eq!(percent(0.004), "< 1 %");
        assert_eq!(percent(0.312), "31 %");
    }
}

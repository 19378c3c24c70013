//! What is said of the selected heart and why: the finding, its evidence, hearts alike, and the rule behind it.

mod evidence;
mod found;
mod rule;
#[cfg(test)]
mod tests;

use egui::{Margin, RichText, ScrollArea, Ui};

use crate::engine::{Topic, VerdictSettings};
use crate::study::LabelRole;
use crate::ui::command::Command;
use crate::ui::controls::{empty_pane_ui, progress_bar_ui, time_left_text};
use crate::ui::style::{medium, note};
use crate::ui::theme::{colours, space};
use crate::ui::verdict_marks::VerdictMark;

/// How the verdicts on all hearts stand.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum VerdictState {
    /// No heart.
    #[default]
    Empty,
    /// They come after the work that is on screen.
    Waiting,
    /// They are being made; what is shown, if anything, is of the thresholds before.
    Computing {
        /// Done share in `0..=1`.
        fraction: f32,
        /// What is being done now; may be empty.
        phase: &'static str,
        /// Estimate, once there is one.
        seconds_left: Option<f64>,
    },
    /// The user stopped it.
    Stopped,
    /// It failed, and why.
    Failed(String),
    /// What is shown is of the study and thresholds of today.
    Ready,
}

/// What is said of one heart.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ToldVerdict {
    /// What was found.
    pub mark: VerdictMark,
    /// "Abnormal patch · 31 % of the LV".
    pub heading: String,
    /// What that means; for a heart that is not assessed, why.
    pub sentence: String,
    /// That the heart counts as abnormal, in `0..=1`; `None` where it is not assessed.
    pub probability: Option<f64>,
    /// Whether that number is a probability; else an order.
    pub calibrated: bool,
    /// By which rule: one that has not seen this heart.
    pub source: &'static str,
    /// How far it lies from what the rule has seen; `None` for a rule that has seen nothing.
    pub familiar: Option<Familiar>,
    /// What speaks for it.
    pub evidence: Vec<EvidenceRow>,
    /// The hearts most like it: with a normal label, with an abnormal one, nearest first.
    pub alike: [Vec<AlikeHeart>; 2],
}

/// How near a heart lies to those that the rule was made of.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Familiar {
    /// In a sentence.
    pub words: String,
    /// Whether it is so far away that the verdict deserves care.
    pub unlike: bool,
}

/// One number about a heart beside those of the normal hearts.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct EvidenceRow {
    /// "Wall that stands still".
    pub name: &'static str,
    /// What it is, for the hover.
    pub what: &'static str,
    /// With its unit; "not told" where it is not.
    pub value: String,
    /// From the least to the greatest of the normal hearts, with the unit; empty where there are none.
    pub normal: String,
    /// Where the value lies between the least and the greatest of all hearts, in `0..=1`.
    pub place: Option<f32>,
    /// Where the normal hearts lie on the same scale.
    pub band: Option<[f32; 2]>,
    /// Whether the rule reads it, or it is evidence beside the rule.
    pub read: bool,
}

/// A heart that is like the selected one.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AlikeHeart {
    /// Index into the study's subjects.
    pub subject: usize,
    /// Pseudonym.
    pub id: String,
    /// Free label.
    pub label: String,
    /// What the label counts as.
    pub role: LabelRole,
    /// What is said of it: "patch 31 %".
    pub verdict: String,
}

/// Where the rule comes from and how good it is.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RuleTold {
    /// "Learnt from 9 normal and 14 abnormal hearts …".
    pub source: String,
    /// Each number beside what chance reaches.
    pub results: Vec<Chance>,
}

/// A number that tells how good a rule is, beside what chance reaches.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Chance {
    /// "Right answers".
    pub name: &'static str,
    /// What it is, for the hover.
    pub what: &'static str,
    /// "22 of 23".
    pub value: String,
    /// "by chance 11.6 · p 0.005"; empty where chance has no say.
    pub chance: String,
}

/// What the pane shows.
#[derive(Clone, Copy, Debug)]
pub struct VerdictPanelView<'a> {
    /// The selected subject.
    pub subject: Option<&'a str>,
    /// How verdicts stand.
    pub state: &'a VerdictState,
    /// What is said of that subject; `None` while nothing is known.
    pub told: Option<&'a ToldVerdict>,
    /// The rule; `None` while nothing is known.
    pub rule: Option<&'a RuleTold>,
}

/// Draws the pane.
pub fn verdict_panel_ui(ui: &mut Ui, view: &VerdictPanelView, commands: &mut Vec<Command>) {
    if view.subject.is_none() {
        empty_pane_ui(
            ui,
            "No heart selected",
            "Select a subject to see whether a part of its wall is abnormal, and why.",
            |_| {},
        );
        return;
    }
    ScrollArea::vertical()
        .id_salt("verdict panel")
        .auto_shrink(false)
        .show(ui, |ui| {
            egui::Frame::new()
                .inner_margin(Margin::same(space::LARGE as i8))
                .show(ui, |ui| {
                    ui.spacing_mut().item_spacing.y = 2.0;
                    if let Some(told) = view.told {
                        found::found_ui(ui, told);
                    }
                    standing_ui(ui, view, commands);
                    if let Some(told) = view.told {
                        evidence::evidence_ui(ui, &told.evidence);
                        rule::alike_ui(ui, &told.alike, commands);
                    }
                    if let Some(told) = view.rule {
                        rule::rule_ui(ui, told);
                    }
                });
        });
}

/// How the work stands, with what can be done about it.
fn standing_ui(ui: &mut Ui, view: &VerdictPanelView, commands: &mut Vec<Command>) {
    let first = view.told.is_none();
    let lines = |ui: &mut Ui, heading: &str, what: &str| {
        if first {
            ui.label(medium(heading));
        }
        ui.add(egui::Label::new(note(what)).wrap());
    };
    match view.state {
        VerdictState::Empty | VerdictState::Ready => return,
        VerdictState::Waiting => lines(ui, "Not judged yet", "Comes after the maps"),
        VerdictState::Computing {
            fraction,
            phase,
            seconds_left,
        } => {
            let what = if first {
                "The walls of all hearts are measured, then a rule is learnt from their labels"
            } else {
                "This is of the thresholds before"
            };
            lines(ui, "Judging the hearts", what);
            let width = ui.available_width().min(180.0);
            progress_bar_ui(ui, width, *fraction, "Judging the hearts");
            let left = seconds_left.map(|left| format!(" · {}", time_left_text(left)));
            let percent = format!("{:.0} %{}", 100.0 * fraction, left.unwrap_or_default());
            ui.label(note(percent)).on_hover_text(*phase);
            let cancel = ui.button("Cancel");
            cancel.widget_info(|| {
                egui::WidgetInfo::labeled(egui::Role::Button, true, "Cancel judging")
            });
            if cancel.clicked() {
                commands.push(Command::Cancel(Topic::of::<VerdictSettings>()));
            }
        }
        VerdictState::Stopped => {
            lines(ui, "Not judged", "Judging was stopped");
            if ui.button("Judge the hearts").clicked() {
                commands.push(Command::Retry(Topic::of::<VerdictSettings>()));
            }
        }
        VerdictState::Failed(why) => {
            let colour = colours(ui).error;
            ui.label(medium("The hearts could not be judged").color(colour));
            ui.add(egui::Label::new(RichText::new(why.as_str()).weak()).wrap());
            if ui.button("Judge again").clicked() {
                commands.push(Command::Retry(Topic::of::<VerdictSettings>()));
            }
        }
    }
    ui.add_space(space::MEDIUM);
}

/// A line with a name on the left and a number on the right; the name gives way.
fn pair_ui(ui: &mut Ui, name: &str, value: &str) -> egui::Response {
    use crate::ui::style::{medium_note_font, note_font};
    let colours = colours(ui);
    let painter = ui.painter().clone();
    let value = painter.layout_no_wrap(value.to_owned(), medium_note_font(), colours.text);
    let size = egui::vec2(ui.available_width(), 18.0);
    let (rect, response) = ui.allocate_exact_size(size, egui::Sense::hover());
    let room = (rect.width() - value.size().x - space::SMALL).max(8.0);
    let mut job =
        egui::text::LayoutJob::simple_singleline(name.to_owned(), note_font(), colours.muted);
    job.wrap = egui::text::TextWrapping::truncate_at_width(room);
    let name = painter.layout_job(job);
    let y = |height: f32| rect.center().y - 0.5 * height;
    let left = egui::pos2(rect.left(), y(name.size().y));
    painter.galley(left, name, colours.muted);
    let right = egui::pos2(rect.right() - value.size().x, y(value.size().y));
    painter.galley(right, value, colours.text);
    response
}

//! Every command and every subject by a few letters (Ctrl+K).

use egui::{
    Align2, Area, Frame, Id, Key, Label, Margin, Modifiers, Order, Rect, RichText, Role,
    ScrollArea, Sense, TextEdit, Ui, WidgetInfo, vec2,
};

use crate::panes::action_state::ActionState;
use crate::panes::actions::ALL_ACTIONS;
use crate::panes::cohort::rows::CohortRow;
use crate::panes::commands::{Command, SelectCommand, TransportCommand, WindowCommand};
use crate::panes::shortcuts::keys_text;
use crate::ui::fuzzy::fuzzy_score;
use crate::ui::style::note;
use crate::ui::theme::{colours, radius, space};

/// What the palette offers.
#[derive(Clone, Debug)]
pub struct CommandPaletteView<'a> {
    /// What can be done now.
    pub actions: &'a ActionState<'a>,
    /// All subjects in the order of the study.
    pub subjects: &'a [CohortRow],
}

/// One line of the palette.
struct Offer {
    name: String,
    where_it_stands: String,
    keys: String,
    enabled: bool,
    command: Command,
}

/// What was typed and which line the arrows are on; kept while the palette is open.
#[derive(Clone, Debug, Default)]
struct Typed {
    text: String,
    place: usize,
    opened: bool,
    /// The pass that drew the palette last.
    pass: u64,
}

/// Greatest number of lines shown.
const MAX_LINES: usize = 50;

/// Draws the palette. It pushes the chosen command after [`WindowCommand::TogglePalette`], which closes it.
pub fn command_palette_ui(ui: &mut Ui, view: &CommandPaletteView, commands: &mut Vec<Command>) {
    let ctx = ui.ctx().clone();
    let id = Id::unique("command palette");
    let pass = ctx.cumulative_pass_nr();
    // What was typed before the palette was closed by its key is forgotten.
    let mut typed: Typed = ctx
        .data(|data| data.get_temp(id))
        .filter(|typed: &Typed| typed.pass + 1 >= pass)
        .unwrap_or_default();
    typed.pass = pass;
    let width = 520f32.min(ctx.content_rect().width() - 2.0 * space::LARGE);
    let [up, down, enter, escape] = taken_keys(&ctx);
    let mut chosen = None;
    let area = Area::new(id)
        .order(Order::Foreground)
        .anchor(Align2::CENTER_TOP, vec2(0.0, 64.0))
        .show(&ctx, |ui| {
            Frame::popup(ui.style())
                .inner_margin(Margin::same(space::MEDIUM as i8))
                .show(ui, |ui| {
                    ui.set_width(width);
                    search_ui(ui, &mut typed);
                    let offers = offers(&ctx, view, &typed.text);
                    let last = offers.len().saturating_sub(1);
                    if down {
                        typed.place = if typed.place >= last {
                            0
                        } else {
                            typed.place + 1
                        };
                    }
                    if up {
                        typed.place = typed.place.checked_sub(1).unwrap_or(last);
                    }
                    typed.place = typed.place.min(last);
                    chosen = offers_ui(ui, &offers, typed.place, up || down);
                    if enter
                        && let Some(offer) = offers.get(typed.place).filter(|offer| offer.enabled)
                    {
                        chosen = Some(offer.command.clone());
                    }
                });
        });
    let outside = ctx.input(|input| input.pointer.any_pressed())
        && typed.opened
        && ctx
            .pointer_interact_pos()
            .is_some_and(|at| !area.response.rect.contains(at));
    typed.opened = true;
    if chosen.is_some() || escape || outside {
        ctx.data_mut(|data| data.remove::<Typed>(id));
        let close = Command::from(WindowCommand::TogglePalette);
        let chosen = chosen.filter(|command| *command != close);
        commands.push(close);
        commands.extend(chosen);
    } else {
        ctx.data_mut(|data| data.insert_temp(id, typed));
    }
}

/// Takes the keys that move through the list before the text field gets them.
fn taken_keys(ctx: &egui::Context) -> [bool; 4] {
    ctx.input_mut(|input| {
        [Key::ArrowUp, Key::ArrowDown, Key::Enter, Key::Escape]
            .map(|key| input.consume_key(Modifiers::NONE, key))
    })
}

fn search_ui(ui: &mut Ui, typed: &mut Typed) {
    let edit = TextEdit::singleline(&mut typed.text)
        .hint_text("Find a command or a subject")
        .desired_width(f32::INFINITY)
        .margin(vec2(space::MEDIUM, 6.0));
    let response = ui.add(edit).accessible_name("Find a command or a subject");
    if !typed.opened || !response.has_focus() {
        response.request_focus();
    }
    if response.changed() {
        typed.place = 0;
    }
}

/// Commands and subjects that fit, best first; in their given order while nothing is typed.
fn offers(ctx: &egui::Context, view: &CommandPaletteView, text: &str) -> Vec<Offer> {
    let actions = ALL_ACTIONS.iter().map(|action| Offer {
        name: action.name.to_owned(),
        where_it_stands: action.menu.name().to_owned(),
        keys: action
            .shortcut
            .as_ref()
            .map(|shortcut| keys_text(ctx, shortcut))
            .unwrap_or_default(),
        enabled: view.actions.enabled(&action.command),
        command: action.command.clone(),
    });
    let subjects = view.subjects.iter().enumerate().map(|(index, row)| Offer {
        name: row.id.clone(),
        where_it_stands: format!("Subject · {}", row.label.as_deref().unwrap_or("no label")),
        keys: String::new(),
        enabled: true,
        command: Command::Select(SelectCommand::SelectSubject(index)),
    });
    let motion = (view.actions.state.document.selected_index())
        .and_then(|from| Some((from, view.subjects.get(from)?)));
    let transports = motion.into_iter().flat_map(|(from, row)| {
        let others = view.subjects.iter().enumerate();
        others
            .filter(move |(onto, _)| *onto != from)
            .map(move |(onto, other)| Offer {
                name: format!("Transport motion: {} → {}", row.id, other.id),
                where_it_stands: "Transport".to_owned(),
                keys: String::new(),
                enabled: other.correspondence == row.correspondence,
                command: Command::Transport(TransportCommand::TransportMotion { from, onto }),
            })
    });
    let mut scored: Vec<(i32, Offer)> = actions
        .chain(subjects)
        .chain(transports)
        .filter_map(|offer| Some((fuzzy_score(&offer.name, text)?, offer)))
        .collect();
    if !text.trim().is_empty() {
        scored.sort_by_key(|(score, _)| std::cmp::Reverse(*score));
    }
    scored
        .into_iter()
        .map(|(_, offer)| offer)
        .take(MAX_LINES)
        .collect()
}

fn offers_ui(ui: &mut Ui, offers: &[Offer], place: usize, moved: bool) -> Option<Command> {
    let mut chosen = None;
    ui.add_space(space::SMALL);
    ui.spacing_mut().item_spacing.y = 0.0;
    if offers.is_empty() {
        ui.label(note("No matching command or subject"));
    }
    ScrollArea::vertical()
        .max_height(12.0 * 26.0)
        .auto_shrink([false, true])
        .show(ui, |ui| {
            for (index, offer) in offers.iter().enumerate() {
                let (rect, response) =
                    ui.allocate_exact_size(vec2(ui.available_width(), 26.0), Sense::click());
                response.widget_info(|| {
                    WidgetInfo::selected(
                        Role::ListBoxOption,
                        offer.enabled,
                        index == place,
                        &offer.name,
                    )
                });
                draw_offer(ui, rect, offer, index == place, response.hovered());
                if index == place && moved {
                    ui.scroll_to_rect(rect, None);
                }
                if response.clicked() && offer.enabled {
                    chosen = Some(offer.command.clone());
                }
            }
        });
    chosen
}

fn draw_offer(ui: &mut Ui, rect: Rect, offer: &Offer, current: bool, hovered: bool) {
    let colours = colours(ui);
    if current || hovered {
        let fill = if current {
            colours.selected_row
        } else {
            colours.control
        };
        ui.painter()
            .rect_filled(rect, f32::from(radius::CONTROL), fill);
    }
    let inner = rect.shrink2(vec2(space::MEDIUM, 0.0));
    let mut line = ui.new_child(egui::UiBuilder::new().max_rect(inner));
    if !offer.enabled {
        line.disable();
    }
    line.set_height(rect.height());
    egui::Sides::new()
        .height(rect.height())
        .shrink_left()
        .truncate()
        .show(
            &mut line,
            |ui| {
                ui.add(Label::new(RichText::new(&offer.name).color(colours.text)));
                ui.label(note(&offer.where_it_stands));
            },
            |ui| {
                ui.label(note(&offer.keys));
            },
        );
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::testing::{state_of, subject_with_frames};
    use crate::panes::ViewCommand;
    use egui_kittest::Harness;

    fn chosen_by(keys: impl FnOnce(&mut Harness<'_, Vec<Command>>)) -> Vec<Command> {
        let state = state_of(
            ["P-041", "N-007"]
                .map(|id| subject_with_frames(id, 2))
                .to_vec(),
        );
        let actions = ActionState {
            state: &state,
            hidden_panes: Vec::new(),
        };
        let subjects = ["P-041", "N-007"].map(|id| CohortRow {
            id: id.to_owned(),
            ..Default::default()
        });
        let mut harness = Harness::builder()
            .with_size([800.0, 600.0])
            .with_context_setup(|ctx| crate::ui::style::apply(ctx, true))
            .build_ui_state(
                |ui, commands: &mut Vec<Command>| {
                    let view = CommandPaletteView {
                        actions: &actions,
                        subjects: &subjects,
                    };
                    if commands.is_empty() {
                        command_palette_ui(ui, &view, commands);
                    }
                },
                Vec::new(),
            );
        harness.run();
        keys(&mut harness);
        harness.run();
        harness.into_state()
    }

    fn type_text(harness: &mut Harness<'_, Vec<Command>>, text: &str) {
        harness.event(egui::Event::Text(text.to_owned()));
        harness.run();
    }

    #[test]
    fn a_few_letters_and_enter_run_a_command() {
        let commands = chosen_by(|harness| {
            type_text(harness, "sbs");
            harness.key_press(Key::Enter);
        });
        let side_by_side = Command::View(ViewCommand::SetViewMode(
            crate::document::ViewMode::SideBySide,
        ));
        assert_eq!(
            commands,
            [Command::Window(WindowCommand::TogglePalette), side_by_side]
        );
    }

    #[test]
    fn a_subject_is_found_by_its_name() {
        let commands = chosen_by(|harness| {
            type_text(harness, "p041");
            harness.key_press(Key::Enter);
        });
        assert_eq!(
            commands,
            [
                Command::Window(WindowCommand::TogglePalette),
                Command::Select(SelectCommand::SelectSubject(0))
            ]
        );
    }

    #[test]
    fn a_motion_is_transported_to_a_subject_by_its_name() {
        let commands = chosen_by(|harness| {
            type_text(harness, "transport n007");
            harness.key_press(Key::Enter);
        });
        let wanted = Command::Transport(TransportCommand::TransportMotion { from: 0, onto: 1 });
        assert_eq!(
            commands,
            [Command::Window(WindowCommand::TogglePalette), wanted]
        );
    }

    #[test]
    fn arrows_choose_the_next_line_and_escape_chooses_nothing() {
        let commands = chosen_by(|harness| {
            harness.key_press(Key::ArrowDown);
            harness.run();
            harness.key_press(Key::Enter);
        });
        assert_eq!(
            commands,
            [
                Command::Window(WindowCommand::TogglePalette),
                ALL_ACTIONS[1].command.clone()
            ]
        );
        let commands = chosen_by(|harness| harness.key_press(Key::Escape));
        assert_eq!(commands, [Command::Window(WindowCommand::TogglePalette)]);
    }
}

//! The 3D view while no study is open, or the selected subject is not ready.

use egui::{Align2, Button, Rect, RichText, Stroke, StrokeKind, Ui};

use crate::engine::mesh_format_names;
use crate::panes::commands::{Command, FileCommand};
use crate::ui::style::{heading_font, note};
use crate::ui::text::note_at;
use crate::ui::theme::{colours, line, radius, space};

/// What the empty window shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct EmptyStateView {
    /// Whether files are held over the window.
    pub files_hover: bool,
    /// Whether something is being opened.
    pub opening: bool,
}

/// Draws what can be opened, with buttons.
pub fn empty_state_ui(ui: &mut Ui, view: &EmptyStateView, commands: &mut Vec<Command>) {
    let colours = colours(ui);
    let whole = ui.available_rect_before_wrap();
    if view.files_hover {
        let rect = whole.shrink(space::LARGE);
        ui.painter()
            .rect_filled(rect, f32::from(radius::PANE), colours.selected_row);
        let stroke = Stroke::new(line::STRONG, colours.accent);
        ui.painter()
            .rect_stroke(rect, f32::from(radius::PANE), stroke, StrokeKind::Inside);
    }
    ui.vertical_centered(|ui| {
        ui.add_space((whole.height() * 0.38 - 60.0).max(space::LARGE));
        let heading = match (view.files_hover, view.opening) {
            (true, _) => "Drop to open",
            (false, true) => "Opening…",
            (false, false) => "Open a study",
        };
        ui.label(
            RichText::new(heading)
                .font(heading_font())
                .color(colours.strong),
        );
        ui.add_space(space::SMALL);
        let what = format!(
            "Mesh sequences of left ventricles ({}), masks of them (NIfTI, NRRD, MetaImage), a folder of either, or a study.toml",
            mesh_format_names().join(", ")
        );
        ui.scope(|ui| {
            ui.set_max_width(420f32.min(ui.available_width() - 2.0 * space::HUGE));
            ui.add(egui::Label::new(RichText::new(what).weak()).wrap());
        });
        ui.add_space(space::LARGE);
        buttons_ui(ui, view.opening, commands);
        ui.add_space(space::LARGE);
        ui.label(note("Or drop files and folders anywhere on this window"));
    });
}

fn buttons_ui(ui: &mut Ui, opening: bool, commands: &mut Vec<Command>) {
    ui.add_enabled_ui(!opening, |ui| {
        for (name, command) in [
            ("Open files…", Command::File(FileCommand::ChooseFiles)),
            ("Open folder…", Command::File(FileCommand::ChooseFolder)),
            (
                "Open the built-in cohort",
                Command::File(FileCommand::OpenBuiltIn),
            ),
        ] {
            let button = Button::new(name).min_size(egui::vec2(220.0, 30.0));
            if ui.add(button).clicked() {
                commands.push(command);
            }
            ui.add_space(space::SMALL);
        }
    });
}

/// Seconds in which a picture fades that is no longer the one asked for: most are replaced before that is seen.
const FADES_S: f32 = 0.4;

/// Dims the picture of another subject than the selected one, and says which one is being made ready.
pub(super) fn loading_ui(ui: &Ui, area: Rect, awaited: Option<&str>) {
    let fades = ui.scope_id().with("fades");
    let dim = (ui.ctx()).animate_bool_with_time(fades, awaited.is_some(), FADES_S);
    let Some(id) = awaited else {
        return;
    };
    let ground = ui.visuals().panel_fill.gamma_multiply(0.75 * dim);
    ui.painter().rect_filled(area, 0.0, ground);
    if dim > 0.5 {
        note_at(
            ui,
            area.center(),
            Align2::CENTER_CENTER,
            format!("loading {id}…"),
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui_kittest::{Harness, kittest::Queryable as _};

    #[test]
    fn an_empty_window_offers_three_ways_to_fill_it() {
        let mut harness = Harness::builder()
            .with_context_setup(|ctx| crate::ui::style::apply(ctx, true))
            .build_ui_state(
                |ui, commands: &mut Vec<Command>| {
                    empty_state_ui(ui, &EmptyStateView::default(), commands);
                },
                Vec::new(),
            );
        harness.run();
        let formats = format!("({})", mesh_format_names().join(", "));
        harness.get_by_label_contains(&formats);
        for name in ["Open files…", "Open folder…", "Open the built-in cohort"] {
            harness.get_by_label(name).click();
            harness.run();
        }
        assert_eq!(
            harness.into_state(),
            [
                Command::File(FileCommand::ChooseFiles),
                Command::File(FileCommand::ChooseFolder),
                Command::File(FileCommand::OpenBuiltIn)
            ]
        );
    }
}

//! The menu of a row: what can be done with its subject, whichever is selected and wherever the pointer is.

use egui::{Button, Key, Modifiers, Popup, Response, SetOpenCommand, Ui};

use crate::document::{TypedField, Typing};
use crate::panes::buttons::command_button_ui;
use crate::panes::commands::{
    Command, EditCommand, Phase, PhaseFrame, SelectCommand, TransportCommand, Whose,
};
use crate::study::{CoordinateUnit, LabelClass, Landmark, Study, Subject};
use crate::ui::controls::choice_ui;
use crate::ui::style::medium;

use super::values::CohortView;

/// Opens with the other button of the pointer, with `button`, or with the key Menu (Shift+F10) for the row that has the
/// keyboard, else for the selected one.
pub(super) fn row_menu_ui(
    ui: &Ui,
    response: &Response,
    button: bool,
    (index, view): (usize, &CohortView),
    commands: &mut Vec<Command>,
) {
    let by_pointer = response.secondary_clicked();
    let opens = by_pointer || button || menu_key_pressed(ui, response, index, view);
    let set = match (opens, response.clicked()) {
        (true, _) => Some(SetOpenCommand::Bool(true)),
        (false, true) => Some(SetOpenCommand::Bool(false)),
        (false, false) => None,
    };
    let id = Popup::default_response_id(response);
    let mut popup = Popup::menu(response).open_memory(set);
    if by_pointer || (!opens && Popup::position_of_id(ui.ctx(), id).is_some()) {
        popup = popup.at_pointer_fixed();
    }
    popup.show(|ui| menu_ui(ui, index, view, commands));
}

fn menu_key_pressed(ui: &Ui, response: &Response, index: usize, view: &CohortView) -> bool {
    let focused = ui.memory(|memory| memory.focused());
    let addressed = match focused {
        Some(focused) => focused == response.id,
        None => view.selected == Some(index) && !ui.ctx().any_popup_open(),
    };
    addressed
        && ui.input_mut(|input| {
            input.consume_key(Modifiers::NONE, Key::Menu)
                || input.consume_key(Modifiers::SHIFT, Key::F10)
        })
}

fn menu_ui(ui: &mut Ui, index: usize, view: &CohortView, commands: &mut Vec<Command>) {
    let row = &view.rows[index];
    let study = view.edits.study;
    let subject = study.and_then(|study| Some((study, study.subject(index)?)));
    ui.label(medium(&row.id));
    let (name, compared) = match view.compared == Some(index) {
        true => ("Stop comparing", None),
        false => ("Compare side by side", Some(index)),
    };
    command_button_ui(ui, "Select", SelectCommand::SelectSubject(index), commands);
    command_button_ui(ui, name, SelectCommand::CompareWith(compared), commands);
    if let Some(selected) = view.selected.filter(|selected| *selected != index) {
        transport_choices_ui(ui, view, [selected, index], commands);
    }
    let Some((study, subject)) = subject else {
        return;
    };
    ui.separator();
    labels_ui(ui, index, view, (study, subject), commands);
    let rename = typing(TypedField::Name, index, vec![index]);
    command_button_ui(ui, "Rename subject…", rename, commands);
    ui.separator();
    phases_ui(ui, index, view, subject, commands);
    units_ui(ui, index, subject, commands);
    landmarks_ui(ui, index, view, subject, commands);
    ui.separator();
    membership_ui(ui, index, study, commands);
}

fn typing(field: TypedField, subject: usize, subjects: Vec<usize>) -> EditCommand {
    EditCommand::Type(Typing {
        field,
        subject,
        subjects,
    })
}

fn labels_ui(
    ui: &mut Ui,
    index: usize,
    view: &CohortView,
    (study, subject): (&Study, &Subject),
    commands: &mut Vec<Command>,
) {
    let label = typing(TypedField::Label, index, vec![index]);
    command_button_ui(ui, "Edit label…", label, commands);
    let shown = view.visible;
    if !view.search.is_empty() && shown.len() > 1 {
        let name = format!("Edit label of the {} shown…", shown.len());
        let label = typing(TypedField::Label, index, shown.to_vec());
        command_button_ui(ui, name, label, commands);
    }
    if let Some(label) = &subject.label {
        ui.menu_button(format!("Class of the label {label}"), |ui| {
            let now = study.class_of(subject);
            for (class, name) in [
                (LabelClass::Normal, "Normal"),
                (LabelClass::Abnormal, "Abnormal"),
                (LabelClass::Neither, "Other"),
            ] {
                if choice_ui(ui, name, class == now) {
                    commands.push(EditCommand::SetClass(Whose::Subject(index), class).into());
                }
            }
        });
    }
}

/// Phases are set to the frame on screen, which the selected subject has.
fn phases_ui(
    ui: &mut Ui,
    index: usize,
    view: &CohortView,
    subject: &Subject,
    commands: &mut Vec<Command>,
) {
    let shown = view.edits.frame.filter(|_| view.selected == Some(index));
    for (phase, stated) in [
        (Phase::EndDiastole, subject.end_diastole),
        (Phase::EndSystole, subject.end_systole),
    ] {
        let mut set = |ui: &mut Ui, name: String, frame| {
            let command = EditCommand::SetPhase(Whose::Subject(index), phase, frame);
            command_button_ui(ui, name, command, commands);
        };
        if let Some(frame) = shown.filter(|frame| stated != Some(*frame)) {
            let name = format!("Frame {frame} is {}", phase.name());
            set(ui, name, PhaseFrame::Frame(frame));
        }
        if stated.is_some() {
            let name = format!("{} from the volume curve", phase.name());
            set(ui, crate::picture::sentence(&name), PhaseFrame::Found);
        }
    }
}

fn units_ui(ui: &mut Ui, index: usize, subject: &Subject, commands: &mut Vec<Command>) {
    let now = subject.coordinate_unit();
    ui.menu_button(format!("Unit: {}", now.name()), |ui| {
        for unit in CoordinateUnit::ALL {
            if choice_ui(ui, unit.name(), unit == now) {
                commands.push(EditCommand::SetUnit(Whose::Subject(index), unit).into());
            }
        }
        ui.separator();
        for unit in CoordinateUnit::ALL {
            let name = format!("All subjects: {}", unit.name());
            let set = EditCommand::SetUnit(Whose::All, unit);
            command_button_ui(ui, name, set, commands);
        }
    });
}

fn landmarks_ui(
    ui: &mut Ui,
    index: usize,
    view: &CohortView,
    subject: &Subject,
    commands: &mut Vec<Command>,
) {
    ui.menu_button("Landmarks", |ui| {
        let clicked = view.edits.picked == Some(index);
        for landmark in Landmark::ALL {
            let name = format!("Set {} at the clicked point", landmark.name());
            let button = ui
                .add_enabled(clicked, Button::new(name))
                .on_disabled_hover_text("Click a point of this subject in the 3D view first");
            if button.clicked() {
                commands.push(EditCommand::SetLandmark(landmark).into());
            }
        }
        ui.separator();
        let known = subject.has_landmarks();
        if ui
            .add_enabled(known, Button::new("Remove landmarks"))
            .clicked()
        {
            commands.push(EditCommand::ClearLandmarks(Whose::Subject(index)).into());
        }
    });
}

fn membership_ui(ui: &mut Ui, index: usize, study: &Study, commands: &mut Vec<Command>) {
    let (whose, excluded) = (Whose::Subject(index), study.is_excluded(index));
    let stays = !excluded && study.subjects.len() == 1;
    let delete = ("Delete from the study", EditCommand::Delete(whose));
    let exclude = match excluded {
        true => ("Include in the cohort", EditCommand::Include(whose)),
        false => ("Exclude from the cohort", EditCommand::Exclude(whose)),
    };
    for (name, command) in [exclude, delete] {
        let button = ui
            .add_enabled(!stays, Button::new(name))
            .on_disabled_hover_text("The only subject of the cohort");
        if button.clicked() {
            commands.push(command.into());
        }
    }
}

/// Transport of one subject's motion to the other, in both directions.
fn transport_choices_ui(
    ui: &mut Ui,
    view: &CohortView,
    pair: [usize; 2],
    commands: &mut Vec<Command>,
) {
    let [a, b] = pair.map(|index| &view.rows[index]);
    let correspond = a.correspondence == b.correspondence;
    for (from, onto) in [(pair[0], pair[1]), (pair[1], pair[0])] {
        let name = format!(
            "Transport motion: {} → {}",
            view.rows[from].id, view.rows[onto].id
        );
        let button = ui
            .add_enabled(correspond, Button::new(name))
            .on_disabled_hover_text("No vertex correspondence");
        if button.clicked() {
            commands.push(TransportCommand::TransportMotion { from, onto }.into());
        }
    }
}

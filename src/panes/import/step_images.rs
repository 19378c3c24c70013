//! The step "Images": what was read, which road leads to walls, and what the files do not say.

use egui::Ui;

use super::controls::{heading_ui, sentence_ui, warning_ui};
use super::current::Current;
use crate::analysis::preparation::{Asked, Preparation, Road, TypedTimes};
use crate::analysis::walls_from_masks::MaskLabels;
use crate::document::ImportStep;
use crate::panes::commands::Command;
use crate::picture::sentence;
use crate::ui::controls::{choices_ui, chooser_ui};
use crate::ui::number_field::{NumberField, number_field_ui};

/// Distances between voxels in millimetres.
const SPACING_MM: [f64; 2] = [0.01, 100.0];
/// Lengths of a beat in milliseconds.
const CYCLE_MS: [f64; 2] = [100.0, 10_000.0];
/// Values of labels.
const LABELS: [f64; 2] = [1.0, 1000.0];

/// The step at which something is said.
pub fn step_of(asked: Asked) -> ImportStep {
    match asked {
        Asked::Spacing | Asked::Times | Asked::Labels => ImportStep::Images,
        Asked::Apex | Asked::Base | Asked::Blood => ImportStep::Orientation,
        Asked::Outlines => ImportStep::Tissue,
    }
}

/// Draws the step.
pub fn ui(ui: &mut Ui, current: &Current, commands: &mut Vec<Command>) {
    sentence_ui(ui, current.series.name.clone());
    let proposal = &current.found.proposal;
    let reason = sentence(&proposal.reason);
    match proposal.suitable {
        true => sentence_ui(ui, reason),
        false => warning_ui(ui, format!("No heart can be expected: {}", proposal.reason)),
    }
    heading_ui(ui, "Taken as");
    let road = current.settings.road;
    chooser_ui(ui, "Kind of images", road.words(), |ui| {
        let roads = Road::ALL.map(|road| (road, road.words()));
        let now = Road::ALL
            .into_iter()
            .find(|known| known.name() == road.name());
        let chosen = choices_ui(ui, roads, now.unwrap_or(road));
        commands.extend(chosen.and_then(|road| with_road(current, road)));
    });
    if let Road::Masks(labels) = road {
        labels_ui(ui, current, labels, commands);
    }
    if !current.found.facts.spacing_known {
        spacing_ui(ui, current, commands);
    }
    if !current.found.facts.times_known {
        cycle_ui(ui, current, commands);
    }
    for notice in &current.series.notices {
        sentence_ui(ui, sentence(&notice.text));
    }
}

/// The settings of another road; what was marked and typed stays.
fn with_road(current: &Current, road: Road) -> Option<Command> {
    current.changed(false, |settings| {
        *settings = Preparation {
            road,
            spacing_mm: settings.spacing_mm,
            times: settings.times.clone(),
            points: settings.points,
            contours: std::sync::Arc::clone(&settings.contours),
            ..Preparation::of_road(road)
        };
    })
}

fn labels_ui(ui: &mut Ui, current: &Current, labels: MaskLabels, commands: &mut Vec<Command>) {
    let found = current.found.facts.labels.iter().flatten();
    let found: Vec<String> = found.map(i32::to_string).collect();
    sentence_ui(ui, format!("Labels in the image: {}", found.join(", ")));
    let fields = [
        (
            "Cavity",
            "The label of the blood of the left ventricle",
            Some(labels.cavity),
        ),
        (
            "Myocardium",
            "The label of the wall of the left ventricle",
            Some(labels.wall),
        ),
        (
            "Right ventricle",
            "The label of the right ventricle, which shows the septum",
            labels.right,
        ),
    ];
    for (place, (name, what, value)) in fields.into_iter().enumerate() {
        let field = NumberField {
            name,
            what,
            unit: "",
            range: LABELS,
            value: value.map(f64::from),
            automatic: (place == 2).then_some("none"),
            enabled: true,
        };
        let typed = number_field_ui(ui, &field, |number| label(number, place == 2));
        commands.extend(typed.and_then(|label| with_label(current, labels, place, label)));
    }
}

fn label(number: Option<f64>, optional: bool) -> Result<Option<i32>, String> {
    match number {
        None if optional => Ok(None),
        Some(label) if label.fract() == 0.0 && (LABELS[0]..=LABELS[1]).contains(&label) => {
            Ok(Some(label as i32))
        }
        _ => Err("a label is a whole number from 1 to 1000".to_owned()),
    }
}

fn with_label(
    current: &Current,
    mut labels: MaskLabels,
    place: usize,
    label: Option<i32>,
) -> Option<Command> {
    match (place, label) {
        (0, Some(label)) => labels.cavity = label,
        (1, Some(label)) => labels.wall = label,
        (2, label) => labels.right = label,
        _ => {}
    }
    current.changed(false, |settings| settings.road = Road::Masks(labels))
}

fn spacing_ui(ui: &mut Ui, current: &Current, commands: &mut Vec<Command>) {
    heading_ui(ui, "Distances between voxels");
    sentence_ui(ui, "The file does not say them: volumes would mean nothing");
    for (axis, name) in ["Along i", "Along j", "Along k"].into_iter().enumerate() {
        let typed = current.settings.spacing_mm;
        let field = NumberField {
            name,
            what: "Distance from one voxel to the next",
            unit: "mm",
            range: SPACING_MM,
            value: typed.map(|spacing| spacing[axis]),
            automatic: None,
            enabled: true,
        };
        let accept = |number: Option<f64>| {
            let number = number.filter(|mm| (SPACING_MM[0]..=SPACING_MM[1]).contains(mm));
            number.ok_or_else(|| "0.01 to 100 mm".to_owned())
        };
        if let Some(mm) = number_field_ui(ui, &field, accept) {
            commands.extend(current.changed(false, |settings| {
                // The first that is typed holds for all, until the others are.
                let spacing = settings.spacing_mm.get_or_insert([mm; 3]);
                spacing[axis] = mm;
            }));
        }
    }
}

fn cycle_ui(ui: &mut Ui, current: &Current, commands: &mut Vec<Command>) {
    heading_ui(ui, "Times");
    sentence_ui(
        ui,
        "The file does not say them: without, the beat counts in shares",
    );
    let field = NumberField {
        name: "Length of the beat",
        what: "Time from one R wave to the next; the volumes are equal parts of it",
        unit: "ms",
        range: CYCLE_MS,
        value: match current.settings.times {
            Some(TypedTimes::Cycle(ms)) => Some(ms),
            _ => None,
        },
        automatic: Some("unknown"),
        enabled: true,
    };
    let accept = |number: Option<f64>| match number {
        Some(ms) if !(CYCLE_MS[0]..=CYCLE_MS[1]).contains(&ms) => Err("100 to 10000 ms".to_owned()),
        number => Ok(number),
    };
    if let Some(cycle) = number_field_ui(ui, &field, accept) {
        commands.extend(current.changed(false, |settings| {
            settings.times = cycle.map(TypedTimes::Cycle);
        }));
    }
}

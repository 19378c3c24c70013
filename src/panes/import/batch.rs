//! The pane "Batch": a row for each person with images, with how far the import is and what needs a look.

use std::sync::Arc;

use egui::{Align2, Color32, Margin, Rect, Sense, Ui, WidgetInfo, pos2, vec2};

use super::current::{Current, wants_walls};
use super::facts::{fit, needs_a_look};
use super::step_walls::is_in_cohort;
use crate::analysis::preparation::Preparation;
use crate::engine::{Interrupted, Showing};
use crate::panes::buttons::command_button_ui;
use crate::panes::commands::{Command, ImagesCommand, ImportCommand, Pane, WindowCommand};
use crate::panes::pane_context::PaneContext;
use crate::ui::controls::{empty_pane_ui, focus_ring, scrolled_ui};
use crate::ui::style::{medium_font, note_font, text_font};
use crate::ui::text::counted;
use crate::ui::theme::{Colours, colours, space};

/// How far the import of one person's images is.
#[derive(Clone, Debug, PartialEq)]
pub enum BatchState {
    /// The images are looked at.
    Looking,
    /// Somebody must say something.
    Missing(String),
    /// Walls were not asked for.
    Waiting,
    /// They are made; done share.
    Making(f32),
    /// The user stopped it.
    Stopped,
    /// There are none, and why.
    Failed(String),
    /// There are walls; what needs a look, if anything.
    Made(Option<String>),
    /// They are in the study.
    InCohort(Option<String>),
}

impl BatchState {
    /// What the row says.
    pub fn words(&self) -> String {
        match self {
            Self::Looking => "looking at the images".to_owned(),
            Self::Missing(what) => format!("needs {what}"),
            Self::Waiting => "walls not made yet".to_owned(),
            Self::Making(share) => format!("making walls, {:.0} %", 100.0 * share),
            Self::Stopped => "stopped".to_owned(),
            Self::Failed(why) => why.clone(),
            Self::Made(Some(what)) | Self::InCohort(Some(what)) => what.clone(),
            Self::Made(None) => "ready".to_owned(),
            Self::InCohort(None) => "in the cohort".to_owned(),
        }
    }

    /// Whether a person should look at it.
    pub fn needs_a_look(&self) -> bool {
        match self {
            Self::Missing(_) | Self::Failed(_) => true,
            Self::Made(what) | Self::InCohort(what) => what.is_some(),
            _ => false,
        }
    }

    fn colour(&self, colours: &Colours) -> Color32 {
        match self {
            Self::Failed(_) => colours.error,
            _ if self.needs_a_look() => colours.warning,
            Self::Made(None) | Self::InCohort(None) => colours.normal,
            _ => colours.muted,
        }
    }
}

/// A row of the table.
#[derive(Clone, Debug, PartialEq)]
pub struct BatchRow {
    /// Whose images.
    pub id: String,
    /// What they are.
    pub found: String,
    /// How far it is.
    pub state: BatchState,
    /// End-diastolic volume, ejection fraction in percent, mean fit in millimetres: as far as they are known.
    pub numbers: [Option<f64>; 3],
}

/// Draws the table with its buttons.
pub fn batch_ui(ui: &mut Ui, cx: &PaneContext<'_>, commands: &mut Vec<Command>) {
    let document = &cx.state().document;
    let count = document.images().len();
    if count == 0 {
        let what = "A folder of studies with images is a table here: what each needs, and how well its walls fit.";
        empty_pane_ui(ui, "No images", what, |_| {});
        return;
    }
    let all: Vec<Option<Current>> = (0..count).map(|images| Current::of(cx, images)).collect();
    let rows: Vec<BatchRow> = (all.iter().enumerate())
        .map(|(images, current)| row(cx, images, current.as_ref()))
        .collect();
    scrolled_ui(ui, "batch", Margin::same(space::MEDIUM as i8), |ui| {
        actions_ui(ui, cx, &all, &rows, commands);
        ui.add_space(space::MEDIUM);
        let columns = columns(ui.available_width());
        heads_ui(ui, &columns);
        for (images, row) in rows.iter().enumerate() {
            let selected = document.slices.images == Some(images);
            match row_ui(ui, row, &columns, selected) {
                Some(Clicked::Once) => commands.push(ImagesCommand::Show(images).into()),
                Some(Clicked::Twice) => {
                    commands.push(ImagesCommand::Show(images).into());
                    commands.push(WindowCommand::ShowPane(Pane::SLICES).into());
                }
                None => {}
            }
        }
    });
}

fn row(cx: &PaneContext<'_>, images: usize, current: Option<&Current>) -> BatchRow {
    let document = &cx.state().document;
    let id = document.images().get(images).map(|entry| entry.id.clone());
    let mut row = BatchRow {
        id: id.unwrap_or_default(),
        found: String::new(),
        state: BatchState::Looking,
        numbers: [None; 3],
    };
    let Some(current) = current else {
        return row;
    };
    let [_, _, slices] = current.found.facts.size;
    let instants = current.found.facts.instants;
    row.found = format!("{}, {slices} × {instants}", current.settings.road.words());
    let missing: Vec<&str> = current.needed().iter().map(|asked| asked.words()).collect();
    if !missing.is_empty() {
        row.state = BatchState::Missing(missing.join(", "));
        return row;
    }
    let showing = match wants_walls(document, images) {
        true => current.ask_walls(cx),
        false => cx.known(&current.walls_query()).map(Showing::Ready),
    };
    if let Some(made) = showing.as_ref().and_then(Showing::ready) {
        let ef = made.measures.ef.map(|ef| 100.0 * ef);
        row.numbers = [made.measures.edv, ef, Some(fit(made).mean_mm)];
    }
    let in_cohort = is_in_cohort(cx, current);
    row.state = match showing {
        Some(Showing::Ready(made)) if in_cohort => BatchState::InCohort(needs_a_look(&made)),
        Some(Showing::Ready(made)) => BatchState::Made(needs_a_look(&made)),
        _ if in_cohort => {
            row.numbers = numbers_in_study(cx, images);
            BatchState::InCohort(None)
        }
        None => BatchState::Waiting,
        Some(Showing::Computing { watch, .. }) => BatchState::Making(watch.fraction()),
        Some(Showing::Interrupted { why, .. }) => match why {
            Interrupted::Stopped => BatchState::Stopped,
            Interrupted::Failed(error) => BatchState::Failed(error.to_string()),
        },
    };
    row
}

/// What the study says of the subject of images.
fn numbers_in_study(cx: &PaneContext<'_>, images: usize) -> [Option<f64>; 3] {
    let state = cx.state();
    let subject = state.document.subject_of_images(images);
    let measures = subject.and_then(|subject| state.measures_of(subject));
    match measures {
        Some(measures) => [measures.edv, measures.ef.map(|ef| 100.0 * ef), None],
        None => [None; 3],
    }
}

fn actions_ui(
    ui: &mut Ui,
    cx: &PaneContext<'_>,
    all: &[Option<Current>],
    rows: &[BatchRow],
    commands: &mut Vec<Command>,
) {
    let document = &cx.state().document;
    let looks = rows.iter().filter(|row| row.state.needs_a_look()).count();
    ui.horizontal_wrapped(|ui| {
        let mut batch = document.import.batch;
        if ui.checkbox(&mut batch, "Make the walls of all").changed() {
            commands.push(ImportCommand::ToggleBatch.into());
        }
        let shown = document
            .slices
            .images
            .and_then(|images| all.get(images)?.as_ref());
        if let Some(shown) = shown.filter(|_| all.len() > 1) {
            let words = format!("Settings of {} for all", shown.id);
            let what =
                "Blur, threshold and surfaces; points, edits and outlines stay those of each";
            let settings: Option<Vec<_>> =
                all.iter().map(|one| like(one.as_ref()?, shown)).collect();
            if let Some(settings) = settings {
                let set = ImportCommand::SetAll { settings };
                command_button_ui(ui, words, set, commands).on_hover_text(what);
            }
        }
        let ready: Vec<(usize, Arc<Preparation>)> = (all.iter().zip(rows).enumerate())
            .filter(|(_, (_, row))| matches!(row.state, BatchState::Made(_)))
            .filter_map(|(images, (one, _))| Some((images, Arc::clone(&one.as_ref()?.settings))))
            .collect();
        if !ready.is_empty() {
            let words = format!("Add {} to the cohort", counted(ready.len(), "subject"));
            command_button_ui(ui, words, ImportCommand::Add(ready), commands);
        }
        let words = match looks {
            0 => counted(rows.len(), "study").replace("studys", "studies"),
            1 => "1 needs a look".to_owned(),
            looks => format!("{looks} need a look"),
        };
        ui.label(crate::ui::style::note(words));
    });
}

/// The settings of one with what concerns all of another's.
fn like(one: &Current, shown: &Current) -> Option<Arc<Preparation>> {
    if one.settings.road.name() != shown.settings.road.name() {
        return Some(Arc::clone(&one.settings));
    }
    let own = &one.settings;
    Some(Arc::new(Preparation {
        spacing_mm: own.spacing_mm,
        times: own.times.clone(),
        edits: own.edits.clone(),
        points: own.points,
        contours: Arc::clone(&own.contours),
        ..Preparation::clone(&shown.settings)
    }))
}

/// Left edges of id, found and note, and right edges of the numbers.
struct Columns {
    found: f32,
    numbers: [f32; 3],
    note: f32,
}

fn columns(width: f32) -> Columns {
    let found = (0.2 * width).max(72.0);
    let first = found + (0.24 * width).max(110.0) + 44.0;
    let step = (0.09 * width).clamp(46.0, 80.0);
    Columns {
        found,
        numbers: [first, first + step, first + 2.0 * step],
        note: first + 2.0 * step + space::LARGE,
    }
}

fn heads_ui(ui: &mut Ui, columns: &Columns) {
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), space::ROW), Sense::hover());
    let colour = colours(ui).muted;
    let y = rect.center().y;
    let heads = [
        ("study", 0.0),
        ("found", columns.found),
        ("note", columns.note),
    ];
    for (text, x) in heads {
        let at = pos2(rect.left() + x + space::SMALL, y);
        ui.painter()
            .text(at, Align2::LEFT_CENTER, text, note_font(), colour);
    }
    for (text, x) in ["EDV ml", "EF %", "fit mm"]
        .into_iter()
        .zip(columns.numbers)
    {
        let at = pos2(rect.left() + x, y);
        ui.painter()
            .text(at, Align2::RIGHT_CENTER, text, note_font(), colour);
    }
}

enum Clicked {
    Once,
    Twice,
}

fn row_ui(ui: &mut Ui, row: &BatchRow, columns: &Columns, selected: bool) -> Option<Clicked> {
    let (rect, response) =
        ui.allocate_exact_size(vec2(ui.available_width(), space::ROW), Sense::click());
    let words = row.state.words();
    let name = format!("{}: {words}", row.id);
    response.widget_info(|| WidgetInfo::selected(egui::Role::Row, true, selected, &name));
    let colours = colours(ui);
    if selected || response.hovered() {
        ui.painter().rect_filled(rect, 2.0, colours.selected_row);
    }
    focus_ring(ui, &response);
    let y = rect.center().y;
    let text = |x: f32, end: f32, text: &str, font, colour| {
        let clip = Rect::from_min_max(
            pos2(rect.left() + x, rect.top()),
            pos2((rect.left() + end).min(rect.right()), rect.bottom()),
        );
        let painter = ui.painter().with_clip_rect(clip.intersect(ui.clip_rect()));
        let at = pos2(clip.left() + space::SMALL, y);
        painter.text(at, Align2::LEFT_CENTER, text, font, colour);
    };
    let id_colour = if selected {
        colours.selection
    } else {
        colours.strong
    };
    text(0.0, columns.found, &row.id, medium_font(), id_colour);
    text(
        columns.found,
        columns.numbers[0] - 40.0,
        &row.found,
        text_font(),
        colours.text,
    );
    text(
        columns.note,
        f32::INFINITY,
        &words,
        text_font(),
        row.state.colour(colours),
    );
    for (place, (value, x)) in row.numbers.into_iter().zip(columns.numbers).enumerate() {
        let digits = if place == 2 { 1 } else { 0 };
        let shown = value.map_or_else(|| "–".to_owned(), |value| format!("{value:.digits$}"));
        let at = pos2(rect.left() + x, y);
        ui.painter()
            .text(at, Align2::RIGHT_CENTER, shown, text_font(), colours.text);
    }
    let response = response.on_hover_text(&name);
    if response.double_clicked() {
        return Some(Clicked::Twice);
    }
    response.clicked().then_some(Clicked::Once)
}

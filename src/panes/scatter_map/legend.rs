//! The strip below a map: how many subjects of each label it holds, how well it fits, and its clusters.

use egui::{Align2, RichText, Sense, Ui, UiBuilder, pos2, vec2};

use crate::panes::cohort::rows::count_text;
use crate::panes::commands::{Command, MapCommand};
use crate::ui::label_marks::{LabelMark, label_mark};
use crate::ui::style::{note, note_font};
use crate::ui::text::text_width;
use crate::ui::theme::{colours, space};

use super::clusters::{cluster_counts, cluster_name};
use super::view::ScatterView;

/// Height of the strip.
pub const LEGEND: f32 = 26.0;

/// Width of a mark, and of all that an entry has beside its text.
const MARK_WIDTH: f32 = 10.0;
const ENTRY_BESIDE_TEXT: f32 = MARK_WIDTH + 3.0 * space::SMALL + space::MEDIUM;
/// Width of "+3".
const MORE_WIDTH: f32 = 24.0;
/// Share of the strip that labels may take from the note.
const LABELS_SHARE: f32 = 0.62;

/// Lines of the hover for subjects that are not on the map.
const MAX_LINES: usize = 12;

/// Counts of labels on the left; on the right the clusters or, where there are none, the note.
pub fn legend_ui(ui: &mut Ui, view: &ScatterView, commands: &mut Vec<Command>) {
    let (strip, _) = ui.allocate_exact_size(vec2(ui.available_width(), LEGEND), Sense::hover());
    let inner = strip.shrink2(vec2(space::LARGE, 0.0));
    let mut row = ui.new_child(UiBuilder::new().max_rect(inner));
    row.set_height(LEGEND);
    let clusters = cluster_counts(view.points);
    let sides = egui::Sides::new().height(LEGEND);
    if clusters.is_empty() {
        let room = LABELS_SHARE * inner.width();
        sides.shrink_right().truncate().show(
            &mut row,
            |ui| label_counts_ui(ui, view, room, inner.width()),
            |ui| {
                let (whole, short) = (trust_text(view), view.note.as_str());
                let cut = text_width(ui, &whole, note_font()) > ui.available_width();
                // That axes have no unit is also said on hover.
                let unsaid = view.left_out.is_empty() && filter_text(view).is_none();
                let text = if cut && unsaid && !short.is_empty() {
                    short
                } else {
                    &whole
                };
                note_ui(ui, view, text);
            },
        );
    } else {
        let wide = inner.width() > 240.0 + 34.0 * clusters.len() as f32;
        sides.shrink_left().show(
            &mut row,
            |ui| {
                // Beside the clusters, or the box that shows them.
                let beside = if wide {
                    110.0 + 34.0 * clusters.len() as f32
                } else {
                    110.0
                };
                let room = inner.width() - beside;
                label_counts_ui(ui, view, room, room);
                if let Some(filter) = filter_text(view) {
                    note_ui(ui, view, &filter);
                } else if !view.left_out.is_empty() {
                    note_ui(ui, view, &left_out_text(view));
                }
            },
            |ui| clusters_ui(ui, view, &clusters, wide, commands),
        );
    }
}

/// One entry of the legend: subjects on the map that are marked alike.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Entry {
    mark: LabelMark,
    /// The label as the study writes it; the class where normal labels share a mark.
    name: String,
    count: usize,
}

/// One entry per mark that occurs, normal first and subjects without a label last.
fn entries(view: &ScatterView) -> Vec<Entry> {
    let mut entries: Vec<Entry> = Vec::new();
    for points in view.points.chunk_by(|a, b| a.subject == b.subject) {
        let subject = points[0].subject;
        if view.is_filtered_out(subject) {
            continue;
        }
        let mark = view.mark(subject);
        match entries.iter_mut().find(|entry| entry.mark == mark) {
            Some(entry) => entry.count += 1,
            None => entries.push(Entry {
                mark,
                name: name_of(view, subject, mark),
                count: 1,
            }),
        }
    }
    entries.sort_by_key(|entry| entry.mark);
    entries
}

fn name_of(view: &ScatterView, subject: usize, mark: LabelMark) -> String {
    let row = view.subjects.get(subject);
    mark.name(row.and_then(|row| row.label.as_deref()))
}

/// What an entry says beside its mark.
#[derive(Clone, Copy)]
enum Words {
    /// "DCM 20".
    NameAndCount,
    /// "DCM": whoever reads the map must know which mark is which.
    Name,
    /// "20".
    Count,
}

impl Words {
    fn of(self, entry: &Entry) -> String {
        match self {
            Self::NameAndCount => format!("{} {}", entry.name, entry.count),
            Self::Name => entry.name.clone(),
            Self::Count => entry.count.to_string(),
        }
    }

    fn width(self, ui: &Ui, entry: &Entry) -> f32 {
        ENTRY_BESIDE_TEXT + text_width(ui, &self.of(entry), note_font())
    }

    /// The most that fits; `beside` is the room where the note yields to names.
    fn that_fit(ui: &Ui, entries: &[Entry], room: f32, beside: f32) -> (Self, f32) {
        let width =
            |words: Self| -> f32 { entries.iter().map(|entry| words.width(ui, entry)).sum() };
        let fits = [
            (Self::NameAndCount, room),
            (Self::Name, room),
            (Self::Name, beside),
        ];
        let fit = fits
            .into_iter()
            .find(|(words, room)| width(*words) <= *room);
        fit.unwrap_or((Self::Count, room))
    }
}

/// Draws the entries; counts, then names are left to the hover where there is little room, and entries past the end to a
/// last one.
fn label_counts_ui(ui: &mut Ui, view: &ScatterView, room: f32, beside: f32) {
    let entries = entries(view);
    ui.spacing_mut().item_spacing.x = space::SMALL;
    let long = |entry: &Entry| Words::NameAndCount.of(entry);
    let (words, mut left) = Words::that_fit(ui, &entries, room, beside);
    for (index, entry) in entries.iter().enumerate() {
        let last = index + 1 == entries.len();
        left -= words.width(ui, entry);
        if left < if last { 0.0 } else { MORE_WIDTH } && index > 0 {
            let rest: Vec<String> = entries[index..].iter().map(long).collect();
            let more = ui.label(note(format!("+{}", rest.len())));
            more.on_hover_text(rest.join("\n"));
            return;
        }
        entry_ui(ui, entry.mark, words.of(entry), long(entry));
    }
}

fn entry_ui(ui: &mut Ui, label: LabelMark, text: String, name: String) {
    let colours = colours(ui);
    let (mark, _) = ui.allocate_exact_size(vec2(MARK_WIDTH, 12.0), Sense::hover());
    let filled = label != LabelMark::Unlabelled;
    label_mark(ui, mark.center(), 4.0, label, filled);
    let galley = ui
        .painter()
        .layout_no_wrap(text, note_font(), colours.muted);
    let (rect, response) = ui.allocate_exact_size(galley.size(), Sense::hover());
    let at = Align2::LEFT_CENTER
        .align_size_within_rect(galley.size(), rect)
        .min;
    ui.painter().galley(pos2(at.x, at.y), galley, colours.muted);
    response.on_hover_text(name);
    ui.add_space(space::MEDIUM);
}

fn note_ui(ui: &mut Ui, view: &ScatterView, text: &str) {
    if ui.available_width() > 70.0 {
        ui.add(egui::Label::new(note(text)).truncate())
            .on_hover_text(explanation(view));
    }
}

/// "stress 0.09 · 3 not on the map".
fn trust_text(view: &ScatterView) -> String {
    if let Some(filter) = filter_text(view) {
        return filter;
    }
    let rest = if view.left_out.is_empty() {
        "axes have no unit".to_owned()
    } else {
        left_out_text(view)
    };
    if view.note.is_empty() {
        rest
    } else {
        format!("{} · {rest}", view.note)
    }
}

/// "6 of 23 shown" while the filter of the cohort table leaves subjects out.
fn filter_text(view: &ScatterView) -> Option<String> {
    let count = view.subjects.len();
    let shown = view.subjects.iter().filter(|row| !row.filtered_out).count();
    (shown < count).then(|| format!("{} shown", count_text(shown, count)))
}

fn left_out_text(view: &ScatterView) -> String {
    format!("{} not on the map", view.left_out.len())
}

fn explanation(view: &ScatterView) -> String {
    let mut text = view.explanation.clone();
    if !view.left_out.is_empty() {
        text += "\nNot on the map:";
        let lines = view.left_out.iter().take(MAX_LINES);
        lines.for_each(|line| text += &format!("\n{line}"));
        if view.left_out.len() > MAX_LINES {
            text += &format!("\nand {} more", view.left_out.len() - MAX_LINES);
        }
    }
    text
}

fn clusters_ui(
    ui: &mut Ui,
    view: &ScatterView,
    clusters: &[(usize, usize)],
    wide: bool,
    commands: &mut Vec<Command>,
) {
    ui.spacing_mut().item_spacing.x = space::SMALL;
    if wide && view.shows_clusters {
        for (cluster, count) in clusters.iter().rev() {
            let text = format!("{} {count}", cluster_name(*cluster));
            let colour = colours(ui).cluster(*cluster);
            ui.label(RichText::new(text).small().color(colour))
                .on_hover_text(format!("{count} subjects in this cluster"));
            ui.add_space(space::SMALL);
        }
    }
    let mut shown = view.shows_clusters;
    let box_ui = ui
        .checkbox(&mut shown, note("Clusters"))
        .on_hover_text("Groups that k-means finds without knowing the labels");
    if box_ui.clicked() {
        commands.push(MapCommand::ToggleClusters.into());
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::panes::scatter_map::tests::{Map, view};

    #[test]
    fn the_legend_has_an_entry_for_each_label_that_is_on_the_map() {
        let mut map = Map::default();
        for (subject, (mark, label)) in [
            (LabelMark::Label(1), Some("MINF")),
            (LabelMark::Normal, Some("NOR")),
            (LabelMark::Label(0), Some("DCM")),
        ]
        .into_iter()
        .enumerate()
        {
            map.subjects[subject].mark = mark;
            map.subjects[subject].label = label.map(str::to_owned);
        }
        let entries = entries(&view(&map)).into_iter();
        let shown: Vec<(String, usize)> = entries.map(|entry| (entry.name, entry.count)).collect();
        let wanted = [("normal", 1), ("DCM", 1), ("MINF", 1)];
        assert_eq!(shown, wanted.map(|(name, count)| (name.to_owned(), count)));
    }

    #[test]
    fn a_filter_takes_subjects_out_of_the_legend_and_says_how_many_are_shown() {
        let mut map = Map::default();
        map.subjects[1].filtered_out = true;
        let view = view(&map);
        assert_eq!(trust_text(&view), "2 of 3 shown");
        let count: usize = entries(&view).iter().map(|entry| entry.count).sum();
        assert_eq!(count, 2);
    }

    #[test]
    fn the_note_ends_with_who_is_missing_and_the_hover_names_twelve_of_them() {
        let map = Map::default();
        let mut view = view(&map);
        assert_eq!(trust_text(&view), "stress 0.08 · axes have no unit");
        let missing: Vec<String> = (0..14).map(|index| format!("M{index}: no wall")).collect();
        view.left_out = &missing;
        assert_eq!(trust_text(&view), "stress 0.08 · 14 not on the map");
        let lines = explanation(&view);
        assert!(lines.contains("\nM11: no wall\nand 2 more"));
        assert!(!lines.contains("M12"));
        view.note.clear();
        assert_eq!(trust_text(&view), "14 not on the map");
    }
}

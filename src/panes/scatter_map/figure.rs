//! A map as a figure: the points, marks and names of the pane, the selected subject on top, without what the pointer is on.

use crate::document::state::State;
use crate::panes::cohort::view::cohort_data;
use crate::panes::pane_context::PaneContext;
use crate::picture::plot::{LegendEntry, MapPath, MapPlot, MapPoint, Plot, PlotFigure, PointLook};
use crate::ui::text::counted;

use super::path::paths;
use super::point::{PosePhase, ScatterPoint};
use super::view::{MapWords, ScatterView};

/// How many subjects that are not on the map are named.
const MAX_NAMED: usize = 3;

/// What a map says of itself in a figure.
#[derive(Clone, Debug)]
pub struct MapFigureWords {
    /// Beginning of its file's name.
    pub stem: &'static str,
    /// The map, its metric and its method.
    pub title: String,
    /// How well it fits; may be empty.
    pub fit: String,
    /// All settings.
    pub parameters: String,
    /// What large, open and small marks mean.
    pub marks: &'static str,
}

/// The figure of a map of these points as the document shows it; `left_out` says who is not on it, and why.
pub fn map_figure(
    cx: &PaneContext<'_>,
    map: &'static MapWords,
    points: &[ScatterPoint],
    left_out: &[String],
    words: MapFigureWords,
) -> PlotFigure {
    let (state, cohort) = (cx.state(), cohort_data(cx));
    let cohort = cohort.borrow_mut();
    let view = ScatterView {
        selected: state.document.selected_index(),
        left_out,
        ..ScatterView::new(map, cohort.rows(), points)
    };
    figure_of(state, &view, words)
}

fn figure_of(state: &State, view: &ScatterView<'_>, words: MapFigureWords) -> PlotFigure {
    let study = state.document.study();
    let paths: Vec<MapPath> = paths(view.points)
        .map(|path| map_path(view, &view.points[path]))
        .collect();
    let mut subjects: Vec<usize> = view.points.iter().map(|point| point.subject).collect();
    subjects.sort_unstable();
    subjects.dedup();
    let mut counts = vec![study.name.clone(), counted(subjects.len(), "subject")];
    if view.points.len() > subjects.len() {
        counts.push(counted(view.points.len(), "point"));
    }
    counts.extend((!words.fit.is_empty()).then_some(words.fit));
    let shown = subjects.iter().copied();
    let shown: Vec<usize> = shown
        .filter(|&index| !view.is_filtered_out(index))
        .collect();
    let mut notes = vec![words.marks.to_owned()];
    if let Some(selected) = view.selected.filter(|index| subjects.contains(index)) {
        let id = state.subject(selected).map_or("", |subject| &subject.id);
        notes.push(format!("Emphasised: {id}"));
    }
    if shown.len() < subjects.len() {
        let (count, all) = (shown.len(), subjects.len());
        let filter = state.document.search.trim();
        notes.push(format!(
            "{count} of {all} subjects match the filter “{filter}”; the others are pale"
        ));
    }
    notes.extend(left_out_note(view.left_out));
    PlotFigure {
        stem: words.stem.to_owned(),
        title: words.title,
        lines: vec![counts.join(" · "), words.parameters],
        notes,
        plot: Plot::Map(MapPlot {
            legend: LegendEntry::of(study, shown),
            paths,
        }),
    }
}

fn map_path(view: &ScatterView<'_>, path: &[ScatterPoint]) -> MapPath {
    let first = &path[0];
    let subject = first.subject;
    let id = view.subjects.get(subject).map_or("", |row| &row.id);
    let before = std::iter::once(None).chain(path.iter().map(Some));
    let point = |(point, before): (&ScatterPoint, Option<&ScatterPoint>)| MapPoint {
        at: point.at,
        look: match point.phase {
            PosePhase::EndDiastole | PosePhase::WholeMotion => PointLook::Filled,
            PosePhase::EndSystole => PointLook::Open,
            PosePhase::Between => PointLook::Small,
        },
        joined: before.is_none_or(|before| before.leads_to(point)),
    };
    MapPath {
        name: view.path_name(id, first),
        mark: view.mark(subject),
        points: path.iter().zip(before).map(point).collect(),
        cyclic: path.len() > 2,
        selected: view.selected == Some(subject),
        dimmed: view.is_filtered_out(subject),
    }
}

/// Who is not on the map: the first few with the reason, and how many more.
fn left_out_note(left_out: &[String]) -> Option<String> {
    let (named, more) = left_out.split_at(left_out.len().min(MAX_NAMED));
    if named.is_empty() {
        return None;
    }
    let more = match more.len() {
        0 => String::new(),
        count => format!("; and {count} more"),
    };
    Some(format!("Not on the map: {}{more}", named.join("; ")))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::panes::scatter_map::tests::{Map, view};

    fn words() -> MapFigureWords {
        MapFigureWords {
            stem: "pose_map",
            title: "Pose map".to_owned(),
            fit: "stress 0.08".to_owned(),
            parameters: "displacement, SMACOF".to_owned(),
            marks: "Filled: end-diastole",
        }
    }

    #[test]
    fn the_selected_subject_is_emphasised_and_one_beside_the_filter_pale() {
        let mut map = Map::default();
        map.subjects[1].filtered_out = true;
        let mut shown = view(&map);
        shown.selected = Some(0);
        let figure = figure_of(&State::default(), &shown, words());
        let Plot::Map(plot) = &figure.plot else {
            panic!("{:?}", figure.plot);
        };
        for path in &plot.paths {
            let index = map
                .subjects
                .iter()
                .position(|row| path.name.starts_with(&row.id));
            assert_eq!(path.selected, index == Some(0), "{}", path.name);
            assert_eq!(path.dimmed, index == Some(1), "{}", path.name);
        }
        assert!(
            figure
                .notes
                .iter()
                .any(|note| note.contains("match the filter"))
        );
        assert!(figure.lines[0].ends_with("stress 0.08"));
    }

    #[test]
    fn who_is_not_on_the_map_is_named_with_the_reason() {
        assert_eq!(left_out_note(&[]), None);
        let missing = ["A: no wall", "B", "C", "D", "E"].map(str::to_owned);
        let note = left_out_note(&missing).unwrap();
        assert_eq!(note, "Not on the map: A: no wall; B; C; and 2 more");
    }
}

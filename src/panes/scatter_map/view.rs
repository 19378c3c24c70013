//! What a map of points shows, as plain values: each map fills these in, and all are drawn alike.

use crate::engine::Topic;
use crate::panes::cohort::rows::CohortRow;
use crate::panes::commands::{Command, SelectCommand};
use crate::panes::work_state::WorkState;
use crate::picture::share_words;
use crate::ui::LabelMark;

use super::orientation::Turn;
use super::path::paths;
use super::point::{PosePhase, ScatterPoint};

/// The words of one map, and what its points ask for.
#[derive(Clone, Copy, Debug)]
pub struct MapWords {
    /// The work that computes it.
    pub job: Topic,
    /// What the map is called.
    pub name: &'static str,
    /// What a path is called: "Curve" of a subject.
    pub item: &'static str,
    /// Heading where there is nothing to map.
    pub empty: &'static str,
    /// What would fill the pane.
    pub what: &'static str,
    /// Heading where it could not be computed.
    pub none: &'static str,
    /// Last lines of the hover card: what the pointer does.
    pub hints: &'static [&'static str],
    /// What a click on a point, or Enter, asks for.
    pub command: fn(&ScatterPoint) -> Command,
}

/// Shows a point's subject at its start frame and plays from there.
pub fn play_command(point: &ScatterPoint) -> Command {
    let (subject, frame) = (point.subject, point.start_frame);
    let play = true;
    Command::Select(SelectCommand::SelectPose {
        subject,
        frame,
        play,
    })
}

/// What a map shows.
#[derive(Clone, Debug)]
pub struct ScatterView<'a> {
    /// Its words.
    pub words: &'static MapWords,
    /// How the map stands.
    pub state: WorkState,
    /// The work that Cancel and Retry are about.
    pub job: Topic,
    /// All subjects of the study.
    pub subjects: &'a [CohortRow],
    /// All points; none where there is no map.
    pub points: &'a [ScatterPoint],
    /// The selected subject.
    pub selected: Option<usize>,
    /// The second subject of the side-by-side view.
    pub compared: Option<usize>,
    /// Where the position between frames lies on each path of the selected subject.
    pub current: Vec<[f64; 2]>,
    /// How the map is turned onto the screen, where a pose is estimated on empty ground.
    pub ground: Option<Turn>,
    /// What is estimated at the place that is looked at.
    pub estimate: Option<EstimateView>,
    /// Whether clusters are drawn, where points have any.
    pub shows_clusters: bool,
    /// How well the map fits, in a few words; may be empty.
    pub note: String,
    /// What the note means.
    pub explanation: String,
    /// Who is not on the map, and why.
    pub left_out: &'a [String],
}

/// What is estimated at a place of the map.
#[derive(Clone, Debug, PartialEq)]
pub struct EstimateView {
    /// The place, in the coordinates of the embedding.
    pub at: [f64; 2],
    /// Points that it is estimated from, by their place in the list, with their weights.
    pub sources: Vec<(usize, f64)>,
    /// What it is estimated from, or why it cannot be; empty while it is computed.
    pub lines: Vec<String>,
}

impl<'a> ScatterView<'a> {
    /// A map of these points as it is computed, with nothing selected.
    pub fn new(
        words: &'static MapWords,
        subjects: &'a [CohortRow],
        points: &'a [ScatterPoint],
    ) -> Self {
        Self {
            words,
            state: WorkState::Ready,
            job: words.job,
            subjects,
            points,
            selected: None,
            compared: None,
            current: Vec::new(),
            ground: None,
            estimate: None,
            shows_clusters: false,
            note: String::new(),
            explanation: String::new(),
            left_out: &[],
        }
    }

    /// Shape and colour of a subject.
    pub fn mark(&self, subject: usize) -> LabelMark {
        let subject = self.subjects.get(subject);
        subject.map(|subject| subject.mark).unwrap_or_default()
    }

    /// Whether the filter of the cohort table leaves a subject out: it is dimmed, and the pointer passes over it.
    pub fn is_filtered_out(&self, subject: usize) -> bool {
        let subject = self.subjects.get(subject);
        subject.is_some_and(|subject| subject.filtered_out)
    }

    /// Whether the subject is one of the two that stand out.
    pub fn is_chosen(&self, subject: usize) -> bool {
        [self.selected, self.compared].contains(&Some(subject))
    }

    /// Whether the points are not those of the settings.
    pub fn out_of_date(&self) -> bool {
        !matches!(self.state, WorkState::Ready | WorkState::Empty)
    }

    /// "P05 · frame 3, 12 % R-R · end-diastole".
    pub fn title(&self, point: &ScatterPoint) -> String {
        let subject = self.subjects.get(point.subject);
        let id = subject.map_or_else(String::new, |subject| subject.id.clone());
        let frames = point.frames.map(|[from, to]| {
            if from == to {
                let share = share_words(point.share, point.rr_is_known);
                format!("frame {from}, {share}")
            } else {
                format!("frame {from} to {to}")
            }
        });
        let phase = match point.phase {
            PosePhase::EndDiastole => Some("end-diastole".to_owned()),
            PosePhase::EndSystole => Some("end-systole".to_owned()),
            PosePhase::Between | PosePhase::WholeMotion => None,
        };
        let parts: Vec<String> = [Some(id), frames, phase].into_iter().flatten().collect();
        parts.join(" · ")
    }

    /// What is written beside a point of a selected subject: "P05 patch 2 ED".
    pub fn label(&self, point: &ScatterPoint) -> Option<String> {
        let label = point.label?;
        let id = &self.subjects.get(point.subject)?.id;
        let mut text = self.path_name(id, point);
        if !label.is_empty() {
            text += &format!(" {label}");
        }
        Some(text)
    }

    /// The subject with its patch; the patch has a number where there are several.
    pub fn path_name(&self, id: &str, point: &ScatterPoint) -> String {
        let Some(patch) = point.patch else {
            return id.to_owned();
        };
        let own = |path: &std::ops::Range<usize>| self.points[path.start].subject == point.subject;
        if paths(self.points).filter(own).count() > 1 {
            format!("{id} patch {}", patch + 1)
        } else {
            format!("{id} patch")
        }
    }
}

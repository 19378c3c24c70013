//! Everything the window shows, as plain values; the room `app` alone changes it.

use std::collections::HashSet;
use std::path::PathBuf;
use std::sync::Arc;

use crate::analysis::classification::Classes;
use crate::analysis::deformations::DeformationMap;
use crate::analysis::embedding::PoseMap;
use crate::analysis::measures::{SubjectMeasures, phases_of};
use crate::analysis::transport::Reference;
use crate::document::ErrorCard;
use crate::document::ThemeChoice;
use crate::engine::{EstimatedPose, NoEstimate, Showing};
use crate::picture::figure::FigureLook;
use crate::study::built_in::BuiltInParams;
use crate::study::{Revision, Study, Subject};

use crate::document::answers::{Answers, FoundWall};
use crate::document::document::{Document, OpeningReport, StudyRef};
use crate::document::editing::{Leaving, PickedPoint, StudyExport, Typing};
use crate::document::import::ImageTool;
use crate::document::interpolated_poses::{InterpolatedMotion, geodesic_params};
use crate::document::path_entry::PathEntry;
use crate::document::play::PlayClock;
use crate::document::transported::{TransportedSubject, transport_params};
use crate::document::undo::History;

/// Which sheets lie over the window.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Sheets {
    /// The command palette.
    pub palette: bool,
    /// The sheet of shortcuts.
    pub shortcuts: bool,
    /// What was found and assumed while reading.
    pub load_report: bool,
    /// About the program.
    pub about: bool,
    /// How figures look.
    pub figure: bool,
}

/// Everything the window shows.
#[derive(Debug)]
pub struct State {
    /// What undo brings back.
    pub document: Document,
    /// Undo and redo.
    pub history: History,
    /// The place of the pose map, in the coordinates of its embedding, whose estimated pose stands in the 3D view.
    pub estimate_at: Option<[f64; 2]>,
    /// Whether and how fast the motion plays.
    pub play: PlayClock,
    /// What lies over the window.
    pub sheets: Sheets,
    /// Light or dark.
    pub theme: ThemeChoice,
    /// How figures look.
    pub figure_look: FigureLook,
    /// The path that is typed, where the system shows no file dialog.
    pub path_entry: Option<PathEntry>,
    /// Whether the window fills the screen.
    pub full_screen: bool,
    /// What was opened before, latest first.
    pub recent: Vec<PathBuf>,
    /// What went wrong, oldest first.
    pub errors: Vec<ErrorCard>,
    /// What the store says in this frame.
    pub answers: Answers,
    /// What was done last, for the status bar.
    pub message: String,
    /// How finely the built-in cohort is made.
    pub built_in: BuiltInParams,
    /// The cell of the cohort table that is typed into.
    pub typing: Option<Typing>,
    /// The point of a surface that was clicked last.
    pub picked: Option<PickedPoint>,
    /// What a click into a slice of an image does; `None` moves the crosshair.
    pub image_tool: Option<ImageTool>,
    /// What waits for an answer about edits that are not exported.
    pub leaving: Option<Leaving>,
    /// Studies that are being written.
    pub(crate) exports: Vec<StudyExport>,
    /// States of studies that stand in files, or can be made again.
    pub(crate) kept: HashSet<Revision>,
    pub(crate) last_opening: u64,
    /// The opening of the study that is being read while it is shown.
    pub(crate) reading: Option<u64>,
    /// The subject, by its id, that is read before the others and selected then.
    pub awaited: Option<String>,
}

impl Default for State {
    fn default() -> Self {
        let nothing = StudyRef {
            study: Arc::default(),
            opening: 0,
            listing: Revision::default(),
            report: Arc::default(),
        };
        Self {
            document: Document::new(nothing),
            history: History::default(),
            estimate_at: None,
            play: PlayClock::default(),
            sheets: Sheets::default(),
            theme: ThemeChoice::default(),
            figure_look: FigureLook::default(),
            path_entry: None,
            full_screen: false,
            recent: Vec::new(),
            errors: Vec::new(),
            answers: Answers::default(),
            message: String::new(),
            built_in: BuiltInParams::default(),
            typing: None,
            picked: None,
            image_tool: None,
            leaving: None,
            exports: Vec::new(),
            kept: HashSet::from([Revision::default()]),
            last_opening: 0,
            reading: None,
            awaited: None,
        }
    }
}

impl State {
    /// Measures of the study on screen, possibly of its state before the last edit.
    pub fn measures(&self) -> Option<&Arc<Vec<SubjectMeasures>>> {
        self.latest(self.answers.measures.as_ref())
    }

    /// Whether they are being computed.
    pub fn is_measuring(&self) -> bool {
        let measures = self.answers.measures.as_ref();
        measures.is_some_and(Showing::computing)
    }

    /// Measures of one subject; of one on screen they are known before those of the whole cohort.
    pub fn measures_of(&self, subject: usize) -> Option<&SubjectMeasures> {
        match self.measures() {
            Some(all) => all.get(subject),
            None => (self.of_this_study(Some(&self.answers))?).measures_of_one(subject),
        }
    }

    /// The map of the study on screen.
    pub fn map(&self) -> Option<&Arc<PoseMap>> {
        self.latest(self.answers.map.as_ref())
    }

    /// The pose that is estimated at a place of the pose map, while one is looked at; the one before until it is there.
    pub fn estimate(&self) -> Option<&EstimatedPose> {
        (**self.estimated()?).as_ref().ok()
    }

    /// Why no pose is estimated at the place that is looked at.
    pub fn without_estimate(&self) -> Option<&NoEstimate> {
        (**self.estimated()?).as_ref().err()
    }

    fn estimated(&self) -> Option<&Arc<Result<EstimatedPose, NoEstimate>>> {
        self.estimate_at?;
        self.latest(self.answers.estimate.as_ref())
    }

    /// The deformation map of the study on screen.
    pub fn deformations(&self) -> Option<&Arc<DeformationMap>> {
        self.latest(self.answers.deformations.as_ref())
    }

    /// How well the classes of the study on screen are classified.
    pub fn classes(&self) -> Option<&Arc<Classes>> {
        self.latest(self.answers.classes.as_ref())
    }

    /// The poses between a subject's frames, as far as they were computed with today's settings.
    pub fn interpolated_poses_of(&self, index: usize) -> Option<&Arc<InterpolatedMotion>> {
        let params = geodesic_params(&self.document)?;
        let motion = self.answers.interpolated_poses(index)?.motion.as_ref()?;
        motion
            .are_of(self.subject(index)?, &params)
            .then_some(motion)
    }

    /// The transported motion that the document asks for, once it is computed.
    pub fn transported_subject(&self) -> Option<&TransportedSubject> {
        let key = (
            self.document.study().revision,
            self.document.visible_transport()?,
            transport_params(&self.document),
        );
        (self.answers.transported.as_ref()).filter(|subject| subject.key == key)
    }

    /// How a subject's wall thickens: with today's settings, else with those before, and whether it is
    /// today's. `None` while nothing is known.
    pub fn wall_of(&self, index: usize) -> Option<(&FoundWall, bool)> {
        self.of_this_study(Some(&self.answers))?;
        let (found, of_today) = self.answers.wall(index)?.found.as_ref()?;
        Some((found, *of_today))
    }

    /// Frames of end-diastole and end-systole of a subject: as stated, else as measured. What was computed with phases,
    /// such as an ejection fraction, has its own, which may be those before the last edit.
    pub fn phases_of(&self, index: usize) -> (Option<usize>, Option<usize>) {
        (self.subject(index)).map_or((None, None), |subject| {
            phases_of(subject, self.measures_of(index))
        })
    }

    /// "ED" or "ES", where a frame of a subject is that phase.
    pub fn phase_name(&self, subject: usize, frame: usize) -> Option<&'static str> {
        let (end_diastole, end_systole) = self.phases_of(subject);
        let named = [(end_diastole, "ED"), (end_systole, "ES")];
        let mut named = named.into_iter();
        named.find_map(|(phase, name)| (phase == Some(frame)).then_some(name))
    }

    /// "ED", "ES", "frame 3": a frame of a subject.
    pub fn moment_name(&self, subject: usize, frame: usize) -> String {
        let phase = self.phase_name(subject, frame);
        phase.map_or_else(|| format!("frame {frame}"), str::to_owned)
    }

    /// A subject of the study on screen.
    pub fn subject(&self, index: usize) -> Option<&Arc<Subject>> {
        self.document.study().subject(index)
    }

    /// Shows a newly read study; the old one can be had back by undo.
    pub fn show_study(&mut self, study: Arc<Study>, report: OpeningReport) {
        self.last_opening += 1;
        let opening = self.last_opening;
        let before = self.document.clone();
        self.kept.insert(study.revision);
        let mut document = Document::new(StudyRef {
            listing: study.revision,
            study,
            opening,
            report: Arc::new(report),
        });
        document.map = before.map;
        if let Some(transport) = document.map.distances.transport
            && matches!(transport.reference, Reference::Subject(_))
        {
            // That subject is not of this study.
            document.map.distances.transport = None;
        }
        document.deformation_map = before.deformation_map;
        document.shows_clusters = before.shows_clusters;
        document.thickening = before.thickening;
        document.bulls_eye = before.bulls_eye;
        document.bulls_eye_segments = before.bulls_eye_segments;
        document.interpolated_poses = before.interpolated_poses;
        document.visibility = before.visibility;
        self.history.forget_studies_before(before.study.opening);
        if before.study.opening > 0 {
            self.history.record(before, None, false, 0.0);
        }
        document.show_images_of_selected();
        self.document = document;
        self.play.playing = false;
        self.estimate_at = None;
        self.leave_listing();
    }

    /// Lets go of what names a subject by its index and is no part of the document: another list is on screen.
    pub fn leave_listing(&mut self) {
        self.typing = None;
        self.picked = None;
        self.image_tool = None;
    }

    /// Whether the study on screen has edits that were not exported.
    pub fn is_edited(&self) -> bool {
        !self.kept.contains(&self.document.study().revision)
    }

    /// An answer, unless it is about a study that is not on screen any more.
    pub(crate) fn of_this_study<'a, T>(&self, answer: Option<&'a T>) -> Option<&'a T> {
        answer.filter(|_| self.answers.listing == self.document.study.listing)
    }

    fn latest<'a, T>(&self, showing: Option<&'a Showing<T>>) -> Option<&'a Arc<T>> {
        self.of_this_study(showing)?.latest()
    }
}

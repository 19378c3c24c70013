//! Everything the window shows, as plain values; `apply` alone changes it.

use std::path::PathBuf;
use std::sync::Arc;

use crate::analysis::classification::Classes;
use crate::analysis::deformations::DeformationMap;
use crate::analysis::measures::SubjectMeasures;
use crate::analysis::medial_map::MedialMap;
use crate::analysis::transport::Reference;
use crate::engine::PoseMap;
use crate::study::built_in::BuiltInParams;
use crate::study::{Revision, Study, Subject};
use crate::ui::{ErrorCard, ThemeChoice};

use super::carried::{CarriedHeart, CarryingState, transport_params};
use super::differences::DifferenceStore;
use super::document::{Document, OpeningReport, StudyRef};
use super::found_verdicts::VerdictStore;
use super::in_betweens::{InBetweenStore, InBetweens, geodesic_params};
use super::play::PlayClock;
use super::thickness_store::ThicknessStore;
use super::undo::History;
use super::walls::{FoundWall, WallStore};

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
}

/// A result with the study it belongs to.
#[derive(Clone, Debug)]
pub struct Fresh<T> {
    /// The revision that it was computed from.
    pub revision: Revision,
    /// Which opening that study came from; subjects' indices mean the same within one.
    pub opening: u64,
    /// The result as the engine gave it.
    pub source: Arc<T>,
    /// The result as it is shown.
    pub value: Arc<T>,
}

/// The latest results; shown while newer ones are computed, as long as they are of the same study.
#[derive(Clone, Debug, Default)]
pub struct Results {
    /// Clinical measures of every subject.
    pub measures: Option<Fresh<Vec<SubjectMeasures>>>,
    /// The map of all poses, turned to agree with the map before it.
    pub map: Option<Fresh<PoseMap>>,
    /// The map of whole deformations, turned likewise.
    pub deformations: Option<Fresh<DeformationMap>>,
    /// How well classes can be told apart.
    pub classes: Option<Fresh<Classes>>,
    /// Poses between the frames of beats.
    pub in_betweens: InBetweenStore,
    /// The beat that was carried over last.
    pub carried: Option<CarriedHeart>,
    /// How the carrying that the document asks for stands.
    pub carrying: CarryingState,
    /// Where the poses side by side differ.
    pub differences: DifferenceStore,
    /// How walls thicken, and their patches.
    pub walls: WallStore,
    /// What is said of all hearts.
    pub verdicts: VerdictStore,
    /// The map of the medial shape space, turned to agree with the map before it.
    pub medial_map: Option<Fresh<MedialMap>>,
    /// Thickness of walls in several ways of measuring it.
    pub thickness: ThicknessStore,
}

/// Everything the window shows.
#[derive(Debug)]
pub struct State {
    /// What undo brings back.
    pub document: Document,
    /// Undo and redo.
    pub history: History,
    /// Whether and how fast the beat plays.
    pub play: PlayClock,
    /// What lies over the window.
    pub sheets: Sheets,
    /// Light or dark.
    pub theme: ThemeChoice,
    /// Whether the window fills the screen.
    pub full_screen: bool,
    /// What was opened before, latest first.
    pub recent: Vec<PathBuf>,
    /// What went wrong, oldest first.
    pub errors: Vec<ErrorCard>,
    /// The latest results.
    pub results: Results,
    /// What was done last, for the status bar.
    pub message: String,
    /// How finely the built-in cohort is made.
    pub built_in: BuiltInParams,
    pub(super) last_opening: u64,
}

impl Default for State {
    fn default() -> Self {
        let nothing = StudyRef {
            study: Arc::default(),
            opening: 0,
            report: Arc::default(),
        };
        Self {
            document: Document::new(nothing),
            history: History::default(),
            play: PlayClock::default(),
            sheets: Sheets::default(),
            theme: ThemeChoice::default(),
            full_screen: false,
            recent: Vec::new(),
            errors: Vec::new(),
            results: Results::default(),
            message: String::new(),
            built_in: BuiltInParams::default(),
            last_opening: 0,
        }
    }
}

impl State {
    /// Measures of the study on screen, possibly of its state before the last edit.
    pub fn measures(&self) -> Option<&Arc<Vec<SubjectMeasures>>> {
        self.of_this_study(self.results.measures.as_ref())
    }

    /// Measures of one subject.
    pub fn measures_of(&self, subject: usize) -> Option<&SubjectMeasures> {
        self.measures()?.get(subject)
    }

    /// The map of the study on screen.
    pub fn map(&self) -> Option<&Arc<PoseMap>> {
        self.of_this_study(self.results.map.as_ref())
    }

    /// The map of deformations of the study on screen.
    pub fn deformations(&self) -> Option<&Arc<DeformationMap>> {
        self.of_this_study(self.results.deformations.as_ref())
    }

    /// The map of the medial shape space of the study on screen.
    pub fn medial_map(&self) -> Option<&Arc<MedialMap>> {
        self.of_this_study(self.results.medial_map.as_ref())
    }

    /// How well the classes of the study on screen can be told apart.
    pub fn classes(&self) -> Option<&Arc<Classes>> {
        self.of_this_study(self.results.classes.as_ref())
    }

    /// The poses between a subject's frames, as far as they were computed with today's settings.
    pub fn in_betweens_of(&self, index: usize) -> Option<&Arc<InBetweens>> {
        let params = geodesic_params(&self.document)?;
        self.results.in_betweens.get(self.subject(index)?, &params)
    }

    /// The carried beat that the document asks for, once it is computed.
    pub fn carried_heart(&self) -> Option<&CarriedHeart> {
        let key = (
            self.document.study().revision,
            self.document.carrying()?,
            transport_params(&self.document),
        );
        (self.results.carried.as_ref()).filter(|heart| heart.key == key)
    }

    /// How a subject's wall thickens: with today's settings, else with those before, and whether it is
    /// today's. `None` while nothing is known.
    pub fn wall_of(&self, index: usize) -> Option<(&FoundWall, bool)> {
        let subject = self.subject(index)?;
        self.results
            .walls
            .latest(subject, &self.document.thickening)
    }

    /// Frames of end-diastole and end-systole of a subject: as stated, else as measured.
    pub fn phases_of(&self, index: usize) -> (Option<usize>, Option<usize>) {
        let stated = self.subject(index);
        let measured = self.measures_of(index);
        (
            stated
                .and_then(|subject| subject.end_diastole)
                .or_else(|| measured.and_then(|measures| measures.end_diastole)),
            stated
                .and_then(|subject| subject.end_systole)
                .or_else(|| measured.and_then(|measures| measures.end_systole)),
        )
    }

    /// A subject of the study on screen.
    pub fn subject(&self, index: usize) -> Option<&Arc<Subject>> {
        self.document.study().subjects.get(index)
    }

    /// Shows a newly read study; the old one can be had back by undo.
    pub fn show_study(&mut self, study: Arc<Study>, report: OpeningReport) {
        self.last_opening += 1;
        let opening = self.last_opening;
        let before = self.document.clone();
        let mut document = Document::new(StudyRef {
            study,
            opening,
            report: Arc::new(report),
        });
        document.map = before.map;
        if let Some(transfer) = document.map.distances.transport
            && matches!(transfer.reference, Reference::Subject(_))
        {
            // That heart is not of this study.
            document.map.distances.transport = None;
        }
        document.deformation_map = before.deformation_map;
        document.shows_clusters = before.shows_clusters;
        document.thickening = before.thickening;
        document.bulls_eye = before.bulls_eye;
        document.bulls_eye_segments = before.bulls_eye_segments;
        document.in_betweens = before.in_betweens;
        document.visibility = before.visibility;
        self.history.forget_studies_before(before.study.opening);
        if before.study.opening > 0 {
            self.history.record(before, None, false, 0.0);
        }
        self.document = document;
        self.play.playing = false;
    }

    fn of_this_study<'a, T>(&self, fresh: Option<&'a Fresh<T>>) -> Option<&'a Arc<T>> {
        fresh
            .filter(|fresh| fresh.opening == self.document.study.opening)
            .map(|fresh| &fresh.value)
    }
}

//! What undo brings back: the study on screen and how it is looked at. Small, cheap to copy, without results.

use std::sync::Arc;

use crate::analysis::deformations::DeformationMapParams;
use crate::analysis::thickening::ThickeningSettings;
use crate::analysis::verdicts::CheckedClassifier;
use crate::document::ViewMode;
use crate::document::cohort_sort::CohortSort;
use crate::engine::{ClassesBy, PoseMapQuery};
use crate::io::{OpenError, OpenedImages};
use crate::picture::{BullsEyeQuantity, Quantity, WallPart};
use crate::study::{CycleTiming, Notice, Revision, Study, Subject};

use crate::document::import::Import;
use crate::document::loop_range::LoopRange;
use crate::document::slice_view::SliceView;
use crate::document::viewpoint::Viewpoint;
use crate::document::visibility::Visibility;

/// Poses between two frames until the user says otherwise.
const INTERPOLATED_POSES: u16 = 3;

/// Whose motion is transported to whom, as the user chose it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TransportChoice {
    /// Whose motion: index into the study's subjects.
    pub from: usize,
    /// Onto whom.
    pub onto: usize,
}

/// Everything a user can change and take back.
#[derive(Clone, Debug, PartialEq)]
pub struct Document {
    /// The study; an edit of labels or phases makes another one, which shares all meshes.
    pub study: StudyRef,
    /// Index of the selected subject.
    pub subject: usize,
    /// Place in the cycle, counted in frames; fractions lie between poses.
    pub position: f64,
    /// The part of the cycle that plays; `None` plays all of it.
    pub loop_range: Option<LoopRange>,
    /// One subject, two or all phases.
    pub view_mode: ViewMode,
    /// The second subject of the side-by-side view; `None` lets the program choose.
    pub compare_with: Option<usize>,
    /// The motion that the second subject plays in place of its own.
    pub transported: Option<TransportChoice>,
    /// Poses computed between two frames; 0 blends frames straight.
    pub interpolated_poses: u16,
    /// From where subjects are looked at.
    pub viewpoint: Viewpoint,
    /// Whether dragging turns about the screen's axes instead of keeping the subject upright.
    pub free_camera: bool,
    /// What is drawn.
    pub visibility: Visibility,
    /// What colours stand for.
    pub quantity: Quantity,
    /// Typed limits, by quantity; quantities that are absent have their fixed range.
    pub colour_limits: Vec<(Quantity, [f64; 2])>,
    /// How poses are compared and mapped.
    pub map: PoseMapQuery,
    /// How whole deformations are mapped.
    pub deformation_map: DeformationMapParams,
    /// What subjects are classified by, where the study offers both; see [`Self::classes_by`].
    pub chosen_classes: ClassesBy,
    /// Whether clusters of deformations are drawn.
    pub shows_clusters: bool,
    /// What is akinetic, and what is a patch.
    pub thickening: ThickeningSettings,
    /// The classifier from a file that makes the verdicts, in the place of the labels of the study.
    pub rule: Option<Arc<CheckedClassifier>>,
    /// The patch or segment that is selected.
    pub part: Option<WallPart>,
    /// What the bull's-eye shows.
    pub bulls_eye: BullsEyeQuantity,
    /// Whether it has one colour for each segment.
    pub bulls_eye_segments: bool,
    /// Which images are looked at, and how.
    pub slices: SliceView,
    /// How images become subjects.
    pub import: Import,
    /// Filter of the cohort table.
    pub search: String,
    /// Order of the cohort table; `None` keeps the order of the study.
    pub sorting: Option<CohortSort>,
}

/// A shared study, compared by its revision.
#[derive(Clone, Debug)]
pub struct StudyRef {
    /// The study.
    pub study: Arc<Study>,
    /// Counts what was opened in this run; edits of one study share the number.
    pub opening: u64,
    /// The state in which the list of subjects became what it is: indices mean the same subjects as long as it stays.
    pub listing: Revision,
    /// What came of reading it.
    pub report: Arc<OpeningReport>,
}

/// What reading a study brought beside its subjects.
#[derive(Clone, Debug, Default)]
pub struct OpeningReport {
    /// What was assumed about the study as a whole.
    pub notices: Vec<Notice>,
    /// What could not be read.
    pub errors: Vec<OpenError>,
    /// Images that were read, with or without subjects made of them.
    pub images: Arc<Vec<OpenedImages>>,
}

impl PartialEq for StudyRef {
    fn eq(&self, other: &Self) -> bool {
        self.study.revision == other.study.revision
    }
}

impl Document {
    /// The first look at a study: its first subject at the first frame, everything by default.
    pub fn new(study: StudyRef) -> Self {
        Self {
            study,
            subject: 0,
            position: 0.0,
            loop_range: None,
            view_mode: ViewMode::default(),
            compare_with: None,
            transported: None,
            interpolated_poses: INTERPOLATED_POSES,
            viewpoint: Viewpoint::default(),
            free_camera: false,
            visibility: Visibility::default(),
            quantity: Quantity::default(),
            colour_limits: Vec::new(),
            map: PoseMapQuery::default(),
            deformation_map: DeformationMapParams::default(),
            chosen_classes: ClassesBy::default(),
            shows_clusters: true,
            thickening: ThickeningSettings::default(),
            rule: None,
            part: None,
            bulls_eye: BullsEyeQuantity::default(),
            bulls_eye_segments: false,
            slices: SliceView::default(),
            import: Import::default(),
            search: String::new(),
            sorting: None,
        }
    }

    /// The study on screen.
    pub fn study(&self) -> &Arc<Study> {
        &self.study.study
    }

    /// The selected subject; `None` where nothing is open.
    pub fn selected(&self) -> Option<&Arc<Subject>> {
        self.study().subject(self.subject)
    }

    /// Index of the selected subject; `None` where nothing is open.
    pub fn selected_index(&self) -> Option<usize> {
        self.selected().map(|_| self.subject)
    }

    /// The patch that is selected, by its place in the list.
    pub fn selected_patch(&self) -> Option<usize> {
        match self.part {
            Some(WallPart::Patch(patch)) => Some(patch),
            Some(WallPart::Segment(_)) | None => None,
        }
    }

    /// First and last frame of the part of the cycle that plays, for the selected subject; `None` where all of it does.
    pub fn loop_frames(&self) -> Option<[usize; 2]> {
        self.loop_range?.frames_of(self.selected()?)
    }

    /// What subjects are classified by: labels, unless the study offers both and the user chose their classes.
    pub fn classes_by(&self) -> ClassesBy {
        match self.study().has_other_classes_than_labels() {
            true => self.chosen_classes,
            false => ClassesBy::Label,
        }
    }

    /// Number of frames of the selected subject; without a subject of the images on screen; at least one.
    pub fn frame_count(&self) -> usize {
        self.selected().map_or_else(
            || self.instant_count(),
            |subject| subject.sequence.frame_count(),
        )
    }

    /// The frame nearest to the position; past the last half frame the motion starts over.
    pub fn frame(&self) -> usize {
        nearest_frame(self.position, self.frame_count())
    }

    /// Typed limits of the quantity on screen.
    pub fn limits(&self) -> Option<[f64; 2]> {
        self.limits_of(self.quantity)
    }

    /// Typed limits of a quantity.
    pub fn limits_of(&self, quantity: Quantity) -> Option<[f64; 2]> {
        self.colour_limits
            .iter()
            .find(|(other, _)| *other == quantity)
            .map(|(_, limits)| *limits)
    }

    /// What the colour bar stands for: on tissue, the atoms have it.
    pub fn bar_quantity(&self) -> Quantity {
        if self.quantity == Quantity::Tissue && self.visibility.atoms {
            Quantity::ThicknessRatio
        } else {
            self.quantity
        }
    }

    /// Sets or clears typed limits of the quantity on screen.
    pub fn set_limits(&mut self, limits: Option<[f64; 2]>) {
        self.set_limits_of(self.bar_quantity(), limits);
    }

    /// Sets or clears typed limits of a quantity.
    pub fn set_limits_of(&mut self, quantity: Quantity, limits: Option<[f64; 2]>) {
        self.colour_limits.retain(|(other, _)| *other != quantity);
        if let Some(limits) = limits {
            self.colour_limits.push((quantity, limits));
        }
    }

    /// The subject beside the selected one: the chosen one, else the next of the cohort.
    pub fn compared(&self) -> Option<usize> {
        let study = self.study();
        let next = (self.subject + 1) % study.subjects.len().max(1);
        let chosen = self.compare_with.filter(|index| *index < study.count());
        let other = |index: &usize| *index != self.subject;
        (chosen.filter(other)).or((!study.subjects.is_empty()).then_some(next).filter(other))
    }

    /// The subject beside the selected one, where two are shown.
    pub fn compared_on_screen(&self) -> Option<usize> {
        self.compared()
            .filter(|_| self.view_mode == ViewMode::SideBySide)
    }

    /// The transported motion that is on screen: it plays beside the subject that it came from.
    pub fn visible_transport(&self) -> Option<TransportChoice> {
        self.transported.filter(|motion| {
            self.subject == motion.from && self.compared_on_screen() == Some(motion.onto)
        })
    }

    /// Ends a transported motion whose subjects are no longer on screen, and its colours with it.
    pub fn end_transport_out_of_sight(&mut self) {
        self.transported = self.visible_transport();
        if self.transported.is_none() && self.quantity == Quantity::MotionDifference {
            self.quantity = Quantity::Tissue;
        }
    }

    /// Selects a subject at the same share of the cycle, so that subjects with other frame counts
    /// stay in phase.
    pub fn select_subject(&mut self, subject: usize) {
        let phase = self
            .selected()
            .map_or(0.0, |shown| cycle_share(shown, self.position));
        self.select_subject_at(subject, 0.0);
        self.position = self
            .selected()
            .map_or(0.0, |shown| position_at_phase(shown, phase));
    }

    /// Selects a subject at a position in its own cycle.
    pub fn select_subject_at(&mut self, subject: usize, position: f64) {
        if subject != self.subject {
            self.let_patch_go();
        }
        self.subject = subject;
        self.show_images_of_selected();
        self.move_to(position);
    }

    /// A patch belongs to its subject; a segment is one of every subject.
    pub(super) fn let_patch_go(&mut self) {
        if self.selected_patch().is_some() {
            self.part = None;
        }
    }

    /// Moves to the position nearest to this one, counted in frames, that the selected subject has.
    pub fn move_to(&mut self, position: f64) {
        // A position just below the frame count lies between the last pose and the first.
        let end = (self.frame_count() as f64).next_down();
        if !position.is_nan() {
            self.position = position.clamp(0.0, end);
        }
    }
}

/// The frame nearest to a position in a cycle of `frame_count` frames.
pub fn nearest_frame(position: f64, frame_count: usize) -> usize {
    let count = frame_count.max(1);
    (position.round().max(0.0) as usize) % count
}

/// Share of the cycle at a subject's position, in `0..1`.
pub fn cycle_share(subject: &Subject, position: f64) -> f64 {
    subject
        .timing
        .phase(position, subject.sequence.frame_count())
}

/// The position of a subject at a share of the cycle: the inverse of [`cycle_share`].
///
/// Frames are found by bisection on the phase, which grows with the position; where several
/// positions have one phase (before the first frame's time), the first is taken.
pub fn position_at_phase(subject: &Subject, phase: f64) -> f64 {
    position_in_cycle(&subject.timing, subject.sequence.frame_count(), phase)
}

/// The same for anything that was recorded over a cycle at `count` instants.
pub fn position_in_cycle(timing: &CycleTiming, count: usize, phase: f64) -> f64 {
    if count <= 1 {
        return 0.0;
    }
    let phase_at = |frame: usize| timing.phase(frame as f64, count);
    let first = phase_at(0);
    let phase = if phase < first { first } else { phase };
    let frame = (0..count)
        .rev()
        .find(|frame| phase_at(*frame) <= phase + 1e-12)
        .unwrap_or(0);
    let start = phase_at(frame);
    let end = if frame + 1 < count {
        phase_at(frame + 1)
    } else {
        1.0
    };
    let part = if end > start {
        ((phase - start) / (end - start)).clamp(0.0, 1.0)
    } else {
        0.0
    };
    let position = frame as f64 + part;
    // The end of the last interval is the start of the next cycle.
    if position >= count as f64 {
        0.0
    } else {
        position
    }
}

#[cfg(test)]
mod tests;

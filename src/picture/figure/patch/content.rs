//! The content of a patch figure: numbers and words, ready for the layout.

use crate::analysis::thickening::Patch;
use crate::analysis::verdicts::{
    ClassifierSource, Finding, NotAssessed, SubjectThickening, Verdicts,
};
use crate::picture::bulls_eye::{BullsEyeScale, PolarMap};
use crate::picture::figure::content::FigureContent;
use crate::picture::figure::patch::bulls_eye::BullsEyeContent;
use crate::picture::figure::patch::order::PatchOrder;
use crate::picture::page::FigureSettings;
use crate::picture::patch_words::{
    PatchStanding, percent, probability_words, segment_words, sentence, smallest_words,
    wall_thickening_words,
};
use crate::picture::quantity::Quantity;
use crate::report::{Column, PatchRow, thickening_words};
use crate::study::Subject;

/// Patches in the table; more are counted below it.
const MAX_ROWS: usize = 4;
/// Segments without this many words say that the orientation is not known.
const NO_SEGMENTS: &str = "orientation not known";

/// The verdict above a patch figure.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct VerdictLines {
    /// "Abnormal patch"; "Not assessed".
    pub heading: String,
    /// Whether the heading names something abnormal.
    pub abnormal: bool,
    /// Probability and where it comes from, or why there is none.
    pub evidence: String,
}

impl VerdictLines {
    /// Of one subject; with `None` for verdicts, thickening alone and that there is no verdict yet.
    pub fn of(wall: &SubjectThickening, verdicts: Option<&Verdicts>, subject: usize) -> Self {
        let classified = verdicts.and_then(|all| Some((all, all.subjects.get(subject)?)));
        match classified {
            _ if wall.not_assessed.is_some() => Self::not_assessed(wall.not_assessed.as_ref()),
            None => Self {
                // Whom verdicts on a cohort leave out is excluded from it.
                heading: match verdicts {
                    Some(_) => "Not assessed: excluded from the cohort".to_owned(),
                    None => "Not yet assessed".to_owned(),
                },
                abnormal: false,
                evidence: wall_thickening_words(&wall.thickening),
            },
            Some((_, Err(reason))) => Self::not_assessed(Some(reason)),
            Some((all, Ok(verdict))) => {
                let abnormal = verdict.finding != Finding::Nothing;
                let mut heading = sentence(verdict.words());
                let share: f64 = wall.thickening.patches.iter().map(|p| p.share).sum();
                if verdict.finding == Finding::AbnormalPatch && share > 0.0 {
                    heading = format!("{heading} · {} of the LV", percent(share));
                }
                Self {
                    heading,
                    abnormal,
                    evidence: evidence(all, verdict.probability),
                }
            }
        }
    }

    fn not_assessed(reason: Option<&NotAssessed>) -> Self {
        Self {
            heading: "Not assessed".to_owned(),
            abnormal: false,
            evidence: reason.map_or_else(String::new, |reason| sentence(&reason.to_string())),
        }
    }
}

fn evidence(verdicts: &Verdicts, probability: f64) -> String {
    match &verdicts.classifier {
        ClassifierSource::OtherStudy(rule) => format!(
            "Predicted probability of abnormal {}; {}",
            probability_words(probability),
            rule.words()
        ),
        ClassifierSource::Cohort { normal, abnormal } => {
            let mut words = format!(
                "Predicted probability of abnormal {}, leave-one-out over {normal} normal and {abnormal} abnormal \
                 subjects (this subject was not in the training set)",
                probability_words(probability)
            );
            if let Some(quality) = &verdicts.quality {
                let accuracy = quality.accuracy;
                words += &format!(
                    "; accuracy (leave-one-out) {} of {}, permutation mean {}",
                    accuracy.correct,
                    accuracy.of,
                    percent(accuracy.baseline)
                );
            }
            words
        }
    }
}

/// The columns of numbers in the table.
pub const PATCH_COLUMNS: [Column<PatchRow>; PatchRow::IN_FIGURE.len()] = PatchRow::IN_FIGURE;
/// Their widths in the design, in points.
pub(super) const COLUMN_WIDTHS: [f32; PATCH_COLUMNS.len()] = [130.0, 110.0, 100.0, 160.0];
/// Width of the column before them, that of the patch's number, in the design.
pub(super) const NUMBER_WIDTH: f32 = 60.0;

/// One patch in the table.
#[derive(Clone, Debug, PartialEq)]
pub struct FigurePatchLine {
    /// Its numbers with units, by [`PATCH_COLUMNS`].
    pub cells: [String; PATCH_COLUMNS.len()],
    /// Where it lies.
    pub segments: String,
}

/// Everything that a patch figure says.
#[derive(Clone, Debug, PartialEq)]
pub struct PatchContent {
    /// Name, moment, volumes, legend, cube.
    pub heart: FigureContent,
    /// Its verdict.
    pub verdict: VerdictLines,
    /// What its patches may be called.
    pub standing: PatchStanding,
    /// The bull's-eye beside the heart.
    pub bulls_eye: BullsEyeContent,
    /// Patches, largest first.
    pub rows: Vec<FigurePatchLine>,
    /// A sentence in place of rows, or below them.
    pub note: String,
    /// How it was made.
    pub parameters: String,
}

impl PatchContent {
    /// Gathers what is known of a heart.
    pub fn of(heart: FigureContent, order: &PatchOrder<'_>) -> Self {
        let PatchOrder { figure, wall, .. } = *order;
        let quantity = figure.bulls_eye;
        let scene = &figure.scene;
        let typed = match quantity.on_heart() {
            Quantity::ThicknessRatio => scene.medial.limits,
            same if same == scene.quantity => scene.typed_limits,
            _ => None,
        };
        let subject = figure.shown.subject;
        let scale = BullsEyeScale::of(quantity, &scene.cohort_ranges, typed, subject.unit);
        let thickening = &wall.thickening;
        let assessed = wall.not_assessed.is_none();
        let flat = PolarMap::of(wall).map(|mut flat| {
            let values = flat.values(wall, subject, quantity, figure.shown.frame);
            if !assessed {
                flat.patches.clear();
            }
            (flat, values)
        });
        let rows: Vec<FigurePatchLine> = (thickening.patches.iter())
            .filter(|_| assessed)
            .enumerate()
            .take(MAX_ROWS)
            .map(|(index, patch)| line(wall, subject, index, patch))
            .collect();
        let more = thickening.patches.len().saturating_sub(rows.len());
        let note = match (assessed, more) {
            (false, _) => {
                "In a wall that is not resolved, regions may be due to blur or noise".to_owned()
            }
            (true, 0) => sentences(&[
                wall_thickening_words(thickening),
                smallest_words(thickening),
            ]),
            (true, more) => sentences(&[
                wall_thickening_words(thickening),
                format!("{more} more in patches.csv"),
                smallest_words(thickening),
            ]),
        };
        Self {
            bulls_eye: BullsEyeContent {
                flat,
                without_flat: wall.without_axis.clone().unwrap_or_default(),
                scale,
                moment: heart.moment.clone(),
                standing: order.standing(),
                by_segment: false,
            },
            parameters: format!(
                "Medial surface {}. Tolerance ± {:.3} ln PT, noise of one atom {:.3} ln r",
                thickening_words(&figure.thickening),
                thickening.tolerance,
                thickening.noise
            ),
            heart,
            verdict: VerdictLines::of(wall, order.verdicts, order.subject),
            standing: order.standing(),
            rows,
            note,
        }
    }
}

/// Sentences one after the other.
fn sentences(parts: &[String]) -> String {
    let present: Vec<&str> = (parts.iter().map(String::as_str))
        .filter(|part| !part.is_empty())
        .collect();
    present.join(". ")
}

fn line(
    wall: &SubjectThickening,
    subject: &Subject,
    index: usize,
    patch: &Patch,
) -> FigurePatchLine {
    let segments = match (patch.segments.is_empty(), &wall.without_axis) {
        (false, _) => segment_words(patch),
        (true, Some(why)) => why.clone(),
        (true, None) => NO_SEGMENTS.to_owned(),
    };
    let row = PatchRow::new(&subject.id, subject.unit, index, patch);
    FigurePatchLine {
        cells: PATCH_COLUMNS
            .each_ref()
            .map(|column| column.shown_with_unit(&row, subject.unit)),
        segments,
    }
}

/// What a patch figure was made with, for the file, after what every figure says.
pub fn patch_settings(content: &PatchContent) -> FigureSettings {
    let mut settings = vec![
        ("Verdict", content.verdict.heading.clone()),
        ("Evidence", content.verdict.evidence.clone()),
        ("Parameters", content.parameters.clone()),
    ];
    for row in &content.rows {
        let cells = PATCH_COLUMNS.iter().zip(&row.cells);
        let words: Vec<String> = (cells.map(|(column, cell)| format!("{} {cell}", column.heading)))
            .chain([row.segments.clone()])
            .collect();
        settings.push(("Patch", words.join(", ")));
    }
    settings
}

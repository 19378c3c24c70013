//! What a patch figure says: numbers and words, ready to be laid out.

use crate::analysis::thickening::Patch;
use crate::analysis::verdicts::{Finding, NotAssessed, RuleSource, Verdicts};
use crate::engine::{SubjectThickening, thickening_words};
use crate::picture::bulls_eye::{BullsEyeScale, FlatValues, FlatWall};
use crate::picture::figure::content::FigureContent;
use crate::picture::figure::patch::make::PatchOrder;
use crate::picture::page::FigureSettings;
use crate::picture::patch_words::{
    PatchStanding, area_text, extent_words, percent, probability_words, segment_words, sentence,
    smallest_words,
};
use crate::picture::quantity::Quantity;

/// Patches in the table; more are counted below it.
const MOST_ROWS: usize = 4;
/// Segments without this many words say that the orientation is not known.
const NO_SEGMENTS: &str = "orientation not known";

/// What is said above a patch figure.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct VerdictLines {
    /// "Abnormal patch"; "Not assessed".
    pub heading: String,
    /// Whether the heading names something ill.
    pub abnormal: bool,
    /// Probability and where it comes from, or why nothing is said.
    pub evidence: String,
}

impl VerdictLines {
    /// What is said of a subject; with `None` for verdicts, what thickening alone tells.
    pub fn of(found: &SubjectThickening, verdicts: Option<&Verdicts>, subject: usize) -> Self {
        let told = verdicts.and_then(|all| Some((all, all.subjects.get(subject)?)));
        match told {
            _ if found.not_assessed.is_some() => Self::not_assessed(found.not_assessed.as_ref()),
            None => Self {
                heading: String::new(),
                abnormal: false,
                evidence: extent_words(&found.thickening),
            },
            Some((_, Err(reason))) => Self::not_assessed(Some(reason)),
            Some((all, Ok(verdict))) => {
                let abnormal = verdict.finding != Finding::Nothing;
                let mut heading = sentence(verdict.finding.name());
                let share: f64 = found.thickening.patches.iter().map(|p| p.share).sum();
                if verdict.finding == Finding::Patch && share > 0.0 {
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
    match verdicts.rule {
        RuleSource::Uncalibrated { normal, abnormal } => format!(
            "By a rule fixed beforehand, since only {normal} normal and {abnormal} abnormal hearts with a label \
             could be assessed: no probability"
        ),
        RuleSource::Cohort { normal, abnormal } => {
            let mut words = format!(
                "Probability of being abnormal {}, by a rule learnt without this heart from {normal} normal and \
                 {abnormal} abnormal ones",
                probability_words(probability)
            );
            if let Some(quality) = &verdicts.quality {
                let told = quality.accuracy;
                words += &format!(
                    "; with each heart left out it is right in {} of {}, by chance in {:.0} %",
                    told.correct,
                    told.of,
                    100.0 * told.baseline
                );
            }
            words
        }
    }
}

/// One patch in the table.
#[derive(Clone, Debug, PartialEq)]
pub struct PatchLine {
    /// Area, share of the LV, PT, confidence, as texts.
    pub cells: [String; 4],
    /// Where it lies.
    pub segments: String,
}

/// Everything that a patch figure says.
#[derive(Clone, Debug, PartialEq)]
pub struct PatchContent {
    /// Name, moment, volumes, legend, cube.
    pub heart: FigureContent,
    /// What is said of it.
    pub verdict: VerdictLines,
    /// What its patches may be called.
    pub standing: PatchStanding,
    /// The wall laid flat; `None` without a long axis.
    pub flat: Option<(FlatWall, FlatValues)>,
    /// Why it is not laid flat.
    pub without_flat: String,
    /// What the bull's-eye shows, in which colours and words.
    pub scale: BullsEyeScale,
    /// Patches, largest first.
    pub rows: Vec<PatchLine>,
    /// Said in place of rows, or below them.
    pub note: String,
    /// How it was made.
    pub parameters: String,
}

impl PatchContent {
    /// Gathers what is known of a heart.
    pub fn of(heart: FigureContent, order: &PatchOrder<'_>) -> Self {
        let PatchOrder { figure, found, .. } = *order;
        let quantity = figure.bulls_eye;
        let scene = &figure.scene;
        let typed = match quantity.on_heart() {
            Quantity::ThicknessRatio => scene.medial.limits,
            same if same == scene.quantity => scene.typed_limits,
            _ => None,
        };
        let subject = figure.shown.subject;
        let scale = BullsEyeScale::of(quantity, &scene.cohort_limits, typed, subject.unit);
        let told = &found.thickening;
        let assessed = found.not_assessed.is_none();
        let flat = FlatWall::of(found).map(|mut flat| {
            let values = flat.values(found, subject, quantity, figure.shown.frame);
            if !assessed {
                flat.borders.clear();
            }
            (flat, values)
        });
        let rows: Vec<PatchLine> = (told.patches.iter())
            .filter(|_| assessed)
            .take(MOST_ROWS)
            .map(|patch| line(found, patch))
            .collect();
        let more = told.patches.len().saturating_sub(rows.len());
        let note = match (assessed, more) {
            (false, _) => {
                "What is found in a wall that is not resolved may be blur or noise".to_owned()
            }
            (true, 0) => said(&[extent_words(told), smallest_words(told)]),
            (true, more) => said(&[
                extent_words(told),
                format!("{more} more in patches.csv"),
                smallest_words(told),
            ]),
        };
        Self {
            without_flat: found.without_axis.clone().unwrap_or_default(),
            parameters: format!(
                "Medial surface {}. Tolerance used ± {:.3} ln PT, noise of one atom {:.3} ln r",
                thickening_words(&figure.thickening),
                told.tolerance,
                told.noise
            ),
            heart,
            verdict: VerdictLines::of(found, order.verdicts, order.subject),
            standing: order.standing(),
            flat,
            scale,
            rows,
            note,
        }
    }
}

/// Sentences one after the other.
fn said(parts: &[String]) -> String {
    let told: Vec<&str> = (parts.iter().map(String::as_str))
        .filter(|part| !part.is_empty())
        .collect();
    told.join(". ")
}

fn line(found: &SubjectThickening, patch: &Patch) -> PatchLine {
    let segments = match (patch.segments.is_empty(), &found.without_axis) {
        (false, _) => segment_words(patch),
        (true, Some(why)) => why.clone(),
        (true, None) => NO_SEGMENTS.to_owned(),
    };
    PatchLine {
        cells: [
            patch.area_cm2.map_or_else(|| "–".to_owned(), area_text),
            percent(patch.share),
            format!("{:.2} ×", patch.thickening.exp()),
            percent(patch.confidence),
        ],
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
        let [area, share, ratio, confidence] = &row.cells;
        let words = format!(
            "{area}, {share} of the LV, PT {ratio}, confidence {confidence}, {}",
            row.segments
        );
        settings.push(("Patch", words));
    }
    settings
}

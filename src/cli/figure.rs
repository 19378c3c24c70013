//! `figure`: a rendered figure with no window.

use std::sync::Arc;

use serde_json::json;

use crate::analysis::measures::SubjectMeasures;
use crate::analysis::thickening::ThickeningSettings;
use crate::analysis::verdicts::{SubjectThickening, Verdicts};
use crate::cli::figure_args::FigureArgs;
use crate::cli::input::{answered, measured, opened_study, store};
use crate::cli::letters::say_missing_letters;
use crate::cli::outcome::CliError;
use crate::cli::print::{print, print_json};
use crate::cli::words::{ThemeWord, ViewWord};
use crate::cli::work::run_work;
use crate::engine::{ExportFile, Store, VerdictQuery, WallThickeningQuery, write_files};
use crate::picture::figure::{
    Figure, FigureOrder, FigureSubject, FigureView, MIN_PATCH_SIZE, PatchOrder, rendered_figure,
    rendered_patch_figure,
};
use crate::picture::page::{FigureFonts, PageFormat};
use crate::picture::{
    BullsEyeQuantity, CohortColourRanges, MedialSettings, PreparedMedial, PreparedSubject,
    Quantity, SceneSettings, SubjectExtras, SubjectMedial, SurfaceScalars, reference_frame,
};
use crate::render::{GeometryPose, Headless};
use crate::study::{Study, Subject};

/// Pixels of a figure of a subject: half a page at 300 dots per inch.
const SIZE: [u32; 2] = [1200, 900];
/// Pixels of a patch figure: two columns of a journal at 340 dots per inch.
const PATCH_SIZE: [u32; 2] = [2400, 1800];

pub(super) fn figure(args: &FigureArgs) -> Result<(), CliError> {
    let format = PageFormat::of(&args.out).ok_or_else(|| {
        let out = args.out.display();
        CliError::Usage(format!(
            "--out {out}: the name must end in .png, .svg or .pdf"
        ))
    })?;
    let usual = if args.patch { PATCH_SIZE } else { SIZE };
    let size = args.size.unwrap_or(usual);
    let [min_width, min_height] = MIN_PATCH_SIZE;
    if args.patch && (size[0] < min_width || size[1] < min_height) {
        return Err(CliError::Usage(format!(
            "--size {}x{}: a patch figure needs at least {min_width}x{min_height} pixels",
            size[0], size[1]
        )));
    }
    let study = opened_study(&args.study)?;
    let index = chosen_subject(&study, args.subject.as_deref())?;
    check_view(args, &study, index)?;
    say_missing_letters(&study);
    let store = store()?;
    let measures = measured(&store, &study)?;
    let shows_ratio = Quantity::from(args.colour) == Quantity::ThicknessRatio;
    let wall = (shows_ratio || args.patch)
        .then(|| assessed_wall(args, &store, &study, index))
        .transpose()?;
    let verdicts = match args.patch {
        true => Some(verdicts_of(args, &store, &study)?),
        false => None,
    };
    let end_systole = wall.as_ref().map(|wall| wall.thickening.end_systole);
    let frame = match args.frame {
        Some(frame) => frame,
        None => end_systole.filter(|_| args.patch).unwrap_or(0),
    };
    let shot = Shot {
        index,
        frame,
        view: args.view,
        size,
        thickening: args.patches.settings()?,
    };
    let look = ChosenScene::of(args);
    let id = subject_at(&study, index)?.id.clone();
    let bytes = run_work(move |progress| -> Result<Vec<u8>, CliError> {
        progress.begin_phase("drawing", 0.0, 1.0);
        let mut studio = Studio::open(&study, &measures)?;
        progress.check()?;
        let settings = look.over(studio.settings());
        let figure = match (&wall, &verdicts) {
            (Some(wall), Some(verdicts)) => {
                studio.patch_figure(&shot, settings, wall, Some(verdicts))?
            }
            _ => studio.figure(&shot, settings, wall.as_deref())?,
        };
        (format.file(&figure.page, &figure.settings, &studio.fonts)).map_err(CliError::unusable)
    })?;
    let file = ExportFile {
        path: args.out.clone(),
        bytes: bytes.into(),
    };
    write_files(vec![file]).map_err(CliError::Unusable)?;
    let out = args.out.display().to_string();
    if args.json {
        let [width, height] = shot.size;
        return print_json(&json!({
            "file": out, "subject": id, "frame": frame, "width": width, "height": height,
        }));
    }
    print(&out)
}

/// A subject by its index, excluded ones included.
fn subject_at(study: &Study, index: usize) -> Result<&Arc<Subject>, CliError> {
    let subject = study.subject(index);
    subject.ok_or_else(|| CliError::Unusable(format!("there is no subject {index}")))
}

/// Whether the frame is there and the direction has a name.
fn check_view(args: &FigureArgs, study: &Study, index: usize) -> Result<(), CliError> {
    let subject = subject_at(study, index)?;
    let frames = subject.sequence.frame_count();
    if let Some(frame) = args.frame.filter(|frame| *frame >= frames) {
        return Err(CliError::Usage(format!(
            "--frame {frame}: {} has frames 0 to {}",
            subject.id,
            frames - 1
        )));
    }
    let across = [
        ViewWord::Anterior,
        ViewWord::Inferior,
        ViewWord::Septal,
        ViewWord::Lateral,
    ];
    if subject.anatomy.is_none() && args.view.is_some_and(|view| across.contains(&view)) {
        return Err(CliError::Unusable(format!(
            "the orientation of {} is not known: only the views apex and base are available",
            subject.id
        )));
    }
    Ok(())
}

/// How the wall of a subject thickens.
fn assessed_wall(
    args: &FigureArgs,
    store: &Arc<Store>,
    study: &Arc<Study>,
    subject: usize,
) -> Result<Arc<SubjectThickening>, CliError> {
    let settings = args.patches.settings()?;
    answered(store, study, &WallThickeningQuery { subject, settings })
}

/// The verdicts of all subjects.
fn verdicts_of(
    args: &FigureArgs,
    store: &Arc<Store>,
    study: &Arc<Study>,
) -> Result<Arc<Verdicts>, CliError> {
    let query = VerdictQuery {
        thickening: args.patches.settings()?,
        ..VerdictQuery::default()
    };
    answered(store, study, &query)
}

fn chosen_subject(study: &Study, id: Option<&str>) -> Result<usize, CliError> {
    let Some(id) = id else {
        return Ok(0);
    };
    study.index_of(id).ok_or_else(|| {
        let some: Vec<&str> = study.subjects.iter().take(8).map(|s| &*s.id).collect();
        let more = if study.subjects.len() > 8 {
            ", …"
        } else {
            ""
        };
        CliError::Usage(format!(
            "--subject {id}: there is no such subject; there are {}{more}",
            some.join(", ")
        ))
    })
}

/// The part of the settings that the command line decides.
#[derive(Clone, Copy)]
struct ChosenScene(SceneSettings);

impl ChosenScene {
    fn of(args: &FigureArgs) -> Self {
        let (theme, transparent) = args.ground().colours(args.theme == ThemeWord::Dark);
        Self(SceneSettings {
            quantity: args.colour.into(),
            typed_limits: args.limits,
            wireframe: args.wireframe,
            medial: if args.patch {
                MedialSettings::of_patch_figure()
            } else {
                MedialSettings::default()
            },
            theme,
            transparent,
            ..SceneSettings::default()
        })
    }

    fn over(self, settings: SceneSettings) -> SceneSettings {
        SceneSettings {
            cohort_ranges: settings.cohort_ranges,
            ..self.0
        }
    }
}

/// One picture to take.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shot {
    /// Of which subject.
    pub(super) index: usize,
    /// At which frame.
    pub(super) frame: usize,
    /// From where.
    pub(super) view: Option<ViewWord>,
    /// Pixels across and down.
    pub(super) size: [u32; 2],
    /// How its wall was assessed.
    pub(super) thickening: ThickeningSettings,
}

/// What all figures of one study share: the renderer, the typefaces, the fixed colour range.
pub(super) struct Studio<'a> {
    study: &'a Study,
    measures: &'a [SubjectMeasures],
    limits: CohortColourRanges,
    headless: Headless,
    pub(super) fonts: FigureFonts,
}

impl<'a> Studio<'a> {
    /// Sets everything up.
    ///
    /// # Errors
    /// If there is no graphics driver, not even a software one.
    pub(super) fn open(
        study: &'a Study,
        measures: &'a [SubjectMeasures],
    ) -> Result<Self, CliError> {
        let references: Vec<usize> = study
            .subjects
            .iter()
            .enumerate()
            .map(|(index, subject)| reference_frame(subject, measures.get(index)))
            .collect();
        Ok(Self {
            study,
            measures,
            limits: CohortColourRanges::of(study, &references),
            headless: Headless::new().map_err(CliError::unusable)?,
            fonts: FigureFonts::load().map_err(CliError::unusable)?,
        })
    }

    /// The usual look with this study's colour range.
    pub(super) fn settings(&self) -> SceneSettings {
        SceneSettings {
            cohort_ranges: self.limits,
            ..SceneSettings::default()
        }
    }

    /// One figure of a subject.
    ///
    /// # Errors
    /// If there is no such subject, or the graphics driver fails.
    pub(super) fn figure(
        &mut self,
        shot: &Shot,
        scene: SceneSettings,
        wall: Option<&SubjectThickening>,
    ) -> Result<Figure, CliError> {
        let stage = Stage::of(self.study, self.measures, shot, wall)?;
        let order = stage.order(self.study, self.measures, shot, scene, wall);
        rendered_figure(&order, &mut self.headless, &self.fonts).map_err(CliError::unusable)
    }

    /// One patch figure.
    ///
    /// # Errors
    /// If there is no such subject, or the graphics driver fails.
    pub(super) fn patch_figure(
        &mut self,
        shot: &Shot,
        scene: SceneSettings,
        wall: &SubjectThickening,
        verdicts: Option<&Verdicts>,
    ) -> Result<Figure, CliError> {
        let stage = Stage::of(self.study, self.measures, shot, Some(wall))?;
        let order = PatchOrder {
            figure: stage.order(self.study, self.measures, shot, scene, Some(wall)),
            wall,
            verdicts,
            subject: shot.index,
        };
        rendered_patch_figure(&order, &mut self.headless, &self.fonts).map_err(CliError::unusable)
    }
}

/// A subject prepared for its picture.
struct Stage {
    subject: Arc<Subject>,
    prepared: PreparedSubject,
    medial: Option<PreparedMedial>,
    numbers: Option<SurfaceScalars>,
}

impl Stage {
    fn of(
        study: &Study,
        measures: &[SubjectMeasures],
        shot: &Shot,
        wall: Option<&SubjectThickening>,
    ) -> Result<Self, CliError> {
        let index = shot.index;
        let subject = subject_at(study, index)?;
        let prepared = PreparedSubject::new(subject, reference_frame(subject, measures.get(index)));
        let medial =
            wall.map(|wall| PreparedMedial::new(subject, &wall.beat, wall.thickening.end_diastole));
        Ok(Self {
            subject: Arc::clone(subject),
            numbers: medial.as_ref().and_then(|medial| medial.numbers(&prepared)),
            medial,
            prepared,
        })
    }

    fn order<'a>(
        &'a self,
        study: &'a Study,
        measures: &'a [SubjectMeasures],
        shot: &Shot,
        scene: SceneSettings,
        wall: Option<&'a SubjectThickening>,
    ) -> FigureOrder<'a> {
        FigureOrder {
            study: &study.name,
            verdict: "",
            shown: FigureSubject {
                subject: &self.subject,
                measures: measures.get(shot.index),
                frame: shot.frame,
            },
            position: shot.frame as f64,
            pose: GeometryPose {
                from: shot.frame,
                to: shot.frame,
                blend: 0.0,
            },
            prepared: &self.prepared,
            extras: SubjectExtras {
                numbers: self.numbers.as_ref(),
                medial: (self.medial.as_ref().zip(wall))
                    .map(|(prepared, wall)| SubjectMedial { prepared, wall }),
            },
            scene,
            bulls_eye: BullsEyeQuantity::default(),
            thickening: shot.thickening,
            view: (shot.view).map_or(FigureView::Home, |word| FigureView::Anatomical(word.into())),
            size: shot.size,
        }
    }
}

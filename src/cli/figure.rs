//! `figure`: a rendered figure with no window.

use std::sync::Arc;

use serde_json::json;

use crate::analysis::measures::SubjectMeasures;
use crate::cli::figure_args::FigureArgs;
use crate::cli::input::{answered, measured, opened_study};
use crate::cli::outcome::CliError;
use crate::cli::print::{print, print_json};
use crate::cli::words::ViewWord;
use crate::cli::work::run_work;
use crate::engine::{
    AnalysisRequest, Cache, ExportFile, SubjectThickening, ThickeningSettings, write_files,
};
use crate::picture::figure::{
    Figure, FigureFonts, FigureOrder, FigureSubject, FigureView, encoded_png, rendered_figure,
};
use crate::picture::{
    CohortLimits, HeartExtras, HeartMedial, PreparedMedial, PreparedSubject, Quantity,
    SceneSettings, reference_frame,
};
use crate::render::Headless;
use crate::study::Study;

pub(super) fn figure(args: &FigureArgs) -> Result<(), CliError> {
    let study = opened_study(&args.study)?;
    let index = chosen_subject(&study, args.subject.as_deref())?;
    let subject = &study.subjects[index];
    let frames = subject.sequence.frame_count();
    if args.frame >= frames {
        return Err(CliError::Usage(format!(
            "--frame {}: {} has frames 0 to {}",
            args.frame,
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
            "the orientation of {} is not known: only the views apex and base can be told",
            subject.id
        )));
    }
    let cache = Arc::new(Cache::default());
    let measures = measured(&study, &cache)?;
    let wall = match Quantity::from(args.colour) {
        Quantity::ThicknessRatio => Some(found_wall(&study, index, &cache)?),
        _ => None,
    };
    let (frame, size, view) = (args.frame, args.size, args.view);
    let look = Look::of(args);
    let id = subject.id.clone();
    let bytes = run_work(move |progress| -> Result<Vec<u8>, CliError> {
        progress.begin_phase("drawing", 0.0, 1.0);
        let mut studio = Studio::open(&study, &measures)?;
        progress.check()?;
        let settings = look.over(studio.settings());
        let figure = studio.figure(index, frame, settings, view, size, wall.as_deref())?;
        encoded_png(&figure.canvas, &figure.settings).map_err(CliError::unusable)
    })?;
    let file = ExportFile {
        path: args.out.clone(),
        bytes: bytes.into(),
    };
    write_files(vec![file]).map_err(CliError::Unusable)?;
    let out = args.out.display().to_string();
    if args.json {
        let [width, height] = size;
        return print_json(&json!({
            "file": out, "subject": id, "frame": frame, "width": width, "height": height,
        }));
    }
    print(&out)
}

/// How the wall of a subject thickens.
fn found_wall(
    study: &Arc<Study>,
    subject: usize,
    cache: &Arc<Cache>,
) -> Result<Arc<SubjectThickening>, CliError> {
    let request = AnalysisRequest::Thickening {
        subject,
        params: ThickeningSettings::default(),
    };
    let outcome = answered(study, request, cache)?;
    match outcome.thickening() {
        Some(found) => Ok(Arc::clone(found)),
        None => Err(CliError::Unusable("the thickness is missing".to_owned())),
    }
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
struct Look(SceneSettings);

impl Look {
    fn of(args: &FigureArgs) -> Self {
        Self(SceneSettings {
            quantity: args.colour.into(),
            typed_limits: args.limits,
            wireframe: args.wireframe,
            theme: args.theme.into(),
            transparent: args.transparent,
            ..SceneSettings::default()
        })
    }

    fn over(self, settings: SceneSettings) -> SceneSettings {
        SceneSettings {
            cohort_limits: settings.cohort_limits,
            ..self.0
        }
    }
}

/// What all figures of one study share: the renderer, the typefaces, the fixed colour range.
pub(super) struct Studio<'a> {
    study: &'a Study,
    measures: &'a [SubjectMeasures],
    limits: CohortLimits,
    headless: Headless,
    fonts: FigureFonts,
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
            limits: CohortLimits::of(study, &references),
            headless: Headless::new().map_err(CliError::unusable)?,
            fonts: FigureFonts::load().map_err(CliError::unusable)?,
        })
    }

    /// The usual look with this study's colour range.
    pub(super) fn settings(&self) -> SceneSettings {
        SceneSettings {
            cohort_limits: self.limits,
            ..SceneSettings::default()
        }
    }

    /// One figure of the subject at `index`.
    ///
    /// # Errors
    /// If there is no such subject, or the graphics driver fails.
    pub(super) fn figure(
        &mut self,
        index: usize,
        frame: usize,
        scene: SceneSettings,
        view: Option<ViewWord>,
        size: [u32; 2],
        wall: Option<&SubjectThickening>,
    ) -> Result<Figure, CliError> {
        let subject = self
            .study
            .subjects
            .get(index)
            .ok_or_else(|| CliError::Unusable(format!("there is no subject {index}")))?;
        let measures = self.measures.get(index);
        let prepared = PreparedSubject::new(subject, reference_frame(subject, measures));
        let medial = wall
            .map(|found| PreparedMedial::new(subject, &found.beat, found.thickening.end_diastole));
        let numbers = medial.as_ref().and_then(|medial| medial.numbers(&prepared));
        let extras = HeartExtras {
            numbers: numbers.as_ref(),
            medial: (medial.as_ref().zip(wall))
                .map(|(prepared, found)| HeartMedial { prepared, found }),
        };
        let order = FigureOrder {
            shown: FigureSubject {
                subject,
                measures,
                frame,
            },
            prepared: &prepared,
            extras,
            scene,
            view: view.map_or(FigureView::Home, |word| FigureView::Anatomical(word.into())),
            size,
        };
        rendered_figure(&order, &mut self.headless, &self.fonts).map_err(CliError::unusable)
    }
}

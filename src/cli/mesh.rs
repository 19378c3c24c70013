//! `mesh`: walls from images and masks, as a study on disk.

use serde_json::json;

use crate::analysis::preparation::{Asked, Preparation};
use crate::analysis::walls_from_masks::SurfaceFit;
use crate::cli::mesh_args::{MeshArgs, with_option};
use crate::cli::outcome::CliError;
use crate::cli::print::{on_one_line, print, print_json, say};
use crate::cli::work::run_work;
use crate::engine::{
    ExportFile, ImageWalls, image_walls, preparation_file, reading_limits, write_files,
};
use crate::image::MarkedPoints;
use crate::io::{MeshFormat, write_study};
use crate::report::{FitRow, csv};
use crate::study::{Notice, Severity, SurfaceKind};

pub(super) fn mesh(args: &MeshArgs) -> Result<(), CliError> {
    let settings = args.wall_settings()?;
    let marked = settings.over.points != MarkedPoints::default();
    let paths = args.paths.clone();
    let made =
        run_work(move |progress| image_walls(&paths, &settings, &reading_limits(), progress))?;
    for error in &made.opened.errors {
        say(&format!("cardiomorph: {error}"));
    }
    for (id, asked) in &made.asked {
        say(&format!(
            "cardiomorph: {}: say {}",
            on_one_line(id),
            options(asked)
        ));
    }
    if marked && made.preparations.len() > 1 {
        let count = made.preparations.len();
        say(&format!(
            "cardiomorph: warning: the marked points were used for {count} subjects; give each its own by --settings"
        ));
    }
    let unusable = made.opened.errors.len() + made.asked.len();
    if made.opened.study.subjects.is_empty() {
        let is_asked = |id: &str| made.asked.iter().any(|(asked, _)| asked == id);
        let others = made
            .opened
            .images
            .iter()
            .filter(|images| !is_asked(&images.id));
        for notice in others.flat_map(|images| &images.notices) {
            say(&format!("cardiomorph: {}", notice.text));
        }
        return Err(CliError::Unusable(match unusable {
            0 => "no walls were found".to_owned(),
            _ => "no walls could be made".to_owned(),
        }));
    }
    written(args, &made)?;
    if args.json {
        print_json(&as_json(args, &made))?;
    } else {
        print(&as_text(args, &made))?;
    }
    match unusable {
        0 => Ok(()),
        1 => Err(CliError::Unusable("1 input is unusable".to_owned())),
        count => Err(CliError::Unusable(format!("{count} inputs are unusable"))),
    }
}

/// What must be said, with the options that say it.
fn options(asked: &[Asked]) -> String {
    let each: Vec<String> = asked.iter().map(|&asked| with_option(asked)).collect();
    each.join(", ")
}

/// Writes the study, the table of fits and the settings that the subjects were made with.
fn written(args: &MeshArgs, made: &ImageWalls) -> Result<(), CliError> {
    let format = MeshFormat::of_extension("ply")
        .ok_or_else(|| CliError::Unusable("PLY is not a format that can be written".to_owned()))?;
    let (study, folder) = (made.opened.study.clone(), args.out.clone());
    run_work(move |progress| {
        progress.begin_phase("writing meshes", 0.0, 1.0);
        write_study(&study, &folder, format, progress)
    })?;
    let rows: Vec<FitRow> = (made.fits.iter())
        .map(|(subject, fit)| FitRow {
            subject: subject.clone(),
            fit: *fit,
        })
        .collect();
    let fits = ExportFile::text(&args.out, "fit.csv", csv(&rows));
    let settings = preparation_file(&made.preparations).map_err(CliError::unusable)?;
    let settings = ExportFile::text(&args.out, "preparation.json", settings);
    write_files(vec![fits, settings]).map_err(CliError::Unusable)?;
    Ok(())
}

fn as_json(args: &MeshArgs, made: &ImageWalls) -> serde_json::Value {
    let subjects: Vec<_> = (made.opened.study.subjects.iter())
        .map(|subject| {
            let notices: Vec<&str> = subject.notices.iter().map(|n| n.text.as_str()).collect();
            json!({
                "id": subject.id,
                "label": subject.label,
                "road": preparation(made, &subject.id).map(|settings| settings.road.name()),
                "frames": subject.sequence.frame_count(),
                "vertices": subject.sequence.vertex_count(),
                "fits": fits(made, &subject.id).map(fit_json).collect::<Vec<_>>(),
                "notices": notices,
            })
        })
        .collect();
    let errors: Vec<String> = made.opened.errors.iter().map(ToString::to_string).collect();
    let notices: Vec<&str> = made
        .opened
        .notices
        .iter()
        .map(|n| n.text.as_str())
        .collect();
    json!({
        "folder": args.out.display().to_string(),
        "subjects": subjects,
        "errors": errors,
        "notices": notices,
        "asked": made.asked.iter().map(|(id, asked)| json!({
            "id": id,
            "needs": asked.iter().map(|asked| asked.words()).collect::<Vec<_>>(),
        })).collect::<Vec<_>>(),
    })
}

/// The settings that a subject was made with.
fn preparation<'a>(made: &'a ImageWalls, id: &str) -> Option<&'a Preparation> {
    let found = made.preparations.iter().find(|(subject, _)| subject == id);
    found.map(|(_, preparation)| preparation)
}

fn fits<'a>(made: &'a ImageWalls, id: &str) -> impl Iterator<Item = &'a SurfaceFit> {
    made.fits
        .iter()
        .filter(move |(subject, _)| subject == id)
        .map(|(_, fit)| fit)
}

fn fit_json(fit: &SurfaceFit) -> serde_json::Value {
    json!({
        "frame": fit.frame,
        "surface": match fit.kind {
            SurfaceKind::Epicardium => "epi",
            _ => "endo",
        },
        "mean_mm": fit.mean_mm,
        "p95_mm": fit.p95_mm,
        "foldovers": fit.foldovers,
        "volume_ml": fit.volume_ml,
        "mask_volume_ml": fit.mask_volume_ml,
    })
}

fn as_text(args: &MeshArgs, made: &ImageWalls) -> String {
    let study = &made.opened.study;
    let mut lines = Vec::new();
    for subject in &study.subjects {
        let worst = fits(made, &subject.id)
            .map(|fit| fit.p95_mm)
            .fold(0.0, f64::max);
        lines.push(format!(
            "{}: {} frames, 95 % of the outlines within {worst:.2} {}",
            on_one_line(&subject.id),
            subject.sequence.frame_count(),
            subject.unit.length_symbol(),
        ));
        lines.extend(
            subject
                .notices
                .iter()
                .map(|notice| format!("  {}", told(notice))),
        );
    }
    lines.extend(made.opened.notices.iter().map(told));
    let count = study.subjects.len();
    let plural = if count == 1 { "subject" } else { "subjects" };
    lines.push(format!("{count} {plural}: {}", args.out.display()));
    lines.join("\n")
}

fn told(notice: &Notice) -> String {
    let warning = match notice.severity {
        Severity::Info => "",
        Severity::Warning => "warning: ",
    };
    format!("{warning}{}", notice.text)
}

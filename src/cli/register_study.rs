//! `register --template`: a study whose vertices correspond, of meshes that do not.

use std::path::{Path, PathBuf};

use serde_json::json;

use crate::analysis::walls_from_masks::SurfaceFit;
use crate::cli::outcome::CliError;
use crate::cli::print::{on_one_line, print, print_json, say};
use crate::cli::work::run_work;
use crate::engine::{
    ExportFile, RegisterSettings, RegisteredWalls, TemplateSource, read_template, reading_limits,
    registered_walls, write_files,
};
use crate::io::{MeshFormat, read_frames, write_study};
use crate::report::{FitRow, csv};
use crate::study::{Severity, SurfaceKind};

/// The word that stands for the template that ships inside.
const BUILT_IN: &str = "built-in";

pub(super) fn register_study(
    study: &Path,
    template: &Path,
    out: &Path,
    as_json: bool,
) -> Result<(), CliError> {
    let source = match template == Path::new(BUILT_IN) {
        true => TemplateSource::BuiltIn,
        false => TemplateSource::Path(template.to_owned()),
    };
    let template = run_work(move |progress| read_template(&source, &reading_limits(), progress))?;
    let name = template.name().to_owned();
    let paths: Vec<PathBuf> = vec![study.to_owned()];
    let made = run_work(move |progress| {
        progress.begin_phase("reading meshes", 0.0, 0.2);
        let read = read_frames(&paths, &reading_limits(), progress)?;
        progress.begin_phase("laying the template", 0.2, 1.0);
        registered_walls(read, &template, &RegisterSettings::default(), progress)
    })?;
    for error in &made.errors {
        say(&format!("cardiomorph: {error}"));
    }
    if made.study.subjects.is_empty() {
        return Err(CliError::Unusable(match made.errors.len() {
            0 => "no meshes were found".to_owned(),
            _ => "nothing could be registered".to_owned(),
        }));
    }
    written(out, &made)?;
    if as_json {
        print_json(&json_of(out, &name, &made))?;
    } else {
        print(&text_of(out, &made))?;
    }
    match made.errors.len() {
        0 => Ok(()),
        1 => Err(CliError::Unusable("1 input is unusable".to_owned())),
        count => Err(CliError::Unusable(format!("{count} inputs are unusable"))),
    }
}

/// Writes the study and the table of fits.
fn written(out: &Path, made: &RegisteredWalls) -> Result<(), CliError> {
    let format = MeshFormat::of_extension("ply")
        .ok_or_else(|| CliError::Unusable("PLY is not a format that can be written".to_owned()))?;
    let (study, folder) = (made.study.clone(), out.to_owned());
    run_work(move |progress| {
        progress.begin_phase("writing meshes", 0.0, 1.0);
        write_study(&study, &folder, format, progress)
    })?;
    let row = |(subject, fit): &(String, SurfaceFit)| FitRow {
        subject: subject.clone(),
        fit: *fit,
    };
    let rows: Vec<FitRow> = made.fits.iter().map(row).collect();
    let fits = ExportFile::text(out, "fit.csv", csv(&rows));
    write_files(vec![fits]).map_err(CliError::Unusable)?;
    Ok(())
}

fn fits<'a>(made: &'a RegisteredWalls, id: &str) -> impl Iterator<Item = &'a SurfaceFit> {
    let own = made.fits.iter().filter(move |(subject, _)| subject == id);
    own.map(|(_, fit)| fit)
}

fn json_of(out: &Path, template: &str, made: &RegisteredWalls) -> serde_json::Value {
    let fit = |fit: &SurfaceFit| {
        let surface = match fit.kind {
            SurfaceKind::Epicardium => "epi",
            _ => "endo",
        };
        // No number is null in JSON.
        json!({
            "frame": fit.frame,
            "surface": surface,
            "mean_mm": fit.mean_mm,
            "p95_mm": fit.p95_mm,
            "foldovers": fit.foldovers,
            "volume_ml": fit.volume_ml,
            "mask_volume_ml": fit.mask_volume_ml,
        })
    };
    let subjects = made.study.subjects.iter().map(|subject| {
        let notices: Vec<&str> = subject.notices.iter().map(|n| n.text.as_str()).collect();
        json!({
            "id": subject.id,
            "label": subject.label,
            "frames": subject.sequence.frame_count(),
            "vertices": subject.sequence.vertex_count(),
            "fits": fits(made, &subject.id).map(fit).collect::<Vec<_>>(),
            "notices": notices,
        })
    });
    let errors: Vec<String> = made.errors.iter().map(ToString::to_string).collect();
    json!({
        "folder": out.display().to_string(),
        "template": template,
        "subjects": subjects.collect::<Vec<_>>(),
        "errors": errors,
    })
}

fn text_of(out: &Path, made: &RegisteredWalls) -> String {
    let mut lines = Vec::new();
    for subject in &made.study.subjects {
        let worst = fits(made, &subject.id).map(|fit| fit.p95_mm);
        lines.push(format!(
            "{}: {} frames, 95 % of both surfaces within {:.2} {}",
            on_one_line(&subject.id),
            subject.sequence.frame_count(),
            worst.fold(0.0, f64::max),
            subject.unit.length_symbol(),
        ));
        for notice in &subject.notices {
            let warning = match notice.severity {
                Severity::Info => "",
                Severity::Warning => "warning: ",
            };
            lines.push(format!("  {warning}{}", notice.text));
        }
    }
    let count = made.study.subjects.len();
    let plural = if count == 1 { "subject" } else { "subjects" };
    lines.push(format!("{count} {plural}: {}", out.display()));
    lines.join("\n")
}

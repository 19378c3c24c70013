//! `mesh`: walls from masks, as a study on disk.

use std::path::PathBuf;

use clap::Args;
use serde_json::json;

use crate::analysis::walls_from_masks::{MaskLabels, SurfaceFit, WallParams};
use crate::cli::outcome::CliError;
use crate::cli::print::{on_one_line, print, print_json, say};
use crate::cli::words::Switch;
use crate::cli::work::run_work;
use crate::engine::{
    ExportFile, MaskWallSettings, MaskWalls, mask_walls, reading_limits, write_files,
};
use crate::io::{MeshFormat, write_study};
use crate::report::{FitRow, csv};
use crate::study::{Notice, Severity, SurfaceKind};

/// Options of `mesh`.
#[derive(Debug, Args)]
pub struct MeshArgs {
    /// Masks: folders such as patient001 with patient001_frame01_gt.nii.gz, pairs NAME_endo and NAME_epi, or folders of them
    #[arg(value_name = "PATH", required = true)]
    pub paths: Vec<PathBuf>,
    /// Output folder; created if missing
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// Values of label images: cavity and wall of the left ventricle, and cavity of the right one if there is one
    #[arg(long, value_name = "NAME=VALUE,…", default_value = "cavity=3,wall=2,right=1", value_parser = labels)]
    pub labels: MaskLabels,
    /// Maximum number of vertices per surface
    #[arg(long, value_name = "N", default_value_t = WallParams::default().vertices)]
    pub vertices: usize,
    /// Whether slices that stand beside their neighbours, because they were taken in another breath-hold, are put back
    #[arg(long, value_enum, default_value_t = Switch::On)]
    pub slice_shifts: Switch,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}

pub(super) fn mesh(args: &MeshArgs) -> Result<(), CliError> {
    let params = WallParams {
        vertices: args.vertices,
        correct_shifts: args.slice_shifts == Switch::On,
    };
    // The number of vertices is an option, so what is wrong with it is wrong usage.
    let walls = params
        .check()
        .map_err(|error| CliError::Usage(error.to_string()))?;
    let settings = MaskWallSettings {
        labels: args.labels,
        walls,
    };
    let paths = args.paths.clone();
    let made =
        run_work(move |progress| mask_walls(&paths, &settings, &reading_limits(), progress))?;
    for error in &made.errors {
        say(&format!("cardiomorph: {error}"));
    }
    if made.study.subjects.is_empty() {
        return Err(CliError::Unusable(match made.errors.len() {
            0 => "no masks were found".to_owned(),
            _ => "no walls could be made".to_owned(),
        }));
    }
    written(args, &made)?;
    if args.json {
        print_json(&as_json(args, &made))?;
    } else {
        print(&as_text(args, &made))?;
    }
    match made.errors.len() {
        0 => Ok(()),
        1 => Err(CliError::Unusable("1 input is unusable".to_owned())),
        count => Err(CliError::Unusable(format!("{count} inputs are unusable"))),
    }
}

/// Writes the study and the table of fits.
fn written(args: &MeshArgs, made: &MaskWalls) -> Result<(), CliError> {
    let format = MeshFormat::of_extension("ply")
        .ok_or_else(|| CliError::Unusable("PLY is not a format that can be written".to_owned()))?;
    let (study, folder) = (made.study.clone(), args.out.clone());
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
    write_files(vec![fits]).map_err(CliError::Unusable)?;
    Ok(())
}

/// `cavity=3,wall=2,right=1`.
fn labels(text: &str) -> Result<MaskLabels, String> {
    let mut labels = MaskLabels {
        right: None,
        ..MaskLabels::default()
    };
    let mut given = Vec::new();
    for part in text.split(',') {
        let wrong = || format!("{part:?} is not NAME=VALUE with a whole number");
        let (name, value) = part.split_once('=').ok_or_else(wrong)?;
        let value: i32 = value.trim().parse().map_err(|_| wrong())?;
        match name.trim() {
            "cavity" => labels.cavity = value,
            "wall" => labels.wall = value,
            "right" => labels.right = Some(value),
            other => {
                return Err(format!(
                    "{other:?} is unknown; cavity, wall and right are known"
                ));
            }
        }
        if given.contains(&name.trim()) {
            return Err(format!("{:?} stands twice", name.trim()));
        }
        given.push(name.trim());
    }
    let missing = ["cavity", "wall"]
        .into_iter()
        .find(|name| !given.contains(name));
    match missing {
        Some(name) => Err(format!("{name} is missing")),
        None => Ok(labels),
    }
}

fn as_json(args: &MeshArgs, made: &MaskWalls) -> serde_json::Value {
    let subjects: Vec<_> = (made.study.subjects.iter())
        .map(|subject| {
            let notices: Vec<&str> = subject.notices.iter().map(|n| n.text.as_str()).collect();
            json!({
                "id": subject.id,
                "label": subject.label,
                "frames": subject.sequence.frame_count(),
                "vertices": subject.sequence.vertex_count(),
                "fits": fits(made, &subject.id).map(fit_json).collect::<Vec<_>>(),
                "notices": notices,
            })
        })
        .collect();
    let errors: Vec<String> = made.errors.iter().map(ToString::to_string).collect();
    let notices: Vec<&str> = made.notices.iter().map(|n| n.text.as_str()).collect();
    json!({
        "folder": args.out.display().to_string(),
        "subjects": subjects,
        "errors": errors,
        "notices": notices,
    })
}

fn fits<'a>(made: &'a MaskWalls, id: &str) -> impl Iterator<Item = &'a SurfaceFit> {
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

fn as_text(args: &MeshArgs, made: &MaskWalls) -> String {
    let study = &made.study;
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
    lines.extend(made.notices.iter().map(told));
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_are_pairs_of_known_names_and_whole_numbers() {
        let all = MaskLabels {
            cavity: 1,
            wall: 2,
            right: Some(3),
        };
        assert_eq!(labels("cavity=1,wall=2,right=3"), Ok(all));
        let without = MaskLabels { right: None, ..all };
        assert_eq!(labels("wall = 2, cavity = 1"), Ok(without));
        for wrong in [
            "",
            "cavity=3",
            "cavity=3,wall",
            "cavity=x,wall=2",
            "atrium=1",
            "wall=2,wall=2,cavity=3",
        ] {
            assert!(labels(wrong).is_err(), "{wrong}");
        }
    }
}

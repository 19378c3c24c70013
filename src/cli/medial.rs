//! `medial`: atoms of a wall.

use std::path::PathBuf;

use clap::Args;
use serde_json::json;

use crate::analysis::medial::{CheckedMedialParams, MedialParams, MedialSurface, medial_surface};
use crate::cli::corresponding::read;
use crate::cli::outcome::CliError;
use crate::cli::print::{print, print_json};
use crate::cli::work::run_work;
use crate::engine::{ExportFile, write_files};
use crate::mesh::TriMesh;
use crate::report::{MedialAtomRow, csv};

/// Options of `medial`.
#[derive(Debug, Args)]
pub struct MedialArgs {
    /// Endocardium; one atom for each of its vertices
    #[arg(
        long,
        value_name = "MESH",
        requires = "epi",
        required_unless_present = "wall"
    )]
    pub endo: Option<PathBuf>,
    /// Epicardium
    #[arg(long, value_name = "MESH", requires = "endo")]
    pub epi: Option<PathBuf>,
    /// The whole wall as one closed mesh; one atom for each vertex of both sides
    #[arg(long, value_name = "MESH", conflicts_with_all = ["endo", "epi"])]
    pub wall: Option<PathBuf>,
    /// Smoothing length of surfaces, as a share of the wall thickness [default: the window's]
    #[arg(long, value_name = "S", allow_negative_numbers = true)]
    pub smoothing: Option<f64>,
    /// CSV to write: vertex,x,y,z,r,s0x,…,end, a row per atom
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}

pub(super) fn medial(args: &MedialArgs) -> Result<(), CliError> {
    let params = checked(args)?;
    let (template, others) = surfaces(args)?;
    let surface = run_work(move |progress| {
        progress.begin_phase("fitting medial spheres", 0.0, 1.0);
        let others: Vec<&TriMesh> = others.iter().collect();
        medial_surface(&template, &others, &params, progress)
    })?;
    let file = ExportFile {
        path: args.out.clone(),
        bytes: csv(&MedialAtomRow::of_surface(&surface))
            .into_bytes()
            .into(),
    };
    write_files(vec![file]).map_err(CliError::Unusable)?;
    report(&surface, args)
}

fn checked(args: &MedialArgs) -> Result<CheckedMedialParams, CliError> {
    let default = MedialParams::default();
    let params = MedialParams {
        smoothing: args.smoothing.unwrap_or(default.smoothing),
        ..default
    };
    (params.check()).map_err(|error| CliError::Usage(error.to_string()))
}

/// The template and the other side, if the wall is not one closed mesh.
fn surfaces(args: &MedialArgs) -> Result<(TriMesh, Vec<TriMesh>), CliError> {
    match (&args.endo, &args.epi, &args.wall) {
        (Some(endo), Some(epi), _) => Ok((read(endo)?, vec![read(epi)?])),
        (_, _, Some(wall)) => Ok((read(wall)?, Vec::new())),
        _ => Err(CliError::Usage(
            "medial needs --endo and --epi, or --wall".to_owned(),
        )),
    }
}

fn report(surface: &MedialSurface, args: &MedialArgs) -> Result<(), CliError> {
    let ends = surface.end.iter().flatten().count();
    let mut thicknesses: Vec<f64> = (surface.atoms.iter().zip(&surface.end))
        .filter(|(_, end)| end.is_none())
        .map(|(atom, _)| 2.0 * atom.radius)
        .collect();
    thicknesses.sort_by(f64::total_cmp);
    let median = thicknesses.get(thicknesses.len() / 2);
    let atoms = surface.atoms.len();
    if args.json {
        return print_json(&json!({
            "atoms": atoms,
            "end_atoms": ends,
            "median_thickness": median,
        }));
    }
    let thickness = median.map_or_else(String::new, |t| format!(", median thickness {t:.4}"));
    print(&format!(
        "{atoms} atoms, {ends} of them at the edge of the medial surface{thickness}: {}",
        args.out.display()
    ))
}

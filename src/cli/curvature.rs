//! `curvature`: how a surface bends at each of its vertices.

use std::path::PathBuf;

use clap::Args;
use serde_json::json;

use crate::analysis::curvature::{
    Curvature, SPECTRUM_BINS, SurfaceCurvature, shape_spectrum, surface_curvature,
};
use crate::cli::corresponding::read;
use crate::cli::outcome::CliError;
use crate::cli::print::{print, print_json};
use crate::cli::work::run_work;
use crate::engine::{ExportFile, write_files};
use crate::mesh::{TriMesh, angle_deficits_rad, flat_angles_rad, vertex_areas};
use crate::report::{VertexCurvatureRow, csv};

/// Options of `curvature`.
#[derive(Debug, Args)]
pub struct CurvatureArgs {
    /// The surface
    #[arg(value_name = "MESH")]
    pub mesh: PathBuf,
    /// Vertices up to so many edges away that the surface is fitted to: more smooth what a measured surface has of noise
    #[arg(long, value_name = "N", default_value_t = 2, value_parser = clap::value_parser!(u8).range(1..=8))]
    pub rings: u8,
    /// CSV to write: vertex,gaussian,mean,k1,k2,shape_index,curvedness, a row per vertex
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}

pub(super) fn curvature(args: &CurvatureArgs) -> Result<(), CliError> {
    let mesh = read(&args.mesh)?;
    let (rings, surface) = (usize::from(args.rings), mesh.clone());
    let found = run_work(move |progress| {
        progress.begin_phase("curvature", 0.0, 1.0);
        surface_curvature(&surface, rings, progress)
    })?;
    let file = ExportFile {
        path: args.out.clone(),
        bytes: csv(&VertexCurvatureRow::of_surface(&found))
            .into_bytes()
            .into(),
    };
    write_files(vec![file]).map_err(CliError::Unusable)?;
    let summary = Summary::of(&mesh, &found);
    if args.json {
        return print_json(&summary.json());
    }
    print(&summary.text(args))
}

/// What is said of the whole surface.
struct Summary {
    vertices: usize,
    without: usize,
    median_mean: Option<f64>,
    median_curvedness: Option<f64>,
    /// Of the angle deficits: by Gauss and Bonnet exactly 2π times the Euler number, whatever the fit says.
    total_gaussian: f64,
    spectrum: Option<[f64; SPECTRUM_BINS]>,
}

impl Summary {
    fn of(mesh: &TriMesh, found: &SurfaceCurvature) -> Self {
        let flat = flat_angles_rad(mesh.faces());
        let deficits = angle_deficits_rad(mesh.vertices(), mesh.triangles(), &flat);
        let areas = vertex_areas(mesh.vertices(), mesh.triangles());
        Self {
            vertices: found.vertices.len(),
            without: found
                .vertices
                .iter()
                .filter(|vertex| vertex.is_none())
                .count(),
            median_mean: found.median(Curvature::mean),
            median_curvedness: found.median(Curvature::curvedness),
            total_gaussian: deficits.iter().sum(),
            spectrum: shape_spectrum(&found.vertices, &areas),
        }
    }

    fn json(&self) -> serde_json::Value {
        json!({
            "vertices": self.vertices,
            "without_curvature": self.without,
            "median_mean_curvature": self.median_mean,
            "median_curvedness": self.median_curvedness,
            "total_gaussian_curvature": self.total_gaussian,
            "shape_spectrum": self.spectrum,
        })
    }

    fn text(&self, args: &CurvatureArgs) -> String {
        let median = self.median_mean.map_or_else(String::new, |mean| {
            format!(", median mean curvature {mean:.4} per unit of coordinates")
        });
        let without = match self.without {
            0 => String::new(),
            count => format!(", {count} without a curvature: too few vertices surround them"),
        };
        format!(
            "{} vertices{without}{median}: {}",
            self.vertices,
            args.out.display()
        )
    }
}

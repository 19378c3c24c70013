//! Experiments with their options.

use std::path::PathBuf;

use clap::{Args, Subcommand};

use crate::cli::experiment_shares::ShareArgs;
use crate::cli::words::{GeodesicsWord, Switch};

/// Experiments.
#[derive(Debug, Subcommand)]
pub enum ExperimentCommand {
    /// Classifies synthetic deformations under noise, transports and interpolates them
    NoiseDeformation(NoiseDeformationArgs),
    /// Classifies synthetic medial surfaces with and without a patch under noise, and detects patches of known size
    NoiseMedial(NoiseMedialArgs),
    /// Classifies the subjects of a study by every metric, on the study and on noisy copies
    Metrics(MetricComparisonArgs),
    /// Ranks the other sequence of the same patient by every metric, with and without parallel transport
    Partners(PartnerArgs),
    /// Shares of angles, curvature and displacement in the distances within beats, by every metric
    Shares(ShareArgs),
}

/// Options of `experiment noise-deformation`.
#[derive(Debug, Args)]
pub struct NoiseDeformationArgs {
    /// Redraws of objects, amplitudes and noise
    #[arg(long, value_name = "N", default_value_t = 10, value_parser = clap::value_parser!(u16).range(1..))]
    pub redraws: u16,
    /// Deformations of each of the four classes
    #[arg(long, value_name = "N", default_value_t = 15, value_parser = clap::value_parser!(u16).range(2..))]
    pub per_class: u16,
    /// Also without smoothing, Procrustes with smoothing, and levels in percent of displacement
    #[arg(long, value_enum, default_value_t = Switch::Off)]
    pub whole: Switch,
    /// Random seed
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// Output folder; created if missing
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}

/// Options of `experiment noise-medial`.
#[derive(Debug, Args)]
pub struct NoiseMedialArgs {
    /// Redraws of surfaces, patches and noise
    #[arg(long, value_name = "N", default_value_t = 10, value_parser = clap::value_parser!(u16).range(1..))]
    pub redraws: u16,
    /// Deformations without a patch, and as many with one
    #[arg(long, value_name = "N", default_value_t = 20, value_parser = clap::value_parser!(u16).range(2..))]
    pub per_class: u16,
    /// Surfaces of each size and number of patches, in each redraw
    #[arg(long, value_name = "N", default_value_t = 4, value_parser = clap::value_parser!(u16).range(1..))]
    pub per_size: u16,
    /// Random seed
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// Output folder; created if missing
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}

/// Options of `experiment metrics`.
#[derive(Debug, Args)]
pub struct MetricComparisonArgs {
    /// Studies, folders and files, together as one study; the built-in cohort if none is given
    #[arg(value_name = "STUDY")]
    pub study: Vec<PathBuf>,
    /// Noisy copies at each level
    #[arg(long, value_name = "N", default_value_t = 3, value_parser = clap::value_parser!(u16).range(1..))]
    pub redraws: u16,
    /// Parallel transport of all motions before they are compared, onto: none, mean, or the id of a subject
    #[arg(long, value_name = "REFERENCE", default_value = "none")]
    pub transfer: String,
    /// Random seed of the noise
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// Output folder; created if missing
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}

/// Options of `experiment partners`.
#[derive(Debug, Args)]
pub struct PartnerArgs {
    /// Studies, folders and files, together as one study; ids of one patient agree up to their last `_`
    #[arg(value_name = "STUDY", required = true)]
    pub study: Vec<PathBuf>,
    /// Interpolated poses of the geodesic from subject to mean shape [default: the window's]
    #[arg(long = "in-betweens", value_name = "K")]
    pub interpolated_poses: Option<u16>,
    /// For which displacements of a motion a geodesic is computed
    #[arg(long, value_enum, default_value_t = GeodesicsWord::First)]
    pub geodesics: GeodesicsWord,
    /// Begin the search for geodesics on a mesh decimated to about N vertices; 0: on the mesh itself [default: the window's]
    #[arg(long, value_name = "N")]
    pub coarse_vertices: Option<u32>,
    /// Output folder; created if missing
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}

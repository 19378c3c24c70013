//! Commands and options; names are fixed because scripts depend on them.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Args, Parser, Subcommand};

use crate::analysis::verdicts::Feature;
use crate::cli::curvature::CurvatureArgs;
use crate::cli::experiment_args::ExperimentCommand;
use crate::cli::figure_args::FigureArgs;
use crate::cli::image::ImageArgs;
use crate::cli::info::InfoArgs;
use crate::cli::limit_options::LimitOptions;
use crate::cli::map_options::MapOptions;
use crate::cli::medial::MedialArgs;
use crate::cli::mesh_args::MeshArgs;
use crate::cli::metric_options::MetricOptions;
use crate::cli::outcome::CliError;
use crate::cli::patch_options::PatchOptions;
use crate::cli::register::RegisterArgs;
use crate::cli::words::{
    AlignWord, DistancesWord, EmbedInput, EmbedMethod, GeodesicsWord, Switch, UnitWord, feature,
};
use crate::io::MeshFormat;

/// Analyses the motion of the left ventricle: moving meshes in 3D, pose and deformation maps, measures and figures.
///
/// Research software, not for diagnosis. With no command, opens the window on PATH…, or on the
/// built-in cohort. Exit codes: 0 done, 1 the input is unusable, 2 wrong usage, 3 stopped by Ctrl-C.
#[derive(Debug, Parser)]
#[command(name = "cardiomorph", version, args_conflicts_with_subcommands = true)]
struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
    /// Studies, folders and files to open in the window
    #[arg(value_name = "PATH")]
    paths: Vec<PathBuf>,
    /// Number of threads; results do not depend on it [default: one per core, at least 2]
    #[arg(long, global = true, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
    /// Memory for results and prepared subjects, in MiB; the least recently used are discarded and computed again when
    /// needed [default: a quarter of the machine's memory]
    #[arg(long, global = true, value_name = "MIB", value_parser = clap::value_parser!(u32).range(16..))]
    memory: Option<u32>,
    #[command(flatten)]
    limits: LimitOptions,
    /// Print what every column of every table means, with its unit, as Markdown
    #[arg(long)]
    columns: bool,
}

/// What to do without a window.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Writes the built-in cohort as a study on disk
    Demo(DemoArgs),
    /// Lists the contents of a study: subjects, frames, vertices, defects
    Info(InfoArgs),
    /// Lists the series of images in files and folders: grid, times, gates, values
    Image(ImageArgs),
    /// Makes walls from images and masks, as a study on disk
    Mesh(MeshArgs),
    /// Runs the whole analysis: tables, maps, summary, figures, report
    Analyze(AnalyzeArgs),
    /// Trains a classifier on the labelled subjects of a study and writes it, for `analyze --rule`
    Learn(LearnArgs),
    /// Writes clinical measures only
    Measure(MeasureArgs),
    /// Fits medial spheres into a wall: centre, radius, spokes, normal
    Medial(MedialArgs),
    /// Measures how a surface bends at each vertex: principal, Gaussian and mean curvature, shape index
    Curvature(CurvatureArgs),
    /// Computes one distance between two meshes in correspondence
    Metric(MetricArgs),
    /// Computes interpolated (geodesic) poses between two meshes in correspondence
    Interpolate(InterpolateArgs),
    /// Moves one mesh onto another, or lays a template onto all frames of a study whose vertices do not correspond
    Register(RegisterArgs),
    /// Transports the motion of one subject onto another (parallel transport)
    Transfer(TransferArgs),
    /// Embeds items by their distances, or points
    Embed(EmbedArgs),
    /// Renders a figure
    Figure(FigureArgs),
    /// Runs an experiment
    #[command(subcommand)]
    Experiment(ExperimentCommand),
}

impl Command {
    /// Whether it draws with a graphics driver.
    pub fn draws(&self) -> bool {
        match self {
            Self::Analyze(args) => args.figures == Switch::On,
            Self::Figure(_) => true,
            _ => false,
        }
    }
}

/// Options of `demo`.
#[derive(Debug, Args)]
pub struct DemoArgs {
    /// Output folder; created if missing
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// Maximum number of vertices per subject, both surfaces together
    #[arg(long, value_name = "N", default_value_t = 2_500)]
    pub vertices: usize,
    /// Random seed of the variation between subjects
    #[arg(long, default_value_t = 2009)]
    pub seed: u64,
    /// Format of the meshes
    #[arg(long, value_parser = mesh_format(), default_value = "ply")]
    pub format: MeshFormat,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}

/// Options of `measure`.
#[derive(Debug, Args)]
pub struct MeasureArgs {
    /// Studies, folders and files, together as one study; the built-in cohort if none is given
    #[arg(value_name = "STUDY")]
    pub study: Vec<PathBuf>,
    /// Unit of length of all subjects [default: as the study says, or by the size of the heart]
    #[arg(long, value_enum)]
    pub unit: Option<UnitWord>,
    /// Output folder; created if missing
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}

/// Options of `analyze`.
#[derive(Debug, Args)]
pub struct AnalyzeArgs {
    /// Studies, folders and files, together as one study; the built-in cohort if none is given
    #[arg(value_name = "STUDY")]
    pub study: Vec<PathBuf>,
    /// Unit of length of all subjects [default: as the study says, or by the size of the heart]
    #[arg(long, value_enum)]
    pub unit: Option<UnitWord>,
    /// Output folder; created if missing
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    #[command(flatten)]
    pub metric: MetricOptions,
    #[command(flatten)]
    pub maps: MapOptions,
    #[command(flatten)]
    pub patches: PatchOptions,
    /// Classify by this file, which `learn` wrote, instead of the labels of the study
    #[arg(long, value_name = "FILE")]
    pub rule: Option<PathBuf>,
    /// Whether a figure is rendered of every subject
    #[arg(long, value_enum, default_value_t = Switch::On)]
    pub figures: Switch,
    /// How the distances between all poses are written: as CSV, as a binary array of NumPy (for more than about 500 poses),
    /// or not at all
    #[arg(long, value_enum, default_value_t = DistancesWord::Csv)]
    pub distances: DistancesWord,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}

/// Options of `learn`.
#[derive(Debug, Args)]
pub struct LearnArgs {
    /// Studies, folders and files, together as one study; the built-in cohort if none is given
    #[arg(value_name = "STUDY")]
    pub study: Vec<PathBuf>,
    /// Unit of length of all subjects [default: as the study says, or by the size of the heart]
    #[arg(long, value_enum)]
    pub unit: Option<UnitWord>,
    /// Output file, JSON: features, weights, ranges and accuracy, and no subject
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
    /// Model features that the classifier reads, by their names in its file, with commas between them [default: all]
    #[arg(long, value_name = "NAMES", value_delimiter = ',', value_parser = feature)]
    pub features: Vec<Feature>,
    /// What the file says of itself
    #[arg(long, value_name = "TEXT")]
    pub note: Option<String>,
    #[command(flatten)]
    pub patches: PatchOptions,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}

/// Options of `metric`.
#[derive(Debug, Args)]
pub struct MetricArgs {
    /// Mesh A
    pub a: PathBuf,
    /// Mesh B, with the faces of A
    pub b: PathBuf,
    #[command(flatten)]
    pub metric: MetricOptions,
    /// How B is aligned with A first
    #[arg(long, value_enum, default_value_t = AlignWord::None)]
    pub align: AlignWord,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}

/// Options of `interpolate`.
#[derive(Debug, Args)]
pub struct InterpolateArgs {
    /// First mesh
    pub a: PathBuf,
    /// Last mesh, with the faces of the first
    pub b: PathBuf,
    /// Number of interpolated poses
    #[arg(long, value_name = "K", default_value_t = 3, value_parser = clap::value_parser!(u16).range(1..=1023))]
    pub poses: u16,
    #[command(flatten)]
    pub metric: MetricOptions,
    /// How B is aligned with A first
    #[arg(long, value_enum, default_value_t = AlignWord::None)]
    pub align: AlignWord,
    /// Relative decrease of energy per step at which the minimisation ends [default: the window's]
    #[arg(long, value_name = "T")]
    pub tolerance: Option<f64>,
    /// Folder for pose_000.ply, pose_001.ply, …; created if missing
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}

/// Options of `transfer`.
#[derive(Debug, Args)]
pub struct TransferArgs {
    /// The sequence whose motion is transported: a folder, or files of one subject
    #[arg(long, value_name = "SEQUENCE")]
    pub from: PathBuf,
    /// The mesh that it is transported onto, with the faces of the sequence
    #[arg(long, value_name = "MESH")]
    pub onto: PathBuf,
    #[command(flatten)]
    pub metric: MetricOptions,
    /// How the sequence is aligned with the mesh first, by its first pose
    #[arg(long, value_enum, default_value_t = AlignWord::Similarity)]
    pub align: AlignWord,
    /// Interpolated poses of the geodesic between the subjects [default: the window's]
    #[arg(long = "in-betweens", value_name = "K")]
    pub interpolated_poses: Option<u16>,
    /// For which displacements of the sequence a geodesic is computed
    #[arg(long, value_enum, default_value_t = GeodesicsWord::First)]
    pub geodesics: GeodesicsWord,
    /// Begin the search for geodesics on a mesh decimated to about N vertices; 0: on the mesh itself [default: the window's]
    #[arg(long, value_name = "N")]
    pub coarse_vertices: Option<u32>,
    /// Relative decrease of energy per step at which the search for geodesics ends [default: the window's]
    #[arg(long, value_name = "T")]
    pub tolerance: Option<f64>,
    /// Whether transport keeps the norm
    #[arg(long, value_enum, default_value_t = Switch::On)]
    pub keep_norm: Switch,
    /// Folder for pose_000.ply, pose_001.ply, …; created if missing
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}

/// Options of `embed`.
#[derive(Debug, Args)]
pub struct EmbedArgs {
    /// CSV without a header: a square matrix of distances, or one point per row
    pub file: PathBuf,
    /// What the file holds
    #[arg(long, value_enum)]
    pub input: EmbedInput,
    /// Embedding method
    #[arg(long, value_enum, default_value_t = EmbedMethod::Smacof)]
    pub method: EmbedMethod,
    /// Dimensions of the embedding
    #[arg(long, value_name = "D", default_value_t = 2, value_parser = clap::value_parser!(u16).range(1..))]
    pub dimensions: u16,
    /// Number of nearest neighbours, for isomap and lle
    #[arg(long, value_name = "K", default_value_t = 12, value_parser = clap::value_parser!(u16).range(1..))]
    pub neighbours: u16,
    /// Regularisation of the weights of lle, as a share of the trace
    #[arg(
        long,
        value_name = "R",
        default_value_t = 1e-3,
        allow_negative_numbers = true
    )]
    pub regularisation: f64,
    /// Random seed of the starts of SMACOF
    #[arg(long, default_value_t = 0)]
    pub seed: u64,
    /// Random starts of SMACOF in addition to classical MDS; the lowest stress is kept
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub starts: u16,
    /// CSV to write: x,y,…, one row per item
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}

/// Extensions of formats that meshes are written in, each with its description.
fn mesh_format() -> impl TypedValueParser<Value = MeshFormat> {
    let word =
        |format: MeshFormat| PossibleValue::new(format.extension()).help(format.description());
    let words = PossibleValuesParser::new(MeshFormat::all().map(word));
    words.try_map(|word| MeshFormat::of_extension(&word).ok_or("no format of meshes"))
}

/// What the command line asks for.
#[derive(Debug)]
pub enum Door {
    /// The dictionary of columns.
    Columns,
    /// A window on these paths.
    Window(Vec<PathBuf>),
    /// A command.
    Command(Box<Command>),
}

/// Reads the command line and sets the number of threads, the memory of stores and the limits of reading. Wrong usage, `--help` and `--version`
/// are answered here and end the program.
pub fn chosen_door() -> Door {
    let cli = Cli::parse();
    if cli.command.is_none() && !cli.columns {
        crate::engine::compute_behind_window();
    }
    crate::engine::configure_threads(cli.threads.map(usize::from));
    crate::engine::configure_memory(cli.memory.and_then(|mib| usize::try_from(mib).ok()));
    crate::engine::configure_limits(cli.limits.limits());
    match cli.command {
        Some(command) => Door::Command(Box::new(command)),
        None if cli.columns => Door::Columns,
        None => Door::Window(cli.paths),
    }
}

/// `analyze` of these paths into this folder, everything else by default.
///
/// # Errors
/// Wrong usage, which no path can be.
pub(super) fn plain_analysis(paths: &[PathBuf], out: &Path) -> Result<AnalyzeArgs, CliError> {
    let mut words: Vec<OsString> = ["cardiomorph", "analyze", "--out"]
        .map(OsString::from)
        .into();
    words.extend([out.as_os_str().to_owned(), OsString::from("--")]);
    words.extend(paths.iter().map(|path| path.as_os_str().to_owned()));
    match Cli::try_parse_from(words).map(|cli| cli.command) {
        Ok(Some(Command::Analyze(args))) => Ok(args),
        Ok(_) => Err(CliError::Usage("no analysis requested".to_owned())),
        Err(error) => Err(CliError::Usage(error.to_string())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_commands_do_not_contradict_each_other() {
        Cli::command().debug_assert();
    }

    #[test]
    fn paths_without_a_command_are_for_the_window() {
        let cli = Cli::try_parse_from(["cardiomorph", "a", "b"]).unwrap();
        assert!(cli.command.is_none());
        assert_eq!(cli.paths.len(), 2);
        let cli = Cli::try_parse_from(["cardiomorph", "info", "a", "--threads", "3"]).unwrap();
        assert!(matches!(cli.command, Some(Command::Info(_))));
        assert_eq!(cli.threads, Some(3));
        let cli = Cli::try_parse_from(["cardiomorph", "info", "a", "--memory", "512"]).unwrap();
        assert_eq!(cli.memory, Some(512));
    }
}

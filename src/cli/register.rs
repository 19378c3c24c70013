//! `register`: one mesh laid onto another, or a template onto all frames of a study.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use clap::{Args, ValueEnum};
use serde_json::{Map, Value, json};

use crate::analysis::alignment::{RigidMotion, Similarity, rigid_motion, similarity};
use crate::analysis::registration::{
    CheckedIcpParams, Icp, IcpParams, SurfaceFit, ThinPlateSpline, distances_to, icp,
};
use crate::cli::corresponding::read;
use crate::cli::landmarks::{LandmarkPairs, read_landmarks};
use crate::cli::outcome::CliError;
use crate::cli::print::{print, print_json};
use crate::cli::register_study::register_study;
use crate::cli::work::run_work;
use crate::engine::{ExportFile, write_files};
use crate::io::write_ply;
use crate::mesh::{ClosestPoint, FaceOrder, Point3, TriMesh};

/// Options of `register`.
#[derive(Debug, Args)]
pub struct RegisterArgs {
    /// The mesh that is moved; with --template the study, folder or files that get the template's vertices
    pub a: PathBuf,
    /// The mesh that it is moved onto; none with --template
    #[arg(required_unless_present = "template", conflicts_with = "template")]
    pub b: Option<PathBuf>,
    /// How A is moved
    #[arg(
        long,
        value_enum,
        required_unless_present = "template",
        conflicts_with = "template"
    )]
    pub method: Option<RegisterMethod>,
    /// Lays one mesh onto all frames of all subjects of A, so that their vertices correspond: a mesh file or study with
    /// endocardium, epicardium or both, open at the base, of which the first subject is taken; or the word built-in
    #[arg(long, value_name = "FILE|built-in")]
    pub template: Option<PathBuf>,
    /// CSV of corresponding landmarks, one pair a row: ax,ay,az,bx,by,bz, with a header of these names or without.
    /// Without the file rigid and similarity take all vertices of meshes with the same faces
    #[arg(long, value_name = "FILE", conflicts_with = "template")]
    pub landmarks: Option<PathBuf>,
    /// Smoothing of tps, in the unit of the coordinates; 0: landmarks are met exactly [default: 0]
    #[arg(
        long,
        value_name = "L",
        allow_negative_numbers = true,
        conflicts_with = "template"
    )]
    pub smoothing: Option<f64>,
    /// Share of the vertices of A that icp aligns, those closest to B [default: 1]
    #[arg(
        long,
        value_name = "SHARE",
        allow_negative_numbers = true,
        conflicts_with = "template"
    )]
    pub kept: Option<f64>,
    /// PLY file to write: A after the motion; with --template the folder of the study that is made
    #[arg(long, value_name = "FILE|DIR")]
    pub out: PathBuf,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}

/// Words of `--method`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum RegisterMethod {
    /// Rotation and translation, by landmarks or corresponding vertices
    Rigid,
    /// Rotation, translation and one scale, by landmarks or corresponding vertices
    Similarity,
    /// Rotation and translation by iterated closest points, from where landmarks or the file put A
    Icp,
    /// Thin-plate spline through landmarks
    Tps,
}

pub(super) fn register(args: &RegisterArgs) -> Result<(), CliError> {
    match (&args.template, &args.b, args.method) {
        (Some(template), ..) => register_study(&args.a, template, &args.out, args.json),
        (None, Some(b), Some(method)) => register_pair(&Pair { b, method, args }),
        // Refused by the parser already.
        _ => Err(CliError::Usage(
            "register needs two meshes and --method, or a study and --template".to_owned(),
        )),
    }
}

/// The options of two meshes.
struct Pair<'a> {
    b: &'a Path,
    method: RegisterMethod,
    args: &'a RegisterArgs,
}

fn register_pair(pair: &Pair) -> Result<(), CliError> {
    let args = pair.args;
    let method = checked(pair)?;
    let landmarks = (args.landmarks.as_deref())
        .map(read_landmarks)
        .transpose()?;
    let (a, b) = (read(&args.a)?, read(pair.b)?);
    let surface = ClosestPoint::new(b.vertices(), b.triangles()).ok_or_else(|| {
        CliError::Unusable(format!("has no faces to register to: {}", pair.b.display()))
    })?;
    let pairs = match (landmarks, pair.method) {
        (None, RegisterMethod::Rigid | RegisterMethod::Similarity) => {
            Some(vertex_pairs(&a, &b, pair)?)
        }
        (landmarks, _) => landmarks,
    };
    let landmark_count =
        (args.landmarks.is_some()).then(|| pairs.as_ref().map_or(0, |p| p.from.len()));
    let vertices = a.shared_vertices();
    let registered = run_work(move |progress| {
        progress.begin_phase("registering", 0.0, 1.0);
        let found = match method {
            Method::Icp(params) => {
                let start = match &pairs {
                    Some(pairs) => rigid_motion(&pairs.from, &pairs.onto).map_err(text)?,
                    None => RigidMotion::identity(),
                };
                Found::Icp(icp(&vertices, &surface, &start, &params, progress).map_err(text)?)
            }
            Method::Closed(word, smoothing) => closed(word, smoothing, &pairs.unwrap_or_default())?,
        };
        let moved = found.moved(&vertices);
        let fit = SurfaceFit::of_distances(&distances_to(&surface, &moved));
        Ok::<_, String>(Registered {
            fit: fit.ok_or("the mesh has no vertices, or was moved beyond the largest number")?,
            foldovers: found.foldovers(&vertices),
            found,
            moved,
        })
    })?;
    let mesh = TriMesh::new(registered.moved.as_slice(), Arc::clone(a.faces()));
    let mut bytes = Vec::new();
    write_ply(&mut bytes, &mesh.map_err(CliError::unusable)?).map_err(CliError::unusable)?;
    let file = ExportFile {
        path: args.out.clone(),
        bytes: bytes.into(),
    };
    write_files(vec![file]).map_err(CliError::Unusable)?;
    report(&registered, landmark_count, pair)
}

/// A method with its checked settings.
enum Method {
    Icp(CheckedIcpParams),
    /// In closed form, with the smoothing of a spline.
    Closed(RegisterMethod, f64),
}

/// Settings that the method has, in their ranges.
fn checked(pair: &Pair) -> Result<Method, CliError> {
    let args = pair.args;
    let wrong = |what: &str| Err(CliError::Usage(what.to_owned()));
    if args.smoothing.is_some() && pair.method != RegisterMethod::Tps {
        return wrong("--smoothing is for --method tps");
    }
    if args.kept.is_some() && pair.method != RegisterMethod::Icp {
        return wrong("--kept is for --method icp");
    }
    if args.landmarks.is_none() && pair.method == RegisterMethod::Tps {
        return wrong("--method tps needs --landmarks");
    }
    let smoothing = args.smoothing.unwrap_or(0.0);
    if !(smoothing.is_finite() && smoothing >= 0.0) {
        return wrong("--smoothing is a finite number of at least 0");
    }
    if pair.method != RegisterMethod::Icp {
        return Ok(Method::Closed(pair.method, smoothing));
    }
    let default = IcpParams::default();
    let params = IcpParams {
        kept_share: args.kept.unwrap_or(default.kept_share),
        ..default
    };
    let params = params.check();
    params
        .map(Method::Icp)
        .map_err(|error| CliError::Usage(error.to_string()))
}

/// The vertices of meshes with the same faces.
fn vertex_pairs(a: &TriMesh, b: &TriMesh, pair: &Pair) -> Result<LandmarkPairs, CliError> {
    if FaceOrder::of(a.faces(), b.faces()) == FaceOrder::Different {
        return Err(CliError::Usage(format!(
            "the vertices of {} and {} do not correspond: --landmarks says what does, --method icp needs no correspondence",
            pair.args.a.display(),
            pair.b.display()
        )));
    }
    Ok(LandmarkPairs {
        from: a.vertices().to_vec(),
        onto: b.vertices().to_vec(),
    })
}

/// What moves A onto B.
enum Found {
    Rigid(RigidMotion),
    Similarity(Similarity),
    Icp(Icp),
    Spline(ThinPlateSpline),
}

struct Registered {
    found: Found,
    moved: Vec<Point3>,
    fit: SurfaceFit,
    /// Vertices where the map folds space over.
    foldovers: usize,
}

fn text(error: impl std::fmt::Display) -> String {
    error.to_string()
}

/// What is found in closed form from corresponding points.
fn closed(word: RegisterMethod, smoothing: f64, pairs: &LandmarkPairs) -> Result<Found, String> {
    let (from, onto) = (&pairs.from, &pairs.onto);
    Ok(match word {
        RegisterMethod::Rigid | RegisterMethod::Icp => {
            Found::Rigid(rigid_motion(from, onto).map_err(text)?)
        }
        RegisterMethod::Similarity => Found::Similarity(similarity(from, onto).map_err(text)?),
        RegisterMethod::Tps => {
            Found::Spline(ThinPlateSpline::new(from, onto, smoothing).map_err(text)?)
        }
    })
}

impl Found {
    fn moved(&self, points: &[Point3]) -> Vec<Point3> {
        match self {
            Self::Rigid(motion) | Self::Icp(Icp { motion, .. }) => {
                points.iter().map(|p| motion.apply(p)).collect()
            }
            Self::Similarity(map) => points.iter().map(|p| map.apply(p)).collect(),
            Self::Spline(spline) => spline.apply_all(points),
        }
    }

    fn foldovers(&self, points: &[Point3]) -> usize {
        match self {
            Self::Spline(spline) => spline.foldovers(points),
            _ => 0,
        }
    }

    /// Scale, rotation or linear part in rows, and translation.
    fn affine(&self) -> (f64, [[f64; 3]; 3], [f64; 3]) {
        let (scale, linear, translation) = match self {
            Self::Rigid(motion) | Self::Icp(Icp { motion, .. }) => {
                (1.0, motion.rotation, motion.translation)
            }
            Self::Similarity(map) => (map.scale, map.rotation, map.translation),
            Self::Spline(spline) => (1.0, spline.linear(), spline.translation()),
        };
        let rows = [0, 1, 2].map(|row| [0, 1, 2].map(|column| linear[(row, column)]));
        (scale, rows, translation.into())
    }
}

fn report(registered: &Registered, landmarks: Option<usize>, pair: &Pair) -> Result<(), CliError> {
    let args = pair.args;
    let Registered {
        found,
        fit,
        foldovers,
        ..
    } = registered;
    let (scale, linear, translation) = found.affine();
    let matrix = if matches!(found, Found::Spline(_)) {
        "linear"
    } else {
        "rotation"
    };
    if args.json {
        let word = pair.method.to_possible_value();
        let mut object = Map::new();
        let mut put = |key: &str, value: Value| object.insert(key.to_owned(), value);
        put(
            "method",
            json!(word.as_ref().map(clap::builder::PossibleValue::get_name)),
        );
        put("landmarks", json!(landmarks));
        put("scale", json!(scale));
        put(matrix, json!(linear));
        put("translation", json!(translation));
        match found {
            Found::Icp(icp) => {
                put("kept", json!(icp.kept));
                put("rms_mm", json!(icp.rms));
                put("iterations", json!(icp.iterations));
                put("converged", json!(icp.converged));
            }
            Found::Spline(spline) => {
                put("bending_energy", json!(spline.bending_energy()));
                put("foldovers", json!(foldovers));
            }
            Found::Rigid(_) | Found::Similarity(_) => {}
        }
        put("mean_mm", json!(fit.mean));
        put("p95_mm", json!(fit.p95));
        put("greatest_mm", json!(fit.greatest));
        return print_json(&Value::Object(object));
    }
    let about = match found {
        Found::Icp(icp) => format!(
            "\niterations: {}{}; vertices aligned: {}",
            icp.iterations,
            if icp.converged { "" } else { ", not converged" },
            icp.kept
        ),
        Found::Spline(spline) => format!(
            "\nbending energy {}, space is folded over at {foldovers} vertices",
            spline.bending_energy()
        ),
        Found::Similarity(_) => format!("\nscale {scale}"),
        Found::Rigid(_) => String::new(),
    };
    print(&format!(
        "distance to B: mean {:.3} mm, 95th percentile {:.3} mm, maximum {:.3} mm: {}{about}\n{matrix} {linear:?}\ntranslation {translation:?}",
        fit.mean,
        fit.p95,
        fit.greatest,
        args.out.display()
    ))
}

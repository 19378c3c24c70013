//! Synthetic medial surfaces of left ventricles over a beat, with thickness as a function on them (section 4.6).

use std::sync::Arc;

use nalgebra::Rotation3;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

use crate::analysis::medial::{Atom, MedialBeat, MedialSurface};
use crate::analysis::medial_space::spokes_from_gradient;
use crate::analysis::segments::LongAxis;
use crate::mesh::{Faces, Point3, Vector3, vertex_normals};
use crate::study::SurfaceKind;

use super::ExperimentError;
use super::noise::{NoiseFamily, coordinate_variance};
use super::sheet_mesh::hemisphere;
use super::sheet_patches::{PatchPlace, patches};

/// How sheets are made and how much they vary.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SheetParams {
    /// Rings of atoms from apex to base.
    pub rings: u16,
    /// Axes of the sheet are multiplied by factors between 1 − this and 1 + this.
    pub shape_jitter: f64,
    /// So are thickness at rest, and by half of it how thickness varies over the sheet.
    pub thickness_jitter: f64,
    /// So are shortening, inward motion, twist, thickening and the pace of the beat.
    pub motion_jitter: f64,
}

impl Default for SheetParams {
    /// 985 atoms, 2 to 4 mm apart; shape and thickness ± 10 %, motion ± 20 %.
    fn default() -> Self {
        Self {
            rings: 24,
            shape_jitter: 0.1,
            thickness_jitter: 0.1,
            motion_jitter: 0.2,
        }
    }
}

/// How far the beat has gone to end-systole at each of its poses; end-diastole is the first.
const CURVE: [f64; 8] = [0.0, 0.35, 0.8, 1.0, 0.7, 0.3, 0.1, 0.05];
/// Poses of end-diastole and end-systole.
pub(super) const PHASES: [usize; 2] = [0, 3];
/// Half axes in millimetres of the middle of the wall at rest; the long one from base to apex.
const HALF_AXES_MM: [f64; 3] = [28.0, 28.0, 66.0];
/// Half the thickness of the wall at rest, in millimetres.
const RADIUS_MM: f64 = 4.5;
/// ln PT of remote myocardium from end-diastole to end-systole: PT = 1.52.
const THICKENING: f64 = 0.42;
/// How much less the apex of remote myocardium thickens, as a share.
const APEX_LESS: f64 = 0.25;
/// Share of its radius by which the sheet draws in to end-systole. This and the following numbers are chosen so that a sheet moves
/// as a normal ventricle does; none is measured or tuned.
const INWARD: f64 = 0.18;
/// Share of its length by which it shortens.
const SHORTENING: f64 = 0.14;
/// Twist of the apex against the base: 14°.
const TWIST_RAD: f64 = 0.25;
/// Bend of the long axis at most, to either side.
const BEND_MM: f64 = 3.0;
/// Shift of a sheet at most along each axis, as of hearts that are not aligned.
const SHIFT_MM: f64 = 8.0;
/// And its turn at most: 9°.
const TURN_RAD: f64 = 0.16;
/// Radius below which noise does not bring an atom, as a share of its clean one.
const MIN_RADIUS: f64 = 0.05;

/// One deforming medial surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Sheet {
    /// The mesh of atoms.
    pub faces: Arc<Faces>,
    /// All but the rim, where the sheet ends.
    pub regular: Vec<bool>,
    /// Positions by pose, in millimetres.
    pub positions: Vec<Vec<Point3>>,
    /// Half thickness by pose, in millimetres.
    pub radii: Vec<Vec<f64>>,
    /// Regular atoms of each patch of constant thickness: those that are at least half members.
    pub patches: Vec<Vec<u32>>,
    /// Long axis at end-diastole with septum and anterior wall, as known beforehand.
    pub axis: Option<LongAxis>,
}

/// Draws of one sheet.
struct Draw<'a>(&'a mut ChaCha8Rng);

impl Draw<'_> {
    fn around(&mut self, spread: f64) -> f64 {
        spread * self.0.random_range(-1.0..=1.0)
    }

    fn factor(&mut self, jitter: f64) -> f64 {
        1.0 + self.around(jitter)
    }

    fn vector(&mut self, spread: f64) -> Vector3 {
        Vector3::from_fn(|_, _| self.around(spread))
    }
}

/// Makes a sheet with a patch of each share of its regular area, anywhere on it. Equal arguments give equal bits.
///
/// A patch takes part in the motion: only its thickness stays.
///
/// # Errors
/// If there are fewer than four rings, a share is not in (0, 0.9), or jitter is not in 0..0.9.
pub fn sheet(
    params: &SheetParams,
    shares: &[f64],
    seed: u64,
    stream: u64,
) -> Result<Sheet, ExperimentError> {
    check(params, shares)?;
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    random.set_stream(stream);
    let bowl = hemisphere(usize::from(params.rings))?;
    let directions: Vec<Vector3> = bowl.vertices().iter().map(|p| p.coords).collect();
    let rim = bowl.faces().boundary_vertices();
    let regular: Vec<bool> = rim.iter().map(|rim| !rim).collect();
    let mut draw = Draw(&mut random);
    let motion = SheetMotion::new(params, &mut draw);
    let wall = Wall::new(params, &mut draw);
    // Timing differs between subjects as well, or all would be compared at equal phases.
    let pace = draw.factor(params.motion_jitter);
    // A power keeps the curve between 0 and 1, and its extremes at their phases.
    let curve = CURVE.map(|c| c.powf(pace));
    let positions: Vec<Vec<Point3>> = curve
        .iter()
        .map(|&c| directions.iter().map(|d| motion.at(d, c)).collect())
        .collect();
    let places = patches(
        &directions,
        &positions[PHASES[0]],
        bowl.triangles(),
        &regular,
        shares,
        &mut random,
    );
    // Where patches overlap the stronger one counts: a wall cannot be more than akinetic.
    let ill = |d: &Vector3| places.iter().map(|p| p.membership(d)).fold(0.0, f64::max);
    let radii = (curve.iter())
        .map(|&c| {
            (directions.iter())
                .map(|d| wall.radius_mm(d, c * (1.0 - ill(d))))
                .collect()
        })
        .collect();
    let members = |place: &PatchPlace| -> Vec<u32> {
        (0..directions.len())
            // Half-way across the border is where a detection may cut either way.
            .filter(|&i| regular[i] && place.membership(&directions[i]) >= 0.5)
            .map(|i| i as u32)
            .collect()
    };
    Ok(Sheet {
        faces: Arc::clone(bowl.faces()),
        patches: places.iter().map(members).collect(),
        axis: motion.axis(),
        regular,
        positions,
        radii,
    })
}

fn check(params: &SheetParams, shares: &[f64]) -> Result<(), ExperimentError> {
    if params.rings < 4 {
        return Err(ExperimentError::TooFew {
            name: "rings",
            value: usize::from(params.rings),
            least: 4,
        });
    }
    for (name, value) in [
        ("shape jitter", params.shape_jitter),
        ("thickness jitter", params.thickness_jitter),
        ("motion jitter", params.motion_jitter),
    ] {
        if !(0.0..0.9).contains(&value) {
            return Err(ExperimentError::Jitter { name, value });
        }
    }
    let fits = |share: &&f64| !(**share > 0.0 && **share < 0.9);
    match shares.iter().find(fits) {
        Some(&share) => Err(ExperimentError::PatchShare { share }),
        None => Ok(()),
    }
}

/// Where atoms are over the beat.
struct SheetMotion {
    axes_mm: Vector3,
    bend_mm: f64,
    inward: f64,
    shortening: f64,
    twist_rad: f64,
    turn: Rotation3<f64>,
    shift: Vector3,
}

impl SheetMotion {
    fn new(params: &SheetParams, draw: &mut Draw<'_>) -> Self {
        let axes_mm =
            Vector3::from(HALF_AXES_MM.map(|axis| axis * draw.factor(params.shape_jitter)));
        let turn = draw.vector(TURN_RAD);
        Self {
            axes_mm,
            bend_mm: draw.around(BEND_MM),
            inward: INWARD * draw.factor(params.motion_jitter),
            shortening: SHORTENING * draw.factor(params.motion_jitter),
            twist_rad: TWIST_RAD * draw.factor(params.motion_jitter),
            turn: Rotation3::from_scaled_axis(turn),
            shift: draw.vector(SHIFT_MM),
        }
    }

    /// Place of a direction of the hemisphere, pole at −z, when the beat has gone so far: the base comes
    /// down to the apex, the wall inwards, and apex and base turn opposite ways.
    fn at(&self, d: &Vector3, c: f64) -> Point3 {
        // Base and apex turn against each other; in between the sheet stays.
        let twist = Rotation3::from_scaled_axis(Vector3::z() * (self.twist_rad * c * (d.z + 0.5)));
        let inward = 1.0 - self.inward * c;
        let rest = d.component_mul(&self.axes_mm);
        // The apex stays and the base comes down, as in a ventricle.
        let height = (rest.z + self.axes_mm.z) * (1.0 - self.shortening * c) - self.axes_mm.z;
        let bend = self.bend_mm * d.z * d.z;
        let drawn_in = Vector3::new(rest.x * inward, rest.y * inward, height);
        let point = twist * drawn_in + Vector3::x() * bend;
        Point3::from(self.turn * point + self.shift)
    }

    fn axis(&self) -> Option<LongAxis> {
        let apex = self.at(&-Vector3::z(), 0.0);
        let base = Point3::from(self.shift);
        LongAxis::oriented(
            apex,
            base,
            self.turn * Vector3::x(),
            self.turn * Vector3::y(),
        )
    }
}

/// Thickness over the sheet.
struct Wall {
    radius_mm: f64,
    thickening: f64,
    /// How thickness at rest and thickening vary over the sheet.
    slopes: [Vector3; 2],
}

impl Wall {
    fn new(params: &SheetParams, draw: &mut Draw<'_>) -> Self {
        Self {
            radius_mm: RADIUS_MM * draw.factor(params.thickness_jitter),
            thickening: THICKENING * draw.factor(params.motion_jitter),
            slopes: [0.5 * params.thickness_jitter, params.thickness_jitter]
                .map(|slope| draw.vector(slope)),
        }
    }

    /// Half thickness where thickening has gone so far, from 0 to 1.
    fn radius_mm(&self, d: &Vector3, c: f64) -> f64 {
        // Near the apex alone: the last fifth of the height.
        let at_apex = ((-d.z - 0.8) / 0.2).max(0.0);
        let amount = self.thickening * (1.0 + self.slopes[1].dot(d)) * (1.0 - APEX_LESS * at_apex);
        self.radius_mm * (1.0 + self.slopes[0].dot(d)) * (c * amount).exp()
    }
}

impl Sheet {
    /// The sheet with noise on every position and radius, independent of each other.
    ///
    /// Variances are `percent` % of the variance per coordinate of the clean sheet at end-diastole, and of the
    /// variance of the clean radii over atoms and poses. A radius stays at least a twentieth of what it is.
    #[must_use]
    pub fn noisy(&self, family: NoiseFamily, percent: f64, random: &mut ChaCha8Rng) -> Self {
        let share = percent / 100.0;
        let way = (share * coordinate_variance(&self.positions[PHASES[0]])).sqrt();
        // Over atoms and poses together, as the variance of what a measurement has to tell apart.
        let thickness = (share * variance(&self.radii)).sqrt();
        let positions = (self.positions.iter())
            .map(|pose| family.added(pose, way, random))
            .collect();
        let radii = (self.radii.iter())
            .map(|pose| {
                (pose.iter())
                    // A radius cannot be negative, and its logarithm must exist.
                    .map(|r| (r + family.draw(thickness, random)).max(MIN_RADIUS * r))
                    .collect()
            })
            .collect();
        Self {
            positions,
            radii,
            ..self.clone()
        }
    }

    /// The sheet as atoms: normals and spokes follow from positions and radii, noise and all.
    pub fn beat(&self) -> MedialBeat {
        let triangles = self.faces.triangles();
        let frames = (self.positions.iter().zip(&self.radii))
            .map(|(points, radii)| surface(points, radii, triangles))
            .collect();
        MedialBeat {
            surface: SurfaceKind::Other,
            vertices: (0..self.regular.len() as u32).collect(),
            faces: Arc::clone(&self.faces),
            frames,
            regular: self.regular.clone(),
        }
    }
}

/// Variance of all numbers.
fn variance(poses: &[Vec<f64>]) -> f64 {
    let count = poses.iter().map(Vec::len).sum::<usize>().max(1) as f64;
    let mean = poses.iter().flatten().sum::<f64>() / count;
    let squares: f64 = poses.iter().flatten().map(|r| (r - mean).powi(2)).sum();
    squares / count
}

fn surface(points: &[Point3], radii: &[f64], triangles: &[[u32; 3]]) -> MedialSurface {
    let normals = vertex_normals(points, triangles);
    let gradients = gradients(points, radii, triangles);
    let atoms = (0..points.len())
        .map(|i| {
            let normal = &normals[i];
            // The gradient along the surface: of a noisy face it has a part along the normal.
            let along = gradients[i] - normal * normal.dot(&gradients[i]);
            Atom {
                position: points[i],
                radius: radii[i],
                // Where noise leaves the spheres no envelope the spokes are the normals.
                spokes: spokes_from_gradient(normal, &along).unwrap_or([-normal, *normal]),
            }
        })
        .collect();
    MedialSurface {
        atoms,
        end: vec![None; normals.len()],
        normals,
    }
}

/// Area-weighted mean at each atom of the gradients of its faces, Σ rᵢ N × eᵢ / 2A, eᵢ the side across from i.
fn gradients(points: &[Point3], values: &[f64], triangles: &[[u32; 3]]) -> Vec<Vector3> {
    let mut sums = vec![(Vector3::zeros(), 0.0); points.len()];
    for triangle in triangles {
        let [i, j, k] = triangle.map(|vertex| vertex as usize);
        let doubled = (points[j] - points[i]).cross(&(points[k] - points[i]));
        let Some(normal) = doubled.try_normalize(0.0) else {
            continue;
        };
        let turned: Vector3 = [[i, j, k], [j, k, i], [k, i, j]]
            .map(|[at, from, to]| (points[to] - points[from]) * values[at])
            .iter()
            .sum();
        for corner in [i, j, k] {
            sums[corner].0 += normal.cross(&turned);
            // Weighted by area: a thin face has a wild gradient.
            sums[corner].1 += doubled.norm();
        }
    }
    sums.iter()
        .map(|(sum, weight)| sum / weight.max(f64::MIN_POSITIVE))
        .collect()
}

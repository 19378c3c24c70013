//! Atoms as small discs that lie on the medial surface, at every frame.

use crate::analysis::medial::MedialBeat;
use crate::mesh::Vector3;
use crate::render::Geometry;

/// Discs do not touch: this share of the way to the nearest neighbour at end-diastole.
const REACH: f64 = 0.42;
/// Corners of a disc, and of one among very many, which is seen from afar.
const CORNERS: [usize; 2] = [14, 6];
/// Discs times frames beyond which they have few corners: about 30 MB of positions and normals.
const MANY: usize = 120_000;

/// Discs of the atoms that take part.
pub(super) struct Discs {
    /// Their shape at every frame.
    pub(super) geometry: Geometry,
    /// The atom of each disc.
    pub(super) atoms: Vec<u32>,
    /// Vertices of one disc.
    pub(super) corners: usize,
}

/// Makes discs; their size is that at end-diastole, so that they show motion and not scale.
pub(super) fn discs(beat: &MedialBeat, end_diastole: usize) -> Discs {
    let atoms: Vec<u32> = (0..beat.regular.len() as u32)
        .filter(|&atom| beat.regular[atom as usize])
        .collect();
    let corners = CORNERS[usize::from(atoms.len() * beat.frames.len() > MANY)];
    let reaches = reaches(beat, end_diastole);
    let mut geometry = Geometry::default();
    for disc in 0..atoms.len() {
        let first = (disc * corners) as u32;
        let fan = (1..corners as u32 - 1).map(|k| [first, first + k, first + k + 1]);
        geometry.triangles.extend(fan);
    }
    for frame in &beat.frames {
        let mut positions = Vec::with_capacity(atoms.len() * corners);
        let mut normals = Vec::with_capacity(atoms.len() * corners);
        for &atom in &atoms {
            let atom = atom as usize;
            let normal = frame.normals[atom];
            let [across, along] = tangents(&normal, &beat.frames[end_diastole].normals[atom]);
            let centre = frame.atoms[atom].position;
            for corner in 0..corners {
                let angle = std::f64::consts::TAU * corner as f64 / corners as f64;
                let offset = across * angle.cos() + along * angle.sin();
                let point = centre + offset * reaches[atom];
                positions.push(point.coords.cast::<f32>().into());
                normals.push(normal.cast::<f32>().into());
            }
        }
        geometry.positions.push(positions);
        geometry.normals.push(normals);
    }
    Discs {
        geometry,
        atoms,
        corners,
    }
}

/// Two directions square to a normal and to each other that turn with it as little as they can over
/// the beat: those of end-diastole laid into the plane of now.
fn tangents(normal: &Vector3, at_end_diastole: &Vector3) -> [Vector3; 2] {
    let start = square_to(at_end_diastole);
    let across = (start - normal * normal.dot(&start))
        .try_normalize(1e-6)
        .unwrap_or_else(|| square_to(normal));
    [across, normal.cross(&across)]
}

fn square_to(normal: &Vector3) -> Vector3 {
    let axis = [Vector3::x(), Vector3::y(), Vector3::z()]
        .into_iter()
        .min_by(|a, b| a.dot(normal).abs().total_cmp(&b.dot(normal).abs()))
        .unwrap_or_else(Vector3::x);
    (axis - normal * normal.dot(&axis))
        .try_normalize(0.0)
        .unwrap_or_else(Vector3::x)
}

/// Radius of each atom's disc, in coordinates.
fn reaches(beat: &MedialBeat, end_diastole: usize) -> Vec<f64> {
    let atoms = &beat.frames[end_diastole].atoms;
    let mut nearest = vec![f64::INFINITY; atoms.len()];
    for triangle in beat.faces.triangles() {
        for (a, b) in [(0, 1), (1, 2), (2, 0)] {
            let [a, b] = [triangle[a] as usize, triangle[b] as usize];
            let length = (atoms[a].position - atoms[b].position).norm();
            if length > 0.0 {
                nearest[a] = nearest[a].min(length);
                nearest[b] = nearest[b].min(length);
            }
        }
    }
    let known: Vec<f64> = nearest.iter().copied().filter(|l| l.is_finite()).collect();
    let mean = known.iter().sum::<f64>() / known.len().max(1) as f64;
    nearest
        .into_iter()
        .map(|length| REACH * if length.is_finite() { length } else { mean })
        .collect()
}

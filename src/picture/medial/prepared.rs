//! The atoms of one heart made ready for drawing, once: discs, PT at every frame, and which atom each vertex of the wall takes its number from.

use std::sync::Arc;

use crate::analysis::medial::MedialBeat;
use crate::mesh::Point3;
use crate::picture::origin::PictureOrigin;
use crate::picture::prepared::PreparedSubject;
use crate::picture::quantity::Quantity;
use crate::picture::surface_scalars::SurfaceScalars;
use crate::render::{Geometry, GeometryPose, VertexScalars};
use crate::study::{Subject, SurfaceSequence};

use super::discs::{Discs, discs};
use super::nearest::Nearest;

/// Atoms of one heart, ready for drawing. Made off the window's thread, then shared.
#[derive(Clone, Debug)]
pub struct PreparedMedial {
    /// What it is made from.
    pub beat: Arc<MedialBeat>,
    /// The frame that PT is counted from.
    pub end_diastole: usize,
    /// From where pictures count coordinates.
    pub(super) origin: PictureOrigin,
    /// The atoms counted from there.
    pub(super) drawn: Arc<MedialBeat>,
    pub(super) discs: Arc<Geometry>,
    /// PT of each vertex of the discs at every frame.
    pub(super) ratios: Arc<VertexScalars>,
    /// Least and greatest PT over the beat.
    pub(super) extremes: [f32; 2],
    /// Vertices of one disc.
    pub(super) corners: usize,
    /// The disc of each atom that takes part.
    disc_of: Vec<Option<u32>>,
    /// The atom of each vertex, surface by surface.
    atom_of: Vec<Vec<Option<u32>>>,
}

impl PreparedMedial {
    /// Prepares atoms; PT counts from `end_diastole`, or from the first frame if there is no such frame.
    pub fn new(subject: &Subject, beat: &Arc<MedialBeat>, end_diastole: usize) -> Self {
        let end_diastole = if end_diastole < beat.frames.len() {
            end_diastole
        } else {
            0
        };
        let origin = PictureOrigin::of(subject);
        let drawn = counted_from(origin, beat);
        let Discs {
            geometry,
            atoms,
            corners,
        } = discs(&drawn, end_diastole);
        let mut disc_of = vec![None; beat.regular.len()];
        for (disc, &atom) in atoms.iter().enumerate() {
            disc_of[atom as usize] = Some(disc as u32);
        }
        let mut extremes = [f32::INFINITY, f32::NEG_INFINITY];
        let values = (0..beat.frames.len())
            .map(|frame| {
                let ratios = atoms
                    .iter()
                    .map(|&atom| ratio(beat, end_diastole, frame, atom) as f32);
                let ratios: Vec<f32> = ratios.collect();
                for &ratio in ratios.iter().filter(|ratio| !ratio.is_nan()) {
                    extremes = [extremes[0].min(ratio), extremes[1].max(ratio)];
                }
                let every = ratios.iter();
                every
                    .flat_map(|&ratio| std::iter::repeat_n(ratio, corners))
                    .collect()
            })
            .collect();
        let feet = outer_feet(beat, end_diastole);
        let nearest = Nearest::new(&feet);
        let surfaces = subject.sequence.surfaces().iter();
        Self {
            atom_of: surfaces
                .map(|surface| atoms_of(surface, beat, end_diastole, &nearest))
                .collect(),
            beat: Arc::clone(beat),
            end_diastole,
            origin,
            drawn,
            discs: Arc::new(geometry),
            ratios: Arc::new(VertexScalars { values }),
            extremes,
            corners,
            disc_of,
        }
    }

    /// PT of an atom at a frame against end-diastole; `None` where it does not take part.
    pub fn ratio(&self, frame: usize, atom: u32) -> Option<f64> {
        let takes_part = self.beat.regular.get(atom as usize).is_some_and(|&on| on);
        (takes_part && frame < self.beat.frames.len())
            .then(|| ratio(&self.beat, self.end_diastole, frame, atom))
    }

    /// The atom that a vertex takes its number from; surfaces count as in the sequence.
    pub fn atom_at(&self, surface: usize, vertex: usize) -> Option<u32> {
        self.atom_of.get(surface)?.get(vertex).copied().flatten()
    }

    /// PT on all surfaces of a heart at all of its poses: between frames in proportion.
    pub fn numbers(&self, prepared: &PreparedSubject) -> Option<SurfaceScalars> {
        let at_frames: Vec<Vec<f32>> = (0..self.beat.frames.len())
            .map(|frame| {
                let every = self.atom_of.iter().flatten();
                every
                    .map(|atom| atom.and_then(|atom| self.ratio(frame, atom)))
                    .map(|ratio| ratio.map_or(f32::NAN, |ratio| ratio as f32))
                    .collect()
            })
            .collect();
        let lists: Vec<Vec<f32>> = (0..prepared.pose_count())
            .map(|pose| {
                let place = prepared.pose_in_frames(GeometryPose {
                    from: pose,
                    to: pose,
                    blend: 0.0,
                });
                let (from, to) = (at_frames.get(place.from)?, at_frames.get(place.to)?);
                let between = from.iter().zip(to);
                Some(between.map(|(a, b)| a + place.blend * (b - a)).collect())
            })
            .collect::<Option<_>>()?;
        SurfaceScalars::of_heart(prepared, Quantity::ThicknessRatio, &lists)
    }

    /// Corners of an atom's disc at a place between frames, in order; none where it has no disc.
    pub(super) fn disc(&self, atom: u32, pose: GeometryPose) -> Vec<[f32; 3]> {
        let Some(disc) = self.disc_of.get(atom as usize).copied().flatten() else {
            return Vec::new();
        };
        let first = disc as usize * self.corners;
        let at = |frame: usize| &self.discs.positions[frame][first..first + self.corners];
        let corners = at(pose.from).iter().zip(at(pose.to));
        corners
            .map(|(from, to)| std::array::from_fn(|x| from[x] + pose.blend * (to[x] - from[x])))
            .collect()
    }
}

/// Atoms with their places counted from another origin.
fn counted_from(origin: PictureOrigin, beat: &Arc<MedialBeat>) -> Arc<MedialBeat> {
    if origin.is_zero() {
        return Arc::clone(beat);
    }
    let mut drawn = MedialBeat::clone(beat);
    for atom in drawn.frames.iter_mut().flat_map(|frame| &mut frame.atoms) {
        atom.position = origin.counted(atom.position);
    }
    Arc::new(drawn)
}

/// r at a frame over r at end-diastole; not a number for an atom that does not take part.
fn ratio(beat: &MedialBeat, end_diastole: usize, frame: usize, atom: u32) -> f64 {
    let atom = atom as usize;
    if !beat.regular[atom] {
        return f64::NAN;
    }
    beat.frames[frame].atoms[atom].thickness_ratio(&beat.frames[end_diastole].atoms[atom])
}

/// Where the spokes of the atoms that take part meet the outer wall at end-diastole; not a number elsewhere.
fn outer_feet(beat: &MedialBeat, end_diastole: usize) -> Vec<Point3> {
    let atoms = beat.frames[end_diastole].atoms.iter();
    atoms
        .zip(&beat.regular)
        .map(|(atom, &regular)| {
            if regular {
                atom.boundary_points()[1]
            } else {
                Point3::new(f64::NAN, f64::NAN, f64::NAN)
            }
        })
        .collect()
}

/// The atom of each vertex of a surface: its own where it has one, elsewhere the one whose outer spoke
/// ends nearest.
fn atoms_of(
    surface: &SurfaceSequence,
    beat: &MedialBeat,
    end_diastole: usize,
    nearest: &Nearest<'_>,
) -> Vec<Option<u32>> {
    let vertices = surface.frames()[end_diastole].vertices();
    let mut atoms = vec![None; vertices.len()];
    let own = surface.kind() == beat.surface;
    let mut has_own = vec![false; vertices.len()];
    if own {
        for (atom, &vertex) in beat.vertices.iter().enumerate() {
            if let Some(place) = atoms.get_mut(vertex as usize) {
                *place = Some(atom as u32);
                has_own[vertex as usize] = true;
            }
        }
    }
    for (vertex, &point) in vertices.iter().enumerate() {
        if !has_own[vertex] {
            atoms[vertex] = nearest.to(point);
        }
    }
    atoms
}

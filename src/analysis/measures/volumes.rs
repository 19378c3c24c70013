//! Volumes and areas of a subject's surfaces at a frame, prepared once per subject.

use crate::mesh::{CappedSheet, MeshError, Point3, Sheet, SheetError, sheets};
use crate::study::{Subject, SurfaceKind, SurfaceSequence};

use super::inner_side::{self, InnerSideError};

/// Why a surface's volume is not known.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum UnknownVolume {
    /// It has no inside.
    #[error("{kind}: {reason}")]
    NoInside {
        /// The word for the surface.
        kind: &'static str,
        /// Why not.
        reason: SheetError,
    },
    /// Its connectivity is broken.
    #[error("{kind}: {reason}")]
    Broken {
        /// The word for the surface.
        kind: &'static str,
        /// What is wrong.
        reason: MeshError,
    },
    /// The wall's inner side cannot be distinguished from its outer one.
    #[error("wall: {0}; the cavity's volume is not known")]
    InnerSide(#[from] InnerSideError),
    /// A wall of one sheet is open, so that it encloses no myocardium.
    #[error("wall: one sheet with {loops} open ends encloses no myocardium")]
    OpenWall {
        /// Its boundary loops.
        loops: usize,
    },
    /// A wall of two sheets whose smaller one does not lie in the other.
    #[error("wall: two sheets, of which neither lies inside the other")]
    NotNested,
    /// A wall of more sheets than two.
    #[error("wall: {sheets} separate sheets; one or two are expected")]
    ManySheets {
        /// How many.
        sheets: usize,
    },
    /// No surface is said to be part of a subject.
    #[error("no surface is labelled endocardium, epicardium, cavity or wall")]
    NoHeart,
}

/// Volumes and areas of a frame in cubic and square coordinates.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct FrameVolumes {
    pub endo: Option<SurfaceSize>,
    pub epi: Option<SurfaceSize>,
    pub wall_volume: Option<f64>,
}

/// Size of one surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SurfaceSize {
    pub volume: f64,
    pub area: f64,
}

/// Sizes of a subject that can be measured, and why the others cannot.
#[derive(Clone, Debug)]
pub(super) struct SubjectGeometry<'a> {
    endo: Option<Enclosure<'a>>,
    epi: Option<Enclosure<'a>>,
    wall: Option<Wall<'a>>,
    pub unknown: Vec<UnknownVolume>,
}

/// A surface that encloses blood, or blood and myocardium.
#[derive(Clone, Debug)]
struct Enclosure<'a> {
    surface: &'a SurfaceSequence,
    sheets: Vec<CappedSheet>,
}

/// A wall given as one surface.
#[derive(Clone, Debug)]
struct Wall<'a> {
    surface: &'a SurfaceSequence,
    form: WallForm,
}

#[derive(Clone, Debug)]
enum WallForm {
    /// One closed sheet; the inner side is part of it.
    Joined {
        whole: CappedSheet,
        inner: Option<CappedSheet>,
    },
    /// Two sheets, one inside the other.
    Nested {
        inner: CappedSheet,
        outer: CappedSheet,
    },
}

impl<'a> SubjectGeometry<'a> {
    pub fn new(subject: &'a Subject) -> Self {
        let mut unknown = Vec::new();
        let sequence = &subject.sequence;
        let mut enclosure = |kinds: [SurfaceKind; 2]| {
            let surface = kinds.iter().find_map(|&kind| sequence.surface(kind))?;
            Enclosure::new(surface)
                .map_err(|reason| unknown.push(reason))
                .ok()
        };
        // A cavity is bounded by the endocardium; where both are given the endocardium is what was traced.
        let endo = enclosure([SurfaceKind::Endocardium, SurfaceKind::Cavity]);
        let epi = enclosure([SurfaceKind::Epicardium; 2]);
        let wall = sequence.surface(SurfaceKind::Wall).and_then(|surface| {
            Wall::new(surface, &mut unknown)
                .map_err(|reason| unknown.push(reason))
                .ok()
        });
        if sequence
            .surfaces()
            .iter()
            .all(|surface| surface.kind() == SurfaceKind::Other)
        {
            unknown.push(UnknownVolume::NoHeart);
        }
        Self {
            endo,
            epi,
            wall,
            unknown,
        }
    }

    /// Sizes at a frame, which must exist.
    pub fn at(&self, frame: usize) -> FrameVolumes {
        let mut sizes = FrameVolumes {
            endo: self.endo.as_ref().map(|surface| surface.at(frame)),
            epi: self.epi.as_ref().map(|surface| surface.at(frame)),
            wall_volume: None,
        };
        if let Some(wall) = &self.wall {
            let of_wall = wall.at(frame);
            // Surfaces of their own are nearer to what was measured than sides split off a wall.
            sizes.endo = sizes.endo.or(of_wall.endo);
            sizes.epi = sizes.epi.or(of_wall.epi);
            sizes.wall_volume = of_wall.wall_volume;
        } else if let (Some(endo), Some(epi)) = (sizes.endo, sizes.epi) {
            sizes.wall_volume = volume_between(endo, epi);
        }
        sizes
    }
}

impl<'a> Enclosure<'a> {
    fn new(surface: &'a SurfaceSequence) -> Result<Self, UnknownVolume> {
        Ok(Self {
            surface,
            sheets: capped_sheets(surface)?
                .into_iter()
                .map(|(_, capped)| capped)
                .collect(),
        })
    }

    /// The sum over sheets, whichever way each is wound.
    fn at(&self, frame: usize) -> SurfaceSize {
        let vertices = self.surface.frames()[frame].vertices();
        let mut size = SurfaceSize {
            volume: 0.0,
            area: 0.0,
        };
        for sheet in &self.sheets {
            let part = sized(sheet, vertices);
            size.volume += part.volume;
            size.area += part.area;
        }
        size
    }
}

impl<'a> Wall<'a> {
    fn new(
        surface: &'a SurfaceSequence,
        unknown: &mut Vec<UnknownVolume>,
    ) -> Result<Self, UnknownVolume> {
        let mut found = capped_sheets(surface)?;
        let vertices = surface.frames()[0].vertices();
        let form = match (found.len(), found.pop(), found.pop()) {
            (1, Some((sheet, whole)), None) => {
                // A cap across both sides of an open end would close the cavity, too.
                if whole.loop_count() > 0 {
                    return Err(UnknownVolume::OpenWall {
                        loops: whole.loop_count(),
                    });
                }
                let inner = inner_side::inner_side(vertices, &sheet, &whole)
                    .map_err(|reason| unknown.push(reason.into()))
                    .ok();
                WallForm::Joined { whole, inner }
            }
            (2, Some((_, one)), Some((_, other))) => nested(one, other, vertices)?,
            (sheets, ..) => return Err(UnknownVolume::ManySheets { sheets }),
        };
        Ok(Self { surface, form })
    }

    fn at(&self, frame: usize) -> FrameVolumes {
        let vertices = self.surface.frames()[frame].vertices();
        match &self.form {
            WallForm::Joined { whole, inner } => {
                let muscle = sized(whole, vertices);
                let endo = inner.as_ref().map(|inner| sized(inner, vertices));
                FrameVolumes {
                    endo,
                    // The outer side is what is left of the surface; with the rim's ring of
                    // myocardium it holds myocardium and blood.
                    epi: endo.map(|endo| SurfaceSize {
                        volume: muscle.volume + endo.volume,
                        area: muscle.area - endo.area,
                    }),
                    wall_volume: Some(muscle.volume),
                }
            }
            WallForm::Nested { inner, outer } => {
                let (endo, epi) = (sized(inner, vertices), sized(outer, vertices));
                FrameVolumes {
                    endo: Some(endo),
                    epi: Some(epi),
                    wall_volume: volume_between(endo, epi),
                }
            }
        }
    }
}

/// `None` where the outer surface holds less than the inner one, which is no wall.
fn volume_between(endo: SurfaceSize, epi: SurfaceSize) -> Option<f64> {
    Some(epi.volume - endo.volume).filter(|&volume| volume > 0.0)
}

/// The inner side of a wall at its first frame: the part of a closed sheet that looks into the cavity, or the inner one of two sheets.
///
/// # Errors
/// If the wall is open, of more than two sheets, or its inner side cannot be determined.
pub(super) fn wall_inner_side(surface: &SurfaceSequence) -> Result<CappedSheet, UnknownVolume> {
    let mut unknown = Vec::new();
    match Wall::new(surface, &mut unknown)?.form {
        WallForm::Joined {
            inner: Some(inner), ..
        }
        | WallForm::Nested { inner, .. } => Ok(inner),
        WallForm::Joined { inner: None, .. } => {
            Err(unknown.pop().unwrap_or(InnerSideError::NoCavity.into()))
        }
    }
}

/// Two sheets as inner and outer one, if the smaller lies in the larger: nine in ten of its
/// vertices, because rims may lie in one plane, where rounding decides.
fn nested(
    one: CappedSheet,
    other: CappedSheet,
    vertices: &[Point3],
) -> Result<WallForm, UnknownVolume> {
    // Enough for a share of nine in ten; not tuned.
    const MAX_SAMPLES: usize = 64;
    let volume = |sheet: &CappedSheet| sheet.signed_volume(vertices).abs();
    // The order in a file says nothing; what is inside is smaller.
    let (inner, outer) = if volume(&one) < volume(&other) {
        (one, other)
    } else {
        (other, one)
    };
    let corners = inner.vertices();
    // A winding number is a pass over the outer surface: a sample of vertices is enough.
    let stride = corners.len().div_ceil(MAX_SAMPLES).max(1);
    let samples: Vec<Point3> = corners
        .iter()
        .step_by(stride)
        .map(|&v| vertices[v as usize])
        .collect();
    let inside = samples
        .iter()
        .filter(|&&point| outer.winding_number(vertices, point) > 0.5)
        .count();
    // Coarse surfaces may touch or cross a little; half inside would be beside each other.
    if 10 * inside >= 9 * samples.len() {
        Ok(WallForm::Nested { inner, outer })
    } else {
        Err(UnknownVolume::NotNested)
    }
}

fn capped_sheets(surface: &SurfaceSequence) -> Result<Vec<(Sheet, CappedSheet)>, UnknownVolume> {
    let kind = surface.kind().name();
    let faces = surface.faces();
    sheets(faces)
        .map_err(|reason| UnknownVolume::NoInside { kind, reason })?
        .into_iter()
        .map(|sheet| {
            let capped = CappedSheet::new(faces.vertex_count(), &sheet)
                .map_err(|reason| UnknownVolume::Broken { kind, reason })?;
            Ok((sheet, capped))
        })
        .collect()
}

fn sized(sheet: &CappedSheet, vertices: &[Point3]) -> SurfaceSize {
    SurfaceSize {
        // The sign is the orientation of the faces, which files choose freely.
        volume: sheet.signed_volume(vertices).abs(),
        area: sheet.area(vertices),
    }
}

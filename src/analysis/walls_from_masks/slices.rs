//! What each slice shows at one instant: outlines of the cavity and of the heart, and which slices belong to the wall.

use super::FrameWallError;
use super::Tissue;
use super::planes::Planes;
use super::region::Region;

/// Share of the cavity's outline that the wall must lie along: a slice with less lies beyond the plane of the valve, or
/// says nothing about the epicardium.
const MIN_ENCLOSED: f64 = 0.5;
/// Share below which a wall counts as open.
const CLOSED: f64 = 0.95;
/// Share of a mask in separate parts that is worth a note.
const NOTED_PARTS: f64 = 0.02;
/// Empty slices between slices of one ventricle; below more of them, masks are of something else.
const MAX_GAP: usize = 2;
/// Slices with an epicardium, and with a cavity, that a surface needs.
const NEEDED: [usize; 2] = [3, 2];

/// Outlines in one slice, without what hangs apart and without holes; `None` where the slice says nothing.
#[derive(Clone, Debug)]
pub(super) struct SliceRegions {
    /// The blood. A slice between others without a cavity holds an empty one.
    pub cavity: Option<Region>,
    /// Blood and wall.
    pub heart: Option<Region>,
}

/// The slices of one instant from the lowest with wall up to the base.
#[derive(Clone, Debug)]
pub(super) struct FrameSlices {
    /// Number of the lowest of `slices` in the stack.
    pub lowest: usize,
    /// From the apex to the base; the last one is the slice below the plane of the valve.
    pub slices: Vec<SliceRegions>,
    /// Sentences on what was left out or is odd.
    pub notes: Vec<String>,
}

/// One slice before it is known where the base is.
struct Seen {
    cavity: Region,
    heart: Region,
    enclosed: f64,
    apart: usize,
}

impl FrameSlices {
    /// Finds the slices of an instant.
    ///
    /// # Errors
    /// If there is no cavity, no wall, no slice where one lies around the other, or there are too few slices.
    pub fn of(planes: &Planes, voxels: &[Tissue]) -> Result<Self, FrameWallError> {
        let seen: Vec<Seen> = (0..planes.count())
            .map(|s| seen(planes, voxels, s))
            .collect();
        if seen.iter().all(|slice| slice.cavity.count() == 0) {
            return Err(FrameWallError::NoCavity);
        }
        if !voxels.contains(&Tissue::Wall) {
            return Err(FrameWallError::NoWall);
        }
        let closed = |slice: &Seen| slice.cavity.count() > 0 && slice.enclosed >= MIN_ENCLOSED;
        let Some(base) = seen.iter().rposition(closed) else {
            let best = seen.iter().map(|slice| slice.enclosed);
            return Err(FrameWallError::NotEnclosed {
                share: best.fold(0.0, f64::max),
            });
        };
        let lowest = lowest_of_run(&seen, base);
        let apex = (lowest..=base)
            .find(|&s| seen[s].cavity.count() > 0)
            .unwrap_or(base);
        let mut notes = Vec::new();
        note_parts(planes, &seen, [lowest, base], &mut notes);
        let said = (lowest..=base).map(|s| regions(&seen[s], s, apex));
        let (slices, oddities): (Vec<SliceRegions>, Vec<Option<Oddity>>) = said.unzip();
        for oddity in Oddity::ALL {
            let with = (lowest..)
                .zip(&oddities)
                .filter(|(_, other)| **other == Some(oddity));
            let slices: Vec<usize> = with.map(|(slice, _)| slice).collect();
            if !slices.is_empty() {
                notes.push(format!("{}: {}", named(planes, &slices), oddity.words()));
            }
        }
        let counts = [
            ("wall", slices.iter().filter(|s| s.heart.is_some()).count()),
            (
                "cavity",
                (apex..=base)
                    .filter(|&s| seen[s].cavity.count() > 0)
                    .count(),
            ),
        ];
        for ((tissue, slices), needed) in counts.into_iter().zip(NEEDED) {
            if slices < needed {
                return Err(FrameWallError::FewSlices {
                    tissue,
                    slices,
                    needed,
                });
            }
        }
        Ok(Self {
            lowest,
            slices,
            notes,
        })
    }
}

fn seen(planes: &Planes, voxels: &[Tissue], slice: usize) -> Seen {
    let cavity = planes.region(voxels, slice, Tissue::Cavity);
    let wall = planes.region(voxels, slice, Tissue::Wall);
    let all = cavity.with(&wall);
    let heart = all.largest_part();
    // The blood that belongs to the heart of this slice.
    let blood = cavity.within(&heart).largest_part().filled();
    let (mut along_wall, mut sides) = (0_usize, 0_usize);
    for (_, beyond) in blood.outline() {
        sides += 1;
        along_wall += usize::from(wall.contains(beyond));
    }
    Seen {
        apart: all.count() - heart.count()
            + cavity.within(&heart).count().saturating_sub(blood.count()),
        heart: heart.filled(),
        enclosed: along_wall as f64 / sides.max(1) as f64,
        cavity: blood,
    }
}

/// The lowest slice that hangs together with the base over gaps of a few empty slices.
fn lowest_of_run(seen: &[Seen], base: usize) -> usize {
    let (mut lowest, mut gap) = (base, 0);
    for (slice, shown) in seen.iter().enumerate().take(base).rev() {
        if shown.heart.count() > 0 {
            (lowest, gap) = (slice, 0);
        } else if gap == MAX_GAP {
            break;
        } else {
            gap += 1;
        }
    }
    lowest
}

/// What a slice between the lowest one and the base says.
fn regions(seen: &Seen, slice: usize, apex: usize) -> (SliceRegions, Option<Oddity>) {
    let Seen {
        cavity,
        heart,
        enclosed,
        ..
    } = seen;
    if heart.count() == 0 {
        return (
            SliceRegions {
                cavity: None,
                heart: None,
            },
            Some(Oddity::Empty),
        );
    }
    if cavity.count() == 0 {
        let between = slice > apex;
        let regions = SliceRegions {
            cavity: between.then(|| cavity.clone()),
            heart: Some(heart.clone()),
        };
        return (regions, between.then_some(Oddity::NoCavity));
    }
    let says = *enclosed >= MIN_ENCLOSED;
    let regions = SliceRegions {
        cavity: Some(cavity.clone()),
        heart: says.then(|| heart.clone()),
    };
    let oddity = match says {
        false => Some(Oddity::LittleWall),
        true => (*enclosed < CLOSED).then_some(Oddity::OpenWall),
    };
    (regions, oddity)
}

/// What is told of a slice.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Oddity {
    Empty,
    NoCavity,
    LittleWall,
    OpenWall,
}

impl Oddity {
    const ALL: [Self; 4] = [
        Self::Empty,
        Self::NoCavity,
        Self::LittleWall,
        Self::OpenWall,
    ];

    fn words(self) -> &'static str {
        match self {
            Self::Empty => "empty, interpolated from the neighbours",
            Self::NoCavity => "no cavity between slices that have one",
            Self::LittleWall => {
                "the wall lies along less than half of the cavity, so that the epicardium is interpolated from the neighbours"
            }
            Self::OpenWall => "the wall is open",
        }
    }
}

/// `slice 3` or `slices 3, 4, 7`, by the numbers in the volume.
fn named(planes: &Planes, slices: &[usize]) -> String {
    let mut numbers: Vec<usize> = slices
        .iter()
        .map(|&s| planes.number_in_volume(s) + 1)
        .collect();
    numbers.sort_unstable();
    let words: Vec<String> = numbers.iter().map(usize::to_string).collect();
    let plural = if words.len() == 1 { "slice" } else { "slices" };
    format!("{plural} {}", words.join(", "))
}

/// Tells what hangs apart and what lies above the base.
fn note_parts(planes: &Planes, seen: &[Seen], [lowest, base]: [usize; 2], notes: &mut Vec<String>) {
    let hearts: usize = seen.iter().map(|slice| slice.heart.count()).sum();
    let apart: usize = seen[lowest..=base].iter().map(|slice| slice.apart).sum();
    if apart as f64 > NOTED_PARTS * hearts as f64 {
        notes.push(format!(
            "{apart} voxels apart from the ventricle were left out"
        ));
    }
    for (range, words) in [
        (
            base + 1..seen.len(),
            "above the plane of the valve, where the wall does not enclose the cavity:",
        ),
        (0..lowest, "apart from the others:"),
    ] {
        let out: Vec<usize> = range
            .filter(|&slice| seen[slice].heart.count() > 0)
            .collect();
        if !out.is_empty() {
            notes.push(format!("{} {words} left out", named(planes, &out)));
        }
    }
}

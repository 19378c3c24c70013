//! Can the volumes of the cavity be those of one cycle?

use super::enclosed_volume::enclosed_volume;
use crate::study::{Notice, Subject, SurfaceKind};

/// Fewer frames than these lie too far apart for a step to say anything: of the eight gates of SPECT, one step
/// reaches 0.55 of the largest volume.
const MIN_FRAMES: usize = 10;
/// Steps count as jumps beyond this share of the largest volume times the steps of a cycle: peak filling is at most
/// some five end-diastolic volumes a second, and a cycle takes about a second. A normal cycle of 25 frames has 2.6.
const MAX_RATE: f64 = 6.0;
/// A step alone counts as a jump beyond this share of the largest volume times the steps of a cycle: the mean of early
/// filling.
const MIN_RATE: f64 = 3.5;
/// A step alone must also be this share of the largest volume, and so must what sets a frame apart from both neighbours.
const MIN_JUMP: f64 = 0.18;
/// A step is alone where it is so many times those before and after it: filling and ejection take several frames.
const ALONE: f64 = 2.0;
/// A frame is apart from both neighbours where it is this many times further from them than the curve goes around it.
const SPIKE: f64 = 3.0;
/// Systole takes no more than this share of a cycle, but for the distance of two frames. At rest it is a third.
const MAX_SYSTOLE: f64 = 0.5;
/// Fewer frames do not tell when the volume is least.
const MIN_FRAMES_OF_SYSTOLE: usize = 8;

/// What is odd about the volumes of a subject over the frames.
///
/// Why it matters: a frame in the wrong place, of another subject, or with another outflow tract changes the ejection
/// fraction, and nothing in the single frame shows it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct VolumeCurve {
    /// Volumes in the subject's shown unit, one per frame; empty without a cavity.
    pub volumes: Vec<f64>,
    /// Frames after which the volume jumps.
    pub jumps: Vec<usize>,
    /// Frames whose volume lies apart from those of both neighbours.
    pub spikes: Vec<usize>,
    /// Frame of the least volume, where it lies later after the largest than systole lasts.
    pub late_end_systole: Option<usize>,
    /// Openings of the cavity.
    openings: usize,
    unit: &'static str,
}

impl VolumeCurve {
    /// Measures the cavity at every frame.
    pub fn of(subject: &Subject) -> Self {
        let sequence = &subject.sequence;
        let surface = sequence
            .surface(SurfaceKind::Endocardium)
            .or_else(|| sequence.surface(SurfaceKind::Cavity));
        let Some(surface) = surface else {
            return Self::default();
        };
        let loops = surface.faces().boundary_loops();
        let factor = subject.unit.volume_from_cubic();
        let volumes: Vec<f64> = surface
            .frames()
            .iter()
            .map(|mesh| factor * enclosed_volume(mesh.vertices(), mesh.triangles(), &loops).abs())
            .collect();
        let stated = subject.end_diastole.is_some() && subject.end_systole.is_some();
        Self {
            jumps: jumps(&volumes),
            spikes: spikes(&volumes),
            late_end_systole: late_end_systole(&volumes).filter(|_| !stated),
            volumes,
            openings: loops.len(),
            unit: subject.unit.volume_symbol(),
        }
    }

    /// What the load report says.
    pub fn notices(&self) -> Vec<Notice> {
        let listed = |sentences: Vec<String>| match sentences.as_slice() {
            [first, second, third, _, ..] => {
                format!(
                    "{first}, {second}, {third} and {} more",
                    sentences.len() - 3
                )
            }
            few => few.join(", "),
        };
        let number = |frame: usize| format!("{:.1}", self.volumes[frame]);
        let mut notices = Vec::new();
        if !self.spikes.is_empty() {
            let texts = self.spikes.iter().map(|&frame| {
                format!(
                    "{} {} in frame {frame} between {} and {}",
                    number(frame),
                    self.unit,
                    number(frame - 1),
                    number(frame + 1)
                )
            });
            notices.push(Notice::warning(format!(
                "the cavity's volume jumps in single frames, as no ventricle does: {}; these frames may be damaged, of another scale or of another subject",
                listed(texts.collect())
            )));
        }
        if !self.jumps.is_empty() {
            let texts = self.jumps.iter().map(|&frame| {
                let (from, to) = (number(frame), number(frame + 1));
                format!(
                    "{from} to {to} {} from frame {frame} to {}",
                    self.unit,
                    frame + 1
                )
            });
            notices.push(Notice::warning(format!(
                "the cavity's volume jumps between neighbouring frames, faster than a ventricle fills or empties: {}; frames may be missing, in another order, or of another subject",
                listed(texts.collect())
            )));
        }
        if let Some(frame) = self.late_end_systole {
            notices.push(self.late(frame));
        }
        notices
    }

    fn late(&self, frame: usize) -> Notice {
        let count = self.volumes.len();
        let diastole = extreme(&self.volumes, 1.0);
        let after = (frame + count - diastole) % count;
        let place = format!(
            "the least volume is in frame {frame}, {:.0} % of the frames after the largest",
            100.0 * after as f64 / count as f64
        );
        if frame + 1 == count && diastole == 0 {
            // Then frames may simply end with systole.
            return Notice::info(format!(
                "{place}, and the last: the frames are taken to end at end-systole"
            ));
        }
        let openings = match self.openings {
            0 | 1 => String::new(),
            openings => format!(
                ", or volumes depend on the lids of the cavity's {openings} openings, as where an outflow tract belongs to the surface"
            ),
        };
        Notice::warning(format!(
            "{place}; systole takes half a cycle at most. The frames may not be evenly spread over one cycle{openings}; check end-systole"
        ))
    }
}

/// Frames after which the volume changes faster than a ventricle can, or far faster than before and after. The step from the last frame
/// to the first one is left out: frames need not make a whole cycle.
fn jumps(volumes: &[f64]) -> Vec<usize> {
    let count = volumes.len();
    let largest = volumes.iter().copied().fold(0.0, f64::max);
    if count < MIN_FRAMES || largest <= 0.0 {
        return Vec::new();
    }
    let steps: Vec<f64> = volumes
        .windows(2)
        .map(|pair| (pair[1] - pair[0]).abs() / largest)
        .collect();
    let spikes = spikes(volumes);
    (0..steps.len())
        .filter(|&at| {
            let beside = [at.checked_sub(1), Some(at + 1)]
                .into_iter()
                .flatten()
                .filter_map(|near| steps.get(near))
                .fold(0.0_f64, |most, step| most.max(*step));
            let least = MIN_JUMP.max(MIN_RATE / count as f64);
            let alone = steps[at] > least && steps[at] > ALONE * beside;
            let of_spike = spikes.iter().any(|&frame| frame == at || frame == at + 1);
            !of_spike && (alone || steps[at] * count as f64 > MAX_RATE)
        })
        .collect()
}

/// Frames that leave the curve and return to it within one step.
fn spikes(volumes: &[f64]) -> Vec<usize> {
    let largest = volumes.iter().copied().fold(0.0, f64::max);
    if volumes.len() < MIN_FRAMES || largest <= 0.0 {
        return Vec::new();
    }
    let step = |a: usize, b: usize| (volumes[b] - volumes[a]).abs();
    (1..volumes.len() - 1)
        .filter(|&at| {
            let off = (volumes[at] - 0.5 * (volumes[at - 1] + volumes[at + 1])).abs();
            // At end-systole the curve turns too, but from steps of the same size before and after.
            let before = at.checked_sub(2).map_or(0.0, |far| step(far, at - 1));
            let after = if at + 2 < volumes.len() {
                step(at + 1, at + 2)
            } else {
                0.0
            };
            let around = step(at - 1, at + 1).max(before).max(after);
            off > MIN_JUMP * largest && off > SPIKE * around
        })
        .collect()
}

/// The frame of the least volume, if it comes too late after the largest.
fn late_end_systole(volumes: &[f64]) -> Option<usize> {
    let count = volumes.len();
    if count < MIN_FRAMES_OF_SYSTOLE {
        return None;
    }
    let (diastole, systole) = (extreme(volumes, 1.0), extreme(volumes, -1.0));
    let after = (systole + count - diastole) % count;
    (after as f64 > MAX_SYSTOLE * count as f64 + 1.0).then_some(systole)
}

/// The first frame of the largest or, with −1, the least volume.
fn extreme(volumes: &[f64], sign: f64) -> usize {
    (0..volumes.len())
        .rev()
        .max_by(|&a, &b| (sign * volumes[a]).total_cmp(&(sign * volumes[b])))
        .unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::phantom;
    use crate::study::{MeshSequence, SurfaceSequence};
    use crate::units::LengthUnit;

    /// Notices on a cavity of these volumes in ml.
    fn notices_of(volumes: &[f64]) -> Vec<Notice> {
        let ball = phantom::sphere(2, 1.0);
        let exact = enclosed_volume(ball.vertices(), ball.triangles(), &[]);
        let frames = volumes
            .iter()
            .map(|ml| phantom::sphere(2, (1e3 * ml / exact).cbrt()))
            .collect();
        let surface = SurfaceSequence::new(SurfaceKind::Cavity, frames).unwrap();
        let sequence = MeshSequence::new(vec![surface]).unwrap();
        VolumeCurve::of(&Subject::new("p", sequence, LengthUnit::Millimetre)).notices()
    }

    /// One measured cycle of 25 frames, cine MRI.
    const CINE: [f64; 25] = [
        174.5, 169.4, 156.2, 140.2, 121.0, 106.0, 96.0, 82.0, 78.0, 71.0, 76.0, 80.0, 87.0, 103.0,
        119.0, 135.0, 144.0, 149.0, 149.0, 146.0, 146.0, 148.0, 153.0, 169.0, 178.0,
    ];
    /// Measured cycles of eight gates, SPECT, in per cent of the largest.
    const GATES: [[f64; 8]; 4] = [
        [100.0, 45.0, 26.0, 27.0, 43.0, 64.0, 74.0, 88.0],
        [93.0, 57.0, 47.0, 39.0, 56.0, 59.0, 68.0, 100.0],
        [100.0, 78.0, 56.0, 45.0, 39.0, 47.0, 60.0, 86.0],
        [84.0, 55.0, 62.0, 40.0, 49.0, 79.0, 88.0, 100.0],
    ];

    #[test]
    fn measured_cycles_bring_no_notice() {
        assert!(notices_of(&CINE).is_empty());
        for gates in GATES {
            assert!(notices_of(&gates).is_empty());
        }
        assert!(notices_of(&[120.0, 50.0]).is_empty());
        assert!(notices_of(&[120.0]).is_empty());
        // Tachycardia with a strong atrial contraction, in ten frames.
        let fast = [100.0, 84.0, 62.0, 45.0, 38.0, 50.0, 68.0, 78.0, 81.0, 84.0];
        assert!(notices_of(&fast).is_empty());
    }

    #[test]
    fn a_jump_between_neighbouring_frames_is_told_with_both_volumes() {
        let mut cycle = CINE;
        for ml in &mut cycle[15..] {
            *ml += 30.1;
        }
        cycle[14] = 118.6;
        cycle[15] = 165.1;
        let found = notices_of(&cycle);
        assert_eq!(found.len(), 1, "{found:?}");
        assert!(
            found[0]
                .text
                .contains("118.6 to 165.1 ml from frame 14 to 15"),
            "{found:?}"
        );
    }

    #[test]
    fn a_frame_of_another_scale_is_told_as_one_frame() {
        let mut cycle = CINE;
        cycle[6] *= 2.1;
        let found = notices_of(&cycle);
        assert_eq!(found.len(), 1, "{found:?}");
        assert!(found[0].text.contains("in frame 6 between"), "{found:?}");
    }

    #[test]
    fn an_end_systole_later_than_systole_lasts_is_told() {
        let mut late: Vec<f64> = CINE.to_vec();
        late.reverse();
        let found = notices_of(&late);
        assert_eq!(found.len(), 1, "{found:?}");
        assert!(
            found[0].text.contains("least volume is in frame 15, 60 %"),
            "{found:?}"
        );
        let only_systole: Vec<f64> = (0..12).map(|i| 120.0 - 5.0 * f64::from(i)).collect();
        let found = notices_of(&only_systole);
        assert!(
            found.len() == 1 && found[0].severity == crate::study::Severity::Info,
            "{found:?}"
        );
    }
}

//! When a glTF animation gives its morph targets which weights.

use gltf::Document;
use gltf::animation::{Interpolation, Property};

use super::accessors::Accessors;
use super::buffers::in_item;
use crate::io::mesh_draft::check_count;
use crate::io::{Limits, ReadMeshError};

/// The weights of one node's morph targets over time.
pub(super) struct WeightTrack {
    pub(super) node: usize,
    targets: usize,
    times_s: Vec<f64>,
    /// One list of weights per key; three for cubic splines (in-tangent, weight, out-tangent).
    weights: Vec<f64>,
    interpolation: Interpolation,
}

/// What the animations of a file say.
#[derive(Default)]
pub(super) struct Animations {
    /// The tracks of the first animation that moves morph targets.
    pub(super) tracks: Vec<WeightTrack>,
    /// Channels that move nodes, and animations after the first, which are left out.
    pub(super) left_out: usize,
}

/// Reads the first animation that moves morph targets; `targets_of` gives how many a node has.
pub(super) fn read_animations(
    document: &Document,
    accessors: &Accessors<'_>,
    limits: &Limits,
    targets_of: &dyn Fn(usize) -> usize,
) -> Result<Animations, ReadMeshError> {
    let mut found = Animations::default();
    let mut weights_in_all = 0_u64;
    for animation in document.animations() {
        let first = found.tracks.is_empty();
        for channel in animation.channels() {
            let node = channel.target().node().index();
            let targets = targets_of(node);
            let weights = channel.target().property() == Property::MorphTargetWeights;
            if !weights || !first || targets == 0 {
                found.left_out += 1;
                continue;
            }
            let item = format!("animations[{}]", animation.index());
            let sampler = channel.sampler();
            check_count("frames", sampler.input().count() as u64, limits.frames)?;
            let times_s = accessors.scalars(&sampler.input())?;
            if times_s.windows(2).any(|pair| pair[0] >= pair[1]) {
                return Err(in_item(item, "times do not increase from key to key"));
            }
            let interpolation = sampler.interpolation();
            let per_key = targets * values_per_weight(interpolation);
            let weights = sampler.output().count();
            if weights != times_s.len() * per_key || times_s.is_empty() {
                let reason = format!(
                    "{weights} weights for {} keys of {targets} morph targets",
                    times_s.len()
                );
                return Err(in_item(item, reason));
            }
            weights_in_all += weights as u64;
            check_count(
                "weights of all keys",
                weights_in_all,
                limits.vertices_of_all_frames,
            )?;
            let weights = accessors.scalars(&sampler.output())?;
            found.tracks.push(WeightTrack {
                node,
                targets,
                times_s,
                weights,
                interpolation,
            });
        }
    }
    Ok(found)
}

fn values_per_weight(interpolation: Interpolation) -> usize {
    match interpolation {
        Interpolation::CubicSpline => 3,
        Interpolation::Linear | Interpolation::Step => 1,
    }
}

/// The times of all keys of all tracks, in order, each once.
pub(super) fn key_times_s(tracks: &[WeightTrack]) -> Vec<f64> {
    let mut times_s: Vec<f64> = tracks
        .iter()
        .flat_map(|t| t.times_s.iter().copied())
        .collect();
    times_s.sort_unstable_by(f64::total_cmp);
    times_s.dedup();
    times_s
}

impl WeightTrack {
    /// The weight of each target at a time: that of the key there, or interpolated as the file
    /// says (glTF 2.0, appendix C), and held before the first key and after the last.
    pub(super) fn weights_at(&self, time_s: f64) -> Vec<f64> {
        let after = self.times_s.partition_point(|&key| key <= time_s);
        let Some(before) = after.checked_sub(1) else {
            return self.key(0, 1);
        };
        if after == self.times_s.len() || self.times_s[before] == time_s {
            return self.key(before, 1);
        }
        let step_s = self.times_s[after] - self.times_s[before];
        let t = (time_s - self.times_s[before]) / step_s;
        let (from, to) = (self.key(before, 1), self.key(after, 1));
        match self.interpolation {
            Interpolation::Step => from,
            Interpolation::Linear => zip(&from, &to, |a, b| a + t * (b - a)),
            Interpolation::CubicSpline => {
                let (t2, t3) = (t * t, t * t * t);
                let value = zip(&from, &to, |a, b| {
                    (2.0 * t3 - 3.0 * t2 + 1.0) * a + (3.0 * t2 - 2.0 * t3) * b
                });
                let slope = zip(&self.key(before, 2), &self.key(after, 0), |out, into| {
                    step_s * ((t3 - 2.0 * t2 + t) * out + (t3 - t2) * into)
                });
                zip(&value, &slope, |a, b| a + b)
            }
        }
    }

    /// Weights at a key; `part` 0 and 2 are the tangents of a cubic spline.
    fn key(&self, key: usize, part: usize) -> Vec<f64> {
        let parts = values_per_weight(self.interpolation);
        let row = key * parts + if parts == 3 { part } else { 0 };
        self.weights[row * self.targets..(row + 1) * self.targets].to_vec()
    }
}

fn zip(a: &[f64], b: &[f64], join: impl Fn(f64, f64) -> f64) -> Vec<f64> {
    a.iter().zip(b).map(|(&a, &b)| join(a, b)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn track(interpolation: Interpolation, weights: &[f64]) -> WeightTrack {
        WeightTrack {
            node: 0,
            targets: 1,
            times_s: vec![1.0, 3.0],
            weights: weights.to_vec(),
            interpolation,
        }
    }

    #[test]
    fn weights_are_held_outside_and_interpolated_between_keys() {
        let linear = track(Interpolation::Linear, &[0.0, 1.0]);
        let at: Vec<f64> = [0.0, 1.5, 3.0, 9.0]
            .map(|t| linear.weights_at(t)[0])
            .to_vec();
        assert_eq!(at, [0.0, 0.25, 1.0, 1.0]);
        assert_eq!(
            track(Interpolation::Step, &[0.0, 1.0]).weights_at(2.9),
            [0.0]
        );
    }

    #[test]
    fn a_cubic_spline_with_the_slope_of_a_line_is_that_line() {
        let cubic = track(Interpolation::CubicSpline, &[0.5, 0.0, 0.5, 0.5, 1.0, 0.5]);
        for (time_s, expected) in [(1.0, 0.0), (1.5, 0.25), (2.2, 0.6), (3.0, 1.0)] {
            assert!(
                (cubic.weights_at(time_s)[0] - expected).abs() < 1e-12,
                "{time_s}"
            );
        }
    }
}

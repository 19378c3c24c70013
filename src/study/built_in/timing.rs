//! How far contraction and rotation have gone at each moment of the beat.
//!
//! The four phases follow one another as in Taimouri, *Shape Analysis in Shape Space*, 3.6.2:
//! clockwise rotation, contraction, expansion, counter-clockwise rotation (of the apex, seen
//! from the base). Rotation therefore leads in systole and lags in diastole. In living subjects
//! much of the untwisting comes before filling; the model keeps the order of the method's text.

use super::FRAMES;

/// Moments of one beat, as shares of its length from R peak to R peak.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct BeatTiming {
    /// Opening of the aortic valve: contraction begins.
    pub ejection_begins: f64,
    /// End-systole.
    pub end_systole: f64,
    /// Opening of the mitral valve: expansion begins.
    pub filling_begins: f64,
    /// Length of the early filling wave.
    pub early_filling: f64,
    /// Beginning of the atrial wave, which lasts to the end of the beat.
    pub atrial_wave_begins: f64,
    /// Share of the stroke volume that the atrial wave brings.
    pub atrial_share: f64,
}

/// State of the motion at one frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct BeatState {
    /// 0 at end-diastole, 1 at end-systole.
    pub contraction: f64,
    /// 0 at end-diastole, near 1 at end-systole.
    pub rotation: f64,
}

impl BeatTiming {
    /// States at the frames k / 8 of the beat; contraction is scaled so that the fullest one
    /// among the frames is 1, and the frames reach the ejection fraction that was designed.
    pub fn frames(&self) -> [BeatState; FRAMES] {
        let mut states = std::array::from_fn(|frame| {
            let phase = frame as f64 / FRAMES as f64;
            BeatState {
                contraction: self.contraction(phase),
                rotation: self.rotation(phase),
            }
        });
        let most = states.iter().map(|s| s.contraction).fold(0.0, f64::max);
        for state in &mut states {
            state.contraction /= most;
        }
        states
    }

    /// Ejection, early filling, a slow rest (diastasis) and the atrial wave.
    fn contraction(&self, phase: f64) -> f64 {
        // A little, so that the volume never stands still; chosen, not measured.
        const DIASTASIS_SHARE: f64 = 0.05;
        let early_ends = self.filling_begins + self.early_filling;
        let ejected = ramp(phase, self.ejection_begins, self.end_systole);
        let filled = (1.0 - self.atrial_share - DIASTASIS_SHARE)
            * ramp(phase, self.filling_begins, early_ends)
            + DIASTASIS_SHARE * ramp(phase, early_ends, 1.0)
            + self.atrial_share * ramp(phase, self.atrial_wave_begins, 1.0);
        ejected - filled
    }

    /// Rises from the R peak, before the volume falls; falls after most of the filling.
    fn rotation(&self, phase: f64) -> f64 {
        let begins_to_turn_back = self.filling_begins + 0.3 * self.early_filling;
        ramp(phase, 0.0, 0.62 * self.end_systole) * (1.0 - ramp(phase, begins_to_turn_back, 1.0))
    }
}

/// 0 before `from`, 1 after `to`, 3x² − 2x³ between.
pub(super) fn ramp(value: f64, from: f64, to: f64) -> f64 {
    let x = ((value - from) / (to - from)).clamp(0.0, 1.0);
    x * x * (3.0 - 2.0 * x)
}

#[cfg(test)]
mod tests {
    use super::*;

    const USUAL: BeatTiming = BeatTiming {
        ejection_begins: 0.05,
        end_systole: 0.37,
        filling_begins: 0.43,
        early_filling: 0.22,
        atrial_wave_begins: 0.84,
        atrial_share: 0.24,
    };

    #[test]
    fn the_beat_begins_and_ends_at_rest() {
        assert_eq!(USUAL.contraction(0.0), 0.0);
        assert!(USUAL.contraction(1.0).abs() < 1e-12);
        assert_eq!(USUAL.rotation(0.0), 0.0);
        assert!(USUAL.rotation(1.0).abs() < 1e-12);
    }

    #[test]
    fn rotation_leads_contraction_and_outlasts_expansion() {
        let states = USUAL.frames();
        assert!(states[1].rotation > 3.0 * states[1].contraction);
        assert_eq!(states[3].contraction, 1.0);
        assert!(states[3].rotation > 0.95);
        assert!(states[5].rotation > 2.0 * states[5].contraction);
    }
}

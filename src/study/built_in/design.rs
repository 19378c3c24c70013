//! The 23 subjects: what is drawn at random, in which ranges, and what is wrong with the patients.
//!
//! The ranges are ours, set to lie inside those of published populations, and quoted only
//! where a number stands here:
//! - cavity volumes and ejection fractions: Petersen et al. (2017), J Cardiovasc Magn Reson 19:18
//!   (UK Biobank, 804 healthy adults of 45–74 years; ejection fraction 61 ± 5 % in women, 58 ± 5 % in
//!   men); Maceira et al. (2006), J Cardiovasc Magn Reson 8:417–426;
//! - wall thickness: Kawel et al. (2012), Circ Cardiovasc Imaging 5:500–508 (MESA);
//!   Kawel-Boehm et al. (2020), J Cardiovasc Magn Reson 22:87, which also collects the rest;
//! - rotation: Opdahl et al. (2008), J Am Soc Echocardiogr 21:1121–1128: some 72 ± 14 % of the
//!   twist is the apex's; apex and base turn opposite ways.

use std::f64::consts::TAU;

use nalgebra::{Isometry3, Translation3, UnitQuaternion};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::motion::MotionDesign;
use super::patch::Patch;
use super::shape::{Form, Wave};
use super::timing::BeatTiming;
use super::truth::Abnormality;

/// Everything about one subject before it is sampled.
#[derive(Clone, Debug)]
pub(super) struct SubjectDesign {
    pub id: String,
    pub abnormality: Abnormality,
    pub form: Form,
    pub edv_ml: f64,
    /// Ejection fraction that the subject would have without patches.
    pub healthy_ejection_fraction: f64,
    pub timing: BeatTiming,
    pub rr_s: f64,
    pub height_cm: f64,
    pub weight_kg: f64,
    /// From model coordinates to those of the study.
    pub placement: Isometry3<f64>,
    shortening: f64,
    twist_rad: f64,
    apex_share_of_twist: f64,
    bend_mm: [f64; 2],
    tilt: [f64; 2],
}

impl SubjectDesign {
    /// The label in the study.
    pub fn label(&self) -> &'static str {
        match self.abnormality {
            Abnormality::None => "normal",
            _ => "abnormal",
        }
    }

    /// The motion with a given squeeze. Seen from the base the apex turns clockwise.
    pub fn motion(&self, squeeze: f64) -> MotionDesign {
        MotionDesign {
            squeeze,
            shortening: self.shortening,
            tip_lengthening: 1.2 * self.shortening,
            apex_turn_rad: -self.twist_rad * self.apex_share_of_twist,
            base_turn_rad: self.twist_rad * (1.0 - self.apex_share_of_twist),
            bend_mm: self.bend_mm,
            tilt: self.tilt,
        }
    }
}

/// Ranges from which a kind of subject is drawn.
struct Ranges {
    edv_ml: [f64; 2],
    ejection_fraction: [f64; 2],
    wall_mm: [f64; 2],
    septal_thickening: [f64; 2],
    /// Length of the cavity over that of a normal one of the same volume.
    lengthening: [f64; 2],
    shortening: [f64; 2],
    twist_degrees: [f64; 2],
    atrial_share: [f64; 2],
}

const NORMAL: Ranges = Ranges {
    edv_ml: [102.0, 182.0],
    ejection_fraction: [0.56, 0.69],
    wall_mm: [6.6, 8.4],
    septal_thickening: [0.05, 0.14],
    lengthening: [0.96, 1.05],
    shortening: [0.21, 0.25],
    twist_degrees: [13.0, 19.0],
    atrial_share: [0.20, 0.28],
};

/// Subjects with patches: what their normal myocardium does. It makes up a little for the rest.
const ISCHAEMIC: Ranges = Ranges {
    edv_ml: [125.0, 175.0],
    ejection_fraction: [0.59, 0.68],
    wall_mm: [7.2, 8.8],
    septal_thickening: [0.05, 0.14],
    lengthening: [0.95, 1.03],
    shortening: [0.17, 0.21],
    twist_degrees: [9.0, 15.0],
    atrial_share: [0.24, 0.36],
};

const DILATED: Ranges = Ranges {
    edv_ml: [235.0, 300.0],
    ejection_fraction: [0.18, 0.30],
    wall_mm: [7.0, 8.6],
    septal_thickening: [0.0, 0.08],
    lengthening: [0.88, 0.94],
    shortening: [0.06, 0.09],
    twist_degrees: [3.0, 6.0],
    atrial_share: [0.12, 0.30],
};

const HYPERTROPHIC: Ranges = Ranges {
    edv_ml: [88.0, 112.0],
    ejection_fraction: [0.68, 0.75],
    wall_mm: [14.5, 17.0],
    septal_thickening: [0.18, 0.40],
    lengthening: [0.95, 1.03],
    shortening: [0.13, 0.17],
    twist_degrees: [15.0, 21.0],
    atrial_share: [0.30, 0.42],
};

/// A patch of a patient's specification: degrees from septum towards anterior wall, degrees
/// from the apex in the chart, radius in degrees, severity.
type PatchSpec = [f64; 4];

/// What is wrong with each patient, and where: the coronary territories in turn.
const PATIENTS: [(Abnormality, &[PatchSpec]); 14] = [
    // lateral at mid-height (segment 11)
    (Abnormality::SmallPatch, &[[205.0, 68.0, 23.0, 1.0]]),
    // anterior at mid-height (7)
    (Abnormality::SmallPatch, &[[95.0, 62.0, 24.0, 1.0]]),
    // inferior (10, 4)
    (Abnormality::MediumPatch, &[[268.0, 78.0, 34.0, 1.0]]),
    // anteroseptal (8, 14)
    (Abnormality::MediumPatch, &[[35.0, 55.0, 33.0, 0.95]]),
    // anterior and apical (13, 14, 7, 17)
    (Abnormality::LargePatch, &[[62.0, 38.0, 40.0, 1.0]]),
    // inferolateral (5, 11, 4, 10)
    (Abnormality::LargePatch, &[[228.0, 74.0, 49.0, 1.0]]),
    // the anterior descending artery's whole territory
    (Abnormality::VeryLargePatch, &[[58.0, 40.0, 62.0, 1.0]]),
    // inferior and lateral walls
    (Abnormality::VeryLargePatch, &[[240.0, 66.0, 65.0, 0.95]]),
    // anterior and inferolateral
    (
        Abnormality::TwoPatches,
        &[[85.0, 60.0, 28.0, 1.0], [235.0, 74.0, 27.0, 0.95]],
    ),
    // apex and basal inferoseptum
    (
        Abnormality::TwoPatches,
        &[[120.0, 14.0, 27.0, 1.0], [325.0, 80.0, 27.0, 1.0]],
    ),
    (Abnormality::Dilated, &[]),
    (Abnormality::Dilated, &[]),
    (Abnormality::Hypertrophic, &[]),
    (Abnormality::Hypertrophic, &[]),
];

/// The nine normal subjects and the fourteen patients. Each has a random stream of its own.
pub(super) fn designs(seed: u64) -> Vec<SubjectDesign> {
    let normal = (1..=9).map(|number| (format!("N{number:02}"), Abnormality::None, [].as_slice()));
    let patients = PATIENTS
        .iter()
        .zip(1..)
        .map(|(&(abnormality, patches), number)| (format!("P{number:02}"), abnormality, patches));
    normal
        .chain(patients)
        .zip(0_u64..)
        .map(|((id, abnormality, patches), stream)| {
            let mut rng = ChaCha8Rng::seed_from_u64(seed);
            rng.set_stream(stream);
            design(id, abnormality, patches, &mut Draw(rng))
        })
        .collect()
}

struct Draw(ChaCha8Rng);

impl Draw {
    fn within(&mut self, [from, to]: [f64; 2]) -> f64 {
        from + (to - from) * self.0.random::<f64>()
    }

    fn around(&mut self, spread: f64) -> f64 {
        self.within([-spread, spread])
    }
}

fn design(
    id: String,
    abnormality: Abnormality,
    patches: &[PatchSpec],
    draw: &mut Draw,
) -> SubjectDesign {
    let ranges = match abnormality {
        Abnormality::None => &NORMAL,
        Abnormality::Dilated => &DILATED,
        Abnormality::Hypertrophic => &HYPERTROPHIC,
        _ => &ISCHAEMIC,
    };
    // A ventricle that lost myocardium widens: by up to a quarter with the largest patches.
    let remodelling = match abnormality {
        Abnormality::LargePatch => 1.12,
        Abnormality::VeryLargePatch => 1.25,
        _ => 1.0,
    };
    let edv_ml = draw.within(ranges.edv_ml) * remodelling;
    let form = form(edv_ml, ranges, patches, draw);
    let rr_s = 60.0 / draw.within([56.0, 84.0]);
    let height_cm = (158.0 + 0.13 * (edv_ml - 100.0) + draw.around(6.0)).round();
    let body_mass_index = draw.within([20.5, 28.5]);
    SubjectDesign {
        id,
        abnormality,
        form,
        edv_ml,
        healthy_ejection_fraction: draw.within(ranges.ejection_fraction),
        timing: timing(rr_s, ranges, draw),
        rr_s,
        height_cm,
        weight_kg: (body_mass_index * height_cm * height_cm * 1e-4).round(),
        placement: placement(draw),
        shortening: draw.within(ranges.shortening),
        twist_rad: draw.within(ranges.twist_degrees).to_radians(),
        apex_share_of_twist: draw.within([0.64, 0.78]),
        bend_mm: [draw.within([-4.0, 1.0]), draw.around(2.5)],
        tilt: [draw.around(0.05), draw.around(0.05)],
    }
}

fn form(edv_ml: f64, ranges: &Ranges, patches: &[PatchSpec], draw: &mut Draw) -> Form {
    // A cavity of 145 ml is 88 mm long here; length goes with the cube root of the volume.
    let length_mm = 88.0 * (edv_ml / 145.0).cbrt() * draw.within(ranges.lengthening);
    let size = (edv_ml / 145.0).cbrt().min(1.1);
    Form {
        cavity_length_mm: length_mm,
        widest_share: draw.within([0.61, 0.70]),
        pointedness: draw.within([0.05, 0.28]),
        septal_flattening: draw.within([0.06, 0.11]),
        waves: [2.0, 3.0, 4.0].map(|order| Wave {
            order,
            amplitude: draw.within([0.006, 0.024]) * 2.0 / order,
            phase_rad: draw.within([0.0, TAU]),
            spiral_rad: draw.around(1.2),
        }),
        wall_mm: draw.within(ranges.wall_mm) * size,
        septal_thickening: draw.within(ranges.septal_thickening),
        tip_share: draw.within([0.72, 0.86]),
        scar_thinning: if patches.is_empty() {
            0.0
        } else {
            draw.within([0.08, 0.20])
        },
        patches: patches
            .iter()
            .map(|&[around, polar, radius, severity]| Patch {
                around_rad: (around + draw.around(6.0)).to_radians(),
                polar_rad: polar.to_radians(),
                radius_rad: (radius * draw.within([0.88, 0.96])).to_radians(),
                // Wide patches have wide borders; a small one keeps a core.
                half_border_rad: (draw.within([0.64, 0.72]) * radius)
                    .clamp(13.0, 26.0)
                    .to_radians(),
                severity,
            })
            .collect(),
    }
}

/// Systole takes a larger share of a shorter beat: about 0.29 s and a tenth of the beat.
fn timing(rr_s: f64, ranges: &Ranges, draw: &mut Draw) -> BeatTiming {
    let end_systole = ((0.27 + draw.around(0.015)) / rr_s + 0.07).clamp(0.30, 0.46);
    let filling_begins = end_systole + draw.within([0.05, 0.08]);
    BeatTiming {
        ejection_begins: draw.within([0.04, 0.065]),
        end_systole,
        filling_begins,
        early_filling: draw.within([0.18, 0.25]),
        atrial_wave_begins: draw.within([0.81, 0.86]),
        atrial_share: draw.within(ranges.atrial_share),
    }
}

/// Subjects lie a little differently in every scanner: within 8 mm and 9°.
fn placement(draw: &mut Draw) -> Isometry3<f64> {
    let shift = Translation3::new(draw.around(8.0), draw.around(8.0), draw.around(8.0));
    let mut turn = || draw.around(0.09);
    let rotation = UnitQuaternion::from_euler_angles(turn(), turn(), turn());
    Isometry3::from_parts(shift, rotation)
}

//! How a slice through the grid of an image lies on the screen.

use crate::image::VolumeFrame;
use crate::mesh::{Point3, Vector3};

/// A direction is named after an axis of the patient if its component along it is at least this: the sine of 24°.
const NAMED: f64 = 0.4;
/// A slice is called after a plane of the patient if its normal is this near to an axis: within 26°.
const ALIGNED: f64 = 0.9;

/// An axis of the grid on the screen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ScreenAxis {
    /// Which axis of the grid: 0, 1 or 2.
    pub axis: usize,
    /// Whether it runs to the left, or upwards.
    pub flipped: bool,
}

/// A slice through the grid at a whole voxel: which axes run to the right and downwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlicePlane {
    /// The axis of the grid that the slice stands across.
    pub normal: usize,
    /// What runs to the right.
    pub right: ScreenAxis,
    /// What runs downwards.
    pub down: ScreenAxis,
}

impl SlicePlane {
    /// The slice across an axis of the grid, as radiologists look at it: from the feet, from the front, or from the left,
    /// whichever is nearest. The left of the patient is at the right; the head, else the front, is above.
    pub fn new(frame: &VolumeFrame, normal: usize) -> Self {
        let [first, second] = match normal {
            0 => [1, 2],
            1 => [0, 2],
            _ => [0, 1],
        };
        let directions = frame.directions();
        // What runs along the body stands upright.
        let upright = |axis: usize| directions[axis].z.abs();
        let lying = directions[first].z.abs() > std::f64::consts::FRAC_1_SQRT_2;
        let [right, down] = match lying && upright(first) > upright(second) {
            true => [second, first],
            false => [first, second],
        };
        Self {
            normal,
            right: ScreenAxis {
                axis: right,
                flipped: runs_against(directions[right]),
            },
            down: ScreenAxis {
                axis: down,
                flipped: runs_against(directions[down]),
            },
        }
    }

    /// Width and height of the slice in millimetres, with half a voxel around the outermost centres.
    pub fn size_mm(&self, frame: &VolumeFrame) -> [f64; 2] {
        let (size, spacing) = (frame.size(), frame.spacing());
        [self.right.axis, self.down.axis].map(|axis| size[axis] as f64 * spacing[axis])
    }

    /// Where a place of the grid is on the slice: shares of its width and height from the upper left corner.
    pub fn shares(&self, frame: &VolumeFrame, voxel: Point3) -> [f64; 2] {
        [self.right, self.down].map(|screen| {
            let share = (voxel[screen.axis] + 0.5) / frame.size()[screen.axis] as f64;
            match screen.flipped {
                true => 1.0 - share,
                false => share,
            }
        })
    }

    /// The place of the grid at such shares, `depth` voxels along the normal.
    pub fn voxel(&self, frame: &VolumeFrame, shares: [f64; 2], depth: f64) -> Point3 {
        let mut voxel = Point3::origin();
        voxel[self.normal] = depth;
        for (screen, share) in [self.right, self.down].into_iter().zip(shares) {
            let share = match screen.flipped {
                true => 1.0 - share,
                false => share,
            };
            voxel[screen.axis] = share * frame.size()[screen.axis] as f64 - 0.5;
        }
        voxel
    }

    /// The letters of the patient at the left, right, upper and lower edge: L, R, A, P, H, F, two where the slice is oblique.
    pub fn letters(&self, frame: &VolumeFrame) -> [String; 4] {
        let directions = frame.directions();
        let of = |screen: ScreenAxis, sign: f64| {
            let sign = if screen.flipped { -sign } else { sign };
            letters(directions[screen.axis] * sign)
        };
        [
            of(self.right, -1.0),
            of(self.right, 1.0),
            of(self.down, -1.0),
            of(self.down, 1.0),
        ]
    }

    /// What such a slice is called where its axes are those of a patient.
    pub fn name(&self, frame: &VolumeFrame) -> &'static str {
        let normal = frame.directions()[self.normal].map(f64::abs);
        match [normal.x, normal.y, normal.z].map(|part| part >= ALIGNED) {
            [true, _, _] => "Sagittal",
            [_, true, _] => "Coronal",
            [_, _, true] => "Axial",
            _ => "Oblique",
        }
    }
}

/// Whether a direction runs against that of the screen: towards right, front or head, whichever is greatest.
fn runs_against(direction: Vector3) -> bool {
    match direction.iamax() {
        0 => direction.x < 0.0,
        1 => direction.y < 0.0,
        _ => direction.z > 0.0,
    }
}

/// Where a direction (LPS) leads, greatest component first.
fn letters(direction: Vector3) -> String {
    let names = [["R", "L"], ["A", "P"], ["F", "H"]];
    let mut axes = [0, 1, 2];
    axes.sort_by(|a, b| direction[*b].abs().total_cmp(&direction[*a].abs()));
    let named = axes.into_iter().take(2);
    let named = named.filter(|axis| direction[*axis].abs() >= NAMED);
    named
        .map(|axis| names[axis][usize::from(direction[axis] > 0.0)])
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn frame(steps: [[f64; 3]; 3]) -> VolumeFrame {
        let steps = steps.map(Vector3::from);
        VolumeFrame::new([20, 30, 10], Point3::new(-7.0, 4.0, 90.0), steps).unwrap()
    }

    #[test]
    fn slices_of_a_grid_in_lps_and_of_one_in_ras_look_the_same() {
        let lps = frame([[2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 5.0]]);
        let ras = frame([[-2.0, 0.0, 0.0], [0.0, -2.0, 0.0], [0.0, 0.0, -5.0]]);
        let wanted = [
            (2, "Axial", ["R", "L", "A", "P"]),
            (1, "Coronal", ["R", "L", "H", "F"]),
            (0, "Sagittal", ["A", "P", "H", "F"]),
        ];
        for frame in [lps, ras] {
            for (normal, name, letters) in wanted {
                let plane = SlicePlane::new(&frame, normal);
                assert_eq!(plane.letters(&frame), letters, "{name}");
                assert_eq!(plane.name(&frame), name);
            }
        }
    }

    #[test]
    fn a_short_axis_slice_is_named_by_two_letters_an_edge() {
        let part = std::f64::consts::FRAC_1_SQRT_2;
        let oblique = frame([
            [part, part, 0.0],
            [0.0, 0.0, -1.5],
            [8.0 * part, -8.0 * part, 0.0],
        ]);
        let plane = SlicePlane::new(&oblique, 2);
        assert_eq!(plane.letters(&oblique), ["RA", "LP", "H", "F"]);
        assert_eq!(plane.name(&oblique), "Oblique");
    }

    #[test]
    fn the_head_is_above_where_the_first_axis_runs_along_the_body() {
        let upright = frame([[0.0, 0.0, -2.0], [2.0, 0.0, 0.0], [0.0, 5.0, 0.0]]);
        let plane = SlicePlane::new(&upright, 2);
        assert_eq!((plane.right.axis, plane.down.axis), (1, 0));
        assert_eq!(plane.letters(&upright), ["R", "L", "H", "F"]);
    }

    #[test]
    fn a_place_goes_to_the_screen_and_back_at_its_physical_size() {
        let frame = frame([[-2.0, 0.0, 0.0], [0.0, 1.5, 0.0], [0.0, 0.0, 5.0]]);
        for normal in 0..3 {
            let plane = SlicePlane::new(&frame, normal);
            let voxel = Point3::new(3.25, 11.0, 6.5);
            let shares = plane.shares(&frame, voxel);
            let back = plane.voxel(&frame, shares, voxel[normal]);
            assert!((back - voxel).norm() < 1e-12, "{normal}");
        }
        let plane = SlicePlane::new(&frame, 2);
        let size = plane.size_mm(&frame);
        assert!((size[0] - 40.0).abs() < 1e-12 && (size[1] - 45.0).abs() < 1e-12);
    }
}

//! Where the voxels of a NIfTI file stand: sform, then qform, then pixdim, as their codes say.

use nalgebra::{Matrix3, Matrix4, Vector3};

use super::header::NiftiHeader;
use crate::image::VolumeFrame;
use crate::io::ReadImageError;
use crate::io::image_file::Provenance;
use crate::study::Notice;

/// The grid, and what the file does not say about it.
#[derive(Debug)]
pub(super) struct Placement {
    pub frame: VolumeFrame,
    pub spacing: Provenance,
    pub position_known: bool,
    pub notices: Vec<Notice>,
}

/// Lengths of steps that differ by more than this share are told.
const SPACING_DIFFERS: f64 = 0.01;
/// Numbers of the header are of 32 bits: steps of 1 mm are this close to 1.
const ROUNDING: f64 = 1e-4;
/// Two placements that are farther apart than this, in millimetres, are told.
const PLACES_DIFFER_MM: f64 = 0.5;

/// Places a grid of `size` voxels.
///
/// # Errors
/// If the matrix that the codes choose is not finite, singular, or no rotation.
pub(super) fn placement(
    header: &NiftiHeader,
    size: [usize; 3],
) -> Result<Placement, ReadImageError> {
    let mut notices = Vec::new();
    let (unit_mm, unit_known) = match header.units & 7 {
        1 => (1e3, true),
        2 => (1.0, true),
        3 => (1e-3, true),
        _ => (1.0, false),
    };
    let (matrix, field, mut all_said) = match (header.sform_code, header.qform_code) {
        (1.., _) => (sform(header, &mut notices)?, "sform", true),
        (_, 1..) => (qform(header)?, "qform", true),
        _ => {
            let (matrix, said) = by_pixdim(header, &mut notices);
            (matrix, "pixdim", said)
        }
    };
    let mut scaled = matrix * unit_mm;
    scaled[(3, 3)] = 1.0;
    let frame = VolumeFrame::from_ras(size, &scaled).map_err(|error| ReadImageError::InField {
        field,
        reason: error.to_string(),
    })?;
    if field == "sform" && header.qform_code > 0 {
        notices.extend(other_place(header, unit_mm, &frame));
    }
    let along_the_world = is_signed_permutation(&scaled.fixed_view::<3, 3>(0, 0).into_owned());
    let unit_steps = frame
        .spacing()
        .iter()
        .all(|step| (step - 1.0).abs() < ROUNDING);
    if !unit_known && unit_steps && along_the_world {
        all_said = false;
        notices.push(Notice::warning(
            "steps of 1 in all directions without a unit: the distances between voxels are unknown, 1 mm stands for them",
        ));
    } else if !unit_known {
        notices.push(Notice::info("no unit of length: millimetres assumed"));
    }
    let at_origin = (0..3).all(|row| scaled[(row, 3)] == 0.0);
    let position_known = field != "pixdim" && !(along_the_world && at_origin);
    if !position_known {
        notices.push(Notice::info(
            "position and orientation in the patient are not in the file",
        ));
    }
    Ok(Placement {
        frame,
        spacing: match (all_said, unit_known) {
            (false, _) => Provenance::Missing,
            (true, false) => Provenance::UnitAssumed,
            (true, true) => Provenance::Stated,
        },
        position_known,
        notices,
    })
}

/// The affine matrix of the rows, unless its steps are of length 1 and those of pixdim are not: then some program wrote
/// directions for steps, as in the files of the ACDC challenge.
fn sform(header: &NiftiHeader, notices: &mut Vec<Notice>) -> Result<Matrix4<f64>, ReadImageError> {
    let mut matrix = Matrix4::identity();
    for (row, numbers) in header.srow.iter().enumerate() {
        for (column, number) in numbers.iter().enumerate() {
            matrix[(row, column)] = *number;
        }
    }
    let steps = [0, 1, 2].map(|axis| matrix.column(axis).norm());
    let Some(pixdim) = positive_steps(header) else {
        return Ok(matrix);
    };
    let differ = |a: f64, b: f64| (a - b).abs() > SPACING_DIFFERS * a.abs().max(b.abs());
    if !steps.iter().zip(&pixdim).any(|(a, b)| differ(*a, *b)) {
        return Ok(matrix);
    }
    if steps.iter().all(|step| (step - 1.0).abs() < ROUNDING) {
        notices.push(Notice::warning(format!(
            "the sform holds directions without steps: distances between voxels are those of pixdim, {}",
            as_product(pixdim)
        )));
        for (axis, step) in pixdim.iter().enumerate() {
            for row in 0..3 {
                matrix[(row, axis)] *= step;
            }
        }
    } else {
        notices.push(Notice::warning(format!(
            "distances between voxels are {} by the sform, which is used, and {} by pixdim",
            as_product(steps),
            as_product(pixdim)
        )));
    }
    Ok(matrix)
}

/// The affine matrix of the quaternion (nifti1.h, method 2): R diag(pixdim₁, pixdim₂, qfac · pixdim₃), with
/// a = √(1 − b² − c² − d²).
fn qform(header: &NiftiHeader) -> Result<Matrix4<f64>, ReadImageError> {
    /// Numbers of 32 bits leave the sum of squares this close to 1.
    const SUM_OF_SQUARES: f64 = 1.0 + 1e-3;
    let wrong = |reason: &str| ReadImageError::InField {
        field: "qform",
        reason: reason.to_owned(),
    };
    let [b, c, d] = header.quaternion;
    let squares = b * b + c * c + d * d;
    if squares.is_nan() || squares > SUM_OF_SQUARES {
        return Err(wrong("its quaternion is no rotation"));
    }
    let a = (1.0 - squares).max(0.0).sqrt();
    let length = (a * a + squares).sqrt();
    let [a, b, c, d] = [a, b, c, d].map(|x| x / length);
    #[rustfmt::skip]
    let rotation = Matrix3::new(
        a * a + b * b - c * c - d * d, 2.0 * (b * c - a * d), 2.0 * (b * d + a * c),
        2.0 * (b * c + a * d), a * a + c * c - b * b - d * d, 2.0 * (c * d - a * b),
        2.0 * (b * d - a * c), 2.0 * (c * d + a * b), a * a + d * d - b * b - c * c,
    );
    let qfac = if header.pixdim[0] < 0.0 { -1.0 } else { 1.0 };
    let mut matrix = Matrix4::identity();
    for axis in 0..3 {
        let step = header.pixdim[axis + 1].abs() * if axis == 2 { qfac } else { 1.0 };
        for row in 0..3 {
            matrix[(row, axis)] = rotation[(row, axis)] * step;
        }
        matrix[(axis, 3)] = header.qoffset[axis];
    }
    Ok(matrix)
}

/// Steps along the axes of the grid (nifti1.h, method 1), and whether all of them are said.
fn by_pixdim(header: &NiftiHeader, notices: &mut Vec<Notice>) -> (Matrix4<f64>, bool) {
    let mut matrix = Matrix4::identity();
    let mut all_said = true;
    for axis in 0..3 {
        let step = header.pixdim[axis + 1].abs();
        if axis < header.sizes.len() && step.is_finite() && step > 0.0 {
            matrix[(axis, axis)] = step;
        } else {
            all_said = false;
        }
    }
    if !all_said {
        notices.push(Notice::warning(
            "some distances between voxels are unknown: 1 mm stands for them",
        ));
    }
    (matrix, all_said)
}

/// pixdim, if all of it can be distances.
fn positive_steps(header: &NiftiHeader) -> Option<[f64; 3]> {
    let steps = [1, 2, 3].map(|axis| header.pixdim[axis].abs());
    let can_be = |step: &f64| step.is_finite() && *step > 0.0;
    steps.iter().all(can_be).then_some(steps)
}

/// Says how far the qform places the grid from where the sform does.
fn other_place(header: &NiftiHeader, unit_mm: f64, frame: &VolumeFrame) -> Option<Notice> {
    let mut matrix = qform(header).ok()? * unit_mm;
    matrix[(3, 3)] = 1.0;
    let size = frame.size();
    let other = VolumeFrame::from_ras(size, &matrix).ok()?;
    let farthest = (0..8)
        .map(|corner: usize| {
            let place = |axis: usize| ((corner >> axis) & 1) as f64 * (size[axis] - 1) as f64;
            let corner = Vector3::new(place(0), place(1), place(2)).into();
            (frame.position(corner) - other.position(corner)).norm()
        })
        .fold(0.0, f64::max);
    (farthest > PLACES_DIFFER_MM).then(|| {
        Notice::info(format!(
            "the qform places corners up to {farthest:.1} mm from where the sform does, which is used"
        ))
    })
}

/// Whether each column has one number that is not 0, each in its own row.
fn is_signed_permutation(matrix: &Matrix3<f64>) -> bool {
    let full = |line: &[f64]| line.iter().filter(|x| **x != 0.0).count() == 1;
    (0..3).all(|k| {
        let (row, column) = (matrix.row(k), matrix.column(k));
        full(&[row[0], row[1], row[2]]) && full(&[column[0], column[1], column[2]])
    })
}

fn as_product(steps: [f64; 3]) -> String {
    let [i, j, k] = steps.map(|step| (step * 1e4).round() / 1e4);
    format!("{i} × {j} × {k}")
}

//! The direction from which a patch is seen best.

use glam::{DVec3, Mat3, Quat, Vec3};

use crate::analysis::thickening::Patch;
use crate::analysis::verdicts::SubjectThickening;
use crate::mesh::Vector3;
use crate::picture::axes::SubjectAxes;

/// Normals of a patch that is all around leave less than this of themselves in their mean.
const MIN_DIRECTION: f64 = 0.2;

/// Rotation of a camera that looks straight at a patch, base up; a patch all around has no direction of its own and is
/// seen from the front.
pub fn facing_patch(wall: &SubjectThickening, patch: &Patch, axes: &SubjectAxes) -> Option<Quat> {
    let rest = wall.beat.frames.get(wall.thickening.end_diastole)?;
    let normal: Vector3 = (patch.atoms.iter())
        .filter_map(|&atom| rest.normals.get(atom as usize))
        .sum();
    let towards = if normal.norm() > MIN_DIRECTION * patch.atoms.len() as f64 {
        normal
    } else {
        axes.front
    };
    let [towards, up, front] =
        [towards, axes.up, axes.front].map(|v| DVec3::new(v.x, v.y, v.z).as_vec3());
    Some(facing(towards, up, front))
}

/// Rotation whose z axis is `towards` and whose y axis is as near to `up` as can be.
fn facing(towards: Vec3, up: Vec3, other: Vec3) -> Quat {
    let z = towards.normalize_or_zero();
    let up = if up.dot(z).abs() > 0.95 { other } else { up };
    let x = up.cross(z).normalize_or_zero();
    let y = z.cross(x);
    Quat::from_mat3(&Mat3::from_cols(x, y, z)).normalize()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_camera_faces_what_it_looks_at_with_the_base_up() {
        let towards = Vec3::new(0.6, 0.1, 0.7).normalize();
        for towards in [towards, Vec3::Z] {
            let turn = facing(towards, Vec3::Z, Vec3::X);
            assert!((turn * Vec3::Z - towards).length() < 1e-6);
        }
        let turn = facing(towards, Vec3::Z, Vec3::X);
        assert!((turn * Vec3::Y).z > 0.0);
        assert!((turn * Vec3::X).z.abs() < 1e-6);
    }
}

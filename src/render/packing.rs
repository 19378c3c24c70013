//! Arrays of a geometry as texels: positions with packed normals, numbers, colours.

use glam::{Vec2, Vec3};

use super::{Geometry, VertexScalars};

/// A unit normal as two signed 16-bit numbers: the octahedron |x| + |y| + |z| = 1 unfolded onto a square.
///
/// Source: Cigolle et al. (2014), JCGT 3(2), section 3.2 ("oct"); the error is below 0.01°.
fn packed_normal(normal: Vec3) -> u32 {
    let n = normal / (normal.x.abs() + normal.y.abs() + normal.z.abs()).max(1e-20);
    let sign = |x: f32| if x >= 0.0 { 1.0 } else { -1.0 };
    let e = if n.z >= 0.0 {
        Vec2::new(n.x, n.y)
    } else {
        Vec2::new((1.0 - n.y.abs()) * sign(n.x), (1.0 - n.x.abs()) * sign(n.y))
    };
    let part = |x: f32| u32::from((x.clamp(-1.0, 1.0) * 32767.0).round() as i16 as u16);
    part(e.x) | part(e.y) << 16
}

/// Normals from positions where a geometry brings none of the right shape.
fn normals_of(positions: &[[f32; 3]], triangles: &[[u32; 3]]) -> Vec<[f32; 3]> {
    let mut sums = vec![Vec3::ZERO; positions.len()];
    for triangle in triangles {
        let [a, b, c] = triangle.map(|i| Vec3::from(positions[i as usize]));
        let area = (b - a).cross(c - a);
        for &i in triangle {
            sums[i as usize] += area;
        }
    }
    sums.into_iter()
        .map(|sum| sum.normalize_or(Vec3::Z).into())
        .collect()
}

/// The triangles whose corners exist.
pub(super) fn sound_triangles(geometry: &Geometry) -> Vec<[u32; 3]> {
    let count = vertex_count(geometry);
    geometry
        .triangles
        .iter()
        .copied()
        .filter(|triangle| triangle.iter().all(|&i| (i as usize) < count))
        .collect()
}

/// Edges of one triangle only, where an open surface ends; in a fixed order.
pub(super) fn rim_edges(triangles: &[[u32; 3]]) -> Vec<[u32; 2]> {
    let mut edges: Vec<[u32; 2]> = triangles
        .iter()
        .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
        .map(|[a, b]| [a.min(b), a.max(b)])
        .collect();
    edges.sort_unstable();
    edges
        .chunk_by(|a, b| a == b)
        .filter(|same| same.len() == 1 && same[0][0] != same[0][1])
        .map(|same| same[0])
        .collect()
}

/// Vertices that every pose has.
pub(super) fn vertex_count(geometry: &Geometry) -> usize {
    geometry.positions.iter().map(Vec::len).min().unwrap_or(0)
}

/// One texel a vertex and pose, pose after pose: three coordinates as bits and the packed normal.
pub(super) fn shape_texels(geometry: &Geometry, triangles: &[[u32; 3]]) -> Vec<[u32; 4]> {
    let count = vertex_count(geometry);
    let mut texels = Vec::with_capacity(count * geometry.positions.len());
    for (pose, positions) in geometry.positions.iter().enumerate() {
        let positions = &positions[..count];
        let made;
        let normals = match geometry.normals.get(pose) {
            Some(normals) if normals.len() >= count => normals,
            _ => {
                made = normals_of(positions, triangles);
                &made
            }
        };
        texels.extend(positions.iter().zip(normals).map(|(p, &n)| {
            let [x, y, z] = p.map(f32::to_bits);
            [x, y, z, packed_normal(n.into())]
        }));
    }
    texels
}

/// One texel a vertex and pose: the bits of a number. Vertices without one get NaN.
pub(super) fn scalar_texels(scalars: &VertexScalars) -> (Vec<u32>, usize) {
    let count = scalars.values.iter().map(Vec::len).max().unwrap_or(0);
    let mut texels = Vec::with_capacity(count * scalars.values.len());
    for values in &scalars.values {
        texels.extend(values.iter().map(|value| value.to_bits()));
        texels.resize(texels.len() + count - values.len(), f32::NAN.to_bits());
    }
    (texels, count)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn unpacked(packed: u32) -> Vec3 {
        let part = |bits: u32| f32::from(bits as u16 as i16) / 32767.0;
        let (x, y) = (part(packed), part(packed >> 16));
        let z = 1.0 - x.abs() - y.abs();
        let fold = (-z).max(0.0);
        let undo = |x: f32| x + if x >= 0.0 { -fold } else { fold };
        Vec3::new(undo(x), undo(y), z).normalize()
    }

    #[test]
    fn a_packed_normal_is_off_by_less_than_a_hundredth_of_a_degree() {
        for i in 0..2000 {
            let z = 1.0 - 2.0 * (i as f32 + 0.5) / 2000.0;
            let angle = i as f32 * 2.399_963;
            let r = (1.0 - z * z).sqrt();
            let n = Vec3::new(r * angle.cos(), r * angle.sin(), z);
            assert!((unpacked(packed_normal(n)) - n).length() < 1.7e-4);
        }
    }

    #[test]
    fn missing_normals_are_made_and_triangles_without_corners_left_out() {
        let geometry = Geometry {
            triangles: vec![[0, 1, 2], [0, 1, 9]],
            positions: vec![vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]],
            normals: vec![],
        };
        let triangles = sound_triangles(&geometry);
        assert_eq!(triangles, [[0, 1, 2]]);
        let texels = shape_texels(&geometry, &triangles);
        assert_eq!(texels.len(), 3);
        assert!((unpacked(texels[0][3]) - Vec3::Z).length() < 1e-4);
    }

    #[test]
    fn the_rim_of_two_triangles_is_their_outline() {
        assert_eq!(
            rim_edges(&[[0, 1, 2], [2, 1, 3]]),
            [[0, 1], [0, 2], [1, 3], [2, 3]]
        );
        assert!(rim_edges(&[[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]]).is_empty());
    }

    #[test]
    fn vertices_without_a_number_are_not_a_number() {
        let scalars = VertexScalars {
            values: vec![vec![1.0, 2.0], vec![3.0]],
        };
        let (texels, count) = scalar_texels(&scalars);
        assert_eq!(count, 2);
        assert!(f32::from_bits(texels[3]).is_nan());
        assert_eq!(f32::from_bits(texels[2]), 3.0);
    }
}

//! Files written by hand, for what other programs seldom write.

use super::read;
use crate::io::Limits;
use crate::mesh::Point3;
use crate::study::Notice;

#[test]
fn obj_indices_count_from_either_end_and_lines_continue() {
    let text = "# a heart\r\nv 0 0 0 1 0 0\r\nv 1 0 \\\r\n0\r\nv 1 1 0\nvn 0 0 1\nv 0 1 0\n\
                f 1//1 2//1 3//1 # first\nf -4 -2 -1\n";
    let file = read("a.obj", text);
    assert_eq!(file.frames[0].triangles(), [[0, 1, 2], [0, 2, 3]]);
    assert_eq!(file.frames[0].vertices()[1], Point3::new(1.0, 0.0, 0.0));
    assert_eq!(file.notices, []);
}

#[test]
fn nothing_is_reshaped_without_a_notice() {
    let text =
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 9 9 9\nf 1 2 3 4\nf 1 1 2\nf 2 3 3\nf 1 2\nl 1 2\n";
    let file = read("a.obj", text);
    assert_eq!(file.frames[0].triangles(), [[0, 1, 2], [0, 2, 3]]);
    assert_eq!(
        file.frames[0].vertices().len(),
        5,
        "unused vertices keep their numbers"
    );
    assert_eq!(
        file.notices,
        [
            Notice::warning("2 triangles with a repeated corner removed"),
            Notice::warning("1 face with fewer than three corners ignored"),
            Notice::info("1 polygon triangulated as a fan from the first corner"),
            Notice::info("1 point or line beside the faces ignored"),
            Notice::info("1 vertex used by no face (kept)"),
        ]
    );
}

/// Vertices with a list and a colour among the coordinates, an unknown element, and faces that
/// stand before the vertices and have a list more.
#[test]
fn ply_lists_and_elements_of_no_interest_are_passed_over() {
    let header = |format: &str| {
        format!(
            "ply\r\nformat {format} 1.0\r\ncomment by hand\r\nelement face 2\r\n\
             property uchar flags\r\nproperty list ushort double texcoord\r\n\
             property list uchar short vertex_index\r\nelement patch 1\r\n\
             property list int float weights\r\nelement vertex 3\r\nproperty double z\r\n\
             property list uchar int neighbours\r\nproperty short x\r\nproperty float y\r\n\
             end_header\r\n"
        )
    };
    let text = header("ascii")
        + "1 2 0.5 0.5 3 0 1 2\n0 0 3 2 1 0\n2 1.5 2.5\n0.1 2 5 6 -7 0.5\n0 0 1 0\n0 1 9 0 1\n";
    let expected = read("a.ply", text);
    assert_eq!(expected.frames[0].triangles(), [[0, 1, 2], [2, 1, 0]]);
    assert_eq!(
        expected.frames[0].vertices()[0],
        Point3::new(-7.0, 0.5, 0.1)
    );
    for big in [false, true] {
        let mut bytes = header(if big {
            "binary_big_endian"
        } else {
            "binary_little_endian"
        })
        .into_bytes();
        let mut put = |little: &[u8]| {
            let mut number = little.to_vec();
            if big {
                number.reverse();
            }
            bytes.extend(number);
        };
        for (flags, texture, corners) in [(1, &[0.5, 0.5][..], [0, 1, 2]), (0, &[], [2, 1, 0])] {
            put(&[flags]);
            put(&(texture.len() as u16).to_le_bytes());
            texture.iter().for_each(|x: &f64| put(&x.to_le_bytes()));
            put(&[3]);
            corners.iter().for_each(|v: &i16| put(&v.to_le_bytes()));
        }
        put(&2_i32.to_le_bytes());
        [1.5_f32, 2.5].iter().for_each(|x| put(&x.to_le_bytes()));
        let vertices = [
            (0.1, &[5, 6][..], -7, 0.5),
            (0.0, &[], 1, 0.0),
            (0.0, &[9], 0, 1.0),
        ];
        for (z, neighbours, x, y) in vertices {
            put(&f64::to_le_bytes(z));
            put(&[neighbours.len() as u8]);
            neighbours.iter().for_each(|v: &i32| put(&v.to_le_bytes()));
            put(&i16::to_le_bytes(x));
            put(&f32::to_le_bytes(y));
        }
        assert_eq!(read("a.ply", bytes), expected, "big-endian: {big}");
    }
}

#[test]
fn stl_corners_weld_in_order_of_first_occurrence_even_across_signed_zeros() {
    let facet = |corners: &str| {
        format!("facet normal nan nan nan\nouter loop\n{corners}endloop\nendfacet\n")
    };
    let text = format!(
        "SOLID heart\n{}{}endsolid\n",
        facet("vertex 5 0 0\nvertex 0 1 0\nvertex 0 0 1\n"),
        facet("vertex 0 0 1\nvertex -0 1 -0\nvertex 2 2 2\n"),
    )
    .replace("SOLID", "solid");
    let file = read("a.stl", text);
    assert_eq!(file.frames[0].triangles(), [[0, 1, 2], [2, 1, 3]]);
    assert_eq!(file.frames[0].vertices()[3], Point3::new(2.0, 2.0, 2.0));
}

#[test]
fn content_decides_where_the_ending_is_wrong() {
    let ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty int x\nproperty int y\n\
               property int z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n\
               0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    let file = read("heart.OBJ", ply);
    assert_eq!(
        file.notices,
        [Notice::info(
            "read as PLY by its content, despite its file name extension"
        )]
    );
    assert_eq!(read("heart", ply).notices, []);
}

#[test]
fn a_mirroring_node_keeps_the_outer_side_outside() {
    let positions: Vec<u8> = [[0.0_f32, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]
        .iter()
        .flatten()
        .flat_map(|x| x.to_le_bytes())
        .collect();
    let bin = positions.len();
    let json = |scale: &str| {
        format!(
            r#"{{"asset":{{"version":"2.0"}},"nodes":[{{"mesh":0,"scale":{scale}}}],
            "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}}}}]}}],
            "accessors":[{{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3",
            "min":[0,0,0],"max":[1,1,0]}}],"bufferViews":[{{"buffer":0,"byteLength":{bin}}}],
            "buffers":[{{"byteLength":{bin},"uri":"three.bin"}}]}}"#
        )
    };
    let triangles = |scale: &str| {
        let beside = |name: &str| (name == "three.bin").then(|| positions.clone());
        let text = json(scale);
        let file = crate::io::read_mesh_with_siblings(
            "a.gltf",
            text.as_bytes(),
            &Limits::default(),
            &beside,
        );
        file.unwrap().frames[0].triangles().to_vec()
    };
    assert_eq!(triangles("[1,1,1]"), [[0, 1, 2]]);
    assert_eq!(triangles("[-1,1,1]"), [[0, 2, 1]]);
}

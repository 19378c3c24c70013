//! glTF files made of parts: what the specification allows and programs seldom write.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde_json::{Value, json};

use crate::io::{Limits, MeshFile, ReadMeshError, read_mesh, read_mesh_with_siblings};
use crate::mesh::Point3;

const SQUARE: [[f32; 3]; 4] = [
    [0.0, 0.0, 0.0],
    [1.0, 0.0, 0.0],
    [1.0, 1.0, 0.0],
    [0.0, 1.0, 0.0],
];

fn floats(values: &[[f32; 3]]) -> Vec<u8> {
    values
        .iter()
        .flatten()
        .flat_map(|x| x.to_le_bytes())
        .collect()
}

/// A file with one mesh at one node, whose buffer is `bytes`; each accessor has a view of its own from the given byte on.
fn document(bytes: &[u8], accessors: &[(usize, Value)], primitives: &Value) -> Value {
    let views: Vec<Value> = accessors
        .iter()
        .map(|(start, _)| json!({"buffer": 0, "byteOffset": start, "byteLength": bytes.len() - start}))
        .collect();
    let accessors: Vec<Value> = accessors
        .iter()
        .enumerate()
        .map(|(view, (_, accessor))| {
            let mut accessor = accessor.clone();
            accessor["bufferView"] = json!(view);
            accessor
        })
        .collect();
    json!({
        "asset": {"version": "2.0"},
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": primitives}],
        "accessors": accessors,
        "bufferViews": views,
        "buffers": [{"byteLength": bytes.len(), "uri": format!("data:,{}", percent(bytes))}],
    })
}

fn percent(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("%{byte:02x}")).collect()
}

fn vec3(kind: u32, count: usize) -> Value {
    json!({"componentType": kind, "count": count, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 1]})
}

fn scalar(kind: u32, count: usize) -> Value {
    json!({"componentType": kind, "count": count, "type": "SCALAR"})
}

const FLOAT: u32 = 5126;
const U8: u32 = 5121;
const I16: u32 = 5122;

fn open(document: &Value) -> Result<MeshFile, ReadMeshError> {
    read_mesh(
        "a.gltf",
        document.to_string().as_bytes(),
        &Limits::default(),
    )
}

/// A square of four points and the indices `corners`, and what its primitive says beside these.
fn square(corners: &[u8], mode: u32) -> Value {
    let bytes = [floats(&SQUARE), corners.to_vec()].concat();
    document(
        &bytes,
        &[(0, vec3(FLOAT, 4)), (48, scalar(U8, corners.len()))],
        &json!([{"attributes": {"POSITION": 0}, "indices": 1, "mode": mode}]),
    )
}

#[test]
fn strips_and_fans_are_the_triangles_of_the_specification() {
    for (corners, mode, expected) in [
        (&[0, 1, 2, 0, 2, 3][..], 4, &[[0, 1, 2], [0, 2, 3]][..]),
        (&[0, 1, 3, 2], 5, &[[0, 1, 3], [1, 2, 3]]),
        (&[0, 1, 2, 3], 6, &[[0, 1, 2], [0, 2, 3]]),
    ] {
        let triangles = open(&square(corners, mode)).unwrap().frames[0]
            .triangles()
            .to_vec();
        let turned = |&[a, b, c]: &[u32; 3]| {
            let mut turns = [[a, b, c], [b, c, a], [c, a, b]];
            turns.sort_unstable();
            turns[0]
        };
        let canonical = |all: &[[u32; 3]]| all.iter().map(turned).collect::<Vec<_>>();
        assert_eq!(canonical(&triangles), canonical(expected), "mode {mode}");
    }
    let odd = open(&square(&[0, 1, 2, 3], 4)).unwrap_err().to_string();
    assert!(
        odd.contains("4 corners are not a multiple of three"),
        "{odd}"
    );
}

#[test]
fn primitives_that_share_their_points_share_vertices_and_others_are_joined() {
    let mut shared = square(&[0, 1, 2, 0, 2, 3], 4);
    shared["meshes"][0]["primitives"] = json!([
        {"attributes": {"POSITION": 0}, "indices": 1},
        {"attributes": {"POSITION": 0}, "indices": 1, "mode": 5},
        {"attributes": {"POSITION": 0}, "mode": 0},
    ]);
    let file = open(&shared).unwrap();
    assert_eq!(file.frames[0].vertices().len(), 4);
    assert_eq!(file.frames[0].triangles()[..2], [[0, 1, 2], [0, 2, 3]]);
    let mut apart = square(&[0, 1, 2], 4);
    let again = apart["accessors"][0].clone();
    apart["accessors"].as_array_mut().unwrap().push(again);
    apart["meshes"][0]["primitives"] = json!([
        {"attributes": {"POSITION": 0}, "indices": 1},
        {"attributes": {"POSITION": 2}, "indices": 1},
    ]);
    assert_eq!(
        open(&apart).unwrap().frames[0].triangles(),
        [[0, 1, 2], [4, 5, 6]]
    );
}

#[test]
fn accessors_without_a_view_are_zeros_and_sparse_ones_change_a_few() {
    let bytes = [
        floats(&SQUARE),
        vec![2, 0, 0, 0],
        floats(&[[5.0, 6.0, 7.0]]),
    ]
    .concat();
    let mut file = document(
        &bytes,
        &[
            (0, vec3(FLOAT, 4)),
            (48, scalar(U8, 1)),
            (52, vec3(FLOAT, 1)),
        ],
        &json!([{
            "attributes": {"POSITION": 0}, "mode": 6, "targets": [{"POSITION": 3}, {"POSITION": 4}, {}],
        }]),
    );
    let accessors = file["accessors"].as_array_mut().unwrap();
    accessors.push(json!({"componentType": FLOAT, "count": 4, "type": "VEC3"}));
    accessors.push(json!({
        "componentType": FLOAT, "count": 4, "type": "VEC3",
        "sparse": {
            "count": 1,
            "indices": {"bufferView": 1, "componentType": U8},
            "values": {"bufferView": 2},
        },
    }));
    let frames = open(&file).unwrap().frames;
    assert_eq!(frames.len(), 4);
    assert_eq!(frames[1], frames[0]);
    assert_eq!(frames[3], frames[0]);
    assert_eq!(frames[2].vertices()[2], Point3::new(6.0, 7.0, 7.0));
    assert_eq!(frames[2].vertices()[3], frames[0].vertices()[3]);
    // the same in an accessor with a view
    file["accessors"][4]["bufferView"] = json!(0);
    let moved = open(&file).unwrap().frames[2].clone();
    assert_eq!(moved.vertices()[1], Point3::new(2.0, 0.0, 0.0));
    assert_eq!(moved.vertices()[2], Point3::new(6.0, 7.0, 7.0));
    // the base of zeros, where each target is a whole pose
    let mut base = file.clone();
    base["accessors"][0] = base["accessors"][3].clone();
    base["extensionsUsed"] = json!(["KHR_draco_mesh_compression"]);
    let error = open(&base).unwrap_err().to_string();
    assert!(
        error.contains("KHR_draco_mesh_compression is not read"),
        "{error}"
    );
}

#[test]
fn positions_may_lie_apart_and_be_whole_numbers() {
    // 12 bytes of a normal after each position
    let apart: Vec<[f32; 3]> = SQUARE.iter().flat_map(|&point| [point, [9.0; 3]]).collect();
    let mut strided = document(
        &floats(&apart),
        &[(0, vec3(FLOAT, 4))],
        &json!([{"attributes": {"POSITION": 0}, "mode": 6}]),
    );
    strided["bufferViews"][0]["byteStride"] = json!(24);
    let expected = open(&square(&[0, 1, 2, 3], 6)).unwrap();
    assert_eq!(open(&strided).unwrap(), expected);
    let shorts: Vec<u8> = SQUARE
        .iter()
        .flat_map(|&[x, y, z]| [x, y, z, 0.0].map(|x| (x * 32_767.0) as i16))
        .flat_map(i16::to_le_bytes)
        .collect();
    let mut quantised = document(
        &shorts,
        &[(0, vec3(I16, 4))],
        &json!([{"attributes": {"POSITION": 0}, "mode": 6}]),
    );
    quantised["bufferViews"][0]["byteStride"] = json!(8);
    quantised["extensionsUsed"] = json!(["KHR_mesh_quantization"]);
    quantised["extensionsRequired"] = json!(["KHR_mesh_quantization"]);
    let whole = open(&quantised).unwrap();
    assert_eq!(
        whole.frames[0].vertices()[2],
        Point3::new(32_767.0, 32_767.0, 0.0)
    );
    quantised["accessors"][0]["normalized"] = json!(true);
    assert_eq!(open(&quantised).unwrap(), expected);
    let extents = quantised["accessors"][0].as_object_mut().unwrap();
    extents.remove("min");
    extents.remove("max");
    assert_eq!(open(&quantised).unwrap(), expected);
    quantised["extensionsRequired"] = json!(["KHR_draco_mesh_compression"]);
    let error = open(&quantised).unwrap_err().to_string();
    assert!(
        error.contains("KHR_draco_mesh_compression is not read"),
        "{error}"
    );
}

#[test]
fn files_beside_are_found_by_every_spelling_and_read_once() {
    let bytes = [floats(&SQUARE), vec![0, 1, 2]].concat();
    let expected = open(&square(&[0, 1, 2], 4)).unwrap();
    for (uri, name) in [
        ("beat.bin", "beat.bin"),
        ("./beat.bin", "beat.bin"),
        ("././beat.bin", "beat.bin"),
        ("data/beat%201.bin", "data/beat 1.bin"),
        ("data\\beat.bin", "data/beat.bin"),
        ("beat%201.bin", "beat%201.bin"),
    ] {
        let mut file = square(&[0, 1, 2], 4);
        file["buffers"][0]["uri"] = json!(uri);
        let asked = std::cell::Cell::new(0);
        let beside = |other: &str| {
            asked.set(asked.get() + usize::from(other == name));
            (other == name).then(|| bytes.clone())
        };
        let many = vec![file["buffers"][0].clone(); 1_000];
        file["buffers"] = json!(many);
        let text = file.to_string();
        let found = read_mesh_with_siblings("a.gltf", text.as_bytes(), &Limits::default(), &beside);
        assert_eq!(found.unwrap(), expected, "{uri}");
        assert_eq!(asked.get(), 1, "{uri}");
    }
    let mut file = square(&[0, 1, 2], 4);
    for kind in [
        "",
        "application/octet-stream",
        "application/gltf-buffer",
        "text/plain;charset=utf-8",
    ] {
        file["buffers"][0]["uri"] =
            json!(format!("data:{kind};base64,{}", STANDARD.encode(&bytes)));
        assert_eq!(open(&file).unwrap(), expected, "{kind}");
    }
}

/// A binary file of chunks, each filled up to four bytes by its own byte.
fn glb(chunks: &[(&[u8; 4], Vec<u8>, u8)]) -> Vec<u8> {
    let mut bytes = b"glTF\x02\0\0\0\0\0\0\0".to_vec();
    for (kind, content, fill) in chunks {
        let padded = content.len().next_multiple_of(4);
        bytes.extend((padded as u32).to_le_bytes());
        bytes.extend(*kind);
        bytes.extend(content);
        bytes.resize(bytes.len() + padded - content.len(), *fill);
    }
    let length = bytes.len() as u32;
    bytes[8..12].copy_from_slice(&length.to_le_bytes());
    bytes
}

#[test]
fn chunks_may_be_padded_unknown_and_followed_by_bytes() {
    let mut file = square(&[0, 1, 2], 4);
    let bytes = [floats(&SQUARE), vec![0, 1, 2]].concat();
    let expected = open(&file).unwrap();
    file["buffers"][0].as_object_mut().unwrap().remove("uri");
    for extra in 0..4 {
        let json = file.to_string() + &" ".repeat(extra);
        let json = json.into_bytes();
        for (chunks, behind) in [
            (
                vec![(b"JSON", json.clone(), b' '), (b"BIN\0", bytes.clone(), 0)],
                0,
            ),
            (
                vec![(b"JSON", json.clone(), 0), (b"BIN\0", bytes.clone(), 7)],
                5,
            ),
            (
                vec![
                    (b"JSON", json.clone(), b' '),
                    (b"MORE", vec![1, 2, 3, 4, 5], 0),
                    (b"BIN\0", bytes.clone(), 0),
                    (b"LAST", vec![9], 0),
                ],
                3,
            ),
        ] {
            let mut whole = glb(&chunks);
            whole.resize(whole.len() + behind, 0xff);
            let mut read = read_mesh("a.glb", &whole, &Limits::default()).unwrap();
            if behind > 0 {
                let notice = read.notices.remove(0);
                assert!(
                    notice.text.starts_with(&format!("{behind} bytes behind")),
                    "{notice:?}"
                );
            }
            assert_eq!(read, expected);
        }
    }
}

#[test]
fn nodes_within_nodes_move_turn_and_scale() {
    let mut file = square(&[0, 1, 2], 4);
    file["nodes"] = json!([
        {"children": [1], "translation": [10, 0, 0]},
        {"children": [2], "rotation": [0, 0, 0.5_f64.sqrt(), 0.5_f64.sqrt()]},
        {"mesh": 0, "matrix": [2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 1, 1]},
    ]);
    let points = open(&file).unwrap().frames[0].vertices().to_vec();
    assert!(
        (points[1] - Point3::new(10.0, 2.0, 1.0)).norm() < 1e-6,
        "{}",
        points[1]
    );
    assert!(
        (points[3] - Point3::new(8.0, 0.0, 1.0)).norm() < 1e-6,
        "{}",
        points[3]
    );
    file["nodes"][0]["translation"] = json!([1e39, 0, 0]);
    assert!(open(&file).is_err());
}

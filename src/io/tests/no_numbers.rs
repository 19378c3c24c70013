//! What is no number is an error with its place in every format, never another number.

use super::{TRIANGLES, error, read, triangle};

#[test]
fn words_that_are_no_number_are_refused_with_their_line_in_every_text_format() {
    let words = [
        "nan",
        "NaN",
        "-nan",
        "nan(ind)",
        "-nan(ind)",
        "inf",
        "-inf",
        "Infinity",
        "1.#INF",
        "-1.#INF00",
        "-1.#IND",
        "-1.#IND00",
        "1.#QNAN",
        "1.#QNAN0",
        "1.#SNAN",
        "1e999",
        "-1e999",
        "1.0D+00",
        "1d0",
        "****",
        "1,5",
        "0x1p0",
        "1.0f",
        "1mm",
        "1e",
        "1_0",
        "#N/A",
        "null",
        "-",
        "\u{2212}1",
    ];
    for (name, _) in TRIANGLES {
        for word in words {
            if name == "a.csv" && word.contains(',') || name == "a.obj" && word.starts_with('#') {
                continue; // the comma parts cells, the sign begins a comment
            }
            let (text, line) = triangle(name, word);
            let error = error(name, &text);
            assert!(
                error.starts_with(&format!("line {line}: ")),
                "{name}, {word}: {error}"
            );
        }
        let (text, _) = triangle(name, "1");
        assert_eq!(read(name, &text).frames[0].vertices()[1].x, 1.0, "{name}");
    }
}

#[test]
fn a_number_that_is_missing_is_an_error_in_every_text_format() {
    for (name, _) in TRIANGLES {
        let (text, line) = triangle(name, "");
        let error = error(name, &text);
        let lines = [line, line + 1, line + 2].map(|line| format!("line {line}: "));
        // of a VTP array only the count is wrong
        let array = error.ends_with("8 coordinates for 3 points");
        assert!(
            array || lines.iter().any(|line| error.starts_with(line)),
            "{name}: {error}"
        );
    }
    assert!(error("a.obj", "v 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").starts_with("line 1: "));
    let (csv, line) = triangle("a.csv", "");
    assert_eq!(
        error("a.csv", csv),
        format!("line {line}: \"\" is not a number")
    );
}

#[test]
fn infinite_and_missing_floats_are_refused_with_their_byte_in_every_binary_format() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures/formats");
    for (name, single, big) in [
        ("ply_vtk_binary.ply", true, false),
        ("ply_vtk_binary_big.ply", true, true),
        ("stl_vtk_binary.stl", true, false),
        ("vtk_binary_4_2.vtk", false, true),
        ("vtk_binary_5_1.vtk", false, true),
        ("vtp_appended_raw_plain_u64.vtp", false, false),
        ("glb_morph_targets.glb", true, false),
    ] {
        let bytes = std::fs::read(folder.join(name)).unwrap();
        // the first x of the fixtures
        let encoded = |x: f64| {
            let mut little = if single {
                (x as f32).to_le_bytes().to_vec()
            } else {
                x.to_le_bytes().to_vec()
            };
            if big {
                little.reverse();
            }
            little
        };
        let first_point = [1.5, 0.0, 0.0].map(encoded).concat();
        let at = bytes
            .windows(first_point.len())
            .position(|window| window == first_point);
        let at = at.unwrap_or_else(|| panic!("{name} holds no such point"));
        let size = first_point.len() / 3;
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let mut damaged = bytes.clone();
            damaged[at..at + size].copy_from_slice(&encoded(bad));
            let error = error(name, damaged);
            let placed = error.starts_with("byte ")
                || error.starts_with("meshes[0].primitives[0]: vertex 0");
            assert!(
                placed && error.ends_with("is not a finite number"),
                "{name}: {error}"
            );
        }
    }
}

#[test]
fn numbers_of_what_is_not_read_may_be_none() {
    let ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n\
               property float z\nproperty float nx\nelement face 1\n\
               property list uchar int vertex_indices\nend_header\n\
               0 0 0 -1.#IND\n1 0 0 nan\n0 1 0 inf\n3 0 1 2\n";
    assert_eq!(read("a.ply", ply).frames[0].vertices().len(), 3);
    let obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn -1.#IND nan 0\nvt 1.#QNAN 0\nf 1/1/1 2/1/1 3//1\n";
    assert_eq!(read("a.obj", obj).frames[0].triangles(), [[0, 1, 2]]);
    let (stl, _) = triangle("a.stl", "1");
    read(
        "a.stl",
        stl.replace("0 0 1\n", "-1.#IND -nan(ind) 1.#QNAN\n"),
    );
}

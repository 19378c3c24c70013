//! Files as programs write them that take a format's description lightly, each read as it is meant.

use super::{TRIANGLES, error, read, triangle};

#[test]
fn keywords_remarks_and_numbers_of_obj_are_taken_as_meant() {
    let (text, _) = triangle("a.obj", "1");
    let expected = read("a.obj", &text);
    for other in [
        text.to_uppercase(),
        format!("% made by a script\n// so\n; and so\n{text}"),
        text.replace("f 1 2 3", "f 1.0 2.0 3.000000e+00"),
        format!("{text}\x1a"),
        format!("{text}\x1a\r\n"),
    ] {
        assert_eq!(read("a.obj", &other), expected, "{other}");
    }
    assert!(error("a.obj", text.replace("f 1 2 3", "f 1 2 2.5")).contains("not a whole number"));
}

#[test]
fn colours_and_padding_of_ascii_stl_are_passed_over() {
    let (text, _) = triangle("a.stl", "1");
    let expected = read("a.stl", &text);
    for other in [
        text.replacen('\n', "\n color 0.5 0.5 0.5\n", 1),
        format!("{text}\0\0\0\0"),
        format!("{text}\x1a"),
    ] {
        assert_eq!(read("a.stl", &other), expected, "{other}");
    }
}

#[test]
fn a_binary_stl_whose_count_was_never_filled_in_is_read_to_its_end_and_told() {
    let corner = |x: f32, y: f32| [x, y, 0.0].map(f32::to_le_bytes).concat();
    let triangle = [
        vec![0; 12],
        corner(0.0, 0.0),
        corner(1.0, 0.0),
        corner(0.0, 1.0),
        vec![0; 2],
    ];
    for count in [0, u32::MAX] {
        let mut bytes = [vec![b' '; 80], count.to_le_bytes().to_vec()].concat();
        bytes.extend(triangle.concat());
        let file = read("a.stl", &bytes);
        assert_eq!(file.frames[0].triangles(), [[0, 1, 2]]);
        assert!(
            file.notices
                .iter()
                .any(|notice| notice.text.contains("all 1 are read"))
        );
        bytes.pop();
        assert!(!error("a.stl", &bytes).is_empty(), "cut short");
    }
}

#[test]
fn names_in_ply_may_be_in_any_case_and_the_list_of_corners_of_any_name() {
    let (text, _) = triangle("a.ply", "1");
    let expected = read("a.ply", &text);
    let list = ["vertex_indices", "vertex_index"]
        .into_iter()
        .find(|name| text.contains(name));
    for other in [
        text.replacen("ply", "PLY", 1),
        text.replace("float x", "float X")
            .replace("float y", "float Y"),
        text.replace(list.unwrap(), "Vertex_Indices"),
        text.replace(list.unwrap(), "corners"),
    ] {
        assert_eq!(read("a.ply", &other), expected, "{other}");
    }
}

#[test]
fn strips_in_ply_are_triangles() {
    let header = "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n\
                  element tristrips 1\nproperty list int int vertex_indices\nend_header\n\
                  0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n";
    let file = read("a.ply", format!("{header}9 0 1 2 3 -1 2 3 4 -1\n"));
    assert_eq!(
        file.frames[0].triangles(),
        [[0, 1, 2], [2, 1, 3], [2, 3, 4]]
    );
    let open = read("a.ply", format!("{header}4 0 1 2 3\n"));
    assert_eq!(open.frames[0].triangles(), [[0, 1, 2], [2, 1, 3]]);
    assert!(error("a.ply", format!("{header}3 0 1 -2\n")).starts_with("line 15: -2 is not"));
}

/// The corners of the triangle as 36 bytes of numbers, with their count before them.
const BINARY: &str = "JAAAAAAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/AAAAAA==";

#[test]
fn vtp_is_read_with_space_before_its_declaration_and_names_in_any_case() {
    let (text, _) = triangle("a.vtp", "1");
    let expected = read("a.vtp", &text);
    for other in [
        format!("\n  {text}"),
        text.replace("connectivity", "Connectivity")
            .replace("offsets", "OFFSETS"),
        text.replace("format=\"ascii\"", "format=\"ASCII\""),
        text.replace("format=\"ascii\"", "format=\"Binary\"")
            .replace("0 0 0\n1 0 0\n0 1 0\n", BINARY),
    ] {
        assert_eq!(read("a.vtp", &other), expected, "{other}");
    }
}

#[test]
fn a_packed_file_is_told_so_in_every_format() {
    for (name, _) in TRIANGLES {
        assert_eq!(
            error(name, b"\x1f\x8b\x08\0\0\0\0\0"),
            "byte 0: packed by gzip: unpack it first"
        );
        assert_eq!(
            error(name, b"PK\x03\x04abc"),
            "byte 0: packed by zip: unpack it first"
        );
    }
}

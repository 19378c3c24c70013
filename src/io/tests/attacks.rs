//! Small files that ask for much: each is refused with its reason before time or memory is spent, or read.
//! Outcomes are asserted, not times: a reader that does what it should not would take minutes or gigabytes here.

use std::fmt::Write;
use std::io::Write as _;

use super::{error, read};
use crate::io::{Limits, read_mesh, read_mesh_with_siblings};

#[test]
fn a_polygon_of_a_million_corners_is_refused_in_every_format() {
    const CORNERS: usize = 1_000_000;
    let corners = |first: usize| {
        (first..CORNERS + first).fold(String::new(), |mut text, corner| {
            let _ = write!(text, " {corner}");
            text
        })
    };
    let from_zero = corners(0);
    let vtp_array = |name: &str, text: &str| {
        format!("<DataArray type=\"Int32\" Name=\"{name}\">{text}</DataArray>")
    };
    let files = [
        ("a.obj", format!("f{}\n", corners(1))),
        (
            "a.ply",
            format!(
                "ply\nformat ascii 1.0\nelement face 1\nproperty list int int vertex_index\n\
                 end_header\n{CORNERS}{from_zero}\n"
            ),
        ),
        (
            "a.vtk",
            format!(
                "# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\nPOLYGONS 1 {}\n{CORNERS}{from_zero}\n",
                CORNERS + 1
            ),
        ),
        (
            "a.vtp",
            format!(
                "<VTKFile type=\"PolyData\"><PolyData><Piece NumberOfPoints=\"{CORNERS}\" NumberOfPolys=\"1\">\
                 <Points>{}</Points><Polys>{}{}</Polys></Piece></PolyData></VTKFile>",
                vtp_array("p", &" 0 0 0".repeat(CORNERS)),
                vtp_array("connectivity", &from_zero),
                vtp_array("offsets", &CORNERS.to_string()),
            ),
        ),
        ("a.csv", format!("f{}\n", from_zero.replace(' ', ","))),
    ];
    for (name, text) in files {
        let error = error(name, text);
        assert!(
            error.starts_with("line ") && error.contains("a polygon of 10"),
            "{name}: {error}"
        );
        assert!(
            error.ends_with("corners; the limit is 10000"),
            "{name}: {error}"
        );
    }
}

#[test]
fn sixty_thousand_attributes_are_refused() {
    let attributes: String = (0..60_000).map(|k| format!(" a{k}=\"\"")).collect();
    let text = format!("<VTKFile type=\"PolyData\"{attributes}><PolyData/></VTKFile>");
    assert_eq!(
        error("a.vtp", text),
        "60001 XML attributes of one element; the limit is 256"
    );
}

/// A file whose points are zeros, packed as VTK packs them.
fn packed_zeros(points: usize, pieces: usize) -> Vec<u8> {
    const BLOCK_BYTES: usize = 32_768;
    let size = 24 * points;
    let packed = |bytes: usize| {
        let mut encoder = flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::best());
        encoder.write_all(&vec![0; bytes]).unwrap();
        encoder.finish().unwrap()
    };
    let (blocks, rest) = (size / BLOCK_BYTES, size % BLOCK_BYTES);
    let (whole, last) = (packed(BLOCK_BYTES), packed(rest));
    let mut array: Vec<u8> = Vec::new();
    let count = blocks + usize::from(rest > 0);
    for number in [count, BLOCK_BYTES, rest] {
        array.extend((number as u32).to_le_bytes());
    }
    for block in 0..count {
        let bytes = if block < blocks { &whole } else { &last };
        array.extend((bytes.len() as u32).to_le_bytes());
    }
    for block in 0..count {
        array.extend(if block < blocks { &whole } else { &last });
    }
    let piece = format!(
        "<Piece NumberOfPoints=\"{points}\" NumberOfPolys=\"0\"><Points>\
         <DataArray type=\"Float64\" format=\"appended\" offset=\"0\"/></Points></Piece>"
    );
    let head = format!(
        "<VTKFile type=\"PolyData\" compressor=\"vtkZLibDataCompressor\"><PolyData>{}</PolyData>\
         <AppendedData encoding=\"raw\">_",
        piece.repeat(pieces)
    );
    [head.as_bytes(), &array, b"</AppendedData></VTKFile>"].concat()
}

#[test]
fn arrays_that_unpack_to_a_thousand_times_their_size_are_refused_before_they_are() {
    let bomb = packed_zeros(5_000_000, 1);
    assert!(bomb.len() < 300_000, "{}", bomb.len());
    let message = error("a.vtp", bomb);
    assert!(
        message.starts_with("byte ") && message.contains("120000000 bytes: too many"),
        "{message}"
    );
    // what the header says is not believed either
    let message = error("a.vtp", packed_zeros(6_000_000, 1));
    assert_eq!(message, "6000000 vertices; the limit is 5000000");
    // many pieces that unpack one array
    let message = error("a.vtp", packed_zeros(500, 900));
    assert!(message.contains("12000 bytes: too many"), "{message}");
    let message = error("a.vtp", packed_zeros(1, 1_001));
    assert_eq!(message, "1001 pieces; the limit is 1000");
    assert_eq!(error("a.vtp", packed_zeros(20, 1)), "holds no triangles");
}

/// A glTF of one triangle, with what is put between.
fn gltf(nodes: &str, buffers: &str, rest: &str) -> String {
    format!(
        "{{\"asset\":{{\"version\":\"2.0\"}},\"nodes\":[{nodes}],\"buffers\":[{buffers}],{rest}\
         \"meshes\":[{{\"primitives\":[{{\"attributes\":{{\"POSITION\":0}}}}]}}],\
         \"accessors\":[{{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}}],\
         \"bufferViews\":[{{\"buffer\":0,\"byteLength\":36}}]}}"
    )
}

fn three_points() -> Vec<u8> {
    let points = [0.0_f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    points.iter().flat_map(|x| x.to_le_bytes()).collect()
}

#[test]
fn one_file_named_a_thousand_times_is_read_once_and_many_files_have_one_limit() {
    let name = |uri: String| format!("{{\"byteLength\":36,\"uri\":\"{uri}\"}}");
    let many = vec![name("a.bin".to_owned()); 1_000].join(",");
    let beside = |_: &str| {
        let mut bytes = three_points();
        bytes.resize(1_500_000, 0);
        Some(bytes)
    };
    let open = |buffers: &str, limits: &Limits| {
        let text = gltf("{\"mesh\":0}", buffers, "");
        read_mesh_with_siblings("a.gltf", text.as_bytes(), limits, &beside)
    };
    assert_eq!(
        open(&many, &Limits::default()).unwrap().frames[0].triangles(),
        [[0, 1, 2]]
    );
    let different: Vec<String> = (0..1_000).map(|k| name(format!("{k}.bin"))).collect();
    let small = Limits {
        file_bytes: 10_000_000,
        ..Limits::default()
    };
    let error = open(&different.join(","), &small).unwrap_err().to_string();
    assert_eq!(error, "10500000 bytes; the limit is 10000000");
}

#[test]
fn three_hundred_thousand_instances_are_refused() {
    let buffer = format!(
        "{{\"byteLength\":36,\"uri\":\"data:,{}\"}}",
        percent(&three_points())
    );
    let text = gltf(&vec!["{\"mesh\":0}"; 300_000].join(","), &buffer, "");
    assert_eq!(
        error("a.gltf", text),
        "1001 parts of the scene; the limit is 1000"
    );
    let text = gltf(&vec!["{\"mesh\":0}"; 100].join(","), &buffer, "");
    assert_eq!(read("a.gltf", &text).frames[0].triangles().len(), 100);
    let small = Limits {
        faces: 500,
        ..Limits::default()
    };
    assert_eq!(
        read_mesh("a.gltf", text.as_bytes(), &small)
            .unwrap_err()
            .to_string(),
        "51 faces of meshes that are placed again; the limit is 50"
    );
}

fn percent(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("%{byte:02x}")).collect()
}

#[test]
fn accessors_of_more_than_the_limit_are_refused_before_they_are_read() {
    let buffer = format!(
        "{{\"byteLength\":36,\"uri\":\"data:,{}\"}}",
        percent(&three_points())
    );
    let text = gltf("{\"mesh\":0}", &buffer, "");
    let zeros = text.replace(
        "\"bufferView\":0,\"componentType\":5126,\"count\":3",
        "\"componentType\":5126,\"count\":4000000000",
    );
    assert_eq!(
        error("a.gltf", zeros),
        "4000000000 vertices; the limit is 5000000"
    );
    let corners = text
        .replace("{\"POSITION\":0}", "{\"POSITION\":0},\"indices\":1")
        .replace(
            "\"VEC3\"}",
            "\"VEC3\"},{\"componentType\":5125,\"count\":4000000000,\"type\":\"SCALAR\"}",
        );
    assert_eq!(
        error("a.gltf", corners),
        "1333333333 faces; the limit is 10000000"
    );
}

#[test]
fn counts_in_headers_take_no_memory() {
    let vtk = "# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\n";
    for (name, text, expected) in [
        ("a.vtk", format!("{vtk}LINES 4000000000 5"), "4000000000 points and lines; the limit is 10000000"),
        ("a.vtk", format!("{vtk}POLYGONS 1 99999999999\n99999999998 0"), "line 6: a cell of 99999999998 corners"),
        (
            "a.vtk",
            format!("{vtk}POLYGONS 2 99999999999\nOFFSETS int\n0 99999999999"),
            "line 7: a cell of 99999999999 corners",
        ),
        (
            "a.ply",
            "ply\nformat ascii 1.0\nelement face 1\nproperty list uint int vertex_index\nend_header\n4294967295 1"
                .to_owned(),
            "line 6: a polygon of 4294967295 corners",
        ),
    ] {
        let error = error(name, text);
        assert!(error.starts_with(expected), "{name}: {error}");
    }
    let small = Limits {
        polygon_corners: 3,
        ..Limits::default()
    };
    let quad = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
    let error = read_mesh("a.obj", quad.as_bytes(), &small).unwrap_err();
    assert_eq!(
        error.to_string(),
        "line 5: a polygon of 4 corners; the limit is 3"
    );
}

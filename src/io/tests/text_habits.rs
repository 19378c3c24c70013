//! White space, line ends, marks, letters and remarks as programs and people write them.

use super::{TRIANGLES, error, read, triangle};
use crate::mesh::Point3;

fn utf16(text: &str, word: fn(u16) -> [u8; 2]) -> Vec<u8> {
    let marked = format!("\u{feff}{text}");
    marked.encode_utf16().flat_map(word).collect()
}

#[test]
fn every_text_format_is_read_with_every_mark_and_every_end_of_line() {
    for (name, _) in TRIANGLES {
        let (text, _) = triangle(name, "1");
        let expected = read(name, &text);
        for other in [
            format!("\u{feff}{text}").into_bytes(),
            utf16(&text, u16::to_le_bytes),
            utf16(&text, u16::to_be_bytes),
            text.replace('\n', "\r\n").into_bytes(),
            format!("\u{feff}{}", text.replace('\n', "\r\n")).into_bytes(),
            text.replace('\n', "\r").into_bytes(),
            text.trim_end().as_bytes().to_vec(),
            format!("{text}\n\n \n").into_bytes(),
        ] {
            assert_eq!(read(name, &other), expected, "{name}");
            if ["a.ply", "a.vtk", "a.vtp"].contains(&name) {
                assert_eq!(read("known by its content", &other), expected, "{name}");
            }
        }
        let (bad, line) = triangle(name, "x");
        for ends in ["\r\n", "\r"] {
            let error = error(name, bad.replace('\n', ends));
            assert!(
                error.starts_with(&format!("line {line}: ")),
                "{name} {ends:?}: {error}"
            );
        }
        assert!(error(name, [b"\xff\xfe\0\0", text.as_bytes()].concat()).contains("UTF-32"));
    }
}

#[test]
fn blanks_tabs_and_empty_lines_part_words_in_every_text_format() {
    for (name, _) in TRIANGLES {
        let (text, _) = triangle(name, "1");
        let expected = read(name, &text);
        let wide = if name == "a.vtp" {
            text.replace("0 0", "0 \t\n 0")
                .replace("0 1 2", "\t0\n1   2 ")
        } else if name == "a.csv" {
            text.replace(',', " ,\t ").replace('\n', " \n\n")
        } else {
            text.replace(' ', " \t ").replace('\n', " \t\n")
        };
        assert_eq!(read(name, &wide), expected, "{name}\n{wide}");
        if name == "a.obj" || name == "a.stl" {
            let indented = text.replace('\n', "\n\n \t");
            assert_eq!(read(name, &indented), expected, "{name}");
        }
    }
}

#[test]
fn a_backslash_continues_only_a_line_that_is_no_comment_and_above_no_keyword() {
    let expected = read("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    for text in [
        "# D:\\hearts\\\nv 0 0 0\nv 1 0 0\n#\\\nv 0 1 0\nf 1 2 3\n",
        "v 0 0 0 # a\\\nv 1 0 0 # b \\ \nv 0 1 0\n  # c\\\t\r\nf 1 2 3\\",
        "mtllib D:\\hearts\\\nv 0 0 0\ng a\\\nv 1 0 0\nusemtl b \\\nv 0 1 0\no c\\\nf 1 2 3\n",
        "v 0 \\\n0 0\nv \\ \n1 \\\t\r\n0 \\\n 0\nv 0 1 0\\\n\nf 1 2 \\\n3\n",
        "v 0 0 0 \\\nv 1 0 0 \\\n\nv 0 1 0\nmtllib a.mtl \\\n b.mtl\nf 1\\\n 2\\\n 3 \\\n# d\\\n",
        "v 0 0 0\\\rv 1 0 0\rv 0 1 0\r# e\\\rf 1 2 3\r",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 \\\n",
    ] {
        let file = read("a.obj", text);
        assert_eq!(file.frames, expected.frames, "{text}");
    }
    assert!(error("a.obj", "v 0 0 \\\nv 1 0 0\nv 0 1 0\nf 1 2 3").starts_with("line 1: 2 coord"));
    assert!(error("a.obj", "v 0 0 0\nf 1/x 1 1").starts_with("line 2: \"1/x\""));
}

#[test]
fn ascii_stl_is_read_as_programs_write_it() {
    let (text, _) = triangle("a.stl", "1");
    let expected = read("a.stl", &text);
    let split = text
        .replace("endloop", "end loop")
        .replace("endfacet", "end  facet")
        .replace("endsolid", "end\nsolid");
    for other in [
        split.clone(),
        split.to_uppercase(),
        text.replace("endloop", "EndLoop").replace("solid", "Solid"),
        text.replace("solid a", "solid")
            .replace("endsolid a", "endsolid"),
        text.replace("solid a", "solid facet of a heart")
            .replace("vertex 1 0 0", "vertex 1\n0\n0"),
        text.replace('\n', " "),
        text.replace("facet normal 0 0 1\nouter", "facet normal\nouter"),
        text.replace("facet normal 0 0 1\n", "facet\nnormal 0\n0 1 "),
        format!("# made by hand\n; so\n\n{text}").replace("outer loop", "// remark\nouter loop"),
        format!("solid empty\nendsolid empty\n{text}solid\nendsolid\n"),
    ] {
        assert_eq!(read("a.stl", &other), expected, "{other}");
    }
    let two = format!(
        "{text}{}",
        text.replace("solid a", "solid b").replace("1 0 0", "2 0 0")
    );
    assert_eq!(
        read("a.stl", two).frames[0].triangles(),
        [[0, 1, 2], [0, 3, 2]]
    );
    for (from, to, expected) in [
        (
            "vertex 1 0 0",
            "vertex 1 0 0 7",
            "line 5: vertex has more than 3",
        ),
        (
            "vertex 1 0 0",
            "vertex 1 0",
            "line 5: \"vertex\" is not a number",
        ),
        ("endloop", "end lop", "line 7: unknown keyword \"end\""),
        ("endsolid a\n", "", "line 8: the file ends within a solid"),
        (
            "solid a\n",
            "<html>\n",
            "line 1: \"<html>\" outside a solid",
        ),
    ] {
        let error = error("a.stl", text.replacen(from, to, 1));
        assert!(error.starts_with(expected), "{to}: {error}");
    }
    assert!(
        error("a.stl", text.replace('\n', " ").repeat(2)).contains("on the line of \"endsolid\"")
    );
}

#[test]
fn legacy_vtk_is_read_in_any_case_with_numbers_on_any_line() {
    let (text, _) = triangle("a.vtk", "1");
    let expected = read("a.vtk", &text);
    let words: Vec<&str> = text.split_whitespace().collect();
    let one_a_line = words[9..].join("\n");
    for other in [
        text.to_lowercase()
            .replace("datafile version", "DataFile Version"),
        text.to_lowercase(),
        text.replace("POINTS 3 float\n", "POINTS 3\tFLOAT ")
            .replace("1 4\n", "1 4 "),
        text.replace("DATASET POLYDATA\n", "\n\n  dataset\n PolyData \n\n"),
        text.replace("ASCII\n", " ascii \n\n"),
        text.replace("\na\n", "\n\n"),
        format!("\n\n{text}"),
        format!("# vtk DataFile Version 2.0\na\nASCII\nDATASET POLYDATA\n{one_a_line}"),
        text.replace("3.0", "5.1").replace(
            "1 4\n3 0 1 2",
            "2 3\nOFFSETS vtktypeint64\n0 3\nconnectivity\nVTKTYPEINT64 0 1 2",
        ),
        text.replace(
            "POLYGONS",
            "METADATA\nINFORMATION 1\nNAME a LOCATION b\nDATA 1 c\n\nPOLYGONS",
        ),
        text.replace("POLYGONS", "METADATA\nINFORMATION 0\nPOLYGONS"),
        text.replace("POLYGONS", "METADATA\n\nPOLYGONS"),
        text.replace(
            "POINTS",
            "FIELD FieldData 3\nTimeValue 1 1 double\n0.5\nMETADATA\nINFORMATION 0\n\n\
             names 1 2 string\na b\n\nmore 2 1 int 7\n8\nPOINTS",
        ),
        text.replace("POLYGONS", "field a 1\nb 1 2 Int\n1\n2\nPOLYGONS")
            + "POINT_DATA 3\nSCALARS s float 1\nLOOKUP_TABLE default\n1 nan -1.#IND\n",
        text.replace("POLYGONS 1 4\n3 0 1 2", "TRIANGLE_STRIPS 1 4 3 0 1 2"),
        text.replace("POLYDATA", "UNSTRUCTURED_GRID")
            .replace("POLYGONS 1 4", "cells 1 4")
            + "cell_types 1 5\n",
    ] {
        assert_eq!(read("a.vtk", &other), expected, "{other}");
    }
    let grid = text
        .replace("POLYDATA", "UNSTRUCTURED_GRID")
        .replace("0 1 0\n", "0 1 0 1 1 0\n");
    let grid = grid.replace("POINTS 3", "POINTS 4");
    for (cell, triangles) in [
        ("3 0 1 2 CELL_TYPES 1 5", &[[0, 1, 2]][..]),
        ("4 0 1 2 3 CELL_TYPES 1 9", &[[0, 1, 2], [0, 2, 3]]),
        ("4 0 1 2 3 CELL_TYPES 1 8", &[[0, 1, 3], [0, 3, 2]]),
        ("4 0 1 2 3 CELL_TYPES 1 6", &[[0, 1, 2], [2, 1, 3]]),
        ("4 0 1 2 3 CELL_TYPES 1 7", &[[0, 1, 2], [0, 2, 3]]),
    ] {
        let size = cell.split_once(" CELL").unwrap().0.split(' ').count();
        let text = grid.replace("POLYGONS 1 4\n3 0 1 2", &format!("CELLS 1 {size} {cell}"));
        assert_eq!(
            read("a.vtk", &text).frames[0].triangles(),
            triangles,
            "{cell}"
        );
    }
    let both = grid.replace(
        "POLYGONS 1 4\n3 0 1 2",
        "CELLS 3 11\n1 0 4 0 1 2 3 3 0 1 2\nCELL_TYPES 3 1 9 5",
    );
    assert_eq!(read("a.vtk", both).frames[0].triangles().len(), 3);
}

#[test]
fn ascii_ply_is_read_with_numbers_on_any_line() {
    let (text, _) = triangle("a.ply", "1");
    let text = text.replace("face 1", "face 2") + "3 2 1 0\n";
    let expected = read("a.ply", &text);
    assert_eq!(expected.frames[0].triangles(), [[0, 1, 2], [2, 1, 0]]);
    let (header, body) = text.split_once("end_header\n").unwrap();
    let numbers: Vec<&str> = body.split_whitespace().collect();
    let wrapped = |width: usize| {
        let lines: Vec<String> = numbers.chunks(width).map(|line| line.join(" ")).collect();
        lines.join("\n")
    };
    let bodies = [
        wrapped(1),
        wrapped(2),
        wrapped(7),
        wrapped(100),
        "0\n0 0\n1 0\n0\n\n0 1 0\n3\n0 1 2\n3 2\n1 0\n".to_owned(),
        "0 0 0\n1 0 0\n0 1 0\n3 0 1 2 3 2 1 0\n".to_owned(),
        "0 0 0 1 0 0 0 1 0\n3 0 1 2\n3 2 1 0\n".to_owned(),
    ];
    for body in bodies {
        assert_eq!(
            read("a.ply", format!("{header}end_header\n{body}")),
            expected,
            "{body}"
        );
    }
    for (body, expected) in [
        ("0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 2 1 0", "line "),
        (
            "0 0 0\n1 0\n0 1 0\n3 0 1 2\n3 2 1 0",
            "line 11: numbers of an element end amid line 12",
        ),
        (
            "0 0 0\n1 0 0\n0 1 0 5\n3 0 1 2\n3 2 1 0",
            "line 12: more numbers",
        ),
        (
            "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 2 1 0 4",
            "line 14: more numbers",
        ),
        (
            "0\n0\n0\n1\n0\n0\n0\n1\n0\n3\n0\n1\n2\n3\n2\n1\n0\n4",
            "line 27: more numbers",
        ),
        ("0\n0\n1\n0\n0\n0\n1\n0\n3\n0\n1\n2\n3\n2\n1\n0", "line "),
        (
            "0 0 0 1 0 0 0 1 0 3 0 1 2 3 2 1 0 4",
            "line 10: more numbers",
        ),
        ("0 0 0 1 0 0 0 1 0 3 0 1 2 3 2 1", "line 10: fewer numbers"),
    ] {
        let error = error("a.ply", format!("{header}end_header\n{body}\n"));
        assert!(error.starts_with(expected), "{body}: {error}");
    }
}

#[test]
fn ply_headers_are_read_as_programs_write_them() {
    let (text, _) = triangle("a.ply", "1");
    let expected = read("a.ply", &text);
    for list in [
        "char", "uchar", "short", "ushort", "int", "uint", "int8", "uint8", "int32", "int64",
    ] {
        for (item, name) in [
            ("int", "vertex_index"),
            ("uint8", "vertex_indices"),
            ("ushort", "vertex_index"),
        ] {
            let other = text.replace(
                "list uchar int vertex_indices",
                &format!("list {list} {item} {name}"),
            );
            assert_eq!(read("a.ply", other), expected);
        }
    }
    for other in [
        text.replace("ply\n", "ply \ncomment a\nobj_info b = c\n")
            .replace("end_", "comment d\nend_"),
        text.replace("format", "  format\t"),
        text.replace(
            "element face",
            "element edge 2\nproperty int a\nelement face",
        )
        .replace("3 0 1 2", "1\n2\n3 0 1 2"),
        text.replace(
            "end_header",
            "element user 1\nproperty list int float b\nend_header",
        ) + "2 nan x\n",
    ] {
        assert_eq!(read("a.ply", &other), expected, "{other}");
    }
    // a header of old Macs; the first byte of the body is a line feed
    let header = "ply\rformat binary_little_endian 1.0\relement vertex 3\rproperty uchar x\r\
                  property uchar y\rproperty uchar z\relement face 1\r\
                  property list uchar uchar vertex_index\rend_header\r";
    let body = [10, 0, 0, 1, 0, 0, 0, 1, 0, 3, 0, 1, 2];
    let file = read("a.ply", [header.as_bytes(), &body].concat());
    assert_eq!(file.frames[0].vertices()[0], Point3::new(10.0, 0.0, 0.0));
}

#[test]
fn vtp_is_read_with_all_that_xml_allows() {
    let (text, _) = triangle("a.vtp", "1");
    let expected = read("a.vtp", &text);
    for other in [
        text.replace("1 0 0\n", "<!-- b --> 1 <!-- c\n\n -->0 0\n"),
        text.replace("1 0 0\n", "1<!-- b --> 0 <?pi 7?>0\n"),
        text.replace("0 0 0\n1 0 0\n", "<![CDATA[0 0 0\n1 0]]> &#48;&#x20;"),
        text.replace("0 1 2<", "<![CDATA[0 1 2]]><"),
        text.replace("0 1 2<", "0<!---->  1 <?a b?>2<"),
        text.replace(
            "<VTKFile",
            "<!-- a = b -->\n<!DOCTYPE VTKFile>\n<?xsl c?>\n<VTKFile",
        ),
        text.replace("<Polys>", "<Verts/><Lines></Lines><Strips/><Polys>"),
        text.replace(" NumberOfPolys=\"1\"", ""),
        text.replace(
            "NumberOfPolys=\"1\"",
            "NumberOfPolys=\" 1 \" NumberOfStrips=\"0\"",
        ),
        text.replace(
            "</PolyData>",
            "<Piece NumberOfPoints=\"0\"></Piece></PolyData>",
        )
        .replace("<PolyData>", "<PolyData><FieldData/>"),
        text.replace(
            "\"PolyData\"",
            "\"PolyData\" compressor=\"vtkLZ4DataCompressor\"",
        ),
        text.replace("<?xml version=\"1.0\"?>\n", ""),
        text.replace("version=\"1.0\"", "version='1.0' encoding='ISO-8859-15'"),
        text.replace("version=\"1.0\"", "version='1.0' encoding='GB18030'"),
    ] {
        let mut file = read("a.vtp", &other);
        file.notices
            .retain(|notice| !notice.text.contains("pieces joined"));
        assert_eq!(file, expected, "{other}");
    }
    // a comment is no white space
    let (split, line) = triangle("a.vtp", "1<!-- -->.5e1<!-- -->0");
    assert_eq!(read("a.vtp", split).frames[0].vertices()[1].x, 1.5e10);
    let (bad, _) = triangle("a.vtp", "1 <!--\n\n--> x");
    assert_eq!(
        error("a.vtp", bad),
        format!("line {}: \"x\" is not a number", line + 2)
    );
    let latin = text.replace("version=\"1.0\"", "version='1.0' encoding='windows-1252'");
    let latin = latin.replace("type=\"Float32\"", "type=\"Float32\" Name=\"Jürgen\"");
    let latin: Vec<u8> = latin.chars().map(|c| c as u8).collect();
    assert_eq!(read("a.vtp", latin), expected);
    let strips = text.replace("Polys", "Strips");
    assert_eq!(read("a.vtp", strips), expected);
    let two = text
        .split_once("<Piece")
        .unwrap()
        .1
        .split_once("</Piece>")
        .unwrap()
        .0;
    let two = read(
        "a.vtp",
        text.replace("</PolyData>", &format!("<Piece{two}</Piece></PolyData>")),
    );
    assert_eq!(two.frames[0].triangles(), [[0, 1, 2], [3, 4, 5]]);
    for (from, to, expected) in [
        (
            "NumberOfPoints=\"3\" ",
            "",
            "line 4: NumberOfPoints is missing",
        ),
        ("Polys>", "Pols>", "line 4: Polys is missing"),
        (
            "<VTKFile",
            "<!DOCTYPE a [<!ENTITY b 'c'>]><VTKFile",
            "line ",
        ),
        (">3<", ">4<", "line 14: offset 4 is not between 0 and 3"),
    ] {
        let error = error("a.vtp", text.replace(from, to));
        assert!(error.starts_with(expected), "{to}: {error}");
    }
}

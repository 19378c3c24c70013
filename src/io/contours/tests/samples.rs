//! A small file of every format of outlines, and images that they were drawn in.

use crate::io::contours::formats::ContourFormat;

/// A file with its name.
pub(super) struct Sample {
    pub name: &'static str,
    pub bytes: Vec<u8>,
    pub format: ContourFormat,
    /// Whether it is text.
    pub text: bool,
}

/// One of every format.
pub(super) fn samples() -> Vec<Sample> {
    let sample = |name, bytes, format| Sample {
        name,
        bytes,
        format,
        text: format != ContourFormat::Structures,
    };
    vec![
        sample(
            "a.cvi42wsx",
            workspace("1.2.3.1").into_bytes(),
            ContourFormat::Cvi42,
        ),
        sample(
            "GPFile_000.txt",
            guide_points().into_bytes(),
            ContourFormat::GuidePoints,
        ),
        sample(
            "endo_frame0.mrk.json",
            markups().into_bytes(),
            ContourFormat::Markups,
        ),
        sample(
            "IM-0001-0002-icontour-manual.txt",
            sunnybrook().into_bytes(),
            ContourFormat::Sunnybrook,
        ),
        sample(
            "rtss.dcm",
            structures("LV endocardium"),
            ContourFormat::Structures,
        ),
    ]
}

/// A square of four corners of a pixel each.
const SQUARE: [[u32; 2]; 4] = [[1, 1], [3, 1], [3, 3], [1, 3]];

/// A cvi42 workspace with an outline of the endocardium in one image, in quarters of pixels.
pub(super) fn workspace(uid: &str) -> String {
    let point = |[x, y]: [u32; 2]| {
        let [x, y] = [4 * x, 4 * y];
        format!("<List:item><Point:x>{x}</Point:x><Point:y>{y}</Point:y></List:item>\n")
    };
    let points: String = SQUARE.into_iter().map(point).collect();
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
         <Workspace xmlns:Hash=\"cvi42/Hash\" xmlns:List=\"cvi42/List\" xmlns:Point=\"cvi42/Point\">\n\
         <Hash:item Hash:key=\"ImageStates\" Hash:count=\"1\">\n<Hash:item Hash:key=\"{uid}\">\n\
         <Hash:item Hash:key=\"Contours\">\n<Hash:item Hash:key=\"saendocardialContour\">\n\
         <Hash:item Hash:key=\"SubpixelResolution\">4</Hash:item>\n\
         <Hash:item Hash:key=\"Points\" List:count=\"4\">\n{points}</Hash:item></Hash:item></Hash:item></Hash:item></Hash:item></Workspace>\n"
    )
}

/// An outline of Sunnybrook, counted from 1.
pub(super) fn sunnybrook() -> String {
    let line = |[x, y]: [u32; 2]| format!("{}.00 {}.50\n", x + 1, y + 1);
    SQUARE.into_iter().map(line).collect()
}

/// Guide points of biv-me: one slice of frame 3.
fn guide_points() -> String {
    let mut text = "x\ty\tz\tcontour type\tframeID\tweight\ttime frame\n".to_owned();
    for kind in ["SAX_LV_ENDOCARDIAL", "SAX_LV_EPICARDIAL", "SAX_RV_SEPTUM"] {
        for [x, y] in SQUARE {
            text += &format!("{x}.5\t-{y}\t12.25\t{kind}\t2\t1.0\t3\n");
        }
    }
    text + "1\t2\t3\tAPEX_POINT\t7\t1.0\t3\n"
}

/// Markups of Slicer: a closed curve and a point.
fn markups() -> String {
    let point = |[x, y]: [u32; 2]| {
        format!(
            "{{\"label\": \"a\", \"position\": [{x}.5, -{y}, 3.0], \"positionStatus\": \"defined\"}}"
        )
    };
    let points = SQUARE.map(point).join(",\n");
    format!(
        "{{\"@schema\": \"markups-schema-v1.0.3.json#\", \"markups\": [\n\
         {{\"type\": \"ClosedCurve\", \"coordinateSystem\": \"RAS\", \"coordinateUnits\": \"mm\", \"controlPoints\": [{points}]}},\n\
         {{\"type\": \"Fiducial\", \"controlPoints\": [{{\"label\": \"apex\", \"position\": [1, 2, 3]}}]}}]}}"
    )
}

/// A DICOM element, explicit and little endian.
fn element(group: u16, number: u16, letters: &str, value: &[u8]) -> Vec<u8> {
    let mut value = value.to_vec();
    if value.len() % 2 == 1 {
        value.push(if letters == "UI" { 0 } else { b' ' });
    }
    let mut out = [group.to_le_bytes(), number.to_le_bytes()].concat();
    out.extend(letters.as_bytes());
    match letters {
        "SQ" | "OW" => {
            out.extend([0, 0]);
            out.extend((value.len() as u32).to_le_bytes());
        }
        _ => out.extend((value.len() as u16).to_le_bytes()),
    }
    out.extend(value);
    out
}

fn item(elements: &[Vec<u8>]) -> Vec<u8> {
    let body = elements.concat();
    [
        &b"\xfe\xff\x00\xe0"[..],
        &(body.len() as u32).to_le_bytes(),
        &body,
    ]
    .concat()
}

fn dicom(class: &str, elements: &[Vec<u8>]) -> Vec<u8> {
    let mut out = vec![0; 128];
    out.extend(b"DICM");
    out.extend(element(2, 2, "UI", class.as_bytes()));
    out.extend(element(2, 0x10, "UI", b"1.2.840.10008.1.2.1"));
    out.extend(elements.concat());
    out
}

/// Structures of radiotherapy: one square, drawn in image 1.2.3.1.
pub(super) fn structures(name: &str) -> Vec<u8> {
    const CLASS: &str = "1.2.840.10008.5.1.4.1.1.481.3";
    let points: Vec<String> = (SQUARE.iter())
        .map(|[x, y]| format!("{x}\\{y}\\10"))
        .collect();
    let contour = item(&[
        element(
            0x3006,
            0x16,
            "SQ",
            &item(&[element(8, 0x1155, "UI", b"1.2.3.1")]),
        ),
        element(0x3006, 0x42, "CS", b"CLOSED_PLANAR"),
        element(0x3006, 0x50, "DS", points.join("\\").as_bytes()),
    ]);
    let structure = item(&[
        element(0x3006, 0x22, "IS", b"1"),
        element(0x3006, 0x26, "LO", name.as_bytes()),
    ]);
    let contours = item(&[
        element(0x3006, 0x40, "SQ", &contour),
        element(0x3006, 0x84, "IS", b"1"),
    ]);
    dicom(
        CLASS,
        &[
            element(8, 0x16, "UI", CLASS.as_bytes()),
            element(0x3006, 0x20, "SQ", &structure),
            element(0x3006, 0x39, "SQ", &contours),
        ],
    )
}

/// An MR image of 6 × 5 pixels of 1 mm in a slice at z = 10 · `slice` mm, at an instant.
pub(super) fn image(uid: &str, slice: u32, trigger_ms: u32) -> Vec<u8> {
    const CLASS: &str = "1.2.840.10008.5.1.4.1.1.4";
    let text = |group, number, letters: &str, value: &str| {
        element(group, number, letters, value.as_bytes())
    };
    let short = |number, value: u16| element(0x28, number, "US", &value.to_le_bytes());
    dicom(
        CLASS,
        &[
            text(8, 8, "CS", "ORIGINAL\\PRIMARY\\M"),
            text(8, 0x16, "UI", CLASS),
            text(8, 0x18, "UI", uid),
            text(8, 0x60, "CS", "MR"),
            text(0x18, 0x50, "DS", "10"),
            text(0x18, 0x1060, "DS", &trigger_ms.to_string()),
            text(0x20, 0xd, "UI", "1.2"),
            text(0x20, 0xe, "UI", "1.2.3"),
            text(0x20, 0x32, "DS", &format!("0\\0\\{}", 10 * slice)),
            text(0x20, 0x37, "DS", "1\\0\\0\\0\\1\\0"),
            short(2, 1),
            text(0x28, 4, "CS", "MONOCHROME2"),
            short(0x10, 5),
            short(0x11, 6),
            text(0x28, 0x30, "DS", "1\\1"),
            short(0x100, 16),
            short(0x101, 16),
            short(0x102, 15),
            short(0x103, 0),
            element(0x7fe0, 0x10, "OW", &[7; 60]),
        ],
    )
}

//! The two forms of a glTF file, and its JSON parsed.

use gltf::{Document, json};

use crate::io::ReadMeshError;
use crate::io::binary_cursor::{BinaryCursor, ByteOrder, Scalar};
use crate::io::mesh_draft::FilePosition;

/// The parsed JSON and the binary chunk, if the file has one.
pub(super) struct Container<'a> {
    pub(super) document: Document,
    /// The chunk and the byte of the file at which it begins.
    pub(super) binary_chunk: Option<(&'a [u8], usize)>,
    /// Bytes behind the length that the header gives.
    pub(super) bytes_behind: usize,
}

/// Required extensions that change nothing of where the surface is.
const HARMLESS: &[&str] = &[
    "KHR_materials_",
    "KHR_texture_",
    "KHR_lights_",
    "KHR_xmp",
    // only allows positions that are whole numbers, which are read
    "KHR_mesh_quantization",
];

/// Splits and parses either form.
pub(super) fn open(bytes: &[u8]) -> Result<Container<'_>, ReadMeshError> {
    if !bytes.starts_with(b"glTF") {
        return Ok(Container {
            document: parse(bytes, None)?,
            binary_chunk: None,
            bytes_behind: 0,
        });
    }
    let mut cursor = BinaryCursor::new(bytes, 4);
    let version = word(&mut cursor, "the version")?;
    if version != 2 {
        return Err(FilePosition::Byte(4).error(format!("glTF version {version}; only 2 is read")));
    }
    let length = word(&mut cursor, "the length")?;
    const HEADER_BYTES: u64 = 12;
    if length > bytes.len() as u64 || length < HEADER_BYTES {
        return Err(FilePosition::Byte(8).error(format!(
            "the header says {length} bytes, but the file has {}",
            bytes.len()
        )));
    }
    let whole = &bytes[..length as usize];
    let mut cursor = BinaryCursor::new(whole, HEADER_BYTES as usize);
    let (json, start) = chunk(&mut cursor, b"JSON")?
        .ok_or_else(|| FilePosition::Byte(12).error("the first chunk is not JSON"))?;
    // filled up with spaces, or by some programs with zeros
    let padding = json.iter().rev().take_while(|&&b| b == 0).count();
    let document = parse(&json[..json.len() - padding], Some(start))?;
    let mut binary_chunk = None;
    while binary_chunk.is_none() && cursor.rest().len() >= CHUNK_HEADER_BYTES {
        binary_chunk = chunk(&mut cursor, b"BIN\0")?; // past chunks of other kinds
    }
    Ok(Container {
        document,
        binary_chunk,
        bytes_behind: bytes.len() - whole.len(),
    })
}

/// A length and a kind.
const CHUNK_HEADER_BYTES: usize = 8;

fn word(cursor: &mut BinaryCursor<'_>, what: &str) -> Result<u64, ReadMeshError> {
    Ok(cursor.number(Scalar::U32, ByteOrder::Little, what)? as u64)
}

/// The next chunk and where its content begins; none if it is of another kind.
fn chunk<'a>(
    cursor: &mut BinaryCursor<'a>,
    kind: &[u8],
) -> Result<Option<(&'a [u8], usize)>, ReadMeshError> {
    let length = word(cursor, "the length of a chunk")?;
    let found = cursor.take(4, "the kind of a chunk")?;
    let FilePosition::Byte(start) = cursor.place() else {
        return Ok(None);
    };
    let content = cursor.take(length, "a chunk")?;
    Ok((found == kind).then_some((content, start)))
}

/// Parses and validates JSON, which begins at byte `start` of a binary file.
fn parse(text: &[u8], start: Option<usize>) -> Result<Document, ReadMeshError> {
    let root: json::Root = json::deserialize::from_slice(text).map_err(|error| {
        let place = match start {
            None => FilePosition::Line(error.line().max(1)),
            Some(start) => FilePosition::Byte(start + byte_of(text, error.line(), error.column())),
        };
        place.error(format!("not valid glTF: {error}"))
    })?;
    let strange = root
        .extensions_required
        .iter()
        .find(|name| !HARMLESS.iter().any(|harmless| name.starts_with(harmless)));
    if let Some(name) = strange {
        return Err(ReadMeshError::InItem {
            item: "extensionsRequired".to_owned(),
            reason: format!("the extension {name} is not read; save the file without it"),
        });
    }
    check_compression(&root)?;
    check_positions(&root)?;
    check_channels(&root)?;
    check_all(&root)?;
    Ok(Document::from_json_without_validation(root))
}

/// What the crate checks, less what it asks for beyond the specification or what is of no use here: bytes behind every
/// accessor, the extents of positions, extensions (which were looked at).
fn check_all(root: &json::Root) -> Result<(), ReadMeshError> {
    use json::validation::{Error, Validate};

    let mut first = None;
    root.validate(root, json::Path::new, &mut |path, error| {
        if first.is_none() {
            let item = path().0;
            let endings = [".bufferView", ".min", ".max"];
            let needless = item.starts_with("extensionsRequired")
                || error == Error::Missing && endings.iter().any(|ending| item.ends_with(ending));
            first = (!needless).then(|| ReadMeshError::InItem {
                item,
                reason: error.to_string().to_lowercase(),
            });
        }
    });
    first.map_or(Ok(()), Err)
}

/// An accessor without a view is all zeros, except where a compression that is not read fills it.
fn check_compression(root: &json::Root) -> Result<(), ReadMeshError> {
    let fills = |name: &&String| name.contains("_compression");
    let empty =
        |accessor: &json::Accessor| accessor.buffer_view.is_none() && accessor.sparse.is_none();
    match root.extensions_used.iter().find(fills) {
        Some(name) if root.accessors.iter().any(empty) => Err(ReadMeshError::InItem {
            item: "extensionsUsed".to_owned(),
            reason: format!("the extension {name} is not read; save the file without it"),
        }),
        _ => Ok(()),
    }
}

/// Checks what the crate's own validation indexes by without a check (gltf-json 1.4.1,
/// `primitive_validate_hook`).
fn check_positions(root: &json::Root) -> Result<(), ReadMeshError> {
    let positions = json::validation::Checked::Valid(json::mesh::Semantic::Positions);
    for (mesh_at, mesh) in root.meshes.iter().enumerate() {
        for (at, primitive) in mesh.primitives.iter().enumerate() {
            let index = primitive.attributes.get(&positions).map(json::Index::value);
            if let Some(index) = index.filter(|&index| index >= root.accessors.len()) {
                return Err(ReadMeshError::InItem {
                    item: format!("meshes[{mesh_at}].primitives[{at}]"),
                    reason: format!(
                        "refers to accessors[{index}], but there are only {}",
                        root.accessors.len()
                    ),
                });
            }
        }
    }
    Ok(())
}

/// Checks what the crate hands out without a check: its validation of animations stops at the
/// samplers (gltf-json 1.4.1, `Animation::validate`).
fn check_channels(root: &json::Root) -> Result<(), ReadMeshError> {
    for (animation_at, animation) in root.animations.iter().enumerate() {
        for (at, channel) in animation.channels.iter().enumerate() {
            let item = || format!("animations[{animation_at}].channels[{at}]");
            let node = channel.target.node.value();
            if node >= root.nodes.len() {
                return Err(ReadMeshError::InItem {
                    item: item(),
                    reason: format!(
                        "refers to nodes[{node}], but there are only {}",
                        root.nodes.len()
                    ),
                });
            }
            if channel.target.path == json::validation::Checked::Invalid {
                return Err(ReadMeshError::InItem {
                    item: item(),
                    reason: "moves neither a node nor weights".to_owned(),
                });
            }
        }
    }
    Ok(())
}

fn byte_of(text: &[u8], line: usize, column: usize) -> usize {
    let lines_before = text
        .split_inclusive(|&b| b == b'\n')
        .take(line.saturating_sub(1));
    lines_before.map(<[u8]>::len).sum::<usize>() + column.saturating_sub(1)
}

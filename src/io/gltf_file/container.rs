//! The two forms of a glTF file, and its JSON parsed.

use gltf::{Document, json};

use crate::io::ReadMeshError;
use crate::io::binary_cursor::{BinaryCursor, ByteOrder, Scalar};
use crate::io::mesh_draft::Place;

/// The parsed JSON and the binary chunk, if the file has one.
pub(super) struct Container<'a> {
    pub(super) document: Document,
    /// The chunk and the byte of the file at which it begins.
    pub(super) binary_chunk: Option<(&'a [u8], usize)>,
}

/// Required extensions that change nothing of where the surface is.
const HARMLESS: &[&str] = &["KHR_materials_", "KHR_texture_", "KHR_lights_", "KHR_xmp"];

/// Splits and parses either form.
pub(super) fn open(bytes: &[u8]) -> Result<Container<'_>, ReadMeshError> {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    if !bytes.starts_with(b"glTF") {
        return Ok(Container {
            document: parse(bytes, None)?,
            binary_chunk: None,
        });
    }
    let mut cursor = BinaryCursor::new(bytes, 4);
    let version = word(&mut cursor, "the version")?;
    if version != 2 {
        return Err(Place::Byte(4).error(format!("glTF version {version}; only 2 is read")));
    }
    let length = word(&mut cursor, "the length")?;
    if length != bytes.len() as u64 {
        return Err(Place::Byte(8).error(format!(
            "the header says {length} bytes, but the file has {}",
            bytes.len()
        )));
    }
    let (json, start) = chunk(&mut cursor, b"JSON")?
        .ok_or_else(|| Place::Byte(12).error("the first chunk is not JSON"))?;
    let document = parse(json, Some(start))?;
    let binary_chunk = if cursor.rest().is_empty() {
        None
    } else {
        chunk(&mut cursor, b"BIN\0")?
    };
    Ok(Container {
        document,
        binary_chunk,
    })
}

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
    let Place::Byte(start) = cursor.place() else {
        return Ok(None);
    };
    let content = cursor.take(length, "a chunk")?;
    Ok((found == kind).then_some((content, start)))
}

/// Parses and validates JSON, which begins at byte `start` of a binary file.
fn parse(text: &[u8], start: Option<usize>) -> Result<Document, ReadMeshError> {
    let root: json::Root = json::deserialize::from_slice(text).map_err(|error| {
        let place = match start {
            None => Place::Line(error.line().max(1)),
            Some(start) => Place::Byte(start + byte_of(text, error.line(), error.column())),
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
    check_positions(&root)?;
    check_channels(&root)?;
    Document::from_json(root).map_err(|error| match error {
        gltf::Error::Validation(errors) => match errors.into_iter().next() {
            Some((path, error)) => ReadMeshError::InItem {
                item: path.0,
                reason: error.to_string().to_lowercase(),
            },
            None => ReadMeshError::Empty,
        },
        other => ReadMeshError::InItem {
            item: "glTF".to_owned(),
            reason: other.to_string(),
        },
    })
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

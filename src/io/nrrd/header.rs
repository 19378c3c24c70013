//! The text header of NRRD: fields `name: value` and keys `name:=value`, up to an empty line.
//!
//! Source: "Definition of NRRD File Format", teem.sourceforge.net/nrrd/format.html. Keys hold free text (names of patients
//! among it): only those that tell times are looked at.

use std::collections::BTreeMap;

use crate::io::ReadImageError;
use crate::io::binary_cursor::{ByteOrder, Scalar};
use crate::io::data_files::names_by_pattern;
use crate::io::image_source::{HeaderLines, number, quoted};

/// Whether bytes begin as NRRD does.
pub(in crate::io) fn recognises(head: &[u8]) -> bool {
    head.starts_with(b"NRRD00")
}

/// A value with the line where it stands.
#[derive(Clone, Debug)]
pub(super) struct Field {
    pub line: usize,
    pub value: String,
}

/// How values are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Encoding {
    Raw,
    Gzip,
    Text,
}

/// A header, and where the values are.
#[derive(Debug)]
pub(super) struct NrrdHeader<'a> {
    fields: BTreeMap<String, Field>,
    keys: BTreeMap<String, String>,
    pub sizes: Vec<usize>,
    pub scalar: Scalar,
    pub encoding: Encoding,
    /// Names of the files with the values, if they stand elsewhere.
    pub data_files: Option<Vec<String>>,
    /// What follows the header.
    pub rest: &'a [u8],
}

/// Axes of the most complex files that are read: three of space and a few of size 1.
const MAX_AXES: usize = 16;

impl<'a> NrrdHeader<'a> {
    /// Reads the header.
    ///
    /// # Errors
    /// If a field that must be there is missing, or says what cannot be or is not read.
    pub(super) fn read(bytes: &'a [u8]) -> Result<Self, ReadImageError> {
        let mut lines = HeaderLines::new(bytes);
        lines.next();
        let (mut fields, mut keys) = (BTreeMap::new(), BTreeMap::new());
        let mut listed = None;
        while let Some((line, text)) = lines.next() {
            if text.is_empty() {
                break;
            }
            if text.starts_with('#') {
                continue;
            }
            // Which of the two separators comes first decides.
            let Some((name, value)) = text.split_once(':') else {
                return Err(ReadImageError::AtLine {
                    line,
                    reason: "neither a field nor a key nor a comment".to_owned(),
                });
            };
            if let Some(value) = value.strip_prefix('=') {
                keys.insert(name.trim().to_ascii_lowercase(), value.trim().to_owned());
                continue;
            }
            let (name, value) = (plain_name(name), value.trim().to_owned());
            let is_list = name == "datafile" && value.split_whitespace().next() == Some("LIST");
            fields.insert(name, Field { line, value });
            if is_list {
                let names = lines.by_ref().map(|(_, name)| name.trim().to_owned());
                listed = Some(names.filter(|name| !name.is_empty()).collect());
            }
        }
        let field = |name| required(&fields, name);
        let (kind, encoding) = (field("type")?, field("encoding")?);
        let sizes = sizes(field("dimension")?, field("sizes")?)?;
        let data_files = match (listed, fields.get("datafile")) {
            (None, Some(field)) => Some(data_files(field)?),
            (listed, _) => listed,
        };
        Ok(Self {
            sizes,
            scalar: scalar(kind)?,
            encoding: self::encoding(encoding)?,
            data_files,
            rest: lines.rest(),
            fields,
            keys,
        })
    }

    /// A field by its name in small letters, without spaces.
    pub(super) fn field(&self, name: &str) -> Option<&Field> {
        self.fields.get(name)
    }

    /// A key by its name in small letters.
    pub(super) fn key(&self, name: &str) -> Option<&str> {
        self.keys.get(name).map(String::as_str)
    }

    /// The byte order, which values of more than one byte must have.
    ///
    /// # Errors
    /// If it is missing or unknown.
    pub(super) fn order(&self) -> Result<ByteOrder, ReadImageError> {
        if self.scalar.size() == 1 || self.encoding == Encoding::Text {
            return Ok(ByteOrder::Little);
        }
        let field = required(&self.fields, "endian")?;
        match field.value.to_ascii_lowercase().as_str() {
            "little" => Ok(ByteOrder::Little),
            "big" => Ok(ByteOrder::Big),
            other => Err(ReadImageError::AtLine {
                line: field.line,
                reason: format!("endian: {} is no byte order", quoted(other)),
            }),
        }
    }

    /// A field that is one whole number, or 0 if it is not there.
    ///
    /// # Errors
    /// If it is none.
    pub(super) fn whole(&self, name: &str) -> Result<i64, ReadImageError> {
        let Some(field) = self.field(name) else {
            return Ok(0);
        };
        number(&field.value, name, field.line)
    }
}

/// `line skip` and `lineskip` are one name, as `centers` and `centerings`.
fn plain_name(name: &str) -> String {
    let letters = name.chars().filter(|c| !c.is_whitespace());
    letters.collect::<String>().to_ascii_lowercase()
}

fn required<'f>(
    fields: &'f BTreeMap<String, Field>,
    name: &'static str,
) -> Result<&'f Field, ReadImageError> {
    fields.get(name).ok_or(ReadImageError::InField {
        field: name,
        reason: "missing from the header".to_owned(),
    })
}

fn sizes(dimension: &Field, sizes: &Field) -> Result<Vec<usize>, ReadImageError> {
    let count: usize = number(&dimension.value, "dimension", dimension.line)?;
    let words: Vec<&str> = sizes.value.split_whitespace().collect();
    if words.len() != count || count > MAX_AXES {
        return Err(ReadImageError::AtLine {
            line: sizes.line,
            reason: format!("{} sizes for {count} axes", words.len()),
        });
    }
    let size = |word: &&str| number(word, "sizes", sizes.line);
    words.iter().map(size).collect()
}

fn scalar(field: &Field) -> Result<Scalar, ReadImageError> {
    let words: Vec<&str> = field.value.split_whitespace().collect();
    let name = words.join(" ").to_ascii_lowercase();
    Ok(match name.as_str() {
        "signed char" | "int8" | "int8_t" => Scalar::I8,
        "uchar" | "unsigned char" | "uint8" | "uint8_t" => Scalar::U8,
        "short" | "short int" | "signed short" | "signed short int" | "int16" | "int16_t" => {
            Scalar::I16
        }
        "ushort" | "unsigned short" | "unsigned short int" | "uint16" | "uint16_t" => Scalar::U16,
        "int" | "signed int" | "int32" | "int32_t" => Scalar::I32,
        "uint" | "unsigned int" | "uint32" | "uint32_t" => Scalar::U32,
        "longlong"
        | "long long"
        | "long long int"
        | "signed long long"
        | "signed long long int"
        | "int64"
        | "int64_t" => Scalar::I64,
        "ulonglong" | "unsigned long long" | "unsigned long long int" | "uint64" | "uint64_t" => {
            Scalar::U64
        }
        "float" => Scalar::F32,
        "double" => Scalar::F64,
        _ => {
            return Err(ReadImageError::AtLine {
                line: field.line,
                reason: format!("type: {} is no type of numbers that is read", quoted(&name)),
            });
        }
    })
}

fn encoding(field: &Field) -> Result<Encoding, ReadImageError> {
    let name = field.value.to_ascii_lowercase();
    Ok(match name.as_str() {
        "raw" => Encoding::Raw,
        "gz" | "gzip" => Encoding::Gzip,
        "txt" | "text" | "ascii" => Encoding::Text,
        "bz2" | "bzip2" | "hex" | "zrl" | "zstd" => {
            return Err(ReadImageError::Unsupported(format!(
                "values are packed as {name}, which is not read: save it as raw or gzip"
            )));
        }
        _ => {
            return Err(ReadImageError::AtLine {
                line: field.line,
                reason: format!("encoding: {} is none that is read", quoted(&name)),
            });
        }
    })
}

/// `name`, or `pattern first last step [axes a file]`.
fn data_files(field: &Field) -> Result<Vec<String>, ReadImageError> {
    let words: Vec<&str> = field.value.split_whitespace().collect();
    if let [pattern, first, last, step, ..] = words[..]
        && pattern.contains('%')
        && words.len() <= 5
    {
        let whole = |word: &str| number(word, "data file", field.line);
        return names_by_pattern(
            pattern,
            [whole(first)?, whole(last)?, whole(step)?],
            "data file",
        );
    }
    Ok(vec![field.value.clone()])
}

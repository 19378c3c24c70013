//! The text header of MetaImage: lines `Key = value`, of which `ElementDataFile` is the last.
//!
//! Source: "MetaIO documentation", Insight Toolkit. Free text (`Comment`, `Name`, `AcquisitionDate`) is never read.

use std::collections::BTreeMap;

use crate::io::ReadImageError;
use crate::io::binary_cursor::{ByteOrder, Scalar};
use crate::io::data_files::names_by_pattern;
use crate::io::image_file::Modality;
use crate::io::image_source::{HeaderLines, number, quoted};

/// Keys that may come first.
const FIRST_KEYS: [&str; 5] = ["objecttype", "ndims", "comment", "objectsubtype", "name"];

/// Whether bytes begin as MetaImage does: the first line has a key that may come first, and one soon says the number of axes.
pub(in crate::io) fn recognises(head: &[u8]) -> bool {
    let key = |text: &str| Some(text.split_once('=')?.0.trim().to_ascii_lowercase());
    let mut lines = HeaderLines::new(head).map(|(_, text)| key(&text));
    let Some(Some(first)) = lines.next() else {
        return false;
    };
    FIRST_KEYS.contains(&first.as_str())
        && (first == "ndims" || lines.any(|key| key.as_deref() == Some("ndims")))
}

/// Where the values are.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum DataPlace {
    /// After the header.
    Local,
    /// In one file or several.
    Files(Vec<String>),
}

/// A header, and what follows it.
#[derive(Debug)]
pub(super) struct MetaHeader<'a> {
    fields: BTreeMap<String, (usize, String)>,
    pub sizes: Vec<usize>,
    pub scalar: Scalar,
    pub place: DataPlace,
    pub rest: &'a [u8],
}

/// More axes than any image has that is read.
const MAX_AXES: usize = 16;

impl<'a> MetaHeader<'a> {
    /// Reads the header.
    ///
    /// # Errors
    /// If a field that must be there is missing, or says what cannot be or is not read.
    pub(super) fn read(bytes: &'a [u8]) -> Result<Self, ReadImageError> {
        let mut lines = HeaderLines::new(bytes);
        let mut fields = BTreeMap::new();
        let mut place = None;
        while let Some((line, text)) = lines.next() {
            let Some((key, value)) = text.split_once('=') else {
                if text.trim().is_empty() {
                    continue;
                }
                return Err(ReadImageError::AtLine {
                    line,
                    reason: "no key with a value".to_owned(),
                });
            };
            let (key, value) = (key.trim().to_ascii_lowercase(), value.trim().to_owned());
            if key == "elementdatafile" {
                place = Some(data_place(&value, line, &mut lines)?);
                break;
            }
            fields.insert(key, (line, value));
        }
        let place = place.ok_or(missing("ElementDataFile"))?;
        let mut header = Self {
            fields,
            sizes: Vec::new(),
            scalar: Scalar::U8,
            place,
            rest: lines.rest(),
        };
        header.refuse_what_is_not_read()?;
        let count: usize = header.one("NDims")?.ok_or(missing("NDims"))?;
        if count > MAX_AXES {
            return Err(ReadImageError::InField {
                field: "NDims",
                reason: format!("{count} axes"),
            });
        }
        header.sizes = header.list("DimSize", count)?.ok_or(missing("DimSize"))?;
        header.scalar = header.scalar()?;
        Ok(header)
    }

    fn text(&self, key: &'static str) -> Option<&(usize, String)> {
        self.fields.get(&key.to_ascii_lowercase())
    }

    /// A field of one number.
    ///
    /// # Errors
    /// If it is none.
    pub(super) fn one<T: std::str::FromStr>(
        &self,
        key: &'static str,
    ) -> Result<Option<T>, ReadImageError> {
        let field = self.text(key);
        field
            .map(|(line, value)| number(value, key, *line))
            .transpose()
    }

    /// A field of `count` numbers.
    ///
    /// # Errors
    /// If one is none, or there are more or fewer.
    pub(super) fn list<T: std::str::FromStr>(
        &self,
        key: &'static str,
        count: usize,
    ) -> Result<Option<Vec<T>>, ReadImageError> {
        let Some((line, value)) = self.text(key) else {
            return Ok(None);
        };
        let words: Vec<&str> = value.split_whitespace().collect();
        if words.len() != count {
            return Err(ReadImageError::AtLine {
                line: *line,
                reason: format!("{key}: {} numbers, not {count}", words.len()),
            });
        }
        words
            .iter()
            .map(|word| number(word, key, *line))
            .collect::<Result<_, _>>()
            .map(Some)
    }

    /// A field that is true or false, as MetaIO reads it: by the first letter.
    pub(super) fn flag(&self, key: &'static str) -> Option<bool> {
        let first = self.text(key)?.1.bytes().next()?;
        Some(matches!(first, b'T' | b't' | b'1' | b'Y' | b'y'))
    }

    /// The byte order, if the header says it.
    pub(super) fn order(&self) -> Option<ByteOrder> {
        let keys = ["BinaryDataByteOrderMSB", "ElementByteOrderMSB"];
        let big = keys.into_iter().find_map(|key| self.flag(key))?;
        Some(if big {
            ByteOrder::Big
        } else {
            ByteOrder::Little
        })
    }

    /// The kind of machine, if the header says it.
    pub(super) fn modality(&self) -> Option<Modality> {
        Some(match self.text("Modality")?.1.as_str() {
            "MET_MOD_CT" => Modality::ComputedTomography,
            "MET_MOD_MR" => Modality::MagneticResonance,
            "MET_MOD_NM" => Modality::NuclearMedicine,
            "MET_MOD_US" => Modality::Ultrasound,
            "MET_MOD_PET" => Modality::PositronEmission,
            "MET_MOD_OTHER" => Modality::Other,
            _ => return None,
        })
    }

    /// Millimetres of the unit of length. MetaIO means millimetres where the header says none.
    pub(super) fn unit_mm(&self) -> f64 {
        match self
            .text("DistanceUnits")
            .map(|(_, unit)| unit.to_ascii_lowercase())
            .as_deref()
        {
            Some("um") => 1e-3,
            Some("cm") => 10.0,
            _ => 1.0,
        }
    }

    fn refuse_what_is_not_read(&self) -> Result<(), ReadImageError> {
        let refused = |what: String| Err(ReadImageError::Unsupported(what));
        if let Some((_, kind)) = self.text("ObjectType")
            && !kind.eq_ignore_ascii_case("image")
        {
            return refused(format!(
                "a MetaIO object that is no image ({})",
                quoted(kind)
            ));
        }
        match self.one::<u64>("ElementNumberOfChannels")? {
            Some(2..) => refused("holds several numbers a voxel, not one".to_owned()),
            _ => Ok(()),
        }
    }

    fn scalar(&self) -> Result<Scalar, ReadImageError> {
        let (line, name) = self.text("ElementType").ok_or(missing("ElementType"))?;
        let plain = name.to_ascii_uppercase();
        Ok(match plain.as_str() {
            "MET_CHAR" => Scalar::I8,
            "MET_UCHAR" | "MET_ASCII_CHAR" => Scalar::U8,
            "MET_SHORT" => Scalar::I16,
            "MET_USHORT" => Scalar::U16,
            // MetaIO writes `long` with four bytes on every machine.
            "MET_INT" | "MET_LONG" => Scalar::I32,
            "MET_UINT" | "MET_ULONG" => Scalar::U32,
            "MET_LONG_LONG" => Scalar::I64,
            "MET_ULONG_LONG" => Scalar::U64,
            "MET_FLOAT" => Scalar::F32,
            "MET_DOUBLE" => Scalar::F64,
            _ if plain.ends_with("_ARRAY") || plain.ends_with("_MATRIX") => {
                let what = "holds several numbers a voxel, not one".to_owned();
                return Err(ReadImageError::Unsupported(what));
            }
            _ => {
                return Err(ReadImageError::AtLine {
                    line: *line,
                    reason: format!("ElementType: {} is no type of numbers", quoted(name)),
                });
            }
        })
    }
}

fn missing(field: &'static str) -> ReadImageError {
    ReadImageError::InField {
        field,
        reason: "missing from the header".to_owned(),
    }
}

/// `LOCAL`, `LIST [axes a file]` with names in the lines that follow, `pattern first last step`, or a name.
fn data_place(
    value: &str,
    line: usize,
    lines: &mut HeaderLines<'_>,
) -> Result<DataPlace, ReadImageError> {
    let words: Vec<&str> = value.split_whitespace().collect();
    match words[..] {
        ["LOCAL" | "Local" | "local"] => Ok(DataPlace::Local),
        ["LIST", ..] => {
            let names = lines.map(|(_, name)| name.trim().to_owned());
            Ok(DataPlace::Files(
                names.filter(|name| !name.is_empty()).collect(),
            ))
        }
        [pattern, first, last, step] if pattern.contains('%') => {
            let whole = |word: &str| number(word, "ElementDataFile", line);
            let numbers = [whole(first)?, whole(last)?, whole(step)?];
            Ok(DataPlace::Files(names_by_pattern(
                pattern,
                numbers,
                "ElementDataFile",
            )?))
        }
        [] => Err(missing("ElementDataFile")),
        _ => Ok(DataPlace::Files(vec![value.to_owned()])),
    }
}

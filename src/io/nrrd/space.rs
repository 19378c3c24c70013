//! The world of an NRRD file: which way its coordinates grow in the patient.

use super::header::NrrdHeader;
use crate::io::ReadImageError;
use crate::io::image_source::quoted;
use crate::mesh::Vector3;

/// The world of the file.
pub(super) struct Space {
    /// For each of its first three coordinates: the axis of LPS and the sign; `None` if it is not that of the patient.
    pub(super) to_lps: Option<[(usize, f64); 3]>,
    /// How many coordinates it has: 3, or 4 with time.
    pub(super) coordinates: usize,
}

impl Space {
    /// By the field `space` or `space dimension`.
    ///
    /// # Errors
    /// If it is no space of a volume.
    pub(super) fn of(header: &NrrdHeader<'_>) -> Result<Self, ReadImageError> {
        let Some(field) = header.field("space") else {
            let coordinates = header.whole("spacedimension")?;
            return match (header.field("spacedimension"), coordinates) {
                (None, _) | (_, 3 | 4) => Ok(Self {
                    to_lps: None,
                    coordinates: if coordinates == 4 { 4 } else { 3 },
                }),
                (Some(field), _) => Err(ReadImageError::AtLine {
                    line: field.line,
                    reason: "space dimension: not that of a volume".to_owned(),
                }),
            };
        };
        let name = field.value.to_ascii_lowercase();
        let (plain, timed) = match name.strip_suffix("-time") {
            Some(plain) => (plain, true),
            None if name.len() == 4 && name.ends_with('t') => (&name[..3], true),
            None => (name.as_str(), false),
        };
        let coordinates = if timed { 4 } else { 3 };
        if ["scanner-xyz", "3d-right-handed", "3d-left-handed"].contains(&plain) {
            return Ok(Self {
                to_lps: None,
                coordinates,
            });
        }
        match anatomical(plain) {
            Some(to_lps) => Ok(Self {
                to_lps: Some(to_lps),
                coordinates,
            }),
            None => Err(ReadImageError::AtLine {
                line: field.line,
                reason: format!("space: {} is no world that is known", quoted(&name)),
            }),
        }
    }

    /// A vector of the file in LPS millimetres; `unit_mm` is the unit of each coordinate.
    pub(super) fn to_lps(&self, coordinates: &[f64], unit_mm: [f64; 3]) -> Vector3 {
        let mut vector = Vector3::zeros();
        let straight = [(0, 1.0), (1, 1.0), (2, 1.0)];
        let turned = self.to_lps.unwrap_or(straight);
        for ((axis, sign), (coordinate, unit)) in
            turned.into_iter().zip(coordinates.iter().zip(unit_mm))
        {
            vector[axis] = sign * coordinate * unit;
        }
        vector
    }
}

/// `right-anterior-superior` or `ras`, in any order and with any signs.
fn anatomical(name: &str) -> Option<[(usize, f64); 3]> {
    let words: Vec<&str> = if name.contains('-') {
        name.split('-').collect()
    } else {
        name.split("").filter(|letter| !letter.is_empty()).collect()
    };
    let axis = |word: &str| match word {
        "left" | "l" => Some((0, 1.0)),
        "right" | "r" => Some((0, -1.0)),
        "posterior" | "p" => Some((1, 1.0)),
        "anterior" | "a" => Some((1, -1.0)),
        "superior" | "s" => Some((2, 1.0)),
        "inferior" | "i" => Some((2, -1.0)),
        _ => None,
    };
    let axes: Vec<(usize, f64)> = words.into_iter().map(axis).collect::<Option<_>>()?;
    let axes: [(usize, f64); 3] = axes.try_into().ok()?;
    (0..3)
        .all(|own| axes.iter().any(|(axis, _)| *axis == own))
        .then_some(axes)
}

//! The values of NRRD fields: lists of vectors, of numbers, of words between quotes, and units.

use super::header::{Field, NrrdHeader};
use crate::io::ReadImageError;
use crate::io::image_source::{number, quoted};

/// One entry of a list of vectors.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Entry {
    /// `none`.
    None,
    /// `(1,2.5,0)`.
    Vector(Vec<f64>),
}

/// A list such as `(1,0,0) (0,1,0) none`.
///
/// # Errors
/// If it holds something else.
pub(super) fn entries(field: &Field, name: &'static str) -> Result<Vec<Entry>, ReadImageError> {
    let mut found = Vec::new();
    let mut rest = field.value.trim_start();
    while !rest.is_empty() {
        if let Some(inside) = rest.strip_prefix('(') {
            let Some((numbers, after)) = inside.split_once(')') else {
                return Err(ReadImageError::AtLine {
                    line: field.line,
                    reason: format!("{name}: a vector does not end"),
                });
            };
            let numbers = numbers
                .split(',')
                .map(|word| number(word.trim(), name, field.line));
            found.push(Entry::Vector(numbers.collect::<Result<_, _>>()?));
            rest = after.trim_start();
        } else {
            let end = rest
                .find(|c: char| c.is_whitespace() || c == '(')
                .unwrap_or(rest.len());
            let (word, after) = rest.split_at(end);
            if !word.eq_ignore_ascii_case("none") {
                return Err(ReadImageError::AtLine {
                    line: field.line,
                    reason: format!("{name}: {} is no vector", quoted(word)),
                });
            }
            found.push(Entry::None);
            rest = after.trim_start();
        }
    }
    Ok(found)
}

/// A field of numbers, one for each axis.
///
/// # Errors
/// If one is none, or there are more or fewer.
pub(super) fn numbers(
    header: &NrrdHeader<'_>,
    name: &'static str,
) -> Result<Option<Vec<f64>>, ReadImageError> {
    let Some(field) = header.field(name) else {
        return Ok(None);
    };
    let words = field.value.split_whitespace();
    let numbers: Vec<f64> = words
        .map(|word| number(word, name, field.line))
        .collect::<Result<_, _>>()?;
    if numbers.len() != header.sizes.len() {
        return Err(ReadImageError::AtLine {
            line: field.line,
            reason: format!("{} {name} for {} axes", numbers.len(), header.sizes.len()),
        });
    }
    Ok(Some(numbers))
}

/// Words between quotes, or parted by white space where there are none.
pub(super) fn quoted_words(text: &str) -> Vec<String> {
    if !text.contains('"') {
        return text.split_whitespace().map(str::to_owned).collect();
    }
    text.split('"')
        .skip(1)
        .step_by(2)
        .map(str::to_owned)
        .collect()
}

/// Millimetres of a unit of length.
pub(super) fn length_mm(unit: &str) -> Option<f64> {
    Some(match unit.trim().to_ascii_lowercase().as_str() {
        "mm" | "millimeter" | "millimetre" | "millimeters" | "millimetres" => 1.0,
        "cm" | "centimeter" | "centimetre" => 10.0,
        "m" | "meter" | "metre" | "meters" | "metres" => 1e3,
        "um" | "µm" | "μm" | "micron" | "microns" | "micrometer" | "micrometre" => 1e-3,
        _ => return None,
    })
}

/// Milliseconds of a unit of time.
pub(super) fn time_ms(unit: &str) -> Option<f64> {
    Some(match unit.trim().to_ascii_lowercase().as_str() {
        "ms" | "msec" | "millisecond" | "milliseconds" => 1.0,
        "s" | "sec" | "second" | "seconds" => 1e3,
        "us" | "µs" | "μs" | "usec" | "microsecond" | "microseconds" => 1e-3,
        "min" | "minute" | "minutes" => 6e4,
        _ => return None,
    })
}

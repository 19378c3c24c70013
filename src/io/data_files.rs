//! Values of an image that stand in one file or several beside its header: one file a slice, or a slab of them.

use std::io::Read;

use super::ReadImageError;
use super::image_source::ImageSource;
use super::limits::MAX_DATA_FILES;
use super::packed::Packing;

/// Names by a pattern such as `slice_%03d.raw`, for numbers from `first` to `last`.
///
/// # Errors
/// If the pattern has no place for a number or the numbers do not end.
pub(super) fn names_by_pattern(
    pattern: &str,
    [first, last, step]: [i64; 3],
    field: &'static str,
) -> Result<Vec<String>, ReadImageError> {
    let wrong = |reason: &str| ReadImageError::DataFile {
        field,
        reason: reason.to_owned(),
    };
    let (before, rest) = pattern
        .split_once('%')
        .ok_or(wrong("its pattern has no number"))?;
    let (digits, after) = rest
        .split_once('d')
        .ok_or(wrong("its pattern has no number"))?;
    if !digits.bytes().all(|byte| byte.is_ascii_digit()) || digits.len() > 3 || after.contains('%')
    {
        return Err(wrong("its pattern has no plain number"));
    }
    let width: usize = digits.parse().unwrap_or(0);
    let zeros = digits.starts_with('0');
    let towards = last.saturating_sub(first);
    if step == 0 || (towards != 0 && (towards > 0) != (step > 0)) {
        return Err(wrong("the numbers of its pattern do not end"));
    }
    let more = usize::try_from(towards / step).unwrap_or(usize::MAX);
    if more >= MAX_DATA_FILES {
        return Err(wrong("the numbers of its pattern are too many"));
    }
    let name = |k: usize| {
        let number = first.saturating_add(step.saturating_mul(k as i64));
        if zeros {
            format!("{before}{number:0width$}{after}")
        } else {
            format!("{before}{number:width$}{after}")
        }
    };
    Ok((0..=more).map(name).collect())
}

/// Where the values of a file begin, given its bytes and its share: at which of its bytes, and after how many unpacked ones.
pub(super) type Begin<'a> = dyn Fn(&[u8], u64) -> (usize, u64) + 'a;

/// The values of all files one after the other, unpacked; each holds the same share of `expected` bytes.
///
/// `begin` says where the values of a file begin, in its bytes as they are, and how many unpacked bytes are skipped then.
///
/// # Errors
/// If a file cannot be had, or has fewer bytes than its share.
pub(super) fn joined_files(
    source: &ImageSource<'_>,
    names: &[String],
    field: &'static str,
    packing: Packing,
    expected: u64,
    begin: &Begin<'_>,
) -> Result<Vec<u8>, ReadImageError> {
    let count = names.len() as u64;
    let wrong = |reason: String| ReadImageError::DataFile { field, reason };
    if count == 0 || count > MAX_DATA_FILES as u64 || !expected.is_multiple_of(count) {
        return Err(wrong(format!(
            "{count} files cannot share {expected} bytes of values"
        )));
    }
    let share = expected / count;
    let mut joined = Vec::new();
    for (index, name) in names.iter().enumerate() {
        let bytes = (source.sibling)(name)
            .map_err(|why| wrong(format!("file {} of {count}: {why}", index + 1)))?;
        let (at, skip) = begin(&bytes, share);
        let mut reader = packing.reader(bytes.get(at..).unwrap_or_default());
        let before = joined.len() as u64;
        let damaged = |_| wrong(format!("file {} of {count} cannot be unpacked", index + 1));
        std::io::copy(&mut (&mut reader).take(skip), &mut std::io::sink()).map_err(damaged)?;
        reader
            .take(share)
            .read_to_end(&mut joined)
            .map_err(damaged)?;
        let held = joined.len() as u64 - before;
        if held < share {
            return Err(wrong(format!(
                "file {} of {count} holds {held} bytes of values, not {share}",
                index + 1
            )));
        }
    }
    Ok(joined)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // A test that fails here says so.
mod tests {
    use super::*;
    use crate::io::Limits;

    #[test]
    fn a_pattern_gives_names_and_one_without_end_is_refused() {
        let names = |pattern, numbers| names_by_pattern(pattern, numbers, "data file");
        assert_eq!(
            names("s_%03d.raw", [8, 10, 1]).unwrap(),
            ["s_008.raw", "s_009.raw", "s_010.raw"]
        );
        assert_eq!(names("s%d", [3, -1, -2]).unwrap(), ["s3", "s1", "s-1"]);
        for (pattern, numbers) in [
            ("s_%d", [0, 5, 0]),
            ("s_%d", [0, 5, -1]),
            ("s_%d", [0, i64::MAX, 1]),
            ("s_%s", [0, 5, 1]),
            ("s_%99999d", [0, 5, 1]),
            ("none", [0, 5, 1]),
        ] {
            assert!(names(pattern, numbers).is_err(), "{pattern} {numbers:?}");
        }
    }

    #[test]
    fn files_are_joined_and_a_short_one_is_named_by_its_number() {
        let sibling = |name: &str| match name {
            "a" => Ok(b"hhAB".to_vec()),
            "b" => Ok(b"hhCD".to_vec()),
            _ => Err("there is no such file".to_owned()),
        };
        let source = ImageSource {
            name: "x.mhd",
            bytes: b"",
            limits: &Limits::default(),
            sibling: &sibling,
        };
        let join = |names: &[&str], expected| {
            let names: Vec<String> = names.iter().map(|name| (*name).to_owned()).collect();
            joined_files(
                &source,
                &names,
                "data file",
                Packing::Plain,
                expected,
                &|_, _| (2, 0),
            )
        };
        assert_eq!(join(&["a", "b"], 4).unwrap(), b"ABCD");
        let text = join(&["a", "b"], 6).unwrap_err().to_string();
        assert!(
            text.ends_with("file 1 of 2 holds 2 bytes of values, not 3"),
            "{text}"
        );
        assert!(
            join(&["a", "c"], 4)
                .unwrap_err()
                .to_string()
                .contains("file 2 of 2: there is no")
        );
        assert!(join(&["a", "b"], 5).is_err());
        assert!(join(&[], 0).is_err());
    }
}

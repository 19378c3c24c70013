//! The elements of a DICOM data set, as they stand in its bytes (PS3.5, chapter 7).
//!
//! Nothing is copied and nothing is allocated by a length that a file states: a value is a part of the bytes that are there.

use std::ops::Range;

use super::tag::{Kind, PIXEL_DATA, Tag};
use crate::io::limits::{MAX_DICOM_DEPTH, MAX_DICOM_ITEMS};

/// How elements are written.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Encoding {
    /// Whether each element says how its value is written.
    pub(super) explicit: bool,
    pub(super) big_endian: bool,
}

/// One element whose value was not looked into.
#[derive(Clone, Copy, Debug)]
pub(super) struct Element<'a> {
    pub(super) tag: Tag,
    /// The letters of the representation, if the file says them.
    pub(super) letters: Option<[u8; 2]>,
    pub(super) value: &'a [u8],
    /// Whether the value has no stated length: items up to a delimiter.
    pub(super) delimited: bool,
    /// Whether fewer bytes are there than the length says.
    pub(super) cut: bool,
}

/// The elements of one level.
#[derive(Clone, Debug)]
pub(super) struct DataSet<'a> {
    elements: Vec<Element<'a>>,
    encoding: Encoding,
}

/// The length that says "up to the delimiter".
const UNDEFINED: u32 = u32::MAX;
/// Group of the tags that begin and end items.
const DELIMITERS: u16 = 0xfffe;

impl Encoding {
    fn u16(self, bytes: &[u8], at: usize) -> Option<u16> {
        let bytes = bytes.get(at..)?.first_chunk()?;
        Some(match self.big_endian {
            true => u16::from_be_bytes(*bytes),
            false => u16::from_le_bytes(*bytes),
        })
    }

    fn u32(self, bytes: &[u8], at: usize) -> Option<u32> {
        let bytes = bytes.get(at..)?.first_chunk()?;
        Some(match self.big_endian {
            true => u32::from_be_bytes(*bytes),
            false => u32::from_le_bytes(*bytes),
        })
    }

    pub(super) fn tag(self, bytes: &[u8], at: usize) -> Option<Tag> {
        Some(Tag(self.u16(bytes, at)?, self.u16(bytes, at + 2)?))
    }

    /// Tag, letters, place of the value and its stated length, of the element at a byte.
    fn head(self, bytes: &[u8], at: usize) -> Option<(Tag, Option<[u8; 2]>, usize, u32)> {
        let tag = self.tag(bytes, at)?;
        let letters: Option<[u8; 2]> = bytes.get(at + 4..at + 6)?.try_into().ok();
        let spelled = letters.filter(|l| self.explicit && l.iter().all(u8::is_ascii_uppercase));
        let Some(letters) = spelled.filter(|_| tag.0 != DELIMITERS) else {
            // Also for a single element without letters in a file that otherwise has them: such files exist.
            return Some((tag, None, at + 8, self.u32(bytes, at + 4)?));
        };
        let long = match &letters {
            b"OB" | b"OW" | b"OF" | b"OD" | b"OL" | b"OV" | b"SQ" | b"UT" | b"UN" | b"UC"
            | b"UR" | b"SV" | b"UV" => true,
            b"AE" | b"AS" | b"AT" | b"CS" | b"DA" | b"DS" | b"DT" | b"FD" | b"FL" | b"IS"
            | b"LO" | b"LT" | b"PN" | b"SH" | b"SL" | b"SS" | b"ST" | b"TM" | b"UI" | b"UL"
            | b"US" => false,
            // Those to come are written the long way (PS3.5, 6.2), whose two spare bytes are zero.
            _ => bytes.get(at + 6..at + 8)? == [0, 0],
        };
        Some(match long {
            true => (tag, Some(letters), at + 12, self.u32(bytes, at + 8)?),
            false => (
                tag,
                Some(letters),
                at + 8,
                u32::from(self.u16(bytes, at + 6)?),
            ),
        })
    }

    /// How the items of a sequence of unknown representation are written: always implicit (PS3.5, 6.2.2, note 2).
    fn within(self, letters: Option<[u8; 2]>) -> Self {
        match letters {
            Some([b'U', b'N']) => Self {
                explicit: false,
                big_endian: false,
            },
            _ => self,
        }
    }

    /// Where the delimiter of a value without stated length begins; `None` if there is none.
    fn delimiter_of_items(self, bytes: &[u8], mut at: usize, depth: usize) -> Option<usize> {
        if depth > MAX_DICOM_DEPTH {
            return None;
        }
        loop {
            let (tag, _, value, length) = self.head(bytes, at)?;
            match tag {
                Tag(DELIMITERS, 0xe0dd) => return Some(at),
                Tag(DELIMITERS, 0xe000) if length == UNDEFINED => {
                    at = self.delimiter_of_elements(bytes, value, depth + 1)? + 8;
                }
                Tag(DELIMITERS, 0xe000) => at = value.checked_add(length as usize)?,
                _ => return None,
            }
        }
    }

    /// Where the delimiter of an item without stated length begins.
    fn delimiter_of_elements(self, bytes: &[u8], mut at: usize, depth: usize) -> Option<usize> {
        if depth > MAX_DICOM_DEPTH {
            return None;
        }
        loop {
            let (tag, letters, value, length) = self.head(bytes, at)?;
            at = match tag {
                Tag(DELIMITERS, 0xe00d) => return Some(at),
                _ if length == UNDEFINED => {
                    let within = self.within(letters);
                    within.delimiter_of_items(bytes, value, depth + 1)? + 8
                }
                _ => value.checked_add(length as usize)?,
            };
        }
    }
}

impl<'a> DataSet<'a> {
    /// The elements of `bytes`, as far as they are sound.
    pub(super) fn new(bytes: &'a [u8], encoding: Encoding) -> Self {
        let mut elements: Vec<Element> = Vec::new();
        let mut at = 0;
        while elements.len() < MAX_DICOM_ITEMS {
            let Some((tag, letters, value, length)) = encoding.head(bytes, at) else {
                break;
            };
            let rest = bytes.get(value..).unwrap_or_default();
            let delimited = length == UNDEFINED;
            let (stated, skip) = if delimited {
                let within = encoding.within(letters);
                match within.delimiter_of_items(bytes, value, 0) {
                    Some(end) => (end - value, 8),
                    None => (usize::MAX, 0),
                }
            } else {
                (length as usize, 0)
            };
            let present = stated.min(rest.len());
            let cut = present < stated;
            // Of values that are cut short only pixels are of use: how many are missing is told there.
            if tag.0 != DELIMITERS && (!cut || tag == PIXEL_DATA) {
                elements.push(Element {
                    tag,
                    letters,
                    value: rest.get(..present).unwrap_or_default(),
                    delimited,
                    cut,
                });
            }
            if cut {
                break;
            }
            at = value + present + skip;
        }
        // They should be in order; the first of two with one tag counts.
        elements.sort_by_key(|element| element.tag);
        Self { elements, encoding }
    }

    /// The tag of the element at the head of `bytes`, and where its value stands; `None` if it is not all there.
    pub(super) fn first(bytes: &[u8], encoding: Encoding) -> Option<(Tag, Range<usize>)> {
        let (tag, _, value, length) = encoding.head(bytes, 0)?;
        let end = value.checked_add(length as usize)?;
        (end <= bytes.len()).then_some((tag, value..end))
    }

    /// The first element of a tag.
    pub(super) fn element(&self, tag: Tag) -> Option<&Element<'a>> {
        let place = self.elements.partition_point(|element| element.tag < tag);
        self.elements
            .get(place)
            .filter(|element| element.tag == tag)
    }

    /// Whether there is a value.
    pub(super) fn has(&self, tag: Tag) -> bool {
        self.element(tag).is_some_and(|e| !e.value.is_empty())
    }

    /// The items of a sequence; none if it is absent.
    pub(super) fn items(&self, tag: Tag) -> Vec<DataSet<'a>> {
        let Some(element) = self.element(tag) else {
            return Vec::new();
        };
        let encoding = self.encoding.within(element.letters);
        let items = Items::new(element.value, encoding);
        items
            .filter_map(|item| element.value.get(item.value))
            .map(|item| DataSet::new(item, encoding))
            .collect()
    }

    /// The first item of a sequence.
    pub(super) fn item(&self, tag: Tag) -> Option<DataSet<'a>> {
        let element = self.element(tag)?;
        let encoding = self.encoding.within(element.letters);
        let item = Items::new(element.value, encoding).next()?;
        Some(DataSet::new(element.value.get(item.value)?, encoding))
    }

    /// A text of ASCII letters without the blanks around it; `None` if it is empty.
    pub(super) fn text(&self, tag: Tag) -> Option<&'a str> {
        let text = std::str::from_utf8(self.element(tag)?.value).ok()?;
        let text = text.trim_matches([' ', '\0']);
        (!text.is_empty() && text.is_ascii()).then_some(text)
    }

    /// The words of a text.
    pub(super) fn words(&self, tag: Tag) -> Vec<&'a str> {
        let text = self.text(tag).unwrap_or_default();
        text.split('\\').map(str::trim).collect()
    }

    /// The numbers of an element, whatever their representation; `None` where one of them is none.
    pub(super) fn numbers(&self, tag: Tag) -> Option<Vec<f64>> {
        let element = self.element(tag).filter(|e| !e.value.is_empty())?;
        let kind = match element.letters {
            None | Some([b'U', b'N'] | [b'O', b'W']) => Kind::implied(tag),
            Some(letters) => Kind::of_letters(letters),
        };
        let big = self.encoding.within(element.letters).big_endian;
        let value = element.value;
        macro_rules! each {
            ($type:ty, $size:literal) => {
                (value.as_chunks::<$size>().0.iter())
                    .map(|bytes| match big {
                        true => f64::from(<$type>::from_be_bytes(*bytes)),
                        false => f64::from(<$type>::from_le_bytes(*bytes)),
                    })
                    .collect()
            };
        }
        let numbers: Vec<f64> = match kind {
            Kind::U16 => each!(u16, 2),
            Kind::I16 => each!(i16, 2),
            Kind::U32 => each!(u32, 4),
            Kind::I32 => each!(i32, 4),
            Kind::F32 => each!(f32, 4),
            Kind::F64 => each!(f64, 8),
            Kind::Text => {
                let words = self.text(tag)?.split('\\');
                let numbers = words.map(|word| word.trim().parse().ok());
                numbers.collect::<Option<Vec<f64>>>()?
            }
            Kind::Tags | Kind::Bytes => return None,
        };
        (!numbers.is_empty() && numbers.iter().all(|x| x.is_finite())).then_some(numbers)
    }

    /// The first number of an element.
    pub(super) fn number(&self, tag: Tag) -> Option<f64> {
        self.numbers(tag)?.first().copied()
    }

    /// The first number of an element if it is a whole one that is not negative.
    pub(super) fn count(&self, tag: Tag) -> Option<usize> {
        let number = self.number(tag)?;
        (number >= 0.0 && number.fract() == 0.0 && number <= f64::from(u32::MAX))
            .then_some(number as usize)
    }

    /// The pairs of numbers of an element that names tags.
    pub(super) fn named_tags(&self, tag: Tag) -> Vec<Tag> {
        let value = self.element(tag).map_or(&[][..], |e| e.value);
        let places = (0..value.len() / 4).map(|n| 4 * n);
        places
            .filter_map(|at| self.encoding.tag(value, at))
            .collect()
    }
}

/// Where an item stands in the value of its sequence.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Item {
    /// Where its tag begins.
    pub(super) begin: usize,
    /// The bytes of its value that are there.
    pub(super) value: Range<usize>,
}

/// The items of a sequence, or the fragments of packed pixels.
#[derive(Clone, Debug)]
pub(super) struct Items<'a> {
    bytes: &'a [u8],
    encoding: Encoding,
    at: usize,
    left: usize,
}

impl<'a> Items<'a> {
    pub(super) fn new(bytes: &'a [u8], encoding: Encoding) -> Self {
        Self {
            bytes,
            encoding,
            at: 0,
            left: MAX_DICOM_ITEMS,
        }
    }
}

impl Iterator for Items<'_> {
    type Item = Item;

    fn next(&mut self) -> Option<Item> {
        self.left = self.left.checked_sub(1)?;
        let begin = self.at;
        let (tag, _, value, length) = self.encoding.head(self.bytes, begin)?;
        if tag != Tag(DELIMITERS, 0xe000) {
            return None;
        }
        let end = if length == UNDEFINED {
            let end = self.encoding.delimiter_of_elements(self.bytes, value, 0);
            let end = end.unwrap_or(self.bytes.len());
            self.at = end + 8;
            end
        } else {
            let end = value.saturating_add(length as usize).min(self.bytes.len());
            self.at = end;
            end
        };
        Some(Item {
            begin,
            value: value..end.max(value),
        })
    }
}

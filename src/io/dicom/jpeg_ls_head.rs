//! The head of a JPEG-LS stream (ITU-T T.87, annex C).

/// What a stream says of itself.
#[derive(Clone, Copy, Debug)]
pub(super) struct JpegLsHead {
    /// Columns, rows.
    pub(super) size: [usize; 2],
    pub(super) components: u8,
    /// Greatest difference of a sample from what was packed: NEAR.
    pub(super) near: i32,
    pub(super) presets: Presets,
    /// Where the bits of the scan begin.
    pub(super) scan: usize,
}

/// Parameters that a stream may set (C.2.4.1.1).
#[derive(Clone, Copy, Debug)]
pub(super) struct Presets {
    /// The greatest sample: MAXVAL.
    pub(super) greatest: i32,
    /// Thresholds of gradients: T1, T2, T3.
    pub(super) thresholds: [i32; 3],
    /// Count at which what was learned is halved: RESET.
    pub(super) reset: i32,
}

impl JpegLsHead {
    /// That of a stream of one scan; `None` if it is damaged or has tables, restarts or several scans.
    pub(super) fn new(bytes: &[u8]) -> Option<Self> {
        let word = |at: usize| {
            let bytes = bytes.get(at..)?.first_chunk()?;
            Some(i32::from(u16::from_be_bytes(*bytes)))
        };
        let (mut frame, mut stated) = (None, [0; 5]);
        let mut at = 2;
        loop {
            let (marker, length) = (word(at)?, word(at + 2)? as usize);
            let place = at + 4;
            match marker {
                0xfff7 => {
                    let bits = *bytes.get(place)?;
                    let size = [word(place + 3)? as usize, word(place + 1)? as usize];
                    frame = Some((u32::from(bits), size, *bytes.get(place + 5)?));
                }
                0xfff8 if bytes.get(place) == Some(&1) => {
                    for (n, value) in stated.iter_mut().enumerate() {
                        *value = word(place + 1 + 2 * n)?;
                    }
                }
                // Tables of values and sizes beyond 16 bits.
                0xfff8 => return None,
                0xffdd if word(place)? != 0 => return None,
                0xffda => {
                    let (bits, size, components) = frame?;
                    let scanned = usize::from(*bytes.get(place)?);
                    let parameters = place + 1 + 2 * scanned;
                    let near = i32::from(*bytes.get(parameters)?);
                    let presets = Presets::new(bits, near, stated)?;
                    return Some(Self {
                        size,
                        components,
                        near,
                        presets,
                        scan: place.checked_add(length.checked_sub(2)?)?,
                    });
                }
                0xffd8..=0xffd9 => return None,
                0xff01..=0xfffe => {}
                _ => return None,
            }
            at = (at + 2).checked_add(length)?;
        }
    }
}

impl Presets {
    /// The stated ones; where 0 is stated, those that follow from the depth (C.2.4.1.1.1).
    fn new(bits: u32, near: i32, [greatest, t1, t2, t3, reset]: [i32; 5]) -> Option<Self> {
        if !(2..=16).contains(&bits) {
            return None;
        }
        let all = (1 << bits) - 1;
        let greatest = if greatest == 0 { all } else { greatest };
        if greatest > all || near > greatest / 2 {
            return None;
        }
        let clamp = |value: i32, low: i32| match value > greatest || value < low {
            true => low,
            false => value,
        };
        let basic = |basic: i32, less: i32, times: i32| {
            if greatest >= 128 {
                let factor = (greatest.min(4095) + 128) / 256;
                factor * (basic - less) + less + times * near
            } else {
                let factor = 256 / (greatest + 1);
                less.max(basic / factor + times * near)
            }
        };
        let or = |stated: i32, else_one: i32| if stated == 0 { else_one } else { stated };
        let first = or(t1, clamp(basic(3, 2, 3), near + 1));
        let second = or(t2, clamp(basic(7, 3, 5), first));
        let third = or(t3, clamp(basic(21, 4, 7), second));
        let ordered = near < first && first <= second && second <= third && third <= greatest;
        let reset = or(reset, 64);
        (ordered && reset >= 3).then_some(Self {
            greatest,
            thresholds: [first, second, third],
            reset,
        })
    }
}

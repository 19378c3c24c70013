//! Counts and frame numbers as words of a sentence.

/// `1 triangle`, `12 triangles`, `1,204 triangles`.
pub fn counted(count: usize, singular: &str, plural: &str) -> String {
    let word = if count == 1 { singular } else { plural };
    format!("{} {word}", with_thousands(count))
}

/// `frame 3`, `frames 0–4, 7`, `both frames`, `all 25 frames`; empty for a still subject, of which there is no
/// other frame to tell it from.
///
/// `frames` are ascending and below `frame_count`.
pub fn frames_phrase(frames: &[usize], frame_count: usize) -> String {
    if frame_count == 1 {
        return String::new();
    }
    if frames.len() == frame_count {
        return all_of(frame_count, "frames");
    }
    let runs: Vec<String> = frames
        .chunk_by(|a, b| a + 1 == *b)
        .map(|run| match run {
            [] => String::new(),
            [one] => one.to_string(),
            [first, second] => format!("{first}, {second}"),
            [first, .., last] => format!("{first}–{last}"),
        })
        .collect();
    let word = if frames.len() == 1 { "frame" } else { "frames" };
    format!("{word} {}", runs.join(", "))
}

/// `both subjects`, `all 20 subjects`.
pub fn all_of(count: usize, plural: &str) -> String {
    if count == 2 {
        format!("both {plural}")
    } else {
        format!("all {} {plural}", with_thousands(count))
    }
}

/// `endocardium` or `endocardium, frames 0–4`: what a sentence is about.
pub(super) fn about(surface: &str, frames: &[usize], frame_count: usize) -> String {
    let phrase = frames_phrase(frames, frame_count);
    if phrase.is_empty() {
        surface.to_owned()
    } else {
        format!("{surface}, {phrase}")
    }
}

fn with_thousands(count: usize) -> String {
    let digits = count.to_string();
    let mut text = String::with_capacity(digits.len() + digits.len() / 3);
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && (digits.len() - place).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_are_named_as_runs() {
        assert_eq!(frames_phrase(&[0, 1, 2, 7], 25), "frames 0–2, 7");
        assert_eq!(frames_phrase(&[3], 25), "frame 3");
        assert_eq!(frames_phrase(&[3, 4], 25), "frames 3, 4");
        assert_eq!(frames_phrase(&[0, 1], 2), "both frames");
        assert_eq!(frames_phrase(&[0], 1), "");
    }

    #[test]
    fn counts_agree_with_their_noun() {
        assert_eq!(counted(1, "vertex", "vertices"), "1 vertex");
        assert_eq!(counted(0, "vertex", "vertices"), "0 vertices");
        assert_eq!(counted(22043, "vertex", "vertices"), "22,043 vertices");
        assert_eq!(counted(999, "vertex", "vertices"), "999 vertices");
    }
}

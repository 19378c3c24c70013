//! The built-in subjects twist and turn in the order of the four phases.

use super::*;

/// Mean turn of the outer surface near a height share of the long axis, from frame 0, in
/// radians, counter-clockwise as seen from the base.
fn turn_rad(subject: &Subject, share: f64, frame: usize) -> f64 {
    let anatomy = subject.anatomy.unwrap();
    let length = (anatomy.base - anatomy.apex).norm();
    let angle = |point: &Point3| {
        let offset = point - anatomy.apex;
        offset
            .dot(&anatomy.anterior)
            .atan2(offset.dot(&anatomy.septal))
    };
    let (before, after) = (vertices(subject, EPI, 0), vertices(subject, EPI, frame));
    let turns: Vec<f64> = before
        .iter()
        .zip(after)
        .filter(|(p, _)| {
            let height = (*p - anatomy.apex).dot(&anatomy.long_axis()) / length;
            (height - share).abs() < 0.06
        })
        .map(|(p, q)| {
            let turn = angle(q) - angle(p);
            turn.sin().atan2(turn.cos())
        })
        .collect();
    turns.iter().sum::<f64>() / turns.len() as f64
}

#[test]
fn seen_from_the_base_the_apex_turns_clockwise_and_the_base_the_other_way() {
    let made = small_cohort();
    for subject in &made.study.subjects[..9] {
        let es = end_systole(subject);
        let (apex, base) = (turn_rad(subject, 0.12, es), turn_rad(subject, 0.93, es));
        assert!((-16.0..-5.0).contains(&apex.to_degrees()), "{apex}");
        assert!((1.5..9.0).contains(&base.to_degrees()), "{base}");
    }
}

#[test]
fn a_beat_turns_contracts_expands_and_turns_back() {
    let made = small_cohort();
    for subject in &made.study.subjects[..9] {
        let volumes = volumes_ml(subject, ENDO);
        let es = end_systole(subject);
        assert!((2..=4).contains(&es));
        let emptied = |frame: usize| (volumes[0] - volumes[frame]) / (volumes[0] - volumes[es]);
        let turned = |frame: usize| turn_rad(subject, 0.12, frame) / turn_rad(subject, 0.12, es);
        assert!(turned(1) > emptied(1) + 0.2, "the turn comes first");
        assert!(turned(6) > emptied(6), "and goes last");
        assert!(turned(7) < 0.35);
        assert!(volumes[1..=es].windows(2).all(|pair| pair[0] > pair[1]));
        assert!(volumes[es..].windows(2).all(|pair| pair[0] < pair[1]));
    }
}

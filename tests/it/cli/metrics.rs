//! Weights of metrics, and what distances are made of.

use super::{cardiomorph, demo, json_of, text};

#[test]
fn shares_of_distances_are_told_for_every_metric() {
    let answer = json_of(&cardiomorph(&[
        "experiment",
        "shares",
        text(demo()),
        "--json",
    ]));
    let rows = answer["shares"].as_array().unwrap();
    // Four metrics, smoothed and not.
    assert_eq!(rows.len(), 8);
    for row in rows {
        assert_eq!(row["beats"], 23, "{row}");
        for pairs in ["end_diastole_to_end_systole", "frame_to_frame"] {
            let share = |part: &str| row[pairs][part].as_f64().unwrap();
            let parts = ["own", "curvature", "displacement"].map(share);
            assert!(parts.iter().all(|part| (0.0..=1.0).contains(part)), "{row}");
            // The quasi-conformal metric is mostly angles and curvature, that of displacement has no regulariser.
            let [own, curvature, displacement] = parts;
            match row["metric"].as_str().unwrap() {
                "quasi-conformal" => assert!(displacement < 0.25 && curvature > 0.1, "{row}"),
                "displacement" => assert_eq!([own, displacement], [1.0, 0.0]),
                _ => assert_eq!(curvature, 0.0),
            }
        }
    }
}

#[test]
fn a_metric_comes_with_its_weights_and_options_are_put_before_them() {
    let [a, b] = [0, 3].map(|frame| demo().join(format!("N01/endo_{frame:03}.ply")));
    let distance = |options: &[&str]| {
        let all = [
            &["metric", text(&a), text(&b), "--json", "--metric"],
            options,
        ]
        .concat();
        json_of(&cardiomorph(&all))["distance"].as_f64().unwrap()
    };
    let usual = distance(&["quasi-conformal"]);
    let spelt = [
        "quasi-conformal",
        "--mu",
        "0.125",
        "--lambda",
        "0.25",
        "--curvature-radius",
        "0.08",
    ];
    assert_eq!(usual, distance(&spelt));
    assert_ne!(
        usual,
        distance(&["quasi-conformal", "--curvature-radius", "0.2"])
    );
    assert_ne!(
        usual,
        distance(&["quasi-conformal", "--curvature-rings", "1"])
    );
    assert_eq!(distance(&["displacement"]), distance(&["rigid"]));
    assert_eq!(
        distance(&["displacement"]),
        distance(&["rigid", "--lambda", "0"])
    );
    assert_eq!(
        distance(&["angle-preserving"]),
        distance(&["angle-preserving", "--lambda", "1"])
    );
}

//! Atoms from the command line: columns that scripts rely on, and refusals.

use cardiomorph::io::write_obj;
use cardiomorph::mesh::phantom;

use super::{cardiomorph, code, demo, header, json_of, rows, said, text};

const COLUMNS: [&str; 15] = [
    "vertex", "x", "y", "z", "r", "s0x", "s0y", "s0z", "s1x", "s1y", "s1z", "nx", "ny", "nz", "end",
];

#[test]
fn medial_writes_one_row_per_vertex_of_the_endocardium() {
    let folder = tempfile::tempdir().unwrap();
    let paths = [("endo.obj", 20.0), ("epi.obj", 28.0)].map(|(name, radius)| {
        let mut bytes = Vec::new();
        write_obj(&mut bytes, &phantom::bowl(radius, 12, 24)).unwrap();
        let path = folder.path().join(name);
        std::fs::write(&path, bytes).unwrap();
        path
    });
    let out = folder.path().join("atoms.csv");
    let options = [
        "medial",
        "--endo",
        text(&paths[0]),
        "--epi",
        text(&paths[1]),
        "--out",
        text(&out),
        "--json",
    ];
    let answer = json_of(&cardiomorph(&options));
    assert_eq!(answer["atoms"], 289);
    assert_eq!(answer["end_atoms"], 24);
    assert!((answer["median_thickness"].as_f64().unwrap() - 8.0).abs() < 0.16);
    assert_eq!(header(&out), COLUMNS);
    let rows = rows(&out);
    assert_eq!(rows.len(), 289);
    for (vertex, row) in rows.iter().enumerate() {
        assert_eq!(row[0], vertex.to_string());
        let numbers: Vec<f64> = row.iter().map(|cell| cell.parse().unwrap()).collect();
        for unit in [5..8, 8..11, 11..14] {
            let square: f64 = numbers[unit].iter().map(|x| x * x).sum();
            assert!((square - 1.0).abs() < 1e-9);
        }
        // Rings lie one after the other, the rim last.
        assert_eq!(numbers[14] == 1.0, vertex >= 289 - 24);
    }
}

#[test]
fn medial_of_a_demo_heart_says_what_it_wrote() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("atoms.csv");
    let [endo, epi] = ["endo", "epi"].map(|side| demo().join(format!("N01/{side}_000.ply")));
    let output = cardiomorph(&[
        "medial",
        "--endo",
        text(&endo),
        "--epi",
        text(&epi),
        "--out",
        text(&out),
    ]);
    assert_eq!(code(&output), 0, "{}", said(&output));
    assert!(!rows(&out).is_empty());
}

#[test]
fn medial_without_a_second_side_is_wrong_usage_and_an_open_wall_is_unusable() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("atoms.csv");
    let endo = demo().join("N01/endo_000.ply");
    for options in [
        vec!["medial", "--out", text(&out)],
        vec!["medial", "--endo", text(&endo), "--out", text(&out)],
        vec![
            "medial",
            "--endo",
            text(&endo),
            "--epi",
            text(&endo),
            "--out",
            text(&out),
            "--smoothing",
            "-1",
        ],
    ] {
        assert_eq!(code(&cardiomorph(&options)), 2, "{options:?}");
    }
    let same = cardiomorph(&[
        "medial",
        "--endo",
        text(&endo),
        "--epi",
        text(&endo),
        "--out",
        text(&out),
    ]);
    assert_eq!(code(&same), 1);
    assert!(
        said(&same).contains("have no inscribed sphere between the sides"),
        "{}",
        said(&same)
    );
    let open = cardiomorph(&["medial", "--wall", text(&endo), "--out", text(&out)]);
    assert_eq!(code(&open), 1);
    assert!(
        said(&open).contains("one sheet with 1 open ends encloses no myocardium"),
        "{}",
        said(&open)
    );
    assert!(!out.exists());
}

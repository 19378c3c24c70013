//! `image`: what is found in a folder of volume files.

use super::*;

#[test]
fn series_come_with_grid_times_and_values_and_what_is_broken_is_an_error() {
    let folder = tempfile::tempdir().unwrap();
    let header = "ObjectType = Image\nNDims = 4\nDimSize = 2 1 2 2\nElementType = MET_SHORT\nComment = SEEDED\n\
        ElementSpacing = 2 3 5 0.25\nTransformMatrix = 0 1 0 0 -1 0 0 0 0 0 1 0 0 0 0 1\nOffset = 1 2 3 0\n\
        BinaryData = False\nElementDataFile = LOCAL\n";
    fs::write(
        folder.path().join("a.mha"),
        format!("{header}1 2 3 4 10 20 30 -40\n"),
    )
    .unwrap();
    let good = cardiomorph(&["image", text(folder.path()), "--json"]);
    assert_eq!(code(&good), 0, "{}", said(&good));
    let found = json_of(&good);
    let series = &found["series"][0];
    assert_eq!(series["format"], "MetaImage");
    assert_eq!(series["size"], serde_json::json!([2, 1, 2]));
    assert_eq!(series["spacing_mm"], serde_json::json!([2.0, 3.0, 5.0]));
    assert_eq!(series["origin_mm"], serde_json::json!([1.0, 2.0, 3.0]));
    assert_eq!(series["directions"][1], serde_json::json!([-1.0, 0.0, 0.0]));
    assert_eq!(series["times_ms"], serde_json::json!([0.0, 250.0]));
    assert_eq!(series["times_source"], "unit assumed");
    assert_eq!(series["gates"], Value::Null);
    assert_eq!(
        (&series["minimum"], &series["maximum"]),
        (&serde_json::json!(-40.0), &serde_json::json!(30.0))
    );
    assert_eq!(series["sums"], serde_json::json!([10.0, 20.0]));

    fs::write(folder.path().join("b.mha"), format!("{header}1 2 3\n")).unwrap();
    let partly = cardiomorph(&["image", text(folder.path())]);
    assert_eq!(code(&partly), 1);
    let printed = String::from_utf8_lossy(&partly.stdout).into_owned();
    assert!(
        printed.contains("2 × 3 × 5 mm (from the file)"),
        "{printed}"
    );
    assert!(
        printed.contains("8 numbers expected, but only 3 are there"),
        "{printed}"
    );
    for output in [&good, &partly] {
        let all = [&output.stdout[..], &output.stderr].concat();
        assert!(!String::from_utf8_lossy(&all).contains("SEEDED"));
    }
    let nothing = cardiomorph(&["image", "/nowhere/at/all"]);
    assert_eq!(code(&nothing), 1);
}

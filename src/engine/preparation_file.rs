//! The settings of an import on disk: those of every subject by its id, or one table for all.

use std::collections::BTreeMap;

use serde_json::{Map, Value, json};

use crate::analysis::preparation::Preparation;
use crate::engine::image_walls::ImageWallSettings;

/// The name under which a table of many has them.
const SUBJECTS: &str = "subjects";

/// The text of a file with the settings that subjects were made with.
///
/// # Errors
/// If a number cannot be written.
pub fn preparation_file(
    preparations: &[(String, Preparation)],
) -> Result<String, serde_json::Error> {
    let mut subjects = Map::new();
    for (id, preparation) in preparations {
        subjects.insert(id.clone(), serde_json::to_value(preparation)?);
    }
    serde_json::to_string_pretty(&json!({ SUBJECTS: subjects }))
}

/// Reads what [`preparation_file`] writes, or the settings of all subjects in one table; JSON or TOML.
///
/// # Errors
/// With what is wrong, and of which subject.
pub fn read_preparations(text: &str) -> Result<ImageWallSettings, String> {
    let table: Value = match serde_json::from_str(text) {
        Ok(table) => table,
        Err(json) => match text.trim_start().starts_with('{') {
            true => return Err(json.to_string()),
            false => toml::from_str(text).map_err(|error| error.to_string())?,
        },
    };
    let Some(subjects) = table.get(SUBJECTS) else {
        let all = serde_json::from_value(table).map_err(|error| error.to_string())?;
        return Ok(ImageWallSettings {
            all: Some(all),
            ..ImageWallSettings::default()
        });
    };
    let subjects = subjects
        .as_object()
        .ok_or_else(|| format!("{SUBJECTS:?} is not a table"))?;
    let mut each = BTreeMap::new();
    for (id, table) in subjects {
        let own = serde_json::from_value(table.clone());
        let own: Preparation = own.map_err(|error| format!("{id}: {error}"))?;
        each.insert(id.clone(), own);
    }
    Ok(ImageWallSettings {
        each,
        ..ImageWallSettings::default()
    })
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // A test that fails here says so.
mod tests {
    use super::*;
    use crate::analysis::preparation::Road;

    #[test]
    fn settings_of_subjects_are_read_as_they_were_written() {
        let mut second = Preparation::of_road(Road::Spect);
        second.threshold = Some(0.4);
        let all = [
            ("a".to_owned(), Preparation::default()),
            ("b".to_owned(), second),
        ];
        let text = preparation_file(&all).unwrap();
        let read = read_preparations(&text).unwrap();
        assert_eq!(read.each.into_iter().collect::<Vec<_>>(), all);
        assert_eq!(read.all, None);
    }

    #[test]
    fn one_table_is_for_all_and_what_is_wrong_is_named() {
        let read = read_preparations("road = \"spect\"\nblur_mm = 5.0\n").unwrap();
        assert_eq!(read.all.unwrap().blur_mm, 5.0);
        let wrong = r#"{"subjects": {"p7": {"road": "spect", "blur_mm": -1.0}}}"#;
        let error = read_preparations(wrong).unwrap_err();
        assert!(error.starts_with("p7: a blur of -1 mm"), "{error}");
        assert!(read_preparations(r#"{"rod": "spect"}"#).is_err());
        assert!(read_preparations("[").is_err());
    }
}

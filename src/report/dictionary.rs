//! All tables with their columns: what a person or a program needs to read them.

use std::fmt::Write;

use super::atoms::AtomRow;
use super::experiments::NoiseRow;
use super::fits::FitRow;
use super::maps::{DeformationRow, MedialPoseRow, PoseRow, distances_described};
use super::measures::{FrameRow, SubjectRow};
use super::medial_atoms::MedialAtomRow;
use super::patch_segments::PatchSegmentRow;
use super::patches::PatchRow;
use super::segments::SegmentRow;
use super::table::{TableWords, described};
use super::verdicts::VerdictRow;
use super::vertex_curvatures::VertexCurvatureRow;
use crate::analysis::experiments::{
    ComparisonRow, InterpolationCase, LocalisationRow, MedialNoiseCell, PartnerRow, TransportCase,
};

/// Every table that the program writes, those of `analyze` first.
pub fn all_tables() -> Vec<TableWords> {
    vec![
        described::<FrameRow>(),
        described::<SubjectRow>(),
        distances_described(),
        described::<PoseRow>(),
        described::<DeformationRow>(),
        described::<VerdictRow>(),
        described::<MedialPoseRow>(),
        described::<AtomRow>(),
        described::<PatchRow>(),
        described::<SegmentRow>(),
        described::<PatchSegmentRow>(),
        described::<MedialAtomRow>(),
        described::<VertexCurvatureRow>(),
        described::<NoiseRow>(),
        described::<TransportCase>(),
        described::<InterpolationCase>(),
        described::<ComparisonRow>(),
        described::<PartnerRow>(),
        described::<MedialNoiseCell>(),
        described::<LocalisationRow>(),
        described::<FitRow>(),
    ]
}

/// The dictionary of columns of all files that the program writes, as Markdown.
pub fn all_columns_md() -> String {
    let tables = all_tables();
    let files = tables.iter().flat_map(|table| table.files);
    columns_md(&files.copied().collect::<Vec<_>>())
}

/// The dictionary of columns of the files with these names, as Markdown.
pub fn columns_md(files: &[&str]) -> String {
    let mut text = "# Columns\n\nNames and order of columns are fixed; new ones go to the end. Numbers have all digits; \
                    a cell is empty where there is no value. Words that begin with =, +, - or @ and are no numbers have an \
                    apostrophe in front, so that no spreadsheet computes them; control characters stand as their codes, \
                    such as \\n.\n"
        .to_owned();
    let mut line = |words: std::fmt::Arguments<'_>| {
        // Writing into a string cannot fail.
        text.write_fmt(words).ok();
    };
    for table in all_tables() {
        let present: Vec<String> = (table.files.iter())
            .filter(|file| files.contains(*file))
            .map(|file| format!("`{file}`"))
            .collect();
        if present.is_empty() {
            continue;
        }
        line(format_args!(
            "\n## {}\n\n{}.\n\n",
            present.join(", "),
            table.row
        ));
        line(format_args!(
            "| column | heading | unit | meaning |\n|---|---|---|---|\n"
        ));
        for column in &table.columns {
            let meaning = column.explanation.replace('|', "\\|");
            line(format_args!(
                "| `{}` | {} | {} | {meaning} |\n",
                column.key, column.heading, column.unit
            ));
        }
        if let Some(further) = table.further {
            line(format_args!("\nBehind these: {further}.\n"));
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_key_stands_twice_in_a_table_and_every_column_is_explained() {
        for table in all_tables() {
            let mut keys: Vec<&str> = table.columns.iter().map(|column| column.key).collect();
            keys.sort_unstable();
            assert!(keys.windows(2).all(|two| two[0] != two[1]), "{table:?}");
            for column in &table.columns {
                assert!(column.explanation.len() > 3, "{column:?}");
                assert_ne!(column.heading, column.key, "{column:?}");
                assert_ne!(column.explanation, column.heading, "{column:?}");
                assert!(!column.explanation.ends_with('.'), "{column:?}");
            }
        }
    }

    #[test]
    fn the_whole_dictionary_holds_every_column_of_every_table() {
        let text = all_columns_md();
        for table in all_tables() {
            for file in table.files {
                assert!(text.contains(&format!("`{file}`")), "{file}");
            }
            for column in table.columns {
                assert!(
                    text.contains(&format!("| `{}` |", column.key)),
                    "{column:?}"
                );
            }
        }
    }

    #[test]
    fn the_dictionary_holds_the_tables_that_are_there_and_no_other() {
        let text = columns_md(&["measures.csv", "subjects.csv", "patches.csv"]);
        assert!(text.contains("## `subjects.csv`, `measures.csv`"));
        assert!(text.contains("| `area_cm2` | Area | cm² | Area on the medial surface"));
        assert!(!text.contains("atoms.csv"));
    }
}

//! `learn`: a rule for verdicts from the labelled subjects of a study, as a file that holds none of them.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use serde_json::json;

use crate::analysis::verdicts::{CheckedRule, Rule};
use crate::cli::args::LearnArgs;
use crate::cli::input::{answered, in_unit, opened_study, store};
use crate::cli::measure::say_warnings;
use crate::cli::outcome::CliError;
use crate::cli::print::{print, print_json};
use crate::engine::{ExportFile, RuleQuery, VerdictQuery, write_files};
use crate::report::pretty_json;

/// Largest file that is read as a rule: one of a hundred labels takes a twentieth.
const MAX_BYTES: u64 = 4 << 20;

pub(super) fn learn(args: &LearnArgs) -> Result<(), CliError> {
    let study = in_unit(opened_study(&args.study)?, args.unit);
    say_warnings(&study);
    let query = RuleQuery(VerdictQuery {
        thickening: args.patches.settings()?,
        ..VerdictQuery::default()
    });
    let rule = answered(&store()?, &study, &query)?;
    let value = serde_json::to_value(&*rule).map_err(CliError::unusable)?;
    let text = pretty_json(&value).map_err(CliError::unusable)?;
    let file = ExportFile {
        path: args.out.clone(),
        bytes: text.into_bytes().into(),
    };
    write_files(vec![file]).map_err(CliError::Unusable)?;
    if args.json {
        return print_json(
            &json!({ "file": args.out.display().to_string(), "training": rule.training }),
        );
    }
    print(&args.out.display().to_string())
}

/// A rule that [`learn`] wrote.
///
/// # Errors
/// If the file cannot be read, is none, or of another version: why, and which.
pub(super) fn read_rule(path: &Path) -> Result<CheckedRule, CliError> {
    let why = |error: &dyn std::fmt::Display| {
        CliError::Unusable(format!(
            "cannot use the classifier file: {error}: {}",
            path.display()
        ))
    };
    let mut text = String::new();
    File::open(path)
        .and_then(|file| file.take(MAX_BYTES).read_to_string(&mut text))
        .map_err(|error| why(&error))?;
    let rule: Rule = serde_json::from_str(&text).map_err(|error| why(&error))?;
    rule.check().map_err(|error| why(&error))
}

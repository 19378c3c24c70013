//! `learn`: a rule for verdicts from the labelled subjects of a study, as a file that holds none of them.

use serde_json::json;

use crate::analysis::verdicts::ClassifierFile;
use crate::cli::args::LearnArgs;
use crate::cli::input::{answered, in_unit, opened_study, store};
use crate::cli::measure::say_warnings;
use crate::cli::outcome::CliError;
use crate::cli::print::{print, print_json};
use crate::engine::{TrainedClassifierQuery, VerdictQuery, classifier_file, write_files};

pub(super) fn learn(args: &LearnArgs) -> Result<(), CliError> {
    let study = in_unit(opened_study(&args.study)?, args.unit);
    say_warnings(&study);
    let mut query = TrainedClassifierQuery::new(VerdictQuery {
        thickening: args.patches.settings()?,
        ..VerdictQuery::default()
    });
    if !args.features.is_empty() {
        query.features = args.features.clone();
    }
    let mut rule = ClassifierFile::clone(&*answered(&store()?, &study, &query)?);
    rule.origin.note = args.note.clone().unwrap_or_default();
    let file = classifier_file(&rule, args.out.clone()).map_err(CliError::unusable)?;
    write_files(vec![file]).map_err(CliError::Unusable)?;
    if args.json {
        return print_json(
            &json!({ "file": args.out.display().to_string(), "training": rule.training }),
        );
    }
    print(&args.out.display().to_string())
}

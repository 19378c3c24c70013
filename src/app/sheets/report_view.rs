//! The load report: what was read of every subject, what was assumed, and what could not be read.

use crate::app::ReportSubject;
use crate::app::errors::file_name;
use crate::document::state::State;
use crate::study::Subject;
use crate::ui::text::counted;

/// All entries: the study as a whole, what could not be read, then subject by subject.
pub fn report_entries(state: &State) -> Vec<ReportSubject> {
    let report = &state.document.study.report;
    let study = state.document.study();
    let mut entries = Vec::new();
    if !report.notices.is_empty() {
        entries.push(ReportSubject {
            id: study.name.clone(),
            summary: "the whole study".to_owned(),
            notices: report.notices.clone(),
            error: None,
        });
    }
    entries.extend(report.errors.iter().map(|error| ReportSubject {
        id: (error.subject.clone()).unwrap_or_else(|| file_name(error)),
        summary: "not opened".to_owned(),
        notices: Vec::new(),
        error: Some(error.to_string()),
    }));
    entries.extend(study.all().map(|subject| ReportSubject {
        id: subject.id.clone(),
        summary: summary(subject),
        notices: subject.notices.clone(),
        error: None,
    }));
    entries
}

/// "25 frames · endocardium + epicardium · 3224 vertices · mm".
fn summary(subject: &Subject) -> String {
    let sequence = &subject.sequence;
    let kinds: Vec<&str> = sequence
        .surfaces()
        .iter()
        .map(|surface| surface.kind().name())
        .collect();
    let frames = counted(sequence.frame_count(), "frame");
    format!(
        "{frames} · {} · {} vertices · {}",
        kinds.join(" + "),
        sequence.vertex_count(),
        subject.unit.length_symbol()
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::document::OpeningReport;
    use crate::document::testing::{study_of, subject_with_frames};
    use crate::io::OpenError;
    use crate::study::Notice;

    #[test]
    fn the_report_names_what_was_assumed_and_what_could_not_be_read() {
        let mut state = State::default();
        let report = OpeningReport {
            notices: vec![Notice::info("units are not given")],
            errors: vec![OpenError {
                subject: None,
                path: "/study/bad.ply".into(),
                reason: "byte 17: the header does not end".to_owned(),
            }],
            ..OpeningReport::default()
        };
        state.show_study(study_of(vec![subject_with_frames("a", 5)]), report);
        let entries = report_entries(&state);
        assert_eq!(entries.len(), 3);
        assert_eq!(entries[1].id, "bad.ply");
        assert_eq!(entries[2].summary, "5 frames · cavity · 42 vertices · mm");
    }
}

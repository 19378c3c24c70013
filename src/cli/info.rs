//! `info`: the subjects of a study, with notes on their files.

use std::path::PathBuf;

use clap::Args;
use serde_json::json;

use crate::cli::input::{nothing_found, opened, without_walls};
use crate::cli::outcome::CliError;
use crate::cli::print::{on_one_line, print, print_json};
use crate::io::Opened;
use crate::study::{Notice, Severity, Subject};

/// Options of `info`.
#[derive(Debug, Args)]
pub struct InfoArgs {
    /// Studies, folders and files
    #[arg(value_name = "PATH", required = true)]
    pub paths: Vec<PathBuf>,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}

pub(super) fn info(args: &InfoArgs) -> Result<(), CliError> {
    let opened = opened(&args.paths)?;
    if args.json {
        print_json(&as_json(&opened))?;
    } else {
        print(&as_text(&opened))?;
    }
    match (opened.errors.len(), opened.study.subjects.len()) {
        (0, 0) => Err(CliError::Unusable(nothing_found(&opened).to_owned())),
        (0, _) => Ok(()),
        (1, _) => Err(CliError::Unusable("1 input is unusable".to_owned())),
        (count, _) => Err(CliError::Unusable(format!("{count} inputs are unusable"))),
    }
}

fn as_json(opened: &Opened) -> serde_json::Value {
    let study = &opened.study;
    let subjects: Vec<_> = (study.in_order().into_iter())
        .filter_map(|index| Some((study.is_excluded(index), study.subject(index)?)))
        .map(|(excluded, subject)| {
            json!({
                "id": subject.id,
                "label": subject.label,
                "excluded": excluded,
                "frames": subject.sequence.frame_count(),
                "vertices": subject.sequence.vertex_count(),
                "faces": subject.sequence.face_count(),
                "surfaces": surfaces(subject),
                "notices": notices(&subject.notices),
            })
        })
        .collect();
    let errors: Vec<String> = opened.errors.iter().map(ToString::to_string).collect();
    let images = without_walls(opened).map(|images| {
        json!({
            "id": images.id,
            "notices": notices(&images.notices),
        })
    });
    json!({
        "subjects": subjects,
        "images_without_walls": images.collect::<Vec<_>>(),
        "errors": errors,
        "notices": notices(&opened.notices),
    })
}

fn as_text(opened: &Opened) -> String {
    let study = &opened.study;
    let mut lines = Vec::new();
    let name = if study.name.is_empty() {
        "study"
    } else {
        &study.name
    };
    let count = study.subjects.len();
    let plural = if count == 1 { "subject" } else { "subjects" };
    lines.push(format!("{name}: {count} {plural}"));
    lines.extend(
        notices(&opened.notices)
            .iter()
            .map(|notice| format!("  {notice}")),
    );
    let widest = study.all().map(|s| s.id.chars().count()).max();
    let width = widest.unwrap_or(0);
    for index in study.in_order() {
        let Some(subject) = study.subject(index) else {
            continue;
        };
        let sequence = &subject.sequence;
        let label = subject.label.as_deref().unwrap_or("no label");
        let excluded = match study.is_excluded(index) {
            true => ", excluded",
            false => "",
        };
        lines.push(format!(
            "{:width$}  {label}{excluded}, {} frames, {} vertices, {} faces: {}",
            subject.id,
            sequence.frame_count(),
            sequence.vertex_count(),
            sequence.face_count(),
            surfaces(subject).join(" + "),
        ));
        lines.extend(
            notices(&subject.notices)
                .iter()
                .map(|notice| format!("  {notice}")),
        );
    }
    for images in without_walls(opened) {
        let id = on_one_line(&images.id);
        lines.push(format!("{id}: images without walls"));
        let notices = notices(&images.notices);
        lines.extend(notices.iter().map(|notice| format!("  {notice}")));
    }
    lines.extend(opened.errors.iter().map(|error| format!("error: {error}")));
    lines.join("\n")
}

fn surfaces(subject: &Subject) -> Vec<&'static str> {
    let surfaces = subject.sequence.surfaces();
    surfaces
        .iter()
        .map(|surface| surface.kind().name())
        .collect()
}

fn notices(notices: &[Notice]) -> Vec<String> {
    let line = |notice: &Notice| match notice.severity {
        Severity::Info => notice.text.clone(),
        Severity::Warning => format!("warning: {}", notice.text),
    };
    notices.iter().map(line).collect()
}

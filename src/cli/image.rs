//! `image`: the series of images in files and folders, with their grids, times and values.

use std::path::PathBuf;

use clap::Args;
use serde_json::{Value, json};

use crate::cli::outcome::CliError;
use crate::cli::print::{on_one_line, print, print_json};
use crate::cli::work::run_work;
use crate::engine::reading_limits;
use crate::image::VolumeFrame;
use crate::io::{FoundImage, Gates, ImageReport, Provenance, each_image};
use crate::mesh::Vector3;
use crate::study::{Notice, Severity};

/// Options of `image`.
#[derive(Debug, Args)]
pub struct ImageArgs {
    /// Files and folders: DICOM, NIfTI, NRRD, MetaImage
    #[arg(value_name = "PATH", required = true)]
    pub paths: Vec<PathBuf>,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}

pub(super) fn image(args: &ImageArgs) -> Result<(), CliError> {
    let paths = args.paths.clone();
    // Voxels are counted and dropped series by series: a cohort need not fit into memory.
    let (series, report) = run_work(move |progress| {
        let mut series = Vec::new();
        let report = each_image(&paths, &reading_limits(), progress, &mut |image| {
            series.push(Summary::of(image));
        })?;
        Ok::<_, crate::progress::Stopped>((series, report))
    })?;
    if args.json {
        print_json(&as_json(&series, &report))?;
    } else {
        print(&as_text(&series, &report))?;
    }
    match (report.errors.len(), series.len()) {
        (0, 0) => Err(CliError::Unusable("no images were found".to_owned())),
        (0, _) => Ok(()),
        (1, _) => Err(CliError::Unusable("1 input is unusable".to_owned())),
        (count, _) => Err(CliError::Unusable(format!("{count} inputs are unusable"))),
    }
}

/// One series without its voxels.
struct Summary {
    name: String,
    path: Option<PathBuf>,
    format: &'static str,
    modality: Option<&'static str>,
    frame: VolumeFrame,
    spacing: Provenance,
    position_known: bool,
    times_ms: Option<Vec<f64>>,
    times: Provenance,
    gates: Option<Gates>,
    volumes: Vec<Values>,
    notices: Vec<Notice>,
}

/// The values of one volume.
#[derive(Clone, Copy)]
struct Values {
    /// `None` if no voxel has a value.
    range: Option<[f32; 2]>,
    sum: f64,
    /// Voxels of padding.
    without: usize,
}

impl Values {
    fn of(voxels: &[f32]) -> Self {
        let mut values = Self {
            range: None,
            sum: 0.0,
            without: 0,
        };
        for &voxel in voxels {
            if voxel.is_nan() {
                values.without += 1;
                continue;
            }
            let [low, high] = values.range.unwrap_or([voxel; 2]);
            values.range = Some([low.min(voxel), high.max(voxel)]);
            values.sum += f64::from(voxel);
        }
        values
    }
}

impl Summary {
    fn of(found: FoundImage) -> Self {
        let FoundImage { path, series, .. } = found;
        let image = &series.image;
        Self {
            path,
            format: series.format,
            modality: series.modality.map(|modality| modality.letters()),
            frame: *image.frame(),
            spacing: series.spacing,
            position_known: series.position_known,
            times_ms: image.times_ms().map(<[f64]>::to_vec),
            times: series.times,
            volumes: image
                .volumes()
                .iter()
                .map(|voxels| Values::of(voxels))
                .collect(),
            gates: series.gates,
            name: series.name,
            notices: series.notices,
        }
    }

    /// The range of all volumes.
    fn range(&self) -> Option<[f32; 2]> {
        let ranges = self.volumes.iter().filter_map(|values| values.range);
        ranges.reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])])
    }

    fn as_json(&self) -> Value {
        let range = self.range();
        let all = |of: &dyn Fn(&Values) -> Value| self.volumes.iter().map(of).collect::<Vec<_>>();
        json!({
            "name": self.name,
            "path": self.path.as_ref().map(|path| path.display().to_string()),
            "format": self.format,
            "modality": self.modality,
            "size": self.frame.size(),
            "volumes": self.volumes.len(),
            "spacing_mm": self.frame.spacing(),
            "spacing_source": self.spacing.word(),
            "origin_mm": without_minus_zero(self.frame.origin().coords),
            "directions": self.frame.directions().map(without_minus_zero),
            "position_known": self.position_known,
            "times_ms": self.times_ms,
            "times_source": (self.volumes.len() > 1).then(|| self.times.word()),
            "gates": self.gates.as_ref().map(|gates| &gates.numbers),
            "cycle_ms": self.gates.as_ref().and_then(|gates| gates.cycle_ms),
            "minimum": range.map(|range| range[0]),
            "maximum": range.map(|range| range[1]),
            "minimums": all(&|values| json!(values.range.map(|range| range[0]))),
            "maximums": all(&|values| json!(values.range.map(|range| range[1]))),
            "sums": all(&|values| json!(values.sum)),
            "without_value": all(&|values| json!(values.without)),
            "notices": notes(&self.notices),
        })
    }

    /// A table of the values, a line for each volume.
    fn value_lines(&self) -> Vec<String> {
        let head = "  values      volume       minimum       maximum             sum".to_owned();
        let line = |(index, values): (usize, &Values)| {
            let [low, high] = match values.range {
                Some(range) => range.map(|value| rounded(f64::from(value), 4)),
                None => ["-", "-"].map(str::to_owned),
            };
            let padding = match values.without {
                0 => String::new(),
                count => format!(", {count} voxels without a value"),
            };
            let (number, sum) = (index + 1, rounded(values.sum, 3));
            format!("              {number:>6}  {low:>12}  {high:>12}  {sum:>14}{padding}")
        };
        let volumes = self.volumes.iter().enumerate().map(line);
        std::iter::once(head).chain(volumes).collect()
    }

    fn lines(&self) -> Vec<String> {
        let mut lines = vec![match &self.path {
            Some(path) => format!(
                "{}: {}",
                self.name,
                on_one_line(&path.display().to_string())
            ),
            None => self.name.clone(),
        }];
        let mut say = |what: &str, text: String| lines.push(format!("  {what:<10}  {text}"));
        if let Some(modality) = self.modality {
            say("modality", modality.to_owned());
        }
        let [i, j, k] = self.frame.size();
        say(
            "size",
            format!("{i} × {j} × {k}, {} volumes", self.volumes.len()),
        );
        let [i, j, k] = self.frame.spacing().map(|step| rounded(step, 4));
        say(
            "spacing",
            format!("{i} × {j} × {k} mm ({})", self.spacing.word()),
        );
        let known = if self.position_known {
            "LPS"
        } else {
            "not in the file"
        };
        let origin = joined(self.frame.origin().coords, 3);
        say("origin", format!("{origin} mm ({known})"));
        let directions = self
            .frame
            .directions()
            .map(|direction| joined(direction, 4));
        say("directions", directions.join("; "));
        let times = match &self.times_ms {
            Some(times) => {
                let times: Vec<String> = times.iter().map(|time| rounded(*time, 2)).collect();
                format!("{} ms ({})", times.join(", "), self.times.word())
            }
            None if self.volumes.len() == 1 => "one volume".to_owned(),
            None => self.times.word().to_owned(),
        };
        say("times", times);
        if let Some(gates) = &self.gates {
            let numbers: Vec<String> = gates.numbers.iter().map(u32::to_string).collect();
            let cycle = gates
                .cycle_ms
                .map_or_else(String::new, |ms| format!(", RR {} ms", rounded(ms, 2)));
            say("gates", format!("{}{cycle}", numbers.join(", ")));
        }
        lines.extend(self.value_lines());
        lines.extend(notes(&self.notices).iter().map(|note| format!("  {note}")));
        lines
    }
}

fn as_json(series: &[Summary], report: &ImageReport) -> Value {
    let errors: Vec<String> = report.errors.iter().map(ToString::to_string).collect();
    json!({
        "series": series.iter().map(Summary::as_json).collect::<Vec<_>>(),
        "errors": errors,
        "notices": notes(&report.notices),
    })
}

fn as_text(series: &[Summary], report: &ImageReport) -> String {
    let mut lines: Vec<String> = series.iter().flat_map(Summary::lines).collect();
    lines.extend(notes(&report.notices));
    lines.extend(report.errors.iter().map(|error| format!("error: {error}")));
    lines.join("\n")
}

fn notes(notices: &[Notice]) -> Vec<String> {
    let line = |notice: &Notice| match notice.severity {
        Severity::Info => notice.text.clone(),
        Severity::Warning => format!("warning: {}", notice.text),
    };
    notices.iter().map(line).collect()
}

/// A number with at most so many digits after the point.
fn rounded(number: f64, digits: usize) -> String {
    let text = format!("{number:.digits$}");
    let short = match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.'),
        false => &text,
    };
    if short == "-0" {
        "0".to_owned()
    } else {
        short.to_owned()
    }
}

fn joined(vector: Vector3, digits: usize) -> String {
    let numbers = without_minus_zero(vector).map(|number| rounded(number, digits));
    numbers.join(", ")
}

/// −0 is 0.
fn without_minus_zero(vector: Vector3) -> [f64; 3] {
    [vector.x, vector.y, vector.z].map(|number| number + 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn voxels_without_a_value_are_counted_and_not_summed() {
        let values = Values::of(&[1.0, f32::NAN, -2.5]);
        assert_eq!(values.range, Some([-2.5, 1.0]));
        assert_eq!((values.sum, values.without), (-1.5, 1));
        assert_eq!(Values::of(&[f32::NAN]).range, None);
    }

    #[test]
    fn numbers_are_short_and_no_zero_is_negative() {
        assert_eq!(rounded(1.80000004, 4), "1.8");
        assert_eq!(rounded(-0.00001, 3), "0");
        assert_eq!(rounded(140.0, 0), "140");
        assert_eq!(joined(Vector3::new(-0.0, 1.5, 100.0), 3), "0, 1.5, 100");
    }
}

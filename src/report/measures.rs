//! Clinical measures: a row per subject, and a row per frame.

use serde_json::{Value, json};

use super::column::{Cell, Column, Digits, Unit, column};
use super::shared;
use super::table::{Row, json_row};
use crate::analysis::measures::{ADULT_RANGES, PhaseSource, SubjectMeasures, outside_reference};
use crate::study::Study;
use crate::units::LengthUnit;

/// Clinical measures of one subject. Volumes are in its shown unit: ml, or cubic units of the file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SubjectRow {
    /// Pseudonym.
    pub subject: String,
    /// What the study says.
    pub label: Option<String>,
    /// Frame of end-diastole, from 0.
    pub end_diastole: Option<usize>,
    /// Frame of end-systole, from 0.
    pub end_systole: Option<usize>,
    /// End-diastolic volume.
    pub edv: Option<f64>,
    /// End-systolic volume.
    pub esv: Option<f64>,
    /// Stroke volume.
    pub sv: Option<f64>,
    /// Ejection fraction as a fraction.
    pub ef: Option<f64>,
    /// Mass of the myocardium in grams.
    pub mass_g: Option<f64>,
    /// Unit of coordinates.
    pub unit: LengthUnit,
    /// Whether the study or the user sets the frames of end-diastole and end-systole.
    pub phases_stated: bool,
    /// Measures outside the range of healthy adults; empty if all are inside.
    pub outside_range: String,
    /// Why measures are missing; empty if none is.
    pub notes: String,
}

impl SubjectRow {
    /// Its pseudonym.
    pub const SUBJECT: Column<Self> = shared::subject(|row| (&row.subject).into());
    /// What the study says.
    pub const LABEL: Column<Self> = shared::label(|row| row.label.as_deref().into());
    /// Frame of end-diastole.
    pub const END_DIASTOLE: Column<Self> =
        column("end_diastole", "ED", |row: &Self| row.end_diastole.into())
            .plain("Frame of end-diastole, numbered from 0");
    /// Frame of end-systole.
    pub const END_SYSTOLE: Column<Self> =
        column("end_systole", "ES", |row: &Self| row.end_systole.into())
            .plain("Frame of end-systole, numbered from 0");
    /// End-diastolic volume.
    pub const EDV: Column<Self> = column("edv", "EDV", |row: &Self| row.edv.into())
        .volume("End-diastolic volume of the cavity");
    /// End-systolic volume.
    pub const ESV: Column<Self> = column("esv", "ESV", |row: &Self| row.esv.into())
        .volume("End-systolic volume of the cavity");
    /// Stroke volume: with a digit more than the volumes, whose rounded difference may be another by one.
    pub const SV: Column<Self> = column("sv", "Stroke volume", |row: &Self| row.sv.into()).with(
        Unit::Volume,
        Digits::Places(1),
        "Stroke volume, EDV − ESV",
    );
    /// Ejection fraction.
    pub const EF: Column<Self> = column("ef", "EF", |row: &Self| row.ef.into())
        .share("Ejection fraction, (EDV − ESV) / EDV, as a fraction");
    /// Mass of the myocardium.
    pub const MASS_G: Column<Self> = column("mass_g", "Mass", |row: &Self| row.mass_g.into()).with(
        Unit::Symbol("g"),
        Digits::OneBelowTen,
        "Mass of the myocardium at end-diastole; empty where coordinates are not in mm",
    );

    /// Measures that are unusual.
    pub const OUTSIDE_RANGE: Column<Self> =
        column("outside_range", "Outside adult range", |row: &Self| {
            some(&row.outside_range)
        })
        .plain(ADULT_RANGES);

    /// One row per subject of the study.
    pub fn of_study(study: &Study, measures: &[SubjectMeasures]) -> Vec<Self> {
        let subjects = study.subjects.iter().zip(measures);
        subjects
            .map(|(subject, measured)| {
                Self::new(subject.id.clone(), subject.label.clone(), measured)
            })
            .collect()
    }

    /// Of one subject.
    pub fn new(subject: String, label: Option<String>, measured: &SubjectMeasures) -> Self {
        Self {
            subject,
            label,
            end_diastole: measured.end_diastole,
            end_systole: measured.end_systole,
            edv: measured.edv,
            esv: measured.esv,
            sv: measured.sv,
            ef: measured.ef,
            mass_g: measured.mass.map(|mass| mass.0),
            unit: measured.unit,
            phases_stated: match measured.phase_source {
                PhaseSource::VolumeCurve => false,
                PhaseSource::Stated => true,
            },
            outside_range: joined(&outside_reference(measured)),
            notes: joined(&measured.notes),
        }
    }

    /// As summaries hold it: `id` in place of `subject`, then the columns of the table.
    fn json(&self) -> Value {
        let mut object = serde_json::Map::new();
        object.insert("id".to_owned(), json!(self.subject));
        let mut columns = json_row(self);
        columns.shift_remove(Self::SUBJECT.key);
        object.extend(columns);
        Value::Object(object)
    }
}

impl Row for SubjectRow {
    // The same table under both names: scripts of the first release read `measures.csv`.
    const FILES: &'static [&'static str] = &["subjects.csv", "measures.csv"];
    const ROW: &'static str = "Clinical measures, a row per subject";
    const COLUMNS: &'static [Column<Self>] = &[
        Self::SUBJECT,
        Self::LABEL,
        Self::END_DIASTOLE,
        Self::END_SYSTOLE,
        Self::EDV,
        Self::ESV,
        Self::SV,
        Self::EF,
        Self::MASS_G,
        shared::volume_unit(|row| row.unit.volume_symbol().into()),
        column("phase_source", "Frames set by", |row: &Self| {
            (if row.phases_stated {
                "stated"
            } else {
                "volume curve"
            })
            .into()
        })
        .plain(
            "Source of end-diastole and end-systole: volume curve, or stated: set by the \
                     user or the study",
        ),
        Self::OUTSIDE_RANGE,
        column("notes", "Notes", |row: &Self| some(&row.notes)).plain("Why measures are missing"),
    ];
}

/// Words, if there are any.
pub(super) fn some(words: &str) -> Cell<'_> {
    (!words.is_empty()).then_some(words).into()
}

fn joined(parts: &[impl ToString]) -> String {
    let words: Vec<String> = parts.iter().map(ToString::to_string).collect();
    words.join("; ")
}

/// Measures of every subject as a list of JSON.
pub fn subjects_json(rows: &[SubjectRow]) -> Value {
    Value::Array(rows.iter().map(SubjectRow::json).collect())
}

/// Volumes and areas of one frame, in the subject's shown units.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FrameRow {
    /// Pseudonym.
    pub subject: String,
    /// From 0.
    pub frame: usize,
    /// Volume inside the endocardium or of the cavity.
    pub endo_volume: Option<f64>,
    /// Volume inside the epicardium.
    pub epi_volume: Option<f64>,
    /// Volume of the myocardium.
    pub wall_volume: Option<f64>,
    /// Area of the endocardium or cavity.
    pub endo_area: Option<f64>,
    /// Area of the epicardium.
    pub epi_area: Option<f64>,
    /// Unit of coordinates.
    pub unit: LengthUnit,
    /// Time after the R peak in seconds; `None` where the study does not say.
    pub time_s: Option<f64>,
}

impl FrameRow {
    /// One row per frame of each subject.
    pub fn of_frames(study: &Study, measures: &[SubjectMeasures]) -> Vec<Self> {
        let subjects = study.subjects.iter().zip(measures);
        subjects
            .flat_map(|(subject, measured)| {
                let (timing, count) = (&subject.timing, measured.frames.len());
                let frames = measured.frames.iter().enumerate();
                frames.map(move |(frame, sizes)| Self {
                    subject: subject.id.clone(),
                    frame,
                    endo_volume: sizes.endo_volume,
                    epi_volume: sizes.epi_volume,
                    wall_volume: sizes.wall_volume,
                    endo_area: sizes.endo_area,
                    epi_area: sizes.epi_area,
                    unit: measured.unit,
                    time_s: timing.time_at(frame as f64, count).map(|time| time.0),
                })
            })
            .collect()
    }
}

impl Row for FrameRow {
    const FILES: &'static [&'static str] = &["frames.csv"];
    const ROW: &'static str =
        "Volumes and areas, a row per frame; empty where the surface is missing";
    const COLUMNS: &'static [Column<Self>] = &[
        shared::subject(|row| (&row.subject).into()),
        shared::frame(|row| row.frame.into()),
        column("endo_volume", "Endocardial volume", |row: &Self| {
            row.endo_volume.into()
        })
        .volume("Volume inside the endocardium or of the cavity, closed at the base"),
        column("epi_volume", "Epicardial volume", |row: &Self| {
            row.epi_volume.into()
        })
        .volume("Volume inside the epicardium, closed at the base"),
        shared::volume_unit(|row| row.unit.volume_symbol().into()),
        column("wall_volume", "Wall volume", |row: &Self| {
            row.wall_volume.into()
        })
        .volume("Volume of the myocardium: epicardial less endocardial, or that of a closed wall"),
        column("endo_area", "Endocardial area", |row: &Self| {
            row.endo_area.into()
        })
        .area("Area of the endocardium or cavity"),
        column("epi_area", "Epicardial area", |row: &Self| {
            row.epi_area.into()
        })
        .area("Area of the epicardium"),
        column("area_unit", "Unit", |row: &Self| {
            row.unit.area_symbol().into()
        })
        .plain("Unit of the areas: cm² where coordinates are in mm, else units²"),
        column("time_s", "Time", |row: &Self| row.time_s.into())
            .coordinate(
                "Time of the frame after the R peak; frames share the cycle evenly where the \
                     study gives its length alone; empty where it gives neither",
            )
            .in_unit("s"),
    ];
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::measures::measure_study;
    use crate::mesh::phantom;
    use crate::progress::Progress;
    use crate::report::csv;
    use crate::report::testing::study;

    #[test]
    fn tables_read_back_with_their_columns_and_quoted_names() {
        let frames = vec![phantom::sphere(3, 30.0), phantom::sphere(3, 24.0)];
        let study = study(&[("P, \"1\"", "MINF")], frames);
        let measures = measure_study(&study, &Progress::default()).unwrap();
        let frames = csv(&FrameRow::of_frames(&study, &measures));
        let mut reader = csv::Reader::from_reader(frames.as_bytes());
        let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
        assert_eq!(rows.len(), 2);
        assert_eq!(&rows[0][0], "P, \"1\"");
        assert_eq!(&rows[1][4], "ml");
        assert_eq!(&rows[1][3], "");
        let subjects = SubjectRow::of_study(&study, &measures);
        let table = csv(&subjects);
        let mut reader = csv::Reader::from_reader(table.as_bytes());
        let row = reader.records().next().unwrap().unwrap();
        let ef: f64 = row[7].parse().unwrap();
        // A sphere that shrinks to four fifths loses 1 − 0.8³ of its volume.
        assert!((ef - 0.488).abs() < 1e-9, "{ef}");
        assert_eq!([&row[2], &row[3]], ["0", "1"]);
        let written = subjects_json(&subjects);
        assert_eq!(written[0]["id"], "P, \"1\"");
        assert_eq!(written[0]["ef"], ef);
        assert_eq!(written[0]["phase_source"], "volume curve");
        let keys: Vec<&String> = written[0].as_object().unwrap().keys().collect();
        assert_eq!(keys[..3], ["id", "label", "end_diastole"]);
    }
}

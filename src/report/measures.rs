//! Clinical measures: a row per subject, and a row per frame.

use serde_json::{Value, json};

use super::column::{Cell, Column, Digits, Unit};
use super::table::{Row, json_row};
use crate::analysis::measures::{PhaseSource, SubjectMeasures};
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
}

const VOLUME: (Unit, Digits) = (Unit::Volume, Digits::OneBelowTen);

const fn volume(
    key: &'static str,
    heading: &'static str,
    explanation: &'static str,
    cell: fn(&SubjectRow) -> Cell,
) -> Column<SubjectRow> {
    Column::new(key, heading, VOLUME.0, VOLUME.1, explanation, cell)
}

impl SubjectRow {
    /// Its pseudonym.
    pub const SUBJECT: Column<Self> =
        Column::plain("subject", "Subject", "Pseudonym of the subject", |row| {
            (&row.subject).into()
        });
    /// What the study says.
    pub const LABEL: Column<Self> = Column::plain(
        "label",
        "Label",
        "Label that the study gives the subject; empty without one",
        |row| row.label.clone().into(),
    );
    /// Frame of end-diastole.
    pub const END_DIASTOLE: Column<Self> = Column::plain(
        "end_diastole",
        "ED",
        "Frame of end-diastole, numbered from 0",
        |row| row.end_diastole.into(),
    );
    /// Frame of end-systole.
    pub const END_SYSTOLE: Column<Self> = Column::plain(
        "end_systole",
        "ES",
        "Frame of end-systole, numbered from 0",
        |row| row.end_systole.into(),
    );
    /// End-diastolic volume.
    pub const EDV: Column<Self> =
        volume("edv", "EDV", "End-diastolic volume of the cavity", |row| {
            row.edv.into()
        });
    /// End-systolic volume.
    pub const ESV: Column<Self> =
        volume("esv", "ESV", "End-systolic volume of the cavity", |row| {
            row.esv.into()
        });
    /// Stroke volume.
    pub const SV: Column<Self> =
        volume("sv", "Stroke volume", "Stroke volume, EDV − ESV", |row| {
            row.sv.into()
        });
    /// Ejection fraction.
    pub const EF: Column<Self> = Column::new(
        "ef",
        "EF",
        Unit::Share,
        Digits::Places(0),
        "Ejection fraction, (EDV − ESV) / EDV, as a fraction",
        |row| row.ef.into(),
    );
    /// Mass of the myocardium.
    pub const MASS_G: Column<Self> = Column::new(
        "mass_g",
        "Mass",
        Unit::Symbol("g"),
        Digits::OneBelowTen,
        "Mass of the myocardium at end-diastole; empty where coordinates are not in mm",
        |row| row.mass_g.into(),
    );

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
        Column::plain(
            "volume_unit",
            "Unit",
            "Unit of the volumes: ml where coordinates are in mm, else units³",
            |row| row.unit.volume_symbol().into(),
        ),
        Column::plain(
            "phase_source",
            "Frames set by",
            "Source of end-diastole and end-systole: volume curve, or stated: set by the user or the study",
            |row| {
                Cell::Word(if row.phases_stated {
                    "stated"
                } else {
                    "volume curve"
                })
            },
        ),
    ];
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
    pub fn of_study(study: &Study, measures: &[SubjectMeasures]) -> Vec<Self> {
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

const fn size(
    key: &'static str,
    heading: &'static str,
    unit: Unit,
    explanation: &'static str,
    cell: fn(&FrameRow) -> Cell,
) -> Column<FrameRow> {
    Column::new(key, heading, unit, Digits::OneBelowTen, explanation, cell)
}

impl Row for FrameRow {
    const FILES: &'static [&'static str] = &["frames.csv"];
    const ROW: &'static str =
        "Volumes and areas, a row per frame; empty where the surface is missing";
    const COLUMNS: &'static [Column<Self>] = &[
        Column::plain("subject", "Subject", "Pseudonym of the subject", |row| {
            (&row.subject).into()
        }),
        Column::plain("frame", "Frame", "Frame, numbered from 0", |row| {
            row.frame.into()
        }),
        size(
            "endo_volume",
            "Endocardial volume",
            Unit::Volume,
            "Volume inside the endocardium or of the cavity, closed at the base",
            |row| row.endo_volume.into(),
        ),
        size(
            "epi_volume",
            "Epicardial volume",
            Unit::Volume,
            "Volume inside the epicardium, closed at the base",
            |row| row.epi_volume.into(),
        ),
        Column::plain(
            "volume_unit",
            "Unit",
            "Unit of the volumes: ml where coordinates are in mm, else units³",
            |row| row.unit.volume_symbol().into(),
        ),
        size(
            "wall_volume",
            "Wall volume",
            Unit::Volume,
            "Volume of the myocardium: epicardial less endocardial, or that of a closed wall",
            |row| row.wall_volume.into(),
        ),
        size(
            "endo_area",
            "Endocardial area",
            Unit::Area,
            "Area of the endocardium or cavity",
            |row| row.endo_area.into(),
        ),
        size(
            "epi_area",
            "Epicardial area",
            Unit::Area,
            "Area of the epicardium",
            |row| row.epi_area.into(),
        ),
        Column::plain(
            "area_unit",
            "Unit",
            "Unit of the areas: cm² where coordinates are in mm, else units²",
            |row| row.unit.area_symbol().into(),
        ),
        Column::new(
            "time_s",
            "Time",
            Unit::Symbol("s"),
            Digits::Places(3),
            "Time of the frame after the R peak; frames share the cycle evenly where the study gives its length alone; empty \
             where it gives neither",
            |row| row.time_s.into(),
        ),
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
        let frames = csv(&FrameRow::of_study(&study, &measures));
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

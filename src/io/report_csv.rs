//! Results as tables for scripts: names and order of columns are fixed, units stand in a column.

use crate::analysis::deformations::DeformationMap;
use crate::analysis::embedding::Embedding;
use crate::analysis::measures::{PhaseSource, SubjectMeasures};
use crate::analysis::pose_distances::{PoseDistances, PoseId};
use crate::study::Study;

/// Volumes and areas of every frame. Cells are empty where a surface is not there; volumes are in
/// `volume_unit`, areas in `area_unit`.
pub fn frames_csv(study: &Study, measures: &[SubjectMeasures]) -> String {
    let mut table = Table::new(&[
        "subject",
        "frame",
        "endo_volume",
        "epi_volume",
        "volume_unit",
        "wall_volume",
        "endo_area",
        "epi_area",
        "area_unit",
    ]);
    for (subject, measured) in study.subjects.iter().zip(measures) {
        for (index, frame) in measured.frames.iter().enumerate() {
            table.row([
                subject.id.clone(),
                index.to_string(),
                number(frame.endo_volume),
                number(frame.epi_volume),
                measured.unit.volume_symbol().to_owned(),
                number(frame.wall_volume),
                number(frame.endo_area),
                number(frame.epi_area),
                measured.unit.area_symbol().to_owned(),
            ]);
        }
    }
    table.text
}

/// Clinical measures, a row per subject: frames are numbered from 0, `ef` is a fraction, volumes
/// are in `volume_unit`.
pub fn subjects_csv(study: &Study, measures: &[SubjectMeasures]) -> String {
    let mut table = Table::new(&[
        "subject",
        "label",
        "end_diastole",
        "end_systole",
        "edv",
        "esv",
        "sv",
        "ef",
        "mass_g",
        "volume_unit",
        "phase_source",
    ]);
    for (subject, measured) in study.subjects.iter().zip(measures) {
        let whole = |frame: Option<usize>| frame.map_or_else(String::new, |f| f.to_string());
        table.row([
            subject.id.clone(),
            subject.label.clone().unwrap_or_default(),
            whole(measured.end_diastole),
            whole(measured.end_systole),
            number(measured.edv),
            number(measured.esv),
            number(measured.sv),
            number(measured.ef),
            number(measured.mass.map(|mass| mass.0)),
            measured.unit.volume_symbol().to_owned(),
            phase_source(measured.phase_source).to_owned(),
        ]);
    }
    table.text
}

/// The square matrix of distances: a row per pose, with a column per pose after its name.
pub fn distances_csv(study: &Study, distances: &PoseDistances) -> String {
    let mut header = vec!["subject".to_owned(), "frame".to_owned()];
    let name = |pose: &PoseId| format!("{}:{}", subject_id(study, pose), pose.frame);
    header.extend(distances.poses.iter().map(name));
    let mut table = Table::new(&header);
    for (i, pose) in distances.poses.iter().enumerate() {
        let mut row = vec![subject_id(study, pose), pose.frame.to_string()];
        let matrix = &distances.distances;
        row.extend((0..matrix.size()).map(|j| matrix.get(i, j).to_string()));
        table.row(row);
    }
    table.text
}

/// Places of all poses on a map of two dimensions, without unit where the metric has none.
pub fn poses_csv(study: &Study, poses: &[PoseId], map: &Embedding) -> String {
    let mut table = Table::new(&["subject", "frame", "x", "y"]);
    for (item, pose) in poses.iter().enumerate().take(map.len()) {
        let at = |axis: usize| number(map.point(item).get(axis).copied());
        table.row([
            subject_id(study, pose),
            pose.frame.to_string(),
            at(0),
            at(1),
        ]);
    }
    table.text
}

/// Places of whole deformations on their map, a row per heart; without unit, since the columns of a
/// locally linear map have length 1.
pub fn deformations_csv(study: &Study, map: &DeformationMap) -> String {
    let mut table = Table::new(&["subject", "label", "x", "y"]);
    for (row, &index) in map.subjects.iter().enumerate().take(map.embedding.len()) {
        let subject = study.subjects.get(index);
        let at = |axis: usize| number(map.embedding.point(row).get(axis).copied());
        table.row([
            subject.map_or_else(String::new, |subject| subject.id.clone()),
            subject.and_then(|s| s.label.clone()).unwrap_or_default(),
            at(0),
            at(1),
        ]);
    }
    table.text
}

/// The word for where phases come from.
pub(super) fn phase_source(source: PhaseSource) -> &'static str {
    match source {
        PhaseSource::VolumeCurve => "volume curve",
        PhaseSource::Stated => "stated",
    }
}

fn subject_id(study: &Study, pose: &PoseId) -> String {
    let subject = study.subjects.get(pose.subject);
    subject.map_or_else(String::new, |subject| subject.id.clone())
}

/// The shortest text that reads back as the same number; empty where there is none.
pub(super) fn number(value: Option<f64>) -> String {
    value.map_or_else(String::new, |value| value.to_string())
}

/// Rows of cells; cells that need quotes get them.
pub(super) struct Table {
    pub(super) text: String,
}

impl Table {
    /// Rows to be added to those of another, without a header.
    pub(super) fn empty() -> Self {
        Self {
            text: String::new(),
        }
    }

    pub(super) fn new<S: AsRef<str>>(header: &[S]) -> Self {
        let mut table = Self::empty();
        table.row(header.iter().map(|name| name.as_ref().to_owned()));
        table
    }

    pub(super) fn row(&mut self, cells: impl IntoIterator<Item = String>) {
        for (column, cell) in cells.into_iter().enumerate() {
            if column > 0 {
                self.text.push(',');
            }
            if cell.contains([',', '"', '\n', '\r']) {
                self.text += &format!("\"{}\"", cell.replace('"', "\"\""));
            } else {
                self.text += &cell;
            }
        }
        self.text.push('\n');
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::measures::measure_study;
    use crate::analysis::pose_distances::DistanceMatrix;
    use crate::mesh::phantom;
    use crate::progress::Progress;
    use crate::study::{MeshSequence, Subject, SurfaceKind, SurfaceSequence};
    use crate::units::LengthUnit;
    use std::sync::Arc;

    fn study() -> Study {
        let frames = vec![phantom::sphere(3, 30.0), phantom::sphere(3, 24.0)];
        let surface = SurfaceSequence::new(SurfaceKind::Cavity, frames).unwrap();
        let sequence = MeshSequence::new(vec![surface]).unwrap();
        let mut subject = Subject::new("P, \"1\"", sequence, LengthUnit::Millimetre);
        subject.label = Some("MINF".to_owned());
        Study {
            subjects: vec![Arc::new(subject)],
            ..Study::default()
        }
    }

    #[test]
    fn tables_read_back_with_their_columns_and_quoted_names() {
        let study = study();
        let measures = measure_study(&study, &Progress::default()).unwrap();
        let frames = frames_csv(&study, &measures);
        let mut reader = csv::Reader::from_reader(frames.as_bytes());
        let columns: Vec<_> = reader
            .headers()
            .unwrap()
            .iter()
            .take(5)
            .map(str::to_owned)
            .collect();
        assert_eq!(
            columns,
            [
                "subject",
                "frame",
                "endo_volume",
                "epi_volume",
                "volume_unit"
            ]
        );
        let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
        assert_eq!(rows.len(), 2);
        assert_eq!(&rows[0][0], "P, \"1\"");
        assert_eq!(&rows[1][4], "ml");
        assert_eq!(&rows[1][3], "");
        let subjects = subjects_csv(&study, &measures);
        let mut reader = csv::Reader::from_reader(subjects.as_bytes());
        let row = reader.records().next().unwrap().unwrap();
        let ef: f64 = row[7].parse().unwrap();
        // A sphere that shrinks to four fifths loses 1 − 0.8³ of its volume.
        assert!((ef - 0.488).abs() < 1e-9, "{ef}");
        assert_eq!(&row[2], "0");
        assert_eq!(&row[3], "1");
    }

    #[test]
    fn deformations_stand_a_row_per_heart_with_its_label() {
        let map = DeformationMap {
            subjects: vec![0],
            curves: vec![vec![[0.0; 3]]],
            time_weight: 1.0,
            embedding: Embedding {
                dimensions: 2,
                coordinates: vec![-0.25, 0.1 + 0.2],
                ..Embedding::default()
            },
        };
        let table = deformations_csv(&study(), &map);
        assert_eq!(
            table,
            "subject,label,x,y\n\"P, \"\"1\"\"\",MINF,-0.25,0.30000000000000004\n"
        );
    }

    #[test]
    fn the_matrix_is_square_and_symmetric() {
        let pose = |frame| PoseId { subject: 0, frame };
        let distances = PoseDistances {
            poses: vec![pose(0), pose(1)],
            distances: DistanceMatrix::from_upper(2, vec![0.1 + 0.2]).unwrap(),
            left_out: Vec::new(),
        };
        let table = distances_csv(&study(), &distances);
        let mut reader = csv::Reader::from_reader(table.as_bytes());
        let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
        assert_eq!(rows.len(), 2);
        assert_eq!(&rows[0][3], &rows[1][2]);
        assert_eq!(rows[0][3].parse::<f64>().unwrap(), 0.1 + 0.2);
        assert_eq!(&rows[0][2], "0");
    }
}

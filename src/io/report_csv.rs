//! Tables of results: measures, distances and maps as CSV, the same bytes for the same results.

use std::io::Write;

use crate::analysis::embedding::Embedding;
use crate::analysis::measures::SubjectMeasures;
use crate::analysis::pose_distances::{PoseDistances, PoseId};
use crate::study::{Study, Subject, SurfaceKind};

/// Why a report cannot be written.
#[derive(Debug, thiserror::Error)]
pub enum ReportError {
    /// Results of another study, or of another state of it.
    #[error("{results} results for {expected} {of}")]
    Counts {
        /// What is counted.
        of: &'static str,
        /// How many results there are.
        results: usize,
        /// How many there should be.
        expected: usize,
    },
    /// A result names a subject that the study does not have.
    #[error("a result for subject {index} of a study of {count}")]
    NoSubject {
        /// The index it names.
        index: usize,
        /// How many subjects there are.
        count: usize,
    },
    /// The table cannot be written.
    #[error(transparent)]
    Csv(#[from] csv::Error),
    /// The file cannot be written.
    #[error(transparent)]
    Io(#[from] std::io::Error),
    /// The summary cannot be written.
    #[error(transparent)]
    Json(#[from] serde_json::Error),
}

/// `frames.csv`: a row per frame, `subject,frame,endo_volume,epi_volume,volume_unit`, and
/// `wall_volume` at the end if a subject of the study has a wall given as one surface.
///
/// Cells of what is not known are empty. Numbers are the shortest that read back as the same.
///
/// # Errors
/// If measures are not one per subject, or writing fails.
pub fn write_frames_csv(
    study: &Study,
    measures: &[SubjectMeasures],
    out: impl Write,
) -> Result<(), ReportError> {
    let with_wall = study
        .subjects
        .iter()
        .any(|subject| subject.sequence.surface(SurfaceKind::Wall).is_some());
    let mut table = csv::Writer::from_writer(out);
    let mut header = vec!["subject", "frame", "endo_volume", "epi_volume", "volume_unit"];
    header.extend(with_wall.then_some("wall_volume"));
    table.write_record(header)?;
    for (subject, measured) in rows(study, measures)? {
        let of_wall = subject.sequence.surface(SurfaceKind::Wall).is_some();
        for (frame, sizes) in measured.frames.iter().enumerate() {
            let mut row = vec![
                subject.id.clone(),
                frame.to_string(),
                cell(sizes.endo_volume),
                cell(sizes.epi_volume),
                measured.unit.volume_symbol().to_owned(),
            ];
            if with_wall {
                row.push(cell(sizes.wall_volume.filter(|_| of_wall)));
            }
            table.write_record(row)?;
        }
    }
    Ok(table.flush()?)
}

/// `subjects.csv`: a row per subject, `subject,label,end_diastole,end_systole,edv,esv,sv,ef,mass_g`;
/// volumes in the unit that `frames.csv` names, `ef` as a fraction.
///
/// # Errors
/// If measures are not one per subject, or writing fails.
pub fn write_subjects_csv(
    study: &Study,
    measures: &[SubjectMeasures],
    out: impl Write,
) -> Result<(), ReportError> {
    let mut table = csv::Writer::from_writer(out);
    table.write_record([
        "subject",
        "label",
        "end_diastole",
        "end_systole",
        "edv",
        "esv",
        "sv",
        "ef",
        "mass_g",
    ])?;
    for (subject, measured) in rows(study, measures)? {
        table.write_record([
            subject.id.clone(),
            subject.label.clone().unwrap_or_default(),
            cell(measured.end_diastole),
            cell(measured.end_systole),
            cell(measured.edv),
            cell(measured.esv),
            cell(measured.sv),
            cell(measured.ef),
            cell(measured.mass.map(|mass| mass.0)),
        ])?;
    }
    Ok(table.flush()?)
}

/// `distances.csv`: the whole symmetric matrix, a row per pose. The columns are `subject,frame`,
/// then one per pose, named `subject:frame`, in the order of the rows.
///
/// # Errors
/// If a pose names a subject that is not there, or writing fails.
pub fn write_distances_csv(
    study: &Study,
    distances: &PoseDistances,
    out: impl Write,
) -> Result<(), ReportError> {
    let (poses, matrix) = (&distances.poses, &distances.distances);
    check_counts("poses", matrix.size(), poses.len())?;
    let mut table = csv::Writer::from_writer(out);
    let mut header = vec!["subject".to_owned(), "frame".to_owned()];
    for pose in poses {
        header.push(format!("{}:{}", subject_of(study, *pose)?.id, pose.frame));
    }
    table.write_record(header)?;
    for (row, pose) in poses.iter().enumerate() {
        table.write_field(&subject_of(study, *pose)?.id)?;
        table.write_field(pose.frame.to_string())?;
        for column in 0..poses.len() {
            table.write_field(matrix.get(row, column).to_string())?;
        }
        table.write_record(None::<&[u8]>)?;
    }
    Ok(table.flush()?)
}

/// `poses_mds.csv`: a row per pose, `subject,frame,x,y`; further coordinates of the map are left
/// out, and `y` is empty on a line.
///
/// # Errors
/// If points are not one per pose, a pose names a subject that is not there, or writing fails.
pub fn write_poses_mds_csv(
    study: &Study,
    poses: &[PoseId],
    map: &Embedding,
    out: impl Write,
) -> Result<(), ReportError> {
    check_counts("poses", map.len(), poses.len())?;
    let mut table = csv::Writer::from_writer(out);
    table.write_record(["subject", "frame", "x", "y"])?;
    for (item, pose) in poses.iter().enumerate() {
        let point = map.point(item);
        table.write_record([
            subject_of(study, *pose)?.id.clone(),
            pose.frame.to_string(),
            cell(point.first()),
            cell(point.get(1)),
        ])?;
    }
    Ok(table.flush()?)
}

/// Subjects with their measures, which must be as many.
pub(super) fn rows<'a>(
    study: &'a Study,
    measures: &'a [SubjectMeasures],
) -> Result<impl Iterator<Item = (&'a Subject, &'a SubjectMeasures)>, ReportError> {
    check_counts("subjects", measures.len(), study.subjects.len())?;
    Ok(study.subjects.iter().map(AsRef::as_ref).zip(measures))
}

fn check_counts(of: &'static str, results: usize, expected: usize) -> Result<(), ReportError> {
    if results == expected {
        Ok(())
    } else {
        Err(ReportError::Counts {
            of,
            results,
            expected,
        })
    }
}

fn subject_of(study: &Study, pose: PoseId) -> Result<&Subject, ReportError> {
    study
        .subjects
        .get(pose.subject)
        .map(AsRef::as_ref)
        .ok_or(ReportError::NoSubject {
            index: pose.subject,
            count: study.subjects.len(),
        })
}

fn cell(value: Option<impl ToString>) -> String {
    value.map_or_else(String::new, |value| value.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::measures::{FrameMeasures, PhaseSource};
    use crate::analysis::pose_distances::DistanceMatrix;
    use crate::mesh::phantom;
    use crate::study::{MeshSequence, SurfaceSequence};
    use crate::units::{Grams, LengthUnit};

    fn study(kinds: &[SurfaceKind]) -> Study {
        let subjects = kinds.iter().enumerate().map(|(index, &kind)| {
            let surface = SurfaceSequence::new(kind, vec![phantom::sphere(0, 1.0); 2]).unwrap();
            let sequence = MeshSequence::new(vec![surface]).unwrap();
            Subject::new(format!("S{index}"), sequence, LengthUnit::FileUnit).into()
        });
        Study {
            subjects: subjects.collect(),
            ..Study::default()
        }
    }

    fn measures(unit: LengthUnit) -> SubjectMeasures {
        let frame = |endo: f64| FrameMeasures {
            endo_volume: Some(endo),
            wall_volume: Some(80.5),
            ..FrameMeasures::default()
        };
        SubjectMeasures {
            unit,
            frames: vec![frame(120.0), frame(48.0)],
            end_diastole: Some(0),
            end_systole: Some(1),
            phase_source: PhaseSource::VolumeCurve,
            edv: Some(120.0),
            esv: Some(48.0),
            sv: Some(72.0),
            ef: Some(0.6),
            mass: (unit == LengthUnit::Millimetre).then_some(Grams(84.525)),
        }
    }

    fn text(write: impl FnOnce(&mut Vec<u8>) -> Result<(), ReportError>) -> String {
        let mut bytes = Vec::new();
        write(&mut bytes).unwrap();
        String::from_utf8(bytes).unwrap()
    }

    #[test]
    fn frames_have_the_columns_that_scripts_rely_on() {
        let measured = [measures(LengthUnit::Millimetre)];
        assert_eq!(
            text(|out| write_frames_csv(&study(&[SurfaceKind::Cavity]), &measured, out)),
            "subject,frame,endo_volume,epi_volume,volume_unit\n\
             S0,0,120,,ml\n\
             S0,1,48,,ml\n"
        );
    }

    #[test]
    fn walls_bring_a_column_that_is_empty_for_other_hearts() {
        let measured = [measures(LengthUnit::FileUnit), measures(LengthUnit::Millimetre)];
        let study = study(&[SurfaceKind::Wall, SurfaceKind::Cavity]);
        let table = text(|out| write_frames_csv(&study, &measured, out));
        let lines: Vec<&str> = table.lines().collect();
        assert_eq!(lines[0], "subject,frame,endo_volume,epi_volume,volume_unit,wall_volume");
        assert_eq!(lines[1], "S0,0,120,,units³,80.5");
        assert_eq!(lines[3], "S1,0,120,,ml,");
    }

    #[test]
    fn subjects_have_their_indices_and_labels_that_need_quotes_get_them() {
        let mut study = study(&[SurfaceKind::Cavity]);
        let mut subject = Subject::clone(&study.subjects[0]);
        subject.label = Some("dilated, \"mild\"".to_owned());
        study.subjects[0] = subject.into();
        let measured = [measures(LengthUnit::Millimetre)];
        assert_eq!(
            text(|out| write_subjects_csv(&study, &measured, out)),
            "subject,label,end_diastole,end_systole,edv,esv,sv,ef,mass_g\n\
             S0,\"dilated, \"\"mild\"\"\",0,1,120,48,72,0.6,84.525\n"
        );
    }

    #[test]
    fn distances_are_a_matrix_and_maps_a_list() {
        let study = study(&[SurfaceKind::Cavity, SurfaceKind::Cavity]);
        let pose = |subject, frame| PoseId { subject, frame };
        let poses = vec![pose(0, 0), pose(0, 1), pose(1, 0)];
        let distances = PoseDistances {
            distances: DistanceMatrix::from_upper(3, vec![0.25, 1.5, 2.0]).unwrap(),
            poses: poses.clone(),
            left_out: Vec::new(),
        };
        assert_eq!(
            text(|out| write_distances_csv(&study, &distances, out)),
            "subject,frame,S0:0,S0:1,S1:0\n\
             S0,0,0,0.25,1.5\n\
             S0,1,0.25,0,2\n\
             S1,0,1.5,2,0\n"
        );
        let map = Embedding {
            dimensions: 2,
            coordinates: vec![0.5, -1.0, 0.25, 0.0, 1e-7, 3.0],
            stress: None,
            eigenvalues: None,
            iterations: None,
        };
        assert_eq!(
            text(|out| write_poses_mds_csv(&study, &poses, &map, out)),
            "subject,frame,x,y\nS0,0,0.5,-1\nS0,1,0.25,0\nS1,0,0.0000001,3\n"
        );
    }

    #[test]
    fn results_of_another_study_are_refused() {
        let study = study(&[SurfaceKind::Cavity]);
        let error = write_subjects_csv(&study, &[], Vec::new()).unwrap_err();
        assert_eq!(error.to_string(), "0 results for 1 subjects");
        let stray = PoseDistances {
            poses: vec![PoseId { subject: 4, frame: 0 }],
            distances: DistanceMatrix::from_upper(1, Vec::new()).unwrap(),
            left_out: Vec::new(),
        };
        let error = write_distances_csv(&study, &stray, Vec::new()).unwrap_err();
        assert_eq!(error.to_string(), "a result for subject 4 of a study of 1");
    }
}

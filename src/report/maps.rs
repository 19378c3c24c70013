//! Distances of poses, and places of poses, deformations and medial poses on their maps.

use serde_json::{Value, json};

use super::cell_text::cell_text;
use super::column::{Column, ColumnWords, column};
use super::shared;
use super::table::{Row, TableWords, records};
use crate::analysis::deformations::{DeformationMap, PartDistances};
use crate::analysis::embedding::Embedding;
use crate::analysis::medial_map::MedialMap;
use crate::analysis::metrics::{Corners, CurvatureMean, Regulariser};
use crate::analysis::pose_distances::{PoseDistanceParams, PoseDistances, PoseId};
use crate::analysis::transport::Reference;
use crate::study::Study;

/// Columns that stand before those of the poses.
const POSE_COLUMNS: [ColumnWords; 2] = [
    ColumnWords {
        key: "subject",
        heading: "Subject",
        unit: "",
        explanation: "Pseudonym of the pose's subject",
    },
    ColumnWords {
        key: "frame",
        heading: "Frame",
        unit: "",
        explanation: "Frame of the pose, numbered from 0",
    },
];

/// The lines of `distances.csv`, a square matrix: a row per pose, with a column per pose behind its name. One after the
/// other, since those of a large cohort do not fit into memory.
pub fn distances_csv<'a>(
    study: &'a Study,
    distances: &'a PoseDistances,
) -> impl Iterator<Item = String> + 'a {
    let name = |pose: &PoseId| {
        let name = format!("{}:{}", subject_id(study, pose.subject), pose.frame);
        cell_text(&name).into_owned()
    };
    let header = (POSE_COLUMNS.iter().map(|column| column.key.to_owned()))
        .chain(distances.poses.iter().map(name));
    let matrix = &distances.distances;
    let rows = distances.poses.iter().enumerate().map(move |(i, pose)| {
        let id = subject_id(study, pose.subject);
        let mut row = vec![cell_text(&id).into_owned(), pose.frame.to_string()];
        row.extend((0..matrix.size()).map(|j| matrix.get(i, j).to_string()));
        row
    });
    let header: Vec<String> = header.collect();
    std::iter::once(header)
        .chain(rows)
        .map(|row| records(std::iter::once(row)))
}

pub(super) fn distances_described() -> TableWords {
    TableWords {
        files: &["distances.csv"],
        row: "Distances of all poses, a row per pose; distances.json says by which metric. With `--distances npy` the numbers \
              alone stand in distances.npy, an array of NumPy with the poses of poses_mds.csv as rows and columns",
        columns: POSE_COLUMNS.to_vec(),
        further: Some(
            "a column per pose, named subject:frame, with the distance; without unit where the metric is \
             scale-invariant",
        ),
    }
}

/// By which metric the distances of `table` are: the words of the command line's options, and one
/// sentence; and where its rows are listed. It stands in a file of its own, since scripts read all columns of the matrix behind the second.
pub fn distances_json(
    study: &Study,
    params: &PoseDistanceParams,
    words: &str,
    table: &str,
) -> Value {
    let metric = &params.metric;
    let transport = params.transport.map(|transport| match transport.reference {
        Reference::Mean => "mean".to_owned(),
        Reference::Subject(index) => subject_id(study, index),
    });
    json!({
        "table": table,
        "rows": "poses_mds.csv",
        "in_words": words,
        "metric": metric.kind.words().id,
        "form": metric.form.id(),
        "corners": match metric.corners {
            Corners::Raw => "raw",
            Corners::ScaleFree => "scale-free",
        },
        "area_weights": metric.area_weights,
        "mu": metric.mu,
        "curvature_radius": match metric.curvature {
            CurvatureMean::Radius(share) => Some(share),
            CurvatureMean::Rings(_) => None,
        },
        "curvature_rings": match metric.curvature {
            CurvatureMean::Radius(_) => None,
            CurvatureMean::Rings(rings) => Some(rings),
        },
        "lambda": metric.lambda,
        "regulariser": match metric.regulariser {
            Regulariser::Uniform => "uniform",
            Regulariser::Area => "area",
        },
        "smoothing": params.smoothing,
        "transfer": transport.unwrap_or_else(|| "none".to_owned()),
    })
}

/// Coordinates of items on a map of any number of dimensions, a row per item.
pub fn coordinates_csv(map: &Embedding) -> String {
    let rows = (0..map.len()).map(|item| map.point(item).iter().map(f64::to_string).collect());
    records(std::iter::once(axis_names(map.dimensions)).chain(rows))
}

/// x, y, z, then x4, x5, …
fn axis_names(dimensions: usize) -> Vec<String> {
    (0..dimensions)
        .map(|axis| match axis {
            0 => "x".to_owned(),
            1 => "y".to_owned(),
            2 => "z".to_owned(),
            more => format!("x{}", more + 1),
        })
        .collect()
}

/// Place of one pose on a map.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PoseRow {
    /// Pseudonym.
    pub subject: String,
    /// From 0.
    pub frame: usize,
    /// Its place.
    pub place: [Option<f64>; 2],
}

impl PoseRow {
    /// One row per pose of the map.
    pub fn of_map(study: &Study, poses: &[PoseId], map: &Embedding) -> Vec<Self> {
        let poses = poses.iter().enumerate().take(map.len());
        poses
            .map(|(item, pose)| Self {
                subject: subject_id(study, pose.subject),
                frame: pose.frame,
                place: place(map, item),
            })
            .collect()
    }
}

impl Row for PoseRow {
    const FILES: &'static [&'static str] =
        &["poses_mds.csv", "poses_smacof.csv", "poses_isomap.csv"];
    const ROW: &'static str = "Pose map: embedding of the distances between poses (classical MDS, SMACOF, Isomap), a row per pose";
    const COLUMNS: &'static [Column<Self>] = &[
        shared::subject(|row| (&row.subject).into()),
        shared::frame(|row| row.frame.into()),
        shared::map_x(|row| row.place[0].into()),
        shared::map_y(|row| row.place[1].into()),
    ];
}

/// Place of one subject's whole deformation on the deformation map.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DeformationRow {
    /// Pseudonym.
    pub subject: String,
    /// What the study says.
    pub label: Option<String>,
    /// Its place.
    pub place: [Option<f64>; 2],
    /// The subject that is nearest by the distances that are mapped.
    pub nearest: Option<String>,
    /// How far that is.
    pub distance: Option<f64>,
    /// Part of the distance that is of deformations, before weights.
    pub deformation: Option<f64>,
    /// Part of the distance that is of shapes, before weights.
    pub shape: Option<f64>,
    /// Share of shape in both parts, each over its median, in `0.0..=1.0`.
    pub shape_share: Option<f64>,
}

impl DeformationRow {
    /// One row per subject of the map.
    pub fn of_map(study: &Study, map: &DeformationMap) -> Vec<Self> {
        let subjects = map.subjects.iter().enumerate().take(map.embedding.len());
        subjects
            .map(|(row, &index)| {
                let near = map.parts.as_ref().and_then(|mapped| {
                    let others = (0..map.subjects.len()).filter(|other| *other != row);
                    let apart = |other: &usize| mapped.distances.get(row, *other);
                    Some((mapped, others.min_by(|a, b| apart(a).total_cmp(&apart(b)))?))
                });
                let of = |value: fn(&PartDistances, usize, usize) -> Option<f64>| {
                    near.and_then(|(mapped, other)| value(&mapped.parts, row, other))
                };
                Self {
                    subject: subject_id(study, index),
                    label: study.subjects.get(index).and_then(|s| s.label.clone()),
                    place: place(&map.embedding, row),
                    nearest: near.map(|(_, other)| subject_id(study, map.subjects[other])),
                    distance: near.map(|(mapped, other)| mapped.distances.get(row, other)),
                    deformation: of(|parts, i, j| Some(parts.deformation.get(i, j))),
                    shape: of(|parts, i, j| Some(parts.shape.get(i, j))),
                    shape_share: of(PartDistances::shape_share),
                }
            })
            .collect()
    }
}

impl Row for DeformationRow {
    const FILES: &'static [&'static str] = &["deformations_lle.csv"];
    const ROW: &'static str =
        "Deformation map: locally linear embedding (LLE) of whole motions, a row per subject";
    const COLUMNS: &'static [Column<Self>] = &[
        shared::subject(|row| (&row.subject).into()),
        shared::label(|row| row.label.as_deref().into()),
        column("x", "Map x", |row: &Self| row.place[0].into()).coordinate(
            "First coordinate on the map; each coordinate has root sum of squares 1 \
                     over the subjects",
        ),
        shared::map_y(|row| row.place[1].into()),
        column("nearest", "Nearest", |row: &Self| {
            row.nearest.as_deref().into()
        })
        .plain("Pseudonym of the subject with the least distance; empty where curves of poses are compared"),
        column("distance", "Distance", |row: &Self| row.distance.into()).plain(
            "Distance to the nearest subject: root of the weighted sum of the squares of both parts, each over its \
             median over all pairs",
        ),
        column("deformation", "Deformation", |row: &Self| {
            row.deformation.into()
        })
        .plain(
            "Part of that distance by deformation: root mean square over the beat of the norm of differences of \
             displacements from end-diastole, transported onto one shape",
        ),
        column("shape", "Shape", |row: &Self| row.shape.into())
            .plain("Part of that distance by shape: distance of the end-diastolic poses"),
        column("shape_share", "Share of shape", |row: &Self| {
            row.shape_share.into()
        })
        .plain("Share of shape in the squared distance to the nearest subject, both parts of equal weight, 0 to 1"),
    ];
}

/// Place of one step of a path in the medial shape space.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MedialPoseRow {
    /// Pseudonym.
    pub subject: String,
    /// First frame of the step.
    pub step_from: usize,
    /// Last frame of the step.
    pub step_to: usize,
    /// Number of the patch, from 0; `None` for all akinetic atoms together.
    pub patch: Option<usize>,
    /// Its place.
    pub place: [Option<f64>; 2],
}

impl MedialPoseRow {
    /// One row per step of all paths; none without a map.
    pub fn of_map(study: &Study, map: Option<&MedialMap>) -> Vec<Self> {
        let Some(map) = map else {
            return Vec::new();
        };
        let poses = map.poses.iter().enumerate();
        poses
            .map(|(row, pose)| Self {
                subject: subject_id(study, pose.subject),
                step_from: pose.step_from,
                step_to: pose.step_to,
                patch: pose.part.patch(),
                place: place(&map.embedding, row),
            })
            .collect()
    }
}

impl Row for MedialPoseRow {
    const FILES: &'static [&'static str] = &["medial_mds.csv"];
    const ROW: &'static str = "Medial map: classical MDS of the poses of akinetic regions in the medial shape space, a row per step of a path";
    const COLUMNS: &'static [Column<Self>] = &[
        shared::subject(|row| (&row.subject).into()),
        column("step_from", "From", |row: &Self| row.step_from.into())
            .plain("First frame of the step, numbered from 0"),
        column("step_to", "To", |row: &Self| row.step_to.into())
            .plain("Last frame of the step, numbered from 0"),
        column("patch", "Patch", |row: &Self| row.patch.into())
            .plain("Number of the patch as in patches.csv; empty for all akinetic atoms together"),
        shared::map_x(|row| row.place[0].into()),
        shared::map_y(|row| row.place[1].into()),
    ];
}

fn place(map: &Embedding, item: usize) -> [Option<f64>; 2] {
    let point = map.point(item);
    [0, 1].map(|axis| point.get(axis).copied())
}

fn subject_id(study: &Study, index: usize) -> String {
    let subject = study.subjects.get(index);
    subject.map_or_else(String::new, |subject| subject.id.clone())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::pose_distances::DistanceMatrix;
    use crate::mesh::phantom;
    use crate::report::{csv, testing};

    fn study() -> Study {
        testing::study(&[("P, \"1\"", "MINF")], vec![phantom::sphere(1, 30.0)])
    }

    #[test]
    fn deformations_stand_a_row_per_heart_with_its_label() {
        let map = DeformationMap {
            subjects: vec![0],
            curves: vec![vec![[0.0; 3]]],
            time_weight: Some(1.0),
            parts: None,
            embedding: Embedding {
                dimensions: 2,
                coordinates: vec![-0.25, 0.1 + 0.2],
                ..Embedding::default()
            },
        };
        let table = csv(&DeformationRow::of_map(&study(), &map));
        assert_eq!(
            table,
            "subject,label,x,y,nearest,distance,deformation,shape,shape_share\n\
             \"P, \"\"1\"\"\",MINF,-0.25,0.30000000000000004,,,,,\n"
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
        let study = study();
        let table: String = distances_csv(&study, &distances).collect();
        let mut reader = csv::Reader::from_reader(table.as_bytes());
        assert_eq!(&reader.headers().unwrap()[3], "P, \"1\":1");
        let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
        assert_eq!(rows.len(), 2);
        assert_eq!(&rows[0][3], &rows[1][2]);
        assert_eq!(rows[0][3].parse::<f64>().unwrap(), 0.1 + 0.2);
        assert_eq!(&rows[0][2], "0");
    }

    #[test]
    fn distances_name_the_metric_by_the_words_of_its_options() {
        let params = PoseDistanceParams::default();
        let written = distances_json(&study(), &params, "in one sentence", "distances.csv");
        assert_eq!(written["metric"], "displacement");
        assert_eq!(written["form"], "additive");
        assert_eq!(written["in_words"], "in one sentence");
        assert_eq!(written["transfer"], "none");
        assert_eq!(written["mu"], params.metric.mu);
    }

    #[test]
    fn axes_beyond_the_third_are_numbered() {
        assert_eq!(axis_names(5), ["x", "y", "z", "x4", "x5"]);
    }
}

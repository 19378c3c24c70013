//! Axes in which positions and normals of different subjects can be compared.

use nalgebra::{Matrix3, Rotation3};

use crate::analysis::medial_space::PoseDescriptor;
use crate::analysis::segments::LongAxis;
use crate::mesh::{Point3, Vector3, bounding_box};

/// Which directions of a subject are known.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Frame {
    /// Septum, anterior wall and base: the same in every subject.
    Anatomical,
    /// The long axis; around it directions are those of the files.
    LongAxis,
    /// Directions are those of the files.
    Files,
}

impl Frame {
    /// How many there are.
    pub const COUNT: usize = 3;

    /// From the most that can be known to the least.
    pub const ALL: [Self; Self::COUNT] = [Self::Anatomical, Self::LongAxis, Self::Files];

    /// The words for it.
    pub fn words(self) -> &'static str {
        match self {
            Self::Anatomical => "directions from septum, anterior wall and base",
            Self::LongAxis => "directions around the long axis as in the files",
            Self::Files => "directions as in the files",
        }
    }
}

/// Takes positions and normals of one subject to where those of all subjects can be compared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// Rows are the axes of the frame in coordinates.
    frame_from_coordinates: Matrix3<f64>,
    /// Middle of the subject's box along these axes, in coordinates turned into the frame.
    middle: Vector3,
    /// Largest side of that box, in coordinates.
    size: f64,
}

impl Placement {
    /// Of a subject with these centres of atoms at end-diastole. `None` where the frame is not known, or
    /// the subject has no extent.
    ///
    /// Positions are counted from the middle of the box of the centres along the axes of the frame, in
    /// units of its largest side, so that neither place nor size of a subject matters, and in the anatomical
    /// frame not how it lies.
    pub fn new(frame: Frame, axis: Option<&LongAxis>, centres: &[Point3]) -> Option<Self> {
        let frame_from_coordinates = match frame {
            Frame::Files => Matrix3::identity(),
            // By the smallest turn, so that angles around the axis stay as in the file.
            Frame::LongAxis => upright(&axis?.direction()),
            Frame::Anatomical => {
                let axis = axis.filter(|axis| axis.is_oriented())?;
                let rows = [axis.left, axis.up(), axis.direction()];
                Matrix3::from_rows(&rows.map(|row| row.transpose()))
            }
        };
        // Turned before it is measured: the box, and with it the size, lies along the axes of the frame.
        let turned: Vec<Point3> = (centres.iter())
            .map(|centre| frame_from_coordinates * centre)
            .collect();
        let [low, high] = bounding_box(&turned)?;
        let size = (high - low).max();
        // A surface without extent has no size to count positions in.
        (size > 0.0 && size.is_finite()).then(|| Self {
            frame_from_coordinates,
            middle: nalgebra::center(&low, &high).coords,
            size,
        })
    }

    /// The descriptor of a pose of this subject, in the frame.
    pub fn placed(&self, pose: &PoseDescriptor) -> PoseDescriptor {
        let turn = &self.frame_from_coordinates;
        PoseDescriptor {
            position: Point3::from((turn * pose.position.coords - self.middle) / self.size),
            // A direction has no place: it is turned only.
            normal: pose.normal.map(|normal| turn * normal),
            ..*pose
        }
    }
}

/// The smallest turn that takes a direction to z.
fn upright(direction: &Vector3) -> Matrix3<f64> {
    match Rotation3::rotation_between(direction, &Vector3::z()) {
        Some(turn) => turn.into_inner(),
        // Half a turn has no smallest: about x.
        None => Rotation3::from_axis_angle(&Vector3::x_axis(), std::f64::consts::PI).into_inner(),
    }
}

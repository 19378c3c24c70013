//! Points and polygons as a reader finds them, and what is done to make a mesh of them.

use super::{Limits, MeshFile, ReadMeshError};
use crate::mesh::{Faces, Point3, TriMesh};
use crate::study::Notice;

/// Where in a file something stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FilePosition {
    /// Line of a text file, from 1.
    Line(usize),
    /// Byte of a binary file, from 0.
    Byte(usize),
}

impl FilePosition {
    /// An error that names this place.
    pub(super) fn error(self, reason: impl Into<String>) -> ReadMeshError {
        let reason = reason.into();
        match self {
            Self::Line(line) => ReadMeshError::AtLine { line, reason },
            Self::Byte(byte) => ReadMeshError::AtByte { byte, reason },
        }
    }
}

/// What a reader has found so far. Points keep the numbers of the file, used or not, so that
/// vertices correspond over the frames of a sequence.
#[derive(Debug)]
pub(super) struct MeshDraft {
    limits: Limits,
    first_number: u64,
    points: Vec<Point3>,
    triangles: Vec<[u32; 3]>,
    /// References to points not yet read, each higher than those before it.
    ahead: Vec<(u32, FilePosition)>,
    polygons_split: usize,
    repeated_corners: usize,
    too_few_corners: usize,
    /// Points and lines, which are no part of a surface.
    not_surface: usize,
    notices: Vec<Notice>,
}

impl MeshDraft {
    /// An empty draft of a file that calls its first vertex `first_number`.
    pub(super) fn new(limits: &Limits, first_number: u64) -> Self {
        Self {
            limits: *limits,
            first_number,
            points: Vec::new(),
            triangles: Vec::new(),
            ahead: Vec::new(),
            polygons_split: 0,
            repeated_corners: 0,
            too_few_corners: 0,
            not_surface: 0,
            notices: Vec::new(),
        }
    }

    /// Number of points so far.
    pub(super) fn point_count(&self) -> usize {
        self.points.len()
    }

    /// Refuses a count of further points that a header gives, if it is over the limit, and
    /// reserves room for as many as `bytes_present` can hold.
    pub(super) fn expect_points(
        &mut self,
        count: u64,
        bytes_present: usize,
        bytes_each: usize,
    ) -> Result<(), ReadMeshError> {
        let total = count.saturating_add(self.points.len() as u64);
        check_count("vertices", total, self.limits.vertices)?;
        let room = bytes_present / bytes_each.max(1);
        self.points.reserve(room.min(count as usize));
        Ok(())
    }

    /// Refuses a count of further faces that a header gives, if it is over the limit.
    pub(super) fn expect_faces(&self, count: u64) -> Result<(), ReadMeshError> {
        let total = count.saturating_add(self.triangles.len() as u64);
        check_count("faces", total, self.limits.faces)
    }

    /// Refuses a polygon of more corners than the limit: it would be split from one corner into
    /// slivers that say nothing of a wall, and that what is computed around a vertex takes long over.
    pub(super) fn check_corners(
        &self,
        count: u64,
        place: FilePosition,
    ) -> Result<(), ReadMeshError> {
        let most = self.limits.polygon_corners;
        if count > most as u64 {
            return Err(place.error(format!("a polygon of {count} corners; the limit is {most}")));
        }
        Ok(())
    }

    /// Adds a point.
    pub(super) fn point(
        &mut self,
        xyz: [f64; 3],
        place: FilePosition,
    ) -> Result<(), ReadMeshError> {
        if let Some(x) = xyz.iter().find(|x| !x.is_finite()) {
            return Err(place.error(format!("coordinate {x} is not a finite number")));
        }
        if self.points.len() >= self.limits.vertices {
            let count = self.points.len() as u64 + 1;
            return check_count("vertices", count, self.limits.vertices);
        }
        self.points.push(Point3::from(xyz));
        Ok(())
    }

    /// Adds a polygon as a fan of triangles from its first corner.
    ///
    /// The fan depends on the order of the corners alone, never on their positions, so that
    /// every frame of a sequence is split alike. Corners may refer to points still to come.
    pub(super) fn polygon(
        &mut self,
        corners: &[u32],
        place: FilePosition,
    ) -> Result<(), ReadMeshError> {
        self.check_corners(corners.len() as u64, place)?;
        self.note_references(corners, place);
        let [first, rest @ ..] = corners else {
            self.too_few_corners += 1;
            return Ok(());
        };
        if rest.len() < 2 {
            self.too_few_corners += 1;
        }
        if rest.len() > 2 {
            self.polygons_split += 1;
        }
        for pair in rest.windows(2) {
            self.triangle([*first, pair[0], pair[1]])?;
        }
        Ok(())
    }

    /// Adds a strip: each corner from the third on makes a triangle with the two before it.
    pub(super) fn strip(
        &mut self,
        corners: &[u32],
        place: FilePosition,
    ) -> Result<(), ReadMeshError> {
        self.note_references(corners, place);
        if corners.len() < 3 {
            self.too_few_corners += 1;
        }
        for (at, three) in corners.windows(3).enumerate() {
            let [a, b, c] = [three[0], three[1], three[2]];
            self.triangle(if at % 2 == 0 { [a, b, c] } else { [b, a, c] })?;
        }
        Ok(())
    }

    fn note_references(&mut self, corners: &[u32], place: FilePosition) {
        for &corner in corners {
            let highest = self.ahead.last().map_or(0, |&(highest, _)| highest);
            if corner as usize >= self.points.len() && (self.ahead.is_empty() || corner > highest) {
                self.ahead.push((corner, place));
            }
        }
    }

    fn triangle(&mut self, corners: [u32; 3]) -> Result<(), ReadMeshError> {
        let [a, b, c] = corners;
        if a == b || b == c || a == c {
            self.repeated_corners += 1;
            return Ok(());
        }
        if self.triangles.len() >= self.limits.faces {
            let count = self.triangles.len() as u64 + 1;
            return check_count("faces", count, self.limits.faces);
        }
        self.triangles.push(corners);
        Ok(())
    }

    /// Counts points or lines that the file holds beside its faces and that are left out.
    pub(super) fn skip_points_and_lines(&mut self, count: usize) {
        self.not_surface = self.not_surface.saturating_add(count);
    }

    /// Adds a line to the load report.
    pub(super) fn notice(&mut self, notice: Notice) {
        self.notices.push(notice);
    }

    /// The mesh, with a note for everything that was left out or changed.
    ///
    /// # Errors
    /// If a face refers to a point that never came, or there is no triangle.
    pub(super) fn finish(self) -> Result<MeshFile, ReadMeshError> {
        let (mesh, notices) = self.finish_mesh()?;
        Ok(MeshFile {
            frames: vec![mesh],
            times_s: None,
            notices,
        })
    }

    /// As [`Self::finish`], for readers that make further frames of the mesh.
    pub(super) fn finish_mesh(mut self) -> Result<(TriMesh, Vec<Notice>), ReadMeshError> {
        let count = self.points.len();
        let missing = self.ahead.iter().find(|(v, _)| *v as usize >= count);
        if let Some(&(vertex, place)) = missing {
            return Err(place.error(missing_vertex(
                u64::from(vertex) + self.first_number,
                count,
                self.first_number,
            )));
        }
        if self.triangles.is_empty() {
            return Err(ReadMeshError::Empty);
        }
        self.report();
        let faces = Faces::new(count, self.triangles)?;
        Ok((TriMesh::new(self.points, faces)?, self.notices))
    }

    fn report(&mut self) {
        let mut used = vec![false; self.points.len()];
        for &corner in self.triangles.iter().flatten() {
            used[corner as usize] = true;
        }
        let unused = used.iter().filter(|used| !**used).count();
        let findings = [
            (
                self.repeated_corners,
                true,
                "triangle",
                "with a repeated corner removed",
            ),
            (
                self.too_few_corners,
                true,
                "face",
                "with fewer than three corners ignored",
            ),
            (
                self.polygons_split,
                false,
                "polygon",
                "triangulated as a fan from the first corner",
            ),
            (
                self.not_surface,
                false,
                "point or line",
                "beside the faces ignored",
            ),
            (unused, false, "vertex", "used by no face (kept)"),
        ];
        for (count, warns, what, done) in findings {
            if count > 0 {
                let text = format!("{count} {} {done}", plural(what, count));
                self.notices.push(if warns {
                    Notice::warning(text)
                } else {
                    Notice::info(text)
                });
            }
        }
    }
}

/// Refuses a count over its limit.
pub(super) fn check_count(
    what: &'static str,
    count: u64,
    most: usize,
) -> Result<(), ReadMeshError> {
    let most = most as u64;
    if count > most {
        return Err(ReadMeshError::TooMany { what, count, most });
    }
    Ok(())
}

/// The reason for a face that names a vertex that is not there, in the numbers of the file.
pub(super) fn missing_vertex(number: u64, count: usize, first_number: u64) -> String {
    if first_number == 0 {
        format!("face refers to vertex {number}, but there are only {count}, counted from 0")
    } else {
        format!("face refers to vertex {number}, but only {count} are defined")
    }
}

fn plural(what: &str, count: usize) -> &str {
    if count == 1 {
        return what;
    }
    match what {
        "triangle" => "triangles",
        "face" => "faces",
        "polygon" => "polygons",
        "vertex" => "vertices",
        _ => "points or lines",
    }
}

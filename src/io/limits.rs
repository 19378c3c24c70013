//! How large an input may be before it is refused with a clear error: all bounds of reading, those that options change as fields of
//! [`Limits`], the others as constants. What depends on one format's numbers alone, such as the axes of a header, stands there.

/// Explicit bounds, so that a damaged or hostile header never decides how much memory or time is taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Bytes of one file, and of all files together that a glTF file names; 512 MiB.
    pub file_bytes: u64,
    /// Vertices of one surface; 5 million.
    pub vertices: usize,
    /// Faces of one surface; 10 million.
    pub faces: usize,
    /// Corners of one polygon; strips may have as many as all faces; 10,000.
    pub polygon_corners: usize,
    /// Frames of one sequence; 1,000.
    pub frames: usize,
    /// Vertices of one surface over all frames that one file holds (glTF morph targets); 16 million.
    pub vertices_of_all_frames: usize,
    /// Parts of meshes (primitives) that the nodes of one glTF scene place; 1,000.
    pub placed_parts: usize,
    /// Pieces of one VTP file; 1,000.
    pub pieces: usize,
    /// How many times more bytes the arrays of a VTP file may unpack to than the file has; 32. zlib makes 5 bytes of one where cells
    /// are offsets of 64 bits, and 8 where they are a regular grid; 1,000 only where all are zero.
    pub unpacked_times: u64,
    /// Bytes of memory that the meshes of all files of a study may take beyond eight times the size of their files; 1 GiB.
    pub unpacked_in_study: u64,
    /// Voxels of one image over all its volumes; 268 million. Each takes four bytes: 1 GiB.
    pub voxels: u64,
    /// Voxels of all images that are held at once; four times those of one.
    pub voxels_in_all: u64,
    /// Files and folders that are looked at in a folder of images; 50,000.
    pub image_files: usize,
    /// Whether links that lead out of a study are followed; no.
    pub follow_links: bool,
}

impl Default for Limits {
    /// The numbers that stand at the fields: ten times the finest hearts that are published, and well inside the memory of a small
    /// machine.
    fn default() -> Self {
        Self {
            file_bytes: 512 << 20,
            vertices: 5_000_000,
            faces: 10_000_000,
            polygon_corners: 10_000,
            frames: 1_000,
            vertices_of_all_frames: 16_000_000,
            placed_parts: 1_000,
            pieces: 1_000,
            unpacked_times: 32,
            unpacked_in_study: 1 << 30,
            voxels: 1 << 28,
            voxels_in_all: 1 << 30,
            image_files: 50_000,
            follow_links: false,
        }
    }
}

impl Limits {
    /// Faces of meshes that a glTF scene places again. A heart stands in a scene once, its parts perhaps twice: a small file could
    /// fill a large memory so.
    pub(super) fn repeated_faces(&self) -> usize {
        self.faces / 10
    }
}

/// Displacements that are added to make all frames of a glTF file: a fraction of a second of work.
pub(super) const MAX_DISPLACEMENTS: usize = 100_000_000;

/// Folders within folders of meshes that are followed.
pub(super) const MAX_MESH_FOLDER_DEPTH: usize = 8;
/// Folders within folders of images that are looked into.
pub(super) const MAX_IMAGE_FOLDER_DEPTH: usize = 16;
/// Files and folders that opening a study may look at, for all its folders and patterns together: a hundred times those of the
/// largest published cohort, and about a second's work.
pub(super) const MAX_ENTRIES: usize = 250_000;
/// Names that the patterns of a study may be compared with, all together: about a second's work.
pub(super) const MAX_COMPARED_NAMES: usize = 5_000_000;
/// Subjects of one manifest: the largest cohorts of hearts in research have about ten thousand.
pub(super) const MAX_SUBJECTS: usize = 20_000;

/// Files with the values of one image: five times the frames of the longest multi-frame files.
pub(super) const MAX_DATA_FILES: usize = 100_000;

/// How deep sequences of a DICOM file may stand in each other: real files have six levels.
pub(super) const MAX_DICOM_DEPTH: usize = 24;
/// Elements of one level of a DICOM file, and items of one sequence: the frames of the longest multi-frame files are 20,000.
pub(super) const MAX_DICOM_ITEMS: usize = 100_000;
/// Bytes that all DICOM files of one opening may take together, for each voxel that all images may have.
pub(super) const DICOM_BYTES_OF_A_VOXEL: u64 = 2;
/// Pixels that one byte of packed ones may hold, as in a frame of 512 × 512 of half a kilobyte; not tuned.
pub(super) const MAX_PIXELS_OF_A_BYTE: u64 = 512;
/// So many pixels more are granted to any packed frame, for frames that are all black: those of 2048 × 2048.
pub(super) const PIXELS_OF_ANY_FRAME: u64 = 1 << 22;

/// Elements, comments and texts of one XML file: far more than lists of files and VTP files have.
pub const MAX_XML_NODES: u32 = 100_000;
/// Attributes of one XML element. The parser compares each with all others of its element.
pub const MAX_XML_ATTRIBUTES: usize = 256;
/// Attributes of all elements of one XML file. The parser reserves memory for every `=` of the text.
pub const MAX_XML_ATTRIBUTES_IN_ALL: usize = 1_000_000;
/// Declarations of XML name spaces in one file. Each element below one keeps a copy of them all.
pub const MAX_XML_NAMESPACES: usize = 1_000;

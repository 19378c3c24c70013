//! How large an input may be before it is refused with a clear error.

/// Explicit bounds, so that a damaged or hostile header never decides how much memory or time is taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Bytes of one file, and of all files together that a glTF file names.
    pub file_bytes: u64,
    /// Vertices of one surface.
    pub vertices: usize,
    /// Faces of one surface.
    pub faces: usize,
    /// Corners of one polygon; strips may have as many as all faces.
    pub polygon_corners: usize,
    /// Frames of one sequence.
    pub frames: usize,
    /// Vertices of one surface over all frames that one file holds (glTF morph targets).
    pub vertices_of_all_frames: usize,
    /// Parts of meshes (primitives) that the nodes of one glTF scene place.
    pub placed_parts: usize,
    /// Pieces of one VTP file.
    pub pieces: usize,
    /// How many times more bytes the arrays of a VTP file may unpack to than the file has.
    pub unpacked_times: u64,
    /// Bytes of memory that the meshes of all files of a study may take beyond eight times the size of their files.
    pub unpacked_in_study: u64,
    /// Voxels of one image over all its volumes; each takes four bytes.
    pub voxels: u64,
    /// Voxels of all images that are held at once.
    pub voxels_in_all: u64,
    /// Files and folders that are looked at in a folder of images.
    pub image_files: usize,
    /// Whether links that lead out of a study are followed.
    pub follow_links: bool,
}

impl Default for Limits {
    /// 512 MiB a file, 5 million vertices, 10 million faces, 10,000 corners a polygon, 1,000 frames, 16 million
    /// vertices over all frames of one file, 1,000 parts of a scene, 1,000 pieces, 32 bytes from one in a file, 1 GiB beyond
    /// eight bytes from one in a study, 268 million voxels an image (1 GiB) and four times as many in all images, 50,000
    /// files in a folder of images, and no links out of it: ten times the finest hearts that are published, and well inside the memory of a small machine. zlib makes 5 bytes of one
    /// where cells are offsets of 64 bits, and 8 where they are a regular grid; 1,000 only where all are zero.
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

/// Elements, comments and texts of one XML file: far more than lists of files and VTP files have.
pub const MAX_XML_NODES: u32 = 100_000;
/// Attributes of one XML element. The parser compares each with all others of its element.
pub const MAX_XML_ATTRIBUTES: usize = 256;
/// Attributes of all elements of one XML file. The parser reserves memory for every `=` of the text.
pub const MAX_XML_ATTRIBUTES_IN_ALL: usize = 1_000_000;
/// Declarations of XML name spaces in one file. Each element below one keeps a copy of them all.
pub const MAX_XML_NAMESPACES: usize = 1_000;

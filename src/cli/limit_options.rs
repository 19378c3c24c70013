//! Options for how large an input may be; the same for the window and every command.

use clap::Args;

use crate::io::Limits;

/// Bounds on what is read.
#[derive(Clone, Copy, Debug, Default, Args)]
pub struct LimitOptions {
    /// Largest file that is read, in MiB [default: 512]
    #[arg(long, global = true, value_name = "MIB", value_parser = clap::value_parser!(u32).range(1..))]
    max_file: Option<u32>,
    /// Most vertices of a surface; twice as many faces, 3.2 times as many vertices over all frames of one file
    /// [default: 5000000]
    #[arg(long, global = true, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    max_vertices: Option<u32>,
    /// Most frames of a sequence [default: 1000]
    #[arg(long, global = true, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    max_frames: Option<u32>,
    /// Most memory that the meshes of a study may take beyond eight times the size of their files, in MiB [default: 1024]
    #[arg(long, global = true, value_name = "MIB")]
    max_unpacked: Option<u32>,
    /// Follow links that lead out of a study; pipes and devices are never read
    #[arg(long, global = true)]
    follow_links: bool,
}

impl LimitOptions {
    /// The limits that they name, the usual ones where they say nothing.
    pub fn limits(self) -> Limits {
        let mut limits = Limits::default();
        if let Some(mib) = self.max_file {
            limits.file_bytes = u64::from(mib) << 20;
        }
        if let Some(vertices) = self.max_vertices {
            let vertices = vertices as usize;
            let usual = Limits::default();
            let in_proportion = |count: usize| vertices.saturating_mul(count) / usual.vertices;
            limits.vertices = vertices;
            limits.faces = in_proportion(usual.faces);
            limits.vertices_of_all_frames = in_proportion(usual.vertices_of_all_frames);
        }
        if let Some(frames) = self.max_frames {
            limits.frames = frames as usize;
        }
        if let Some(mib) = self.max_unpacked {
            limits.unpacked_in_study = u64::from(mib) << 20;
        }
        limits.follow_links = self.follow_links;
        limits
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_not_said_stays_and_faces_grow_with_vertices() {
        assert_eq!(LimitOptions::default().limits(), Limits::default());
        let limits = LimitOptions {
            max_vertices: Some(500_000),
            max_frames: Some(7),
            ..LimitOptions::default()
        }
        .limits();
        let expected = Limits {
            frames: 7,
            vertices: 500_000,
            faces: 1_000_000,
            vertices_of_all_frames: 1_600_000,
            ..Limits::default()
        };
        assert_eq!(limits, expected);
    }
}

//! The surface that a threshold and edits leave of one volume, for the eye while they are set.

use std::sync::Arc;

use crate::analysis::preparation::{BrightSurface, Preparation, Road, preview};
use crate::engine::queries::image_series::{SeriesRef, interrupted};
use crate::engine::store::{Context, Dependencies, Interrupted, Memory, Query, Urgency};
use crate::mesh::TriMesh;
use crate::study::Study;

/// The surface that is shown while settings are made.
#[derive(Clone, Debug, PartialEq)]
pub struct ImagePreviewQuery {
    /// Of which images.
    pub series: SeriesRef,
    /// Which volume.
    pub instant: usize,
    /// The settings; only those of the surface count.
    pub settings: Arc<Preparation>,
}

/// One blurred volume.
#[derive(Clone, Debug, PartialEq)]
struct BlurredQuery(ImagePreviewQuery);

/// With its memory.
struct Blurred {
    surface: BrightSurface,
    bytes: usize,
}

impl Query for BlurredQuery {
    type Answer = Blurred;
    const TITLE: &'static str = "Blur images";
    const URGENCY: Urgency = Urgency::Interactive;
    const LISTED: bool = false;

    fn depends_on(&self, _study: &Study) -> Dependencies {
        Dependencies::nothing()
    }

    fn run(&self, cx: &Context<'_>) -> Result<Blurred, Interrupted> {
        let Self(asked) = self;
        let image = &asked.series.0.image;
        let surface = BrightSurface::new(image, asked.instant, &asked.settings, cx.progress());
        Ok(Blurred {
            surface: surface.map_err(interrupted)?,
            bytes: image.frame().voxel_count() * size_of::<f32>(),
        })
    }

    fn memory(blurred: &Blurred, memory: &mut Memory) {
        memory.own(blurred.bytes);
    }

    fn replaces(&self, _other: &Self) -> bool {
        false
    }
}

impl Query for ImagePreviewQuery {
    type Answer = TriMesh;
    const TITLE: &'static str = "Preview surface";
    const URGENCY: Urgency = Urgency::Interactive;
    const LISTED: bool = false;

    fn depends_on(&self, _study: &Study) -> Dependencies {
        Dependencies::nothing()
    }

    fn run(&self, cx: &Context<'_>) -> Result<TriMesh, Interrupted> {
        if let Road::Masks(_) = self.settings.road {
            let image = &self.series.0.image;
            let surface = preview(image, self.instant, &self.settings, cx.progress());
            return surface.map_err(interrupted);
        }
        // Thresholds and edits find the volume blurred.
        let blurred = cx.get(&BlurredQuery(Self {
            settings: Arc::new(blur_alone(&self.settings)),
            ..self.clone()
        }))?;
        let surface = blurred.surface.surface(&self.settings, cx.progress());
        surface.map_err(interrupted)
    }

    fn memory(surface: &TriMesh, memory: &mut Memory) {
        memory.own(size_of_val(surface.vertices()) + size_of_val(surface.triangles()));
    }

    fn replaces(&self, other: &Self) -> bool {
        self.series == other.series
    }

    fn lets_finish(&self, begun: &Self) -> bool {
        self.series == begun.series
    }
}

/// The settings that the blurred volume depends on.
fn blur_alone(settings: &Preparation) -> Preparation {
    Preparation {
        spacing_mm: settings.spacing_mm,
        blur_mm: settings.blur_mm,
        ..Preparation::of_road(settings.road)
    }
}

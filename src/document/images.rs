//! The images of the document: which are on screen, of whom, and at which instant of the beat.

use std::sync::Arc;

use crate::image::VolumeFrame;
use crate::io::{ImageSeries, OpenedImages};
use crate::mesh::Point3;
use crate::study::CycleTiming;
use crate::units::Seconds;

use crate::document::document::{Document, cycle_share, nearest_frame};

impl Document {
    /// The images that came with the study, one entry a person.
    pub fn images(&self) -> &[OpenedImages] {
        &self.study.report.images
    }

    /// The images on screen.
    pub fn shown_images(&self) -> Option<&OpenedImages> {
        self.images().get(self.slices.images?)
    }

    /// The series on screen.
    pub fn shown_series(&self) -> Option<&Arc<ImageSeries>> {
        let series = &self.shown_images()?.series;
        series.get(self.slices.series).or(series.first())
    }

    /// The images of a subject: those that it was made from, else those of its name.
    pub fn images_of(&self, subject: usize) -> Option<usize> {
        let subject = self.study().subject(subject)?;
        let images = self.images();
        let made = |entry: &OpenedImages| entry.made == Some(subject.sequence.id());
        let made = images.iter().position(made);
        made.or_else(|| images.iter().position(|entry| entry.id == subject.id))
    }

    /// The subject of some images, if there is one.
    pub fn subject_of_images(&self, images: usize) -> Option<usize> {
        let entry = self.images().get(images)?;
        let made = |id| {
            let mut all = self.study().all();
            all.position(|subject| subject.sequence.id() == id)
        };
        let named = || self.study().index_of(&entry.id);
        entry.made.and_then(made).or_else(named)
    }

    /// Shows these images, and selects their subject if there is one.
    pub fn show_images(&mut self, images: usize) {
        if images >= self.images().len() {
            return;
        }
        self.put_images(Some(images));
        match self.subject_of_images(images) {
            Some(subject) if subject != self.subject => self.select_subject(subject),
            _ => {}
        }
    }

    /// Shows the images of the selected subject; without a subject those on screen stay, or the first are shown.
    pub fn show_images_of_selected(&mut self) {
        let images = match self.selected_index() {
            Some(subject) => self.images_of(subject),
            None => (self.slices.images).or((!self.images().is_empty()).then_some(0)),
        };
        self.put_images(images);
    }

    fn put_images(&mut self, images: Option<usize>) {
        if self.slices.images != images {
            // Places and greys of one person mean nothing in the images of another.
            self.slices.images = images;
            self.slices.series = 0;
            self.slices.crosshair = None;
            self.slices.window = None;
        }
    }

    /// Number of instants of the images on screen, at least one.
    pub fn instant_count(&self) -> usize {
        let series = self.shown_series();
        series.map_or(1, |series| series.image.volumes().len().max(1))
    }

    /// The instant of the images on screen that is nearest to the position in the beat.
    pub fn instant(&self) -> usize {
        let count = self.instant_count();
        let Some(subject) = self.selected() else {
            return nearest_frame(self.position, count);
        };
        if subject.sequence.frame_count() == count {
            return self.frame();
        }
        let Some(series) = self.shown_series() else {
            return 0;
        };
        let timing = image_timing(series);
        let share = cycle_share(subject, self.frame() as f64);
        let apart = |instant: usize| {
            let far = (timing.phase(instant as f64, count) - share).abs();
            // The beat starts over at its end.
            far.min(1.0 - far)
        };
        let instants = 0..count;
        (instants.min_by(|a, b| apart(*a).total_cmp(&apart(*b)))).unwrap_or(0)
    }

    /// Where the voxels of the images on screen stand: as the file says, or by the distances that were typed.
    pub fn image_frame(&self) -> Option<VolumeFrame> {
        let frame = *self.shown_series()?.image.frame();
        let settings = self.import.settings.get(&self.slices.images?);
        let Some(spacing_mm) = settings.and_then(|settings| settings.spacing_mm) else {
            return Some(frame);
        };
        let directions = frame.directions();
        let steps = [0, 1, 2].map(|axis| directions[axis] * spacing_mm[axis]);
        // Distances that place no grid are never set.
        VolumeFrame::new(frame.size(), frame.origin(), steps)
            .ok()
            .or(Some(frame))
    }

    /// Whether distances in the images on screen are in millimetres.
    pub fn images_are_measured(&self) -> bool {
        let series = self
            .shown_series()
            .is_some_and(|series| series.spacing_known());
        let images = self.slices.images;
        let settings = images.and_then(|images| self.import.settings.get(&images));
        series || settings.is_some_and(|settings| settings.spacing_mm.is_some())
    }

    /// Where the slices cross, in the world of the image on screen.
    pub fn crosshair(&self) -> Option<Point3> {
        let frame = self.image_frame()?;
        let middle = frame.size().map(|count| 0.5 * (count as f64 - 1.0));
        let middle = || frame.position(Point3::from(middle));
        Some(self.slices.crosshair.unwrap_or_else(middle))
    }
}

/// When the volumes of a series were taken, as far as its files say it.
pub fn image_timing(series: &ImageSeries) -> CycleTiming {
    let seconds = |ms: &f64| 1e-3 * ms;
    let times = series.image.times_ms();
    let cycle_ms = series.gates.as_ref().and_then(|gates| gates.cycle_ms);
    CycleTiming {
        frame_times_s: times.map(|times| times.iter().map(seconds).collect()),
        rr: cycle_ms.map(|ms| Seconds(1e-3 * ms)),
    }
}

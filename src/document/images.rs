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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::document::{OpeningReport, StudyRef};
    use crate::document::testing::{study_of, subject_with_frames};
    use crate::image::Image;
    use crate::io::Provenance;
    use crate::mesh::Vector3;
    use crate::study::{Study, Subject};

    fn series(instants: usize) -> Arc<ImageSeries> {
        let steps = [2.0, 2.0, 5.0];
        let steps = [0, 1, 2].map(|axis| Vector3::ith(axis, steps[axis]));
        let frame = VolumeFrame::new([3, 4, 5], Point3::origin(), steps).unwrap();
        let volumes = vec![vec![0.5_f32; 60].into(); instants];
        Arc::new(ImageSeries {
            name: "made".to_owned(),
            format: "NIfTI-1",
            modality: None,
            image: Image::new(frame, volumes, None).unwrap(),
            gates: None,
            spacing: Provenance::Missing,
            times: Provenance::Missing,
            position_known: false,
            notices: Vec::new(),
        })
    }

    fn document(subjects: Vec<Subject>, ids: &[&str]) -> Document {
        let images = ids.iter().map(|id| OpenedImages {
            id: (*id).to_owned(),
            series: vec![series(10)],
            notices: Vec::new(),
            made: None,
        });
        let report = OpeningReport {
            images: Arc::new(images.collect()),
            ..OpeningReport::default()
        };
        let study: Arc<Study> = study_of(subjects);
        let mut document = Document::new(StudyRef {
            listing: study.revision,
            study,
            opening: 1,
            report: Arc::new(report),
        });
        document.show_images_of_selected();
        document
    }

    #[test]
    fn images_without_a_subject_are_shown_and_their_instants_are_the_frames() {
        let mut document = document(Vec::new(), &["a", "b"]);
        assert_eq!(document.shown_images().unwrap().id, "a");
        assert_eq!(document.frame_count(), 10);
        document.move_to(7.4);
        assert_eq!(document.instant(), 7);
        document.show_images(1);
        assert_eq!(document.shown_images().unwrap().id, "b");
    }

    #[test]
    fn a_subject_brings_its_images_and_images_their_subject() {
        let subjects = ["n", "b"].map(|id| subject_with_frames(id, 5));
        let mut document = document(subjects.into(), &["a", "b"]);
        assert!(document.shown_images().is_none(), "there are none of n");
        document.select_subject(1);
        assert_eq!(document.shown_images().unwrap().id, "b");
        // Five frames over ten instants: every other one.
        document.move_to(3.0);
        assert_eq!(document.instant(), 6);
        document.select_subject(0);
        document.show_images(1);
        assert_eq!(document.selected().unwrap().id, "b");
    }

    #[test]
    fn typed_distances_place_the_voxels() {
        let mut document = document(Vec::new(), &["a"]);
        assert!(!document.images_are_measured());
        let settings = crate::analysis::preparation::Preparation {
            spacing_mm: Some([1.0, 1.5, 8.0]),
            ..Default::default()
        };
        document.import.settings.insert(0, Arc::new(settings));
        let frame = document.image_frame().unwrap();
        assert!(document.images_are_measured());
        assert!((frame.spacing()[2] - 8.0).abs() < 1e-12);
        let middle = document.crosshair().unwrap();
        assert!((middle - Point3::new(1.0, 2.25, 16.0)).norm() < 1e-12);
    }
}

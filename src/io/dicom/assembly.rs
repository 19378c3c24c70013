//! From the contents of files to series, with all that is left out.

use std::collections::HashMap;

use super::contents::{Contents, VolumeFile};
use super::group::{Group, drop_same_images, groups};
use super::join::{join_single_instants, join_single_slices};
use super::plane::{FileFacts, Plane};
use super::reading::DicomReading;
use super::series::{series_of_film, series_of_stack};
use super::sources_of_slices::{SliceSource, sources_of_slices};
use super::stack::stacks;
use crate::io::image_file::{ImageSeries, ReadImageError};
use crate::io::limits::Limits;
use crate::progress::{Progress, Stopped};
use crate::study::Notice;

/// Planes of a file with the times of its frames, if it is a film.
type Film = (Vec<Plane>, Option<Vec<f64>>);

/// What was read so far.
pub(super) struct Assembly<'a> {
    limits: &'a Limits,
    progress: &'a Progress,
    /// Voxels that may still be held.
    left: u64,
    planes: Vec<Plane>,
    films: Vec<Film>,
    found: Vec<Found>,
    reading: DicomReading,
}

/// A series with what orders it among all.
struct Found {
    order: Order,
    series: ImageSeries,
    sources: Vec<SliceSource>,
    /// Whether it is a single image of one slice.
    single: bool,
}

/// The study, the number of the series and the number of its first file.
#[derive(Clone, Debug, Default)]
struct Order {
    study: String,
    series: f64,
    file: usize,
}

impl Order {
    fn of_file(facts: &FileFacts) -> Self {
        Self {
            study: facts.study.clone(),
            series: facts.series_number.unwrap_or(0.0),
            file: facts.number,
        }
    }

    fn of_planes(planes: &[Plane]) -> Self {
        let facts = planes.iter().map(|plane| &plane.facts);
        let first = facts.min_by_key(|facts| facts.number);
        first.map(|facts| Self::of_file(facts)).unwrap_or_default()
    }
}

impl<'a> Assembly<'a> {
    pub(super) fn new(limits: &'a Limits, progress: &'a Progress) -> Self {
        Self {
            limits,
            progress,
            left: limits.voxels_in_all,
            planes: Vec::new(),
            films: Vec::new(),
            found: Vec::new(),
            reading: DicomReading::default(),
        }
    }

    /// Takes what a file holds.
    ///
    /// # Errors
    /// If it holds volumes that cannot be made.
    pub(super) fn take(&mut self, contents: Contents) -> Result<(), ReadImageError> {
        match contents {
            Contents::Contours(structures) => self.reading.contours.extend(structures),
            Contents::Planes(planes, Some(times)) => self.films.push((planes, Some(times))),
            Contents::Planes(planes, None) => self.planes.extend(planes),
            Contents::Volumes(file) => self.take_volumes(&file)?,
        }
        Ok(())
    }

    fn take_volumes(&mut self, file: &VolumeFile) -> Result<(), ReadImageError> {
        for series in file.series(self.most())? {
            self.keep(Order::of_file(file.facts()), series, Vec::new(), false);
        }
        Ok(())
    }

    /// Voxels that one more series may have.
    fn most(&self) -> u64 {
        self.limits.voxels.min(self.left)
    }

    fn keep(&mut self, order: Order, series: ImageSeries, sources: Vec<SliceSource>, single: bool) {
        let image = &series.image;
        let voxels = image.frame().voxel_count() as u64;
        let voxels = voxels.saturating_mul(image.volumes().len() as u64);
        self.left = self.left.saturating_sub(voxels);
        self.found.push(Found {
            order,
            series,
            sources,
            single,
        });
    }

    /// Makes series of all that was taken. `alone` says that it was one file: then also an image without a place is one.
    ///
    /// # Errors
    /// If it was asked to stop.
    pub(super) fn finish(mut self, alone: bool) -> Result<DicomReading, Stopped> {
        let copies = drop_same_images(&mut self.planes);
        if copies > 0 {
            (self.reading).leave_out_planes(copies, "copies of images that are there already");
        }
        let groups = groups(std::mem::take(&mut self.planes));
        let placed = |group: &Group| group.planes.iter().all(|plane| plane.place.is_some());
        let (placed, unplaced): (Vec<Group>, Vec<Group>) = groups.into_iter().partition(placed);
        for group in unplaced {
            let count = group.planes.len();
            match alone {
                true => self.films.push((group.planes, None)),
                false => (self.reading)
                    .leave_out_planes(count, "its position and orientation are not said"),
            }
        }
        for (planes, times) in std::mem::take(&mut self.films) {
            self.progress.check()?;
            match series_of_film(&planes, times, self.most()) {
                Ok(series) => self.keep(Order::of_planes(&planes), series, Vec::new(), false),
                Err(reason) => self.reading.leave_out(planes.len(), reason),
            }
        }
        let placed = self.without_scouts(placed);
        let (groups, joined) = join_single_slices(join_single_instants(placed));
        let joined = joined.into_iter().map(joined_group);
        let rest = groups.into_iter().map(|group| (group, Vec::new()));
        for (group, parts) in joined.chain(rest) {
            self.progress.check()?;
            self.stack(group, parts);
            self.progress.check()?;
        }
        self.leave_out_scouts();
        Ok(self.in_order())
    }

    /// Leaves out what says that it is a localizer, if there is anything else.
    fn without_scouts(&mut self, groups: Vec<Group>) -> Vec<Group> {
        let scout = |group: &Group| {
            let first = group.planes.first();
            first.is_some_and(|plane| plane.facts.is_kind("LOCALIZER"))
        };
        let (scouts, others): (Vec<Group>, Vec<Group>) = groups.into_iter().partition(scout);
        if others.is_empty() {
            return scouts;
        }
        for group in scouts {
            self.reading
                .leave_out_planes(group.planes.len(), "a localizer, as its file says");
        }
        others
    }

    /// Makes stacks of a group; if it was joined of parts and makes none, of each part.
    fn stack(&mut self, group: Group, parts: Vec<Group>) {
        let count = group.planes.len();
        let order = Order::of_planes(&group.planes);
        let made = match stacks(group) {
            Ok(made) => made,
            Err(reason) if !parts.is_empty() => {
                let note = format!(
                    "{} parallel series of one slice each make no stack: {reason}",
                    parts.len()
                );
                for mut part in parts {
                    part.notices.push(Notice::warning(note.clone()));
                    self.stack(part, Vec::new());
                }
                return;
            }
            Err(reason) => return self.reading.leave_out_planes(count, &reason),
        };
        for stack in made {
            let single = stack.slices.len() == 1 && stack.key.is_none();
            let images = stack.slices.iter().map(|slice| slice.planes.len()).sum();
            match series_of_stack(&stack, self.most(), self.progress) {
                Ok(series) => self.keep(order.clone(), series, sources_of_slices(&stack), single),
                Err(reason) => self.reading.leave_out(images, reason),
            }
        }
    }

    /// Single images beside stacks or films are scouts, by which the others were placed.
    fn leave_out_scouts(&mut self) {
        if self.found.iter().all(|found| found.single) {
            return;
        }
        let scouts = self.found.iter().filter(|found| found.single).count();
        self.found.retain(|found| !found.single);
        if scouts > 0 {
            self.reading.leave_out_planes(
                scouts,
                "a single image beside stacks and films: a localizer, or one instant of a film",
            );
        }
    }

    /// Series by study, number and file. Studies are counted in the order of their first files.
    fn in_order(mut self) -> DicomReading {
        self.found.sort_by_key(|found| found.order.file);
        let mut studies: HashMap<String, usize> = HashMap::new();
        for found in &self.found {
            let number = studies.len();
            studies.entry(found.order.study.clone()).or_insert(number);
        }
        let study = |found: &Found| studies.get(&found.order.study).copied().unwrap_or(0);
        self.found.sort_by(|a, b| {
            let by_study = study(a).cmp(&study(b));
            by_study.then(a.order.series.total_cmp(&b.order.series))
        });
        let mut reading = self.reading;
        for (series, found) in self.found.into_iter().enumerate() {
            reading.studies.push(study(&found));
            let sources = found.sources.into_iter();
            reading
                .sources
                .extend(sources.map(|source| SliceSource { series, ..source }));
            reading.series.push(found.series);
        }
        reading
    }
}

/// The planes of several series as one group, and the series themselves, should they make no stack.
fn joined_group(parts: Vec<Group>) -> (Group, Vec<Group>) {
    let mut joined = Group::default();
    for part in &parts {
        joined.planes.extend(part.planes.iter().cloned());
        joined.notices.extend(part.notices.iter().cloned());
    }
    joined.notices.push(Notice::info(format!(
        "{} series of one slice each make one stack",
        parts.len()
    )));
    (joined, parts)
}

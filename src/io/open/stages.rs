//! Subject by subject: which is read next, who hears of it, and files that several subjects share.

use std::collections::{BTreeSet, HashMap};
use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};

use rayon::prelude::*;

use super::frames::{FramesOrErrors, frames_of};
use super::plan::SubjectPlan;
use super::read_file::{read_bytes, read_mesh_at};
use super::read_subjects::{SubjectOrErrors, excess, join_subject};
use super::study_budget::StudyBudget;
use crate::io::{Limits, MeshFile};
use crate::mesh::{Faces, TriMesh};
use crate::progress::{Progress, Stopped};
use crate::study::checks::check_count;
use crate::study::{ReadSubject, Study};

/// Who hears of subjects while others are still to be read, and says which come first.
pub trait OpenListener: Sync {
    /// What will be read: a study in which all subjects are unread, and how many bytes their files have.
    fn planned(&self, study: Study, bytes: u64);
    /// A subject was read, or cannot be.
    fn read(&self, subject: ReadSubject);
    /// The id of a subject to be read before the others.
    fn wanted(&self) -> Option<String>;
    /// Whether no further subject is to be read.
    fn enough(&self) -> bool;
    /// How many subjects are read at a time, by so many threads.
    fn at_a_time(&self, threads: usize) -> usize;
}

/// Nobody: all subjects, in the order of the input.
impl OpenListener for () {
    fn planned(&self, _: Study, _: u64) {}
    fn read(&self, _: ReadSubject) {}
    fn wanted(&self) -> Option<String> {
        None
    }
    fn enough(&self) -> bool {
        false
    }
    /// Enough that threads rarely wait for each other.
    fn at_a_time(&self, threads: usize) -> usize {
        4 * threads
    }
}

/// Reads all files of all subjects, each a step, and joins them; `None` for a subject that was not wanted any more.
pub(super) fn read_subjects(
    plans: &[SubjectPlan],
    limits: &Limits,
    progress: &Progress,
    listener: &dyn OpenListener,
) -> Result<Vec<Option<SubjectOrErrors>>, Stopped> {
    let reader = Reader::of(plans, limits, progress);
    let checks: usize = plans.iter().map(|p| check_count(p.surfaces.len())).sum();
    let files: usize = plans.iter().map(|p| reader.files_of(p).count()).sum();
    progress.expect_steps(files + checks);
    let mut left: BTreeSet<usize> = (0..plans.len()).collect();
    let mut outcomes: Vec<Option<SubjectOrErrors>> = plans.iter().map(|_| None).collect();
    let threads = rayon::current_num_threads();
    while !left.is_empty() && !listener.enough() {
        let wanted = (listener.wanted())
            .and_then(|id| left.iter().copied().find(|&index| plans[index].id == id));
        // Whoever waits for a subject has all threads for it, as has the first one.
        let count = match wanted {
            None if left.len() < plans.len() => listener.at_a_time(threads),
            _ => 1,
        };
        let others = left.iter().copied().filter(|index| Some(*index) != wanted);
        let next: Vec<usize> = wanted
            .into_iter()
            .chain(others)
            .take(count.max(1))
            .collect();
        let read = next.into_par_iter().map(|index| {
            let outcome = reader.subject(&plans[index])?;
            let subject = outcome.as_ref().ok().map(Arc::clone);
            listener.read((plans[index].id.clone(), subject));
            Ok((index, outcome))
        });
        for (index, outcome) in read.collect::<Result<Vec<_>, Stopped>>()? {
            left.remove(&index);
            outcomes[index] = Some(outcome);
        }
    }
    Ok(outcomes)
}

/// Reads all files of all subjects, each a step, without joining frames to sequences.
pub(super) fn read_frames_of(
    plans: &[SubjectPlan],
    limits: &Limits,
    progress: &Progress,
) -> Result<Vec<FramesOrErrors>, Stopped> {
    let reader = Reader::of(plans, limits, progress);
    progress.expect_steps(plans.iter().map(|p| reader.files_of(p).count()).sum());
    let read = plans
        .iter()
        .map(|plan| Ok(frames_of(plan, reader.contents(plan)?, limits)));
    read.collect()
}

/// Bytes of all files that the plans name.
pub(super) fn bytes_of(plans: &[SubjectPlan]) -> u64 {
    let files = plans.iter().flat_map(|plan| &plan.surfaces);
    files
        .flat_map(|surface| &surface.files)
        .filter_map(|path| std::fs::metadata(path).ok())
        .map(|facts| facts.len())
        .sum()
}

type Content = Result<MeshFile, String>;

/// Reads files; one of several subjects or frames is read once, and kept until it was used for the last time.
struct Reader<'a> {
    shared: HashMap<PathBuf, Mutex<Shared>>,
    /// Connectivities that were read: meshes whose faces are listed alike hold them together.
    faces: Mutex<Vec<Arc<Faces>>>,
    budget: StudyBudget,
    limits: &'a Limits,
    progress: &'a Progress,
}

/// Connectivities that are compared with: a cohort has a few, or one a subject.
const MAX_FACES: usize = 16;

struct Shared {
    uses_left: usize,
    content: Option<Content>,
}

impl<'a> Reader<'a> {
    fn of(plans: &[SubjectPlan], limits: &'a Limits, progress: &'a Progress) -> Self {
        let mut reader = Self {
            shared: HashMap::new(),
            faces: Mutex::default(),
            budget: StudyBudget::new(limits),
            limits,
            progress,
        };
        let mut uses: HashMap<&PathBuf, usize> = HashMap::new();
        for path in plans.iter().flat_map(|plan| reader.files_of(plan)) {
            *uses.entry(path).or_default() += 1;
        }
        let shared = uses.into_iter().filter(|&(_, uses)| uses > 1);
        reader.shared = shared
            .map(|(path, uses_left)| {
                let content = None;
                (path.clone(), Mutex::new(Shared { uses_left, content }))
            })
            .collect();
        reader
    }

    /// The files that are read of a subject: none of one with too many.
    fn files_of<'p>(&self, plan: &'p SubjectPlan) -> impl Iterator<Item = &'p PathBuf> + use<'p> {
        let surfaces = match excess(plan, self.limits) {
            Some(_) => &[],
            None => plan.surfaces.as_slice(),
        };
        surfaces.iter().flat_map(|surface| &surface.files)
    }

    fn share_faces(&self, mesh: &mut TriMesh) {
        let mut known = self.faces.lock().unwrap_or_else(PoisonError::into_inner);
        let same = known.iter().find(|known| ***known == **mesh.faces());
        match same.map(|same| TriMesh::new(mesh.shared_vertices(), Arc::clone(same))) {
            Some(Ok(sharing)) => *mesh = sharing,
            None if known.len() < MAX_FACES => known.push(Arc::clone(mesh.faces())),
            _ => {}
        }
    }

    fn subject(&self, plan: &SubjectPlan) -> Result<SubjectOrErrors, Stopped> {
        let contents = self.contents(plan)?;
        join_subject(plan, contents, self.limits, self.progress)
    }

    fn contents(&self, plan: &SubjectPlan) -> Result<Vec<Content>, Stopped> {
        let files: Vec<&PathBuf> = self.files_of(plan).collect();
        let contents = files.into_par_iter().map(|path| {
            self.progress.step()?;
            Ok(self.content(path))
        });
        contents.collect()
    }

    fn content(&self, path: &PathBuf) -> Content {
        let read = || {
            let bytes = read_bytes(path, self.limits)?;
            let file = read_mesh_at(path, &bytes, self.limits)?;
            let mut file = self.budget.taken(file, bytes.len())?;
            for mesh in &mut file.frames {
                self.share_faces(mesh);
            }
            Ok(file)
        };
        let Some(shared) = self.shared.get(path) else {
            return read();
        };
        // Readers use no other threads, so whoever holds the lock comes to an end.
        let mut shared = shared.lock().unwrap_or_else(PoisonError::into_inner);
        shared.uses_left = shared.uses_left.saturating_sub(1);
        match shared.content.take() {
            Some(content) if shared.uses_left == 0 => content,
            known => {
                let content = known.unwrap_or_else(read);
                if shared.uses_left > 0 {
                    shared.content = Some(content.clone());
                }
                content
            }
        }
    }
}

//! What a question to a study is: one `impl Query` is one analysis, and nothing else lists it.

use std::fmt::Debug;
use std::sync::Arc;

use crate::engine::activity::Topic;
use crate::engine::store::dependencies::Dependencies;
use crate::engine::store::interrupted::Interrupted;
use crate::engine::store::memory::Memory;
use crate::engine::store::queue::Urgency;
use crate::engine::store::shelves::Shelves;
use crate::engine::store::work::Work;
use crate::progress::Progress;
use crate::study::Study;

/// One question to a study. Its fields are the settings of the analysis.
pub trait Query: Clone + PartialEq + Debug + Send + Sync + 'static {
    /// Plain data; panes, tables and figures read it.
    type Answer: Send + Sync + 'static;

    /// What the activity list calls it.
    const TITLE: &'static str;
    /// What a card says if it fails; `None` where its pane says so itself.
    const FAILURE: Option<&'static str> = None;
    /// When it runs.
    const URGENCY: Urgency = Urgency::Visible;
    /// Whether the activity list shows it.
    const LISTED: bool = true;

    /// Its settings in words, for the activity list; empty where it has none.
    fn parameters(&self) -> String {
        String::new()
    }

    /// What of the study the answer depends on: on everything, labels included, unless it says less. One that names its
    /// [`Query::subjects`] depends on these, in the same order, and must say so here.
    fn depends_on(&self, study: &Study) -> Dependencies {
        Dependencies::study(study)
    }

    /// Computes the answer. Other questions are asked through `cx`, so that nothing is computed twice. Same study, same
    /// question: the same bits with any number of threads.
    ///
    /// # Errors
    /// What interrupted it. `?` passes on errors of analyses and of other questions alike.
    fn run(&self, cx: &Context<'_>) -> Result<Self::Answer, Interrupted>;

    /// Counts the memory of an answer.
    fn memory(answer: &Self::Answer, memory: &mut Memory);

    /// Whether the answer to `other`, on the same surfaces, may stay on screen until this one is there. It may not where
    /// it is about another subject: a number of one must never stand under the name of another.
    fn replaces(&self, other: &Self) -> bool;

    /// The indices of the subjects that it is about, in the order in which it depends on them: another state of the study
    /// may have these subjects in other places. None where it is about the whole cohort. An answer whose subjects are not
    /// those that it depends on is forgotten when the study is edited.
    fn subjects(&mut self) -> Vec<&mut usize> {
        Vec::new()
    }

    /// Whether `begun`, which is under way, is finished before this one begins: settings that are dragged would
    /// otherwise stop each other's work, and nothing would follow the drag.
    fn lets_finish(&self, _begun: &Self) -> bool {
        false
    }
}

impl Topic {
    /// All questions of one type.
    pub const fn of<Q: Query>() -> Self {
        Self::named(Q::TITLE)
    }
}

/// What a running question sees.
pub struct Context<'a> {
    pub(super) study: &'a Arc<Study>,
    pub(super) progress: Progress,
    pub(super) work: &'a Arc<Work>,
    /// The urgency of the work whose thread this is.
    pub(super) place: Urgency,
    pub(super) shelves: &'a Arc<Shelves>,
}

impl<'a> Context<'a> {
    /// The study that it is asked about.
    pub fn study(&self) -> &'a Arc<Study> {
        self.study
    }

    /// Reports steps and hears "stop".
    pub fn progress(&self) -> &Progress {
        &self.progress
    }

    /// The context of a part of the work, which takes the share from `from` to `to` of the whole.
    pub fn part(&self, name: &'static str, from: f32, to: f32) -> Self {
        Self {
            progress: self.progress.part(name, from, to),
            ..*self
        }
    }
}

//! What a pane may look at: the state, the store, and what it made in earlier frames. It changes none of them.

use std::any::{Any, TypeId};
use std::cell::{RefCell, RefMut};
use std::collections::HashMap;
use std::rc::Rc;
use std::sync::Arc;
use std::sync::atomic::AtomicU64;

use egui::Ui;

use crate::document::State;
use crate::engine::{Activity, Query, Showing, Store};
use crate::study::Study;

/// What a pane may look at in one frame.
pub struct PaneContext<'a> {
    pub(crate) state: &'a State,
    pub(crate) store: &'a Store,
    pub(crate) memo: &'a Memo,
    pub(crate) activities: &'a [Activity],
    pub(crate) opening: bool,
    pub(crate) pointer_held: bool,
    pub(crate) meter: &'a Arc<AtomicU64>,
}

impl<'a> PaneContext<'a> {
    /// Everything the window shows.
    pub fn state(&self) -> &'a State {
        self.state
    }

    /// The answer to a question about the study on screen, as far as it is known; asking begins the work.
    pub fn ask<Q: Query>(&self, query: &Q) -> Showing<Q::Answer> {
        self.store.ask(self.state.document.study(), query)
    }

    /// The same for what takes the whole cohort, see [`ask_at_rest`].
    pub fn ask_at_rest<Q: Query>(&self, query: &Q) -> Showing<Q::Answer> {
        let study = self.state.document.study();
        ask_at_rest(self.store, study, self.pointer_held, query)
    }

    /// The answer to a question about the study as it is now, if it is known; begins nothing.
    pub fn known<Q: Query>(&self, query: &Q) -> Option<Arc<Q::Answer>> {
        self.store.known(self.state.document.study(), query)
    }

    /// Finished and running work, newest first.
    pub fn activities(&self) -> &'a [Activity] {
        self.activities
    }

    /// Whether a study is being read.
    pub fn is_opening(&self) -> bool {
        self.opening
    }

    /// Takes the time of the paint callbacks.
    pub fn meter(&self) -> &'a Arc<AtomicU64> {
        self.meter
    }

    /// What panes made of answers in earlier frames.
    pub fn memo(&self) -> &'a Memo {
        self.memo
    }
}

/// Asks what takes the whole cohort: while the pointer is down nothing of it begins, for a threshold is dragged through
/// many values; what has begun goes on.
pub fn ask_at_rest<Q: Query>(
    store: &Store,
    study: &Arc<Study>,
    pointer_held: bool,
    query: &Q,
) -> Showing<Q::Answer> {
    match pointer_held {
        true => store.watch(study, query),
        false => store.ask(study, query),
    }
}

/// Seconds on the window's clock, and whether points may walk to new places.
pub fn motion(ui: &Ui) -> (f64, bool) {
    let now_s = ui.input(|input| input.time);
    (now_s, ui.ctx().global_style().animation_time > 0.0)
}

/// Values that panes make once and keep as long as what they were made from stays the same: one of each type.
#[derive(Default)]
pub struct Memo(RefCell<HashMap<TypeId, Rc<dyn Any>>>);

/// A value of the memo that is being used.
pub struct Kept<T>(Rc<RefCell<T>>);

impl<T> Kept<T> {
    /// The value. It must not be in use elsewhere: a pane that uses another one's value does so after its own.
    pub fn borrow_mut(&self) -> RefMut<'_, T> {
        self.0.borrow_mut()
    }
}

impl Memo {
    /// The value of a type, the default one at first.
    pub fn get<T: Default + 'static>(&self) -> Kept<T> {
        let mut values = self.0.borrow_mut();
        let value = values
            .entry(TypeId::of::<T>())
            .or_insert_with(|| Rc::new(RefCell::new(T::default())));
        let value = Rc::clone(value).downcast::<RefCell<T>>();
        // It is stored under its own type.
        Kept(value.unwrap_or_default())
    }

    /// Puts a value in place of the default one.
    pub fn put<T: 'static>(&self, value: T) {
        let mut values = self.0.borrow_mut();
        values.insert(TypeId::of::<T>(), Rc::new(RefCell::new(value)));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_stays_from_frame_to_frame_and_each_type_has_its_own() {
        let memo = Memo::default();
        memo.get::<Vec<u8>>().borrow_mut().push(7);
        memo.put(String::from("kept"));
        assert_eq!(*memo.get::<Vec<u8>>().borrow_mut(), [7]);
        assert_eq!(*memo.get::<String>().borrow_mut(), "kept");
        assert!(memo.get::<Vec<u16>>().borrow_mut().is_empty());
    }
}

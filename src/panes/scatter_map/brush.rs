//! The subject under the pointer on one map stands out on all maps.

use egui::{Id, Ui};

/// Who is pointed at, and on which map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Brush {
    map: Id,
    subject: usize,
}

/// Tells all maps whom the pointer is on, on the map with this id, and returns whom it is on
/// anywhere.
pub fn brush(ui: &Ui, map: Id, subject: Option<usize>) -> Option<usize> {
    let key = Id::unique("brushed subject");
    let kept: Option<Brush> = ui.data(|data| data.get_temp(key));
    // A map that is no longer drawn does not say that the pointer left it.
    let kept_now = kept.filter(|kept| ui.ctx().read_response(kept.map).is_some());
    let brushed = match subject {
        Some(subject) => Some(Brush { map, subject }),
        None => kept_now.filter(|kept| kept.map != map),
    };
    if brushed != kept {
        ui.data_mut(|data| match brushed {
            Some(brushed) => {
                data.insert_temp(key, brushed);
            }
            None => data.remove::<Brush>(key),
        });
        // Maps that were drawn before this one show it in the next frame.
        ui.ctx().request_repaint();
    }
    brushed.map(|brushed| brushed.subject)
}

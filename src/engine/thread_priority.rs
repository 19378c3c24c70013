//! Threads that compute leave the processor to the one that draws.

use std::sync::atomic::{AtomicBool, Ordering};

static BEHIND_WINDOW: AtomicBool = AtomicBool::new(false);

/// From now on threads that this program starts to compute or to read come after its window, whose pictures may be
/// drawn by the processor alone: a click is answered while maps are computed. Called before the first of them starts.
/// Without a window they are as urgent as any other program's.
pub fn compute_behind_window() {
    // Threads begun later see it: starting a thread orders what was written before.
    BEHIND_WINDOW.store(true, Ordering::Relaxed);
}

/// Called by a thread about itself, first of all.
pub(super) fn take_place() {
    if BEHIND_WINDOW.load(Ordering::Relaxed) {
        come_after_window();
    }
}

/// Niceness of Linux counts for one thread. Where it counts for the whole program, as on macOS, the window would be slowed
/// too, so nothing is done there.
#[cfg(target_os = "linux")]
fn come_after_window() {
    /// A thread of the window gets nine tenths of a core that both want (weights 1024 and 110 of the scheduler).
    const NICENESS: i32 = 10;
    // Where it is refused, threads are equal, as they are without it.
    rustix::process::nice(NICENESS).ok();
}

#[cfg(not(target_os = "linux"))]
fn come_after_window() {}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    #[test]
    fn only_the_thread_that_asks_comes_later() {
        let niceness = || rustix::process::nice(0).unwrap();
        let before = niceness();
        let later = std::thread::spawn(move || {
            super::come_after_window();
            niceness()
        });
        // 19 is the last place there is.
        assert_eq!(later.join().unwrap(), (before + 10).min(19));
        assert_eq!(niceness(), before);
    }
}

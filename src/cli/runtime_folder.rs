//! Keeps the libraries of the window system quiet where there is no session.

/// Begins the program again with `XDG_RUNTIME_DIR` set, where it is not; otherwise, and where that is not possible, does
/// nothing.
///
/// Mesa's drivers ask for a Wayland display even to draw without a window, and the library that they ask writes
/// `error: XDG_RUNTIME_DIR is invalid or not set in the environment` to standard error, as if something had failed. A process
/// cannot change its own environment safely once libraries may read it, so it is replaced by itself, with the same number and
/// the same streams. The folder is the one that a session would have; nothing is made there.
#[cfg(all(unix, not(target_os = "macos")))]
pub fn ensure_runtime_folder() {
    use std::os::unix::fs::MetadataExt;
    use std::os::unix::process::CommandExt;

    const NAME: &str = "XDG_RUNTIME_DIR";
    if std::env::var_os(NAME).is_some_and(|folder| !folder.is_empty()) {
        return;
    }
    let (Ok(program), Ok(me)) = (std::env::current_exe(), std::fs::metadata("/proc/self")) else {
        return;
    };
    let mut arguments = std::env::args_os();
    let mut again = std::process::Command::new(program);
    if let Some(name) = arguments.next() {
        again.arg0(name);
    }
    again.args(arguments);
    again.env(NAME, format!("/run/user/{}", me.uid()));
    // Returns only if it fails: the message of the library is then the lesser evil.
    let _failed = again.exec();
}

/// Nothing asks for it here.
#[cfg(not(all(unix, not(target_os = "macos"))))]
pub fn ensure_runtime_folder() {}

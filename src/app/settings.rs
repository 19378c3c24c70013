//! What is remembered from one run to the next: theme, tiles, look of figures, recent files, how motions play. Nothing
//! about subjects.

use std::path::PathBuf;

use egui::{Context, ThemePreference};
use serde::{Deserialize, Serialize};

use crate::document::ThemeChoice;
use crate::document::play::PlayClock;
use crate::document::state::State;
use crate::picture::figure::FigureLook;

use super::layout::Layout;

/// Where the settings lie in the window system's storage.
const KEY: &str = "cardiomorph-settings-1";

/// How many recent files are kept.
const MAX_RECENT: usize = 10;

/// Remembered settings as they are written. Never changed in meaning: a new shape gets a new key.
#[derive(Debug, Default, Serialize, Deserialize)]
#[serde(default)]
struct SettingsV1 {
    theme: ThemeChoice,
    layout: String,
    recent: Vec<PathBuf>,
    figure: FigureLook,
    /// Speed, and whether the motion starts over; absent in settings of earlier versions.
    play: Option<(f32, bool)>,
}

/// Remembered settings in use.
#[derive(Debug, Default)]
pub struct Settings {
    /// Light, dark, or as the system says.
    pub theme: ThemeChoice,
    /// Where the tiles lie.
    pub layout: Layout,
    /// What the user opened, latest first.
    pub recent: Vec<PathBuf>,
    /// How figures look.
    pub figure: FigureLook,
    /// How motions play; the clock is stopped.
    pub play: PlayClock,
}

impl Settings {
    /// Reads what the last run left; defaults where there is nothing or it cannot be read.
    pub fn load(storage: Option<&dyn eframe::Storage>) -> Self {
        storage
            .and_then(|storage| storage.get_string(KEY))
            .map(|text| Self::from_text(&text))
            .unwrap_or_default()
    }

    /// Leaves settings for the next run.
    pub fn save(storage: &mut dyn eframe::Storage, state: &State, layout: &Layout) {
        if let Some(text) = to_text(state, layout) {
            storage.set_string(KEY, text);
        }
    }

    fn from_text(text: &str) -> Self {
        let saved: SettingsV1 = serde_json::from_str(text).unwrap_or_default();
        Self {
            theme: saved.theme,
            layout: Layout::from_saved(&saved.layout),
            recent: saved.recent.into_iter().take(MAX_RECENT).collect(),
            figure: saved.figure.usable(),
            play: saved
                .play
                .map_or_else(PlayClock::default, |(speed, repeat)| {
                    let mut play = PlayClock {
                        repeat,
                        ..PlayClock::default()
                    };
                    play.set_speed(speed);
                    play
                }),
        }
    }
}

fn to_text(state: &State, layout: &Layout) -> Option<String> {
    let saved = SettingsV1 {
        theme: state.theme,
        figure: state.figure_look,
        layout: layout.to_saved().unwrap_or_default(),
        // JSON holds no path that is no Unicode: such a one is forgotten, the rest is kept.
        recent: (state.recent.iter())
            .filter(|path| path.to_str().is_some())
            .cloned()
            .collect(),
        play: Some((state.play.speed, state.play.repeat)),
    };
    serde_json::to_string(&saved).ok()
}

/// Puts what was opened first in the list of recent files, once.
pub fn remember_recent(recent: &mut Vec<PathBuf>, opened: &[PathBuf]) {
    recent.retain(|path| !opened.contains(path));
    recent.splice(0..0, opened.iter().cloned());
    recent.truncate(MAX_RECENT);
}

/// Follows a choice of theme.
pub fn choose_theme(ctx: &Context, choice: ThemeChoice) {
    ctx.set_theme(match choice {
        ThemeChoice::System => ThemePreference::System,
        ThemeChoice::Dark => ThemePreference::Dark,
        ThemeChoice::Light => ThemePreference::Light,
    });
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::panes::Pane;
    use crate::picture::figure::{FigureBackground, FigureTheme};

    fn light_state(recent: Vec<PathBuf>) -> State {
        State {
            theme: ThemeChoice::Light,
            recent,
            ..State::default()
        }
    }

    #[test]
    fn settings_of_a_version_that_knew_no_look_and_a_size_that_no_figure_has_are_defaults() {
        for figure in ["", ",\"figure\":{\"size\":[9,1000000]}"] {
            let text = format!("{{\"theme\":\"light\"{figure}}}");
            let back = Settings::from_text(&text);
            assert_eq!(back.theme, ThemeChoice::Light);
            assert_eq!(back.figure, FigureLook::default());
        }
    }

    #[test]
    fn settings_come_back_from_their_text() {
        let mut layout = Layout::default();
        layout.set_open(Pane::ACTIVITY, false);
        let mut state = light_state(vec![PathBuf::from("/a"), PathBuf::from("/b")]);
        state.figure_look = FigureLook {
            size: Some([1920, 1080]),
            background: FigureBackground::Black,
            theme: FigureTheme::Dark,
        };
        state.play = PlayClock {
            playing: true,
            speed: 2.0,
            repeat: false,
        };
        let play = state.play;
        let text = to_text(&state, &layout).unwrap();
        let back = Settings::from_text(&text);
        assert_eq!(back.theme, ThemeChoice::Light);
        assert_eq!(back.recent, state.recent);
        assert_eq!(back.figure, state.figure_look);
        assert!(!back.layout.is_open(Pane::ACTIVITY));
        let still = PlayClock {
            playing: false,
            ..play
        };
        assert_eq!(back.play, still, "nothing plays unasked");
    }

    #[cfg(unix)]
    #[test]
    fn a_path_that_is_no_unicode_stops_nothing_else_from_being_kept() {
        use std::ffi::OsStr;
        use std::os::unix::ffi::OsStrExt;
        let odd = PathBuf::from(OsStr::from_bytes(b"/data/M\xfcller"));
        let state = light_state(vec![odd, PathBuf::from("/b")]);
        let text = to_text(&state, &Layout::default()).unwrap();
        let back = Settings::from_text(&text);
        assert_eq!(back.theme, ThemeChoice::Light);
        assert_eq!(back.recent, [PathBuf::from("/b")]);
    }

    #[test]
    fn unreadable_settings_are_forgotten() {
        let settings = Settings::from_text("[1, 2");
        assert_eq!(settings.theme, ThemeChoice::System);
        assert!(settings.recent.is_empty());
        let odd = Settings::from_text(r#"{"play": [1e9, true]}"#);
        assert_eq!(odd.play.speed, 4.0, "no faster than the window offers");
        let earlier = Settings::from_text(r#"{"recent": ["/a"]}"#);
        assert_eq!(earlier.play, PlayClock::default());
    }

    #[test]
    fn recent_files_stand_once_latest_first_and_at_most_ten() {
        let mut recent = Vec::new();
        for i in 0..15 {
            remember_recent(&mut recent, &[PathBuf::from(format!("/{i}"))]);
        }
        remember_recent(&mut recent, &[PathBuf::from("/9")]);
        assert_eq!(recent.len(), MAX_RECENT);
        assert_eq!(recent[0], PathBuf::from("/9"));
        assert_eq!(recent.iter().filter(|path| path.ends_with("9")).count(), 1);
    }
}

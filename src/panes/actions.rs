//! All that menus, the palette and the sheet of keys list: the actions of commands, and one for each pane.

use std::sync::LazyLock;

use super::commands::{ACTIONS, Action, FileCommand, Menu, WindowCommand, row};
use super::table::PANES;

/// The group of the menu View in which panes are shown and hidden.
const PANE_GROUP: u8 = 5;

/// The group of the menu Export with the figures of panes, behind those of the 3D view.
const FIGURE_GROUP: u8 = 1;

/// All actions, by menu and group.
pub static ALL_ACTIONS: LazyLock<Vec<Action>> = LazyLock::new(|| {
    let toggles = PANES.iter().map(|spec| {
        let command = WindowCommand::TogglePane(spec.pane).into();
        row(Menu::View, PANE_GROUP, spec.toggle, None, command)
    });
    let opens = PANES.iter().filter_map(|spec| {
        let (group, name) = spec.open?;
        let command = WindowCommand::ShowPane(spec.pane).into();
        Some(row(Menu::Analysis, group, name, None, command))
    });
    let figures = PANES.iter().filter_map(|spec| {
        let command = FileCommand::ExportPaneFigure(spec.pane, None).into();
        let name = spec.figure.as_ref()?.action;
        Some(row(Menu::Export, FIGURE_GROUP, name, None, command))
    });
    let actions = toggles.chain(ACTIONS.iter().cloned());
    let actions = actions.chain(opens).chain(figures);
    let mut actions: Vec<Action> = actions.collect();
    // Stable: within a group the order of the tables stays.
    actions.sort_by_key(|action| (action.menu, action.group));
    actions
});

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use super::*;

    #[test]
    fn no_two_actions_share_a_name_or_a_key_and_every_pane_has_one() {
        let (mut names, mut keys) = (HashSet::new(), HashSet::new());
        for action in ALL_ACTIONS.iter() {
            assert!(names.insert(action.name), "{}", action.name);
            if let Some(shortcut) = action.shortcut {
                assert!(keys.insert(format!("{shortcut:?}")), "{}", action.name);
            }
        }
        assert!(PANES.iter().all(|spec| names.contains(spec.toggle)));
    }
}

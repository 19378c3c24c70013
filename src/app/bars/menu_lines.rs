//! Which lines a menu has: actions of one kind are a submenu, so that no menu is long.

use crate::panes::actions::ALL_ACTIONS;
use crate::panes::commands::{Action, Menu};

/// One line of a menu.
#[derive(Clone, Debug)]
pub enum MenuLine {
    /// A line between groups.
    Separator,
    /// Something that can be done.
    Action(Item),
    /// Lines of one kind under a title.
    Submenu(String, Vec<Item>),
}

/// An action with its name in its menu, which does not repeat the title of a submenu.
#[derive(Clone, Debug)]
pub struct Item {
    /// What is written.
    pub name: String,
    /// What it does.
    pub action: &'static Action,
}

/// Groups that are a submenu as a whole.
const GROUPS: [(Menu, u8, &str); 4] = [
    (Menu::View, 1, "Camera"),
    (Menu::View, 2, "Surfaces and marks"),
    (Menu::Analysis, 0, "Playback"),
    (Menu::Analysis, 2, "Maps"),
];

/// Titles of submenus whose actions begin alike, where the beginning alone is not one.
const TITLES: [(&str, &str); 5] = [
    ("Pane", "Panes"),
    ("Colour", "Colour of the surface"),
    ("Bull's-eye", "Colour of the bull's-eye"),
    ("Pose map", "Embedding of the pose map"),
    ("Figure", "Figure of a pane"),
];

/// The lines of a menu, with a separator between groups.
pub fn menu_lines(menu: Menu) -> Vec<MenuLine> {
    let mut lines: Vec<MenuLine> = Vec::new();
    let mut group = None;
    for action in ALL_ACTIONS.iter().filter(|action| action.menu == menu) {
        if group.is_some_and(|group| group != action.group) {
            lines.push(MenuLine::Separator);
        }
        group = Some(action.group);
        let Some((title, name)) = place(action) else {
            let name = action.name.to_owned();
            lines.push(MenuLine::Action(Item { name, action }));
            continue;
        };
        let item = Item { name, action };
        let known = lines.iter_mut().find_map(|line| match line {
            MenuLine::Submenu(known, items) if *known == title => Some(items),
            _ => None,
        });
        match known {
            Some(items) => items.push(item),
            None => lines.push(MenuLine::Submenu(title.to_owned(), vec![item])),
        }
    }
    lines
}

/// The submenu of an action and its name there; `None` where it stands in the menu itself.
fn place(action: &'static Action) -> Option<(&'static str, String)> {
    let whole = GROUPS
        .iter()
        .find(|(menu, group, _)| (*menu, *group) == (action.menu, action.group));
    if let Some((.., title)) = whole {
        return Some((title, action.name.to_owned()));
    }
    let (kind, name) = action.name.split_once(": ")?;
    let title = TITLES.iter().find(|(known, _)| *known == kind);
    Some((title.map_or(kind, |(_, title)| title), capitalised(name)))
}

fn capitalised(name: &str) -> String {
    let mut letters = name.chars();
    let first = letters.next().into_iter().flat_map(char::to_uppercase);
    first.chain(letters).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_action_stands_in_one_menu_once_and_no_menu_is_long() {
        let mut count = 0;
        for menu in Menu::ALL {
            let lines = menu_lines(menu);
            assert!(lines.len() <= 26, "{menu:?}: {} lines", lines.len());
            for line in lines {
                count += match line {
                    MenuLine::Separator => 0,
                    MenuLine::Action(_) => 1,
                    MenuLine::Submenu(title, items) => {
                        assert!((2..=18).contains(&items.len()), "{title}");
                        items.len()
                    }
                };
            }
        }
        assert_eq!(count, ALL_ACTIONS.len());
    }

    #[test]
    fn a_submenu_does_not_repeat_its_title_in_its_lines() {
        let lines = menu_lines(Menu::View);
        let theme = lines.into_iter().find_map(|line| match line {
            MenuLine::Submenu(title, items) if title == "Theme" => Some(items),
            _ => None,
        });
        let names: Vec<String> = theme.into_iter().flatten().map(|item| item.name).collect();
        assert_eq!(names, ["System", "Dark", "Light"]);
    }
}

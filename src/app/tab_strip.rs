//! Which names a strip of tabs shows: all of them, or those that have room, and the others in a menu.

use egui::Ui;

use crate::panes::{Command, Pane, WindowCommand, spec_of};
use crate::ui::controls::{choice_ui, chooser_ui};
use crate::ui::theme::space;
use crate::ui::{medium_font, text_width};

/// Width of the button of the menu, with the air beside it.
const MENU_WIDTH: f32 = 55.0;

/// What a strip of tabs shows.
#[derive(Clone, Debug, PartialEq)]
pub struct FittedTabs {
    /// Whether each tab is shown.
    pub shown: Vec<bool>,
    /// The air before each name.
    pub gap: f32,
}

/// The tabs that have room for their whole name; `front`, which is in front, is always one of them. Tabs are left out from
/// the last one on, so that those that stay keep their places.
pub fn fitted(widths: &[f32], front: usize, room: f32) -> FittedTabs {
    let mut shown = vec![true; widths.len()];
    let needed = |shown: &[bool]| {
        let names = widths.iter().zip(shown).filter(|(_, shown)| **shown);
        names.map(|(width, _)| width + space::SMALL).sum::<f32>()
    };
    let mut left = room;
    let mut others = (0..widths.len()).rev().filter(|tab| *tab != front);
    // Widths are sums of many: a rounding error leaves nothing out.
    while needed(&shown) > left + 0.01 {
        let Some(last) = others.next() else {
            break;
        };
        shown[last] = false;
        left = room - MENU_WIDTH;
    }
    let count = shown.iter().filter(|shown| **shown).count().max(1) as f32;
    let free = left - needed(&shown);
    FittedTabs {
        gap: (space::SMALL + free / count)
            .floor()
            .clamp(space::SMALL, space::LARGE),
        shown,
    }
}

/// The air at the right end of a strip with nothing beside its tabs: less where they need it.
pub fn air_behind(ui: &Ui, panes: &[Pane]) -> f32 {
    let names = panes
        .iter()
        .map(|pane| name_width(ui, *pane) + space::SMALL);
    match ui.available_width() - names.sum::<f32>() {
        free if free >= 0.0 => free.floor().min(space::LARGE),
        _ => space::SMALL,
    }
}

fn title(pane: Pane) -> &'static str {
    spec_of(pane).map_or("", |spec| spec.title)
}

fn name_width(ui: &Ui, pane: Pane) -> f32 {
    text_width(ui, title(pane), medium_font())
}

/// Fits the tabs of `panes` into what is left of the width, and draws the menu of those that have no room.
pub fn fitted_tabs_ui(
    ui: &mut Ui,
    panes: &[Pane],
    front: usize,
    commands: &mut Vec<Command>,
) -> FittedTabs {
    let widths: Vec<f32> = panes.iter().map(|pane| name_width(ui, *pane)).collect();
    let fitted = fitted(&widths, front, ui.available_width());
    let hidden = panes.iter().zip(&fitted.shown);
    let hidden: Vec<Pane> = hidden
        .filter(|(_, shown)| !**shown)
        .map(|(pane, _)| *pane)
        .collect();
    if !hidden.is_empty() {
        chooser_ui(ui, "More panes", format!("+{}", hidden.len()), |ui| {
            for pane in hidden {
                if choice_ui(ui, title(pane), false) {
                    commands.push(WindowCommand::ShowPane(pane).into());
                }
            }
        });
    }
    fitted
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_names_stand_in_a_wide_strip_and_the_front_one_in_any() {
        let widths = [62.0, 36.0, 46.0];
        let wide = fitted(&widths, 0, 400.0);
        assert_eq!((wide.shown, wide.gap), (vec![true; 3], space::LARGE));
        let tight = fitted(&widths, 0, 144.0 + 3.0 * space::SMALL);
        assert_eq!((tight.shown, tight.gap), (vec![true; 3], space::SMALL));
        assert_eq!(fitted(&widths, 0, 126.0).shown, [true, false, false]);
        assert_eq!(fitted(&widths, 2, 126.0).shown, [false, false, true]);
        assert_eq!(fitted(&widths, 1, 10.0).shown, [false, true, false]);
        assert_eq!(fitted(&widths, 1, 170.0 - 1.0).shown, [true, true, true]);
    }

    #[test]
    fn names_that_stay_have_room_beside_the_menu() {
        let widths = [45.0, 50.0, 110.0, 40.0];
        for room in 60..300_u16 {
            let room = f32::from(room);
            let tabs = fitted(&widths, 0, room);
            let names = widths.iter().zip(&tabs.shown).filter(|(_, shown)| **shown);
            let used: f32 = names.map(|(width, _)| width + tabs.gap).sum();
            let hidden = tabs.shown.contains(&false);
            let menu = if hidden { MENU_WIDTH } else { 0.0 };
            let alone = tabs.shown.iter().filter(|shown| **shown).count() == 1;
            assert!(alone || used + menu <= room + 0.02, "{room}: {tabs:?}");
        }
    }
}

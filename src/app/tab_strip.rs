//! Which names a strip of tabs shows: all of them, or those that have room, and the others in a menu.

use egui::Ui;

use crate::panes::{Command, Pane, WindowCommand, spec_of};
use crate::ui::controls::{choice_ui, chooser_ui};
use crate::ui::theme::space;
use crate::ui::{medium_font, text_width};

/// Width of the button of the menu with the air beside it, as far as it is known before it is drawn.
const MENU_WIDTH: f32 = 57.0;

/// What a strip of tabs shows.
#[derive(Clone, Debug, PartialEq)]
pub struct FittedTabs {
    /// Whether each tab is shown.
    pub shown: Vec<bool>,
    /// The air before each name.
    pub gap: f32,
}

/// Which tabs have room for their whole name; `front`, which is in front, is always one of them. Tabs are left out from the
/// last one on, so that those that stay keep their places.
fn fitted(widths: &[f32], front: usize, room: f32) -> Vec<bool> {
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
    shown
}

/// The air before each name that is shown, in the room that is left for names.
fn gap(widths: &[f32], shown: &[bool], left: f32) -> f32 {
    let names = widths.iter().zip(shown).filter(|(_, shown)| **shown);
    let (count, used) = names.fold((0_u16, 0.0), |(count, used), (width, _)| {
        (count + 1, used + width)
    });
    let each = (left - used + 0.01) / f32::from(count.max(1));
    each.floor().clamp(0.0, space::LARGE)
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
    let shown = fitted(&widths, front, ui.available_width());
    let hidden = panes.iter().zip(&shown);
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
    let gap = gap(&widths, &shown, ui.available_width());
    FittedTabs { shown, gap }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_names_stand_in_a_wide_strip_and_the_front_one_in_any() {
        let widths = [62.0, 36.0, 46.0];
        let all = [true; 3];
        assert_eq!(fitted(&widths, 0, 400.0), all);
        assert_eq!(gap(&widths, &all, 400.0), space::LARGE);
        let tight = 144.0 + 3.0 * space::SMALL;
        assert_eq!(fitted(&widths, 0, tight), all);
        assert_eq!(gap(&widths, &all, tight), space::SMALL);
        assert_eq!(fitted(&widths, 0, 126.0), [true, false, false]);
        assert_eq!(fitted(&widths, 2, 126.0), [false, false, true]);
        assert_eq!(fitted(&widths, 1, 10.0), [false, true, false]);
    }

    #[test]
    fn names_that_stay_have_room_beside_the_menu() {
        let widths = [45.0, 50.0, 110.0, 40.0];
        for room in 110..300_u16 {
            let room = f32::from(room);
            let shown = fitted(&widths, 0, room);
            let menu = if shown.contains(&false) {
                MENU_WIDTH
            } else {
                0.0
            };
            let gap = gap(&widths, &shown, room - menu);
            let names = widths.iter().zip(&shown).filter(|(_, shown)| **shown);
            let used: f32 = names.map(|(width, _)| width + gap).sum();
            assert!(used + menu <= room + 0.02, "{room}: {shown:?} {gap}");
        }
    }
}

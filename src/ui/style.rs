//! Passes the design tokens to egui: fonts, spacing and the looks of controls in both themes.

use std::borrow::Cow;
use std::sync::Arc;

use egui::style::{ScrollStyle, Selection, WidgetVisuals};
use egui::{
    Context, CornerRadius, FontData, FontDefinitions, FontFamily, FontId, Margin, RichText, Shadow,
    Stroke, Style, TextStyle, Theme, ThemePreference, vec2,
};

use crate::ui::pointer_steps::PointerSteps;
use crate::ui::theme::{Colours, MOTION_S, line, radius, space, type_size};

/// Seconds until a tooltip appears: with the frame that draws it, less than 0.3.
const TOOLTIP_S: f32 = 0.25;

const REGULAR: &[u8] = include_bytes!("../../assets/fonts/Inter-Regular.otf");
const MEDIUM: &[u8] = include_bytes!("../../assets/fonts/Inter-Medium.otf");
const SEMIBOLD: &[u8] = include_bytes!("../../assets/fonts/Inter-SemiBold.otf");

/// Gives a window its fonts and both themes, once, before anything is drawn.
pub fn install(ctx: &Context) {
    ctx.add_plugin(PointerSteps::default());
    ctx.set_fonts(fonts());
    for theme in [Theme::Dark, Theme::Light] {
        ctx.set_style_of(theme, style(theme == Theme::Dark));
    }
}

/// Adds faces, each a file and the number of the face in it, for letters that the window's own lack.
pub fn add_faces(ctx: &Context, faces: Vec<(Cow<'static, [u8]>, u32)>) {
    let mut fonts = fonts();
    for (number, (bytes, index)) in faces.into_iter().enumerate() {
        let name = format!("further {number}");
        let mut face = FontData::from_static(&[]);
        face.font = Arc::new(bytes);
        face.index = index;
        fonts.font_data.insert(name.clone(), Arc::new(face));
        for order in fonts.families.values_mut() {
            order.push(name.clone());
        }
    }
    ctx.set_fonts(fonts);
}

/// [`install`] and a fixed theme.
pub fn apply(ctx: &Context, dark: bool) {
    install(ctx);
    ctx.set_theme(if dark {
        ThemePreference::Dark
    } else {
        ThemePreference::Light
    });
}

/// Inter in three weights, before the fonts that come with egui for whatever it lacks.
fn fonts() -> FontDefinitions {
    let mut fonts = FontDefinitions::default();
    let fallback = fonts
        .families
        .get(&FontFamily::Proportional)
        .cloned()
        .unwrap_or_default();
    for (name, bytes, family) in [
        ("Inter", REGULAR, FontFamily::Proportional),
        ("Inter Medium", MEDIUM, medium_family()),
        ("Inter SemiBold", SEMIBOLD, semibold_family()),
    ] {
        fonts
            .font_data
            .insert(name.to_owned(), Arc::new(FontData::from_static(bytes)));
        let mut order = vec![name.to_owned()];
        order.extend(fallback.iter().cloned());
        fonts.families.insert(family, order);
    }
    fonts
}

fn medium_family() -> FontFamily {
    FontFamily::Name("medium".into())
}

fn semibold_family() -> FontFamily {
    FontFamily::Name("semibold".into())
}

/// Notes and axis labels.
pub fn note_font() -> FontId {
    FontId::proportional(type_size::NOTE)
}

/// Running text.
pub fn text_font() -> FontId {
    FontId::proportional(type_size::TEXT)
}

/// Tabs, names and column heads.
pub fn medium_font() -> FontId {
    FontId::new(type_size::TEXT, medium_family())
}

/// Small emphasised text: marks on plots.
pub fn medium_note_font() -> FontId {
    FontId::new(type_size::NOTE, medium_family())
}

/// Headings of windows and panes that stand alone.
pub fn heading_font() -> FontId {
    FontId::new(type_size::HEADING, semibold_family())
}

/// Subject titles and the one number that matters.
pub fn title_font() -> FontId {
    FontId::new(type_size::TITLE, semibold_family())
}

/// The program's name in the menu bar.
pub fn title_text_font() -> FontId {
    FontId::new(type_size::TEXT, semibold_family())
}

/// Small, muted text.
pub fn note(text: impl Into<String>) -> RichText {
    RichText::new(text).text_style(TextStyle::Small).weak()
}

/// Text in the middle weight.
pub fn medium(text: impl Into<String>) -> RichText {
    RichText::new(text).font(medium_font())
}

fn style(dark: bool) -> Style {
    let colours = Colours::of(dark);
    let mut style = Theme::from_dark_mode(dark).default_style();
    style.text_styles = [
        (TextStyle::Small, note_font()),
        (TextStyle::Body, text_font()),
        (TextStyle::Button, text_font()),
        (TextStyle::Heading, heading_font()),
        (TextStyle::Monospace, FontId::monospace(type_size::NOTE)),
    ]
    .into();
    style.animation_time = MOTION_S;
    style.interaction.selectable_labels = false;
    style.interaction.tooltip_delay = TOOLTIP_S;
    style.scroll_animation = egui::style::ScrollAnimation::duration(MOTION_S);
    spacing(&mut style);
    visuals(&mut style, colours);
    style
}

fn spacing(style: &mut Style) {
    let spacing = &mut style.spacing;
    spacing.item_spacing = vec2(space::MEDIUM, space::SMALL);
    spacing.button_padding = vec2(space::MEDIUM, 3.0);
    spacing.interact_size = vec2(space::HUGE, space::HUGE);
    spacing.window_margin = Margin::same(space::LARGE as i8);
    spacing.menu_margin = Margin::same(6);
    spacing.icon_width = 14.0;
    spacing.icon_width_inner = 8.0;
    spacing.icon_spacing = 6.0;
    spacing.combo_width = 80.0;
    spacing.tooltip_width = 360.0;
    spacing.menu_width = 240.0;
    spacing.scroll = ScrollStyle {
        bar_width: 8.0,
        floating_width: 4.0,
        ..ScrollStyle::floating()
    };
}

fn visuals(style: &mut Style, colours: &Colours) {
    let visuals = &mut style.visuals;
    let control = |fill, text, edge| WidgetVisuals {
        bg_fill: fill,
        weak_bg_fill: fill,
        bg_stroke: Stroke::new(line::THIN, edge),
        corner_radius: CornerRadius::same(radius::CONTROL),
        fg_stroke: Stroke::new(line::THIN, text),
        expansion: 0.0,
    };
    visuals.widgets.noninteractive = control(colours.pane, colours.text, colours.line);
    visuals.widgets.inactive = control(colours.control, colours.text, colours.line);
    visuals.widgets.hovered = control(colours.control_hovered, colours.strong, colours.muted);
    visuals.widgets.active = control(colours.control_hovered, colours.strong, colours.accent);
    visuals.widgets.open = control(colours.control_hovered, colours.strong, colours.line);
    visuals.selection = Selection {
        bg_fill: colours.accent.gamma_multiply(0.35),
        stroke: Stroke::new(line::MARK, colours.accent),
    };
    visuals.weak_text_color = Some(colours.muted);
    visuals.hyperlink_color = colours.accent;
    visuals.faint_bg_color = colours.control;
    visuals.extreme_bg_color = colours.control;
    visuals.text_edit_bg_color = Some(colours.control);
    visuals.code_bg_color = colours.control;
    visuals.warn_fg_color = colours.warning;
    visuals.error_fg_color = colours.error;
    visuals.window_fill = colours.pane;
    visuals.window_stroke = Stroke::new(line::THIN, colours.line);
    visuals.panel_fill = colours.window;
    visuals.window_corner_radius = CornerRadius::same(radius::PANE);
    visuals.menu_corner_radius = CornerRadius::same(radius::PANE);
    let shadow = Shadow {
        offset: [0, 4],
        blur: 16,
        spread: 0,
        color: egui::Color32::from_black_alpha(if visuals.dark_mode { 110 } else { 36 }),
    };
    visuals.window_shadow = shadow;
    visuals.popup_shadow = shadow;
    visuals.striped = false;
    visuals.slider_trailing_fill = true;
    // A blinking cursor would ask for repaints for ever.
    visuals.text_cursor.blink = false;
    visuals.text_cursor.stroke = Stroke::new(line::STRONG, colours.accent);
}

//! The 3D view: subjects drawn by our renderer, the camera under the pointer, and what lies over them.

use std::sync::Arc;
use std::sync::atomic::AtomicU64;

use egui::{Rect, Response, Role, Sense, Stroke, Ui, UiBuilder, WidgetInfo};

use crate::document::ViewMode;
use crate::panes::{
    Command, EditCommand, SelectCommand, SubjectTarget, ViewCommand, WallCommand, dragged_subject,
    subject_target_ui, viewport_overlay_ui,
};
use crate::picture::{
    CohortColourRanges, MedialSettings, PatchLook, PictureTheme, Quantity, SceneSettings,
    SubjectScene, WallPart, scene_with_extras,
};
use crate::render::{Camera, ViewId};
use crate::study::Revision;
use crate::ui::controls::clicked_twice;
use crate::ui::theme::{colours, line};

use crate::document::document::Document;
use crate::document::play::pose_in;
use crate::document::state::State;
use crate::document::visible_poses;
use crate::panes::viewport::camera_drag::camera_command;
use crate::panes::viewport::empty_state::loading_ui;
use crate::panes::viewport::fits::Fits;
use crate::panes::viewport::overlay_view::overlay_view;
use crate::panes::viewport::paint::{ScenePaint, pixels};
use crate::panes::viewport::pick_label::{Picked, picked, picked_ui};
use crate::panes::viewport::places::{frame_label, places};
use crate::panes::viewport::queries::{Pictures, PlacedSubject};
use crate::panes::viewport::shown_subject::{
    ScalarCache, ShownSubject, Tile, shown_estimate, shown_subject,
};

/// The subjects on screen and what was worked out for them.
#[derive(Default)]
pub struct Viewport {
    shown: Vec<ShownSubject>,
    mode: ViewMode,
    /// Which opening of a study and which list the subjects on screen are of.
    of: (u64, Revision),
    limits: CohortColourRanges,
    fits: Fits,
    numbers: ScalarCache,
    pinned: Option<Picked>,
    has_device: bool,
}

impl Viewport {
    /// Whether there is a device to draw with.
    pub fn has_device(&self) -> bool {
        self.has_device
    }

    /// A view that draws if there is a device to draw with.
    pub fn new(has_device: bool) -> Self {
        Self {
            has_device,
            ..Self::default()
        }
    }

    /// Asks for the subjects of the state; shows them together once all are ready.
    pub fn prepare(&mut self, state: &State, pictures: Pictures<'_>, reference_frames: &[usize]) {
        let open = &state.document.study;
        let study = state.document.study();
        let numbers = &mut self.numbers;
        let (mode, ready): (ViewMode, Option<Vec<ShownSubject>>) = match state.estimate() {
            Some(pose) => {
                let shown = shown_estimate(state, pictures, pose);
                (ViewMode::Single, shown.map(|shown| vec![shown]))
            }
            None => {
                let places = visible_poses(state).into_iter();
                // All are asked for, also after one that is not ready.
                let shown: Vec<_> = places
                    .map(|place| shown_subject(state, pictures, numbers, reference_frames, &place))
                    .collect();
                (state.document.view_mode, shown.into_iter().collect())
            }
        };
        if let Some(ready) = ready {
            self.shown = ready;
            self.mode = mode;
            self.of = (open.opening, open.listing);
        } else if self.of == (open.opening, open.listing) {
            (self.shown.iter_mut()).for_each(|shown| shown.follow(study));
        }
        // A label that a click left belongs to its subject.
        let pinned = self.pinned.take();
        self.pinned = pinned.filter(|picked| {
            let mut shown = self.shown.iter();
            shown.any(|shown| picked.belongs_to(&shown.subject))
        });
        if !open.study.subjects.is_empty()
            && let Some(limits) = pictures.cohort_ranges(reference_frames)
        {
            self.limits = limits;
        }
        let placed = self.placed();
        self.fits.keep(&placed);
        self.numbers.keep(&placed);
    }

    fn placed(&self) -> Vec<Arc<PlacedSubject>> {
        let placed = self.shown.iter().map(|shown| &shown.placed);
        placed.map(Arc::clone).collect()
    }

    /// Subjects on screen.
    pub fn shown(&self) -> &[ShownSubject] {
        &self.shown
    }

    /// The opening of the study whose subjects are on screen.
    pub fn shown_opening(&self) -> Option<u64> {
        (!self.shown.is_empty()).then_some(self.of.0)
    }

    /// The camera of a subject on screen, as last drawn; fitted to a square where it never was.
    pub fn camera(&self, document: &Document, shown: &ShownSubject) -> Camera {
        let viewpoint = document.viewpoint;
        let fitted = self.fits.latest(&shown.placed).unwrap_or_else(|| {
            let rotation = viewpoint.rotation(&shown.placed.prepared.axes);
            shown.placed.fitted(rotation, 1.0)
        });
        viewpoint.camera(&shown.placed.frame, fitted)
    }

    /// The fixed colour ranges of the study.
    pub fn cohort_ranges(&self) -> &CohortColourRanges {
        &self.limits
    }

    /// How a document has subjects drawn.
    pub fn settings(&self, document: &Document, dark: bool) -> SceneSettings {
        let visible = document.visibility;
        SceneSettings {
            quantity: document.quantity,
            cohort_ranges: self.limits,
            typed_limits: document.limits(),
            inner: visible.endocardium,
            outer: visible.epicardium,
            wireframe: visible.wireframe,
            vertices: visible.vertices,
            shading: visible.shading,
            medial: MedialSettings {
                atoms: visible.atoms,
                spokes: visible.spokes,
                patches: visible.patches,
                patch_look: PatchLook::default(),
                direction: visible.direction,
                part: document.part,
                limits: document.limits_of(Quantity::ThicknessRatio),
            },
            theme: if dark {
                PictureTheme::DARK
            } else {
                PictureTheme::LIGHT
            },
            ..SceneSettings::default()
        }
    }

    /// Draws the view into all room left; `meter` takes the time of the callback.
    pub fn ui(
        &mut self,
        ui: &mut Ui,
        state: &State,
        meter: &Arc<AtomicU64>,
        commands: &mut Vec<Command>,
    ) {
        let (area, response) = ui.allocate_exact_size(ui.available_size(), Sense::click_and_drag());
        response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, "3D viewport"));
        let rects = places(self.mode, area, self.shown.len());
        let placed = self.placed();
        let viewpoint = &state.document.viewpoint;
        let cameras = self.fits.cameras(viewpoint, self.mode, &placed, &rects);
        let tiles: Vec<Tile> = self
            .shown
            .iter()
            .zip(rects)
            .zip(cameras)
            .map(|((shown, rect), camera)| Tile {
                shown,
                rect,
                camera,
            })
            .collect();
        commands.extend(camera_command(ui, &response, state, &tiles));
        // Until the first subject of another list is ready, indices of the subjects on screen mean other ones.
        let is_of_study = self.of.1 == state.document.study.listing;
        if is_of_study {
            commands.extend(self.click_command(&response, &tiles));
        }
        let settings = self.settings(&state.document, ui.visuals().dark_mode);
        let (hovered, clicked) = pointed(&response, state, &tiles, &settings);
        let legends = self.draw(ui, &settings, &tiles, meter);
        self.overlays_ui(ui, state, &tiles, (area, &legends), commands);
        loading_ui(ui, area, self.awaited(state));
        if is_of_study {
            targets_ui(ui, &response, state, &tiles, commands);
        }
        let quantity = state.document.bar_quantity();
        if let Some(now) = clicked.as_ref().filter(|_| is_of_study) {
            commands.extend(part_command(state, &tiles, now.as_ref()));
            let point = now.as_ref().and_then(|picked| picked.point(&tiles));
            commands.push(EditCommand::Pick(point).into());
        }
        let pinned = match clicked {
            Some(now) => now,
            None => self.pinned.clone(),
        };
        for picked in hovered.iter().chain(&pinned) {
            for tile in tiles.iter().filter(|tile| picked.is_on(tile)) {
                picked_ui(ui, tile, picked, quantity);
            }
        }
        self.pinned = pinned;
    }

    /// A double click fits the subject; a click on one of all phases goes there.
    fn click_command(&self, response: &Response, tiles: &[Tile]) -> Option<Command> {
        if clicked_twice(response) {
            return Some(Command::View(ViewCommand::FitView));
        }
        let at = response
            .interact_pointer_pos()
            .filter(|_| response.clicked())?;
        let tile = tiles.iter().find(|tile| tile.rect.contains(at))?;
        // The subject on screen may still be the one before.
        (self.mode == ViewMode::AllFrames).then_some(Command::Select(SelectCommand::SelectPose {
            subject: tile.shown.index,
            frame: tile.shown.position as usize,
            play: false,
        }))
    }

    /// The selected subject, while another one is still on screen.
    fn awaited<'a>(&self, state: &'a State) -> Option<&'a str> {
        let selected = state.document.selected()?;
        let mut shown = self.shown.iter();
        let is_shown = shown.any(|shown| Arc::ptr_eq(&shown.subject, selected));
        (!is_shown).then_some(&*selected.id)
    }

    /// Hands the subjects to our renderer; returns what the colours mean at each subject where they mean something else
    /// than at those before it.
    fn draw(
        &self,
        ui: &Ui,
        settings: &SceneSettings,
        tiles: &[Tile],
        meter: &Arc<AtomicU64>,
    ) -> Vec<(usize, SubjectScene)> {
        let mut legends: Vec<(usize, SubjectScene)> = Vec::new();
        for (place, tile) in tiles.iter().enumerate() {
            let prepared = &tile.shown.placed.prepared;
            let pose = pose_in(prepared, tile.shown.position);
            let settings = tile.shown.settings(settings);
            let mut picture = scene_with_extras(prepared, tile.shown.extras(), &settings, pose);
            let scene = std::mem::take(&mut picture.scene);
            let same = |(_, other): &(usize, SubjectScene)| other.legend == picture.legend;
            if picture.legend.is_some() && !legends.iter().any(same) {
                legends.push((place, picture));
            }
            if !self.has_device {
                continue;
            }
            let paint = ScenePaint {
                view: ViewId(place as u32),
                views: tiles.len() as u32,
                scene,
                camera: tile.camera,
                rect: tile.rect,
                ctx: ui.ctx().clone(),
                size: pixels(tile.rect, ui.pixels_per_point()),
                meter: Arc::clone(meter),
            };
            ui.painter().add(paint.shape());
        }
        legends
    }

    fn overlays_ui(
        &self,
        ui: &mut Ui,
        state: &State,
        tiles: &[Tile],
        (area, legends): (Rect, &[(usize, SubjectScene)]),
        commands: &mut Vec<Command>,
    ) {
        let whole_beat = self.mode == ViewMode::AllFrames;
        let shown = if whole_beat {
            &tiles[..tiles.len().min(1)]
        } else {
            tiles
        };
        for (place, tile) in shown.iter().enumerate() {
            let rect = if whole_beat { area } else { tile.rect };
            let last = place + 1 == shown.len();
            let mut legends = legends.iter().filter(|(at, _)| *at == place || whole_beat);
            let legends = legends.next().map(|(_, legends)| legends);
            let view = overlay_view(
                legends,
                &tile.shown.placed.prepared,
                &tile.camera,
                tile.rect.height(),
                last,
            );
            let builder = UiBuilder::new().max_rect(rect).id_salt(("heart", place));
            let mut over = ui.new_child(builder);
            over.set_clip_rect(rect.intersect(ui.clip_rect()));
            viewport_overlay_ui(&mut over, &tile.shown.caption, &view, commands);
            if place > 0 {
                let line = Stroke::new(line::THIN, colours(ui).line);
                ui.painter().vline(rect.left(), rect.y_range(), line);
            }
        }
        if whole_beat {
            for tile in tiles {
                frame_label(ui, state, tile);
            }
        }
    }
}

/// While a subject is dragged, the others are places where it can be let go.
fn targets_ui(
    ui: &Ui,
    response: &Response,
    state: &State,
    tiles: &[Tile],
    commands: &mut Vec<Command>,
) {
    let Some(dragged) = dragged_subject(ui) else {
        return;
    };
    let Some(source) = state.subject(dragged.subject) else {
        return;
    };
    for tile in tiles {
        let Some(subject) = state.subject(tile.shown.index) else {
            continue;
        };
        let target = SubjectTarget {
            rect: tile.rect,
            subject: tile.shown.index,
            id: &subject.id,
            corresponds: subject.sequence.correspondence() == source.sequence.correspondence(),
        };
        subject_target_ui(ui, response, &target, commands);
    }
}

/// The vertex under a resting pointer, and the vertex that was clicked: `Some(None)` where a
/// click met nothing. While the motion plays or the subject turns, nothing is looked for.
fn pointed(
    response: &Response,
    state: &State,
    tiles: &[Tile],
    settings: &SceneSettings,
) -> (Option<Picked>, Option<Option<Picked>>) {
    let at = |place: Option<egui::Pos2>| {
        let place = place?;
        let tile = tiles.iter().find(|tile| tile.rect.contains(place))?;
        picked(tile, settings, place)
    };
    let clicked = response
        .clicked()
        .then(|| at(response.interact_pointer_pos()));
    let quiet = !state.play.playing && !response.dragged();
    let hovered = quiet.then(|| at(response.hover_pos())).flatten();
    (hovered, clicked)
}

/// A click on a patch of the selected subject selects it; elsewhere, lets go of what was selected.
fn part_command(state: &State, tiles: &[Tile], clicked: Option<&Picked>) -> Option<Command> {
    let document = &state.document;
    let on_patch = clicked
        .filter(|_| document.visibility.patches)
        .and_then(|picked| {
            let mut own = tiles
                .iter()
                .filter(|tile| tile.shown.index == document.subject);
            let tile = own.find(|tile| picked.is_on(tile))?;
            let atom = picked.atom(tile)?;
            let found = &tile.shown.medial.as_ref()?.wall.thickening;
            let mut patches = found.patches.iter();
            patches.position(|patch| patch.atoms.binary_search(&atom).is_ok())
        });
    let part = on_patch.map(WallPart::Patch);
    (part != document.part).then_some(Command::Wall(WallCommand::SelectPart(part)))
}

//! Which vertex is under the pointer, and what its number is.

use std::sync::Arc;

use egui::{Pos2, Rect, Ui};
use glam::Vec2;

use crate::document::PickedPoint;
use crate::mesh::Point3;
use crate::picture::{
    PictureOrigin, PreparedSubject, Quantity, SceneSettings, SurfaceRole, SurfaceScalars,
    subject_scene,
};
use crate::render::{GeometryPose, VertexScalars, pick};
use crate::study::Subject;
use crate::ui::theme::{colours, line, radius, space, type_size};

use crate::document::play::pose_in;
use crate::panes::viewport::shown_subject::Tile;

/// A vertex of a subject, named so that it stays the same while the motion plays.
#[derive(Clone)]
pub struct Picked {
    subject: Arc<Subject>,
    role: SurfaceRole,
    vertex: usize,
}

/// The vertex nearest to where the pointer meets the subject of a cell.
pub fn picked(tile: &Tile, settings: &SceneSettings, at: Pos2) -> Option<Picked> {
    let placed = &tile.shown.placed;
    let prepared = &placed.prepared;
    let pose = pose_in(prepared, tile.shown.position);
    let scene = subject_scene(prepared, settings, pose).scene;
    let local = at - tile.rect.min;
    let size = tile.rect.size();
    let hit = pick(
        &scene,
        &tile.camera,
        Vec2::new(local.x, local.y),
        Vec2::new(size.x, size.y),
    )?;
    let geometry = &scene.surfaces.get(hit.surface)?.geometry;
    let surface = prepared
        .surfaces
        .iter()
        .find(|surface| Arc::ptr_eq(&surface.geometry, geometry))?;
    Some(Picked {
        subject: Arc::clone(&tile.shown.subject),
        role: surface.role,
        vertex: hit.vertex as usize,
    })
}

impl Picked {
    /// Whether the vertex belongs to the subject of a cell.
    pub fn is_on(&self, tile: &Tile) -> bool {
        self.belongs_to(&tile.shown.subject)
    }

    /// Whether the vertex is one of a subject.
    pub fn belongs_to(&self, subject: &Arc<Subject>) -> bool {
        Arc::ptr_eq(&self.subject, subject)
    }

    /// Where the vertex is in the first frame of its subject; `None` on what was transported there.
    pub fn point(&self, tiles: &[Tile]) -> Option<PickedPoint> {
        let mut on_screen = tiles.iter().filter(|tile| self.is_on(tile));
        let shown = on_screen.find(|tile| !tile.shown.transported)?.shown;
        let surface = shown.placed.prepared.surface(self.role)?;
        let at = surface.geometry.positions.first()?.get(self.vertex)?;
        let at = Point3::from(at.map(f64::from));
        Some(PickedPoint {
            subject: shown.index,
            at: PictureOrigin::of(&self.subject).in_subject(at),
        })
    }

    /// The atom of the medial surface that belongs to the vertex.
    pub fn atom(&self, tile: &Tile) -> Option<u32> {
        let surfaces = &tile.shown.placed.prepared.surfaces;
        let place = surfaces
            .iter()
            .position(|surface| surface.role == self.role)?;
        let medial = tile.shown.medial.as_ref()?;
        medial.prepared.atom_at(place, self.vertex)
    }

    /// Surface, vertex and number with its unit: `endocardium · vertex 812 · 7.3 mm`.
    pub fn words(
        &self,
        prepared: &PreparedSubject,
        numbers: Option<&SurfaceScalars>,
        quantity: Quantity,
        pose: GeometryPose,
    ) -> String {
        let mut words = format!("{} · vertex {}", role_name(self.role), self.vertex);
        let own = prepared.surface(self.role);
        let own = own.and_then(|surface| surface.scalars(quantity));
        let shared = numbers.filter(|numbers| numbers.quantity == quantity);
        let shared = shared.and_then(|numbers| numbers.of(self.role));
        if let Some(scalars) = own.or(shared)
            && let Some(value) = value(scalars, self.vertex, pose)
        {
            words.push_str(" · ");
            words.push_str(&number(prepared, quantity, value));
        }
        words
    }

    /// Where the vertex is on the screen at the cell's pose.
    fn place(&self, tile: &Tile) -> Option<Pos2> {
        let prepared = &tile.shown.placed.prepared;
        let pose = pose_in(prepared, tile.shown.position);
        let positions = &prepared.surface(self.role)?.geometry.positions;
        let from = glam::Vec3::from(*positions.get(pose.from)?.get(self.vertex)?);
        let to = glam::Vec3::from(*positions.get(pose.to)?.get(self.vertex)?);
        let size = tile.rect.size();
        let size = Vec2::new(size.x, size.y);
        let seen = tile.camera.project(from.lerp(to, pose.blend), size)?;
        Some(tile.rect.min + egui::vec2(seen.pixel.x, seen.pixel.y))
    }
}

/// Draws a mark on the vertex and its words beside it.
pub fn picked_ui(ui: &Ui, tile: &Tile, picked: &Picked, quantity: Quantity) {
    let Some(at) = picked.place(tile) else {
        return;
    };
    let colours = colours(ui);
    let painter = ui.painter().with_clip_rect(tile.rect);
    painter.circle(at, 3.5, colours.selection, (line::THIN, colours.window));
    let prepared = &tile.shown.placed.prepared;
    let pose = pose_in(prepared, tile.shown.position);
    let words = picked.words(prepared, tile.shown.numbers.as_deref(), quantity, pose);
    let font = egui::FontId::proportional(type_size::NOTE);
    let galley = painter.layout_no_wrap(words, font, colours.text);
    let size = galley.size() + egui::vec2(2.0 * space::MEDIUM, space::MEDIUM);
    let mut corner = at + egui::vec2(10.0, -10.0 - size.y);
    corner.x = corner.x.min(tile.rect.right() - size.x - space::SMALL);
    corner.y = corner.y.max(tile.rect.top() + space::SMALL);
    let card = Rect::from_min_size(corner, size);
    painter.rect(
        card,
        f32::from(radius::CONTROL),
        colours.control,
        (line::THIN, colours.line),
        egui::StrokeKind::Inside,
    );
    let text_at = card.min + egui::vec2(space::MEDIUM, 0.5 * space::MEDIUM);
    painter.galley(text_at, galley, colours.text);
}

fn role_name(role: SurfaceRole) -> &'static str {
    match role {
        SurfaceRole::Inner => "endocardium",
        SurfaceRole::Outer => "epicardium",
        SurfaceRole::Rim => "base",
        SurfaceRole::Alone(kind) => kind.name(),
    }
}

fn value(scalars: &VertexScalars, vertex: usize, pose: GeometryPose) -> Option<f64> {
    let values = &scalars.values;
    let at = |frame: usize| {
        let frame = values.get(frame).or_else(|| values.first())?;
        frame.get(vertex).copied().map(f64::from)
    };
    let (from, to) = (at(pose.from)?, at(pose.to)?);
    Some(from + f64::from(pose.blend) * (to - from))
}

fn number(prepared: &PreparedSubject, quantity: Quantity, value: f64) -> String {
    if value.is_nan() {
        return "no value".to_owned();
    }
    match quantity {
        Quantity::Tissue => String::new(),
        Quantity::Displacement => {
            format!("displacement {value:.1} {}", prepared.unit.length_symbol())
        }
        Quantity::AreaRatio => format!("area ratio {value:.2}"),
        Quantity::ThicknessRatio => format!("PT {value:.2} ×"),
        Quantity::Contribution => format!("contribution {value:.2} × the mean"),
        Quantity::MotionDifference => {
            format!(
                "{value:.1} {} from own motion",
                prepared.unit.length_symbol()
            )
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::testing::subject_with_frames;

    #[test]
    fn a_vertex_says_its_surface_and_its_number_with_unit() {
        let subject = Arc::new(subject_with_frames("a", 5));
        let prepared = PreparedSubject::new(&subject, 0);
        let picked = Picked {
            subject,
            role: SurfaceRole::Alone(crate::study::SurfaceKind::Cavity),
            vertex: 7,
        };
        // The sphere of the test shrinks by 1 mm a frame.
        let half_way = GeometryPose {
            from: 2,
            to: 3,
            blend: 0.5,
        };
        let lists: Vec<Vec<f32>> = (0..5).map(|frame| vec![frame as f32; 42]).collect();
        let numbers = SurfaceScalars::of_heart(&prepared, Quantity::MotionDifference, &lists);
        let words = |quantity| picked.words(&prepared, numbers.as_ref(), quantity, half_way);
        let transported = words(Quantity::MotionDifference);
        assert_eq!(transported, "cavity · vertex 7 · 2.5 mm from own motion");
        assert_eq!(words(Quantity::Contribution), "cavity · vertex 7");
        assert_eq!(words(Quantity::Tissue), "cavity · vertex 7");
        assert_eq!(
            words(Quantity::Displacement),
            "cavity · vertex 7 · displacement 2.5 mm"
        );
        assert_eq!(
            words(Quantity::AreaRatio),
            "cavity · vertex 7 · area ratio 0.84"
        );
    }
}

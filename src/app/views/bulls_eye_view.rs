//! The bull's-eye of the selected heart: laid flat once, coloured at every pose.

use std::sync::Arc;

use crate::analysis::segments::{
    Polar, Segment, flat_map, plot_point, polar, segment_means, vertex_areas,
};
use crate::app::document::nearest_frame;
use crate::app::state::State;
use crate::app::views::overlay_view::phase_name;
use crate::app::views::patch_words::{part_name, percent};
use crate::engine::SubjectThickening;
use crate::mesh::Point3;
use crate::picture::{Quantity, WallPart};
use crate::ui::{BullsEyePatch, BullsEyeQuantity, BullsEyeView, PatchStanding, WallState};

/// What the atoms' colours are made from and how the plot is laid.
#[derive(Debug, Default)]
pub struct BullsEyeData {
    made_from: Option<Arc<SubjectThickening>>,
    points: Vec<[f64; 2]>,
    faces: Vec<[u32; 3]>,
    /// Area of each atom that takes part, 0 of others.
    weights: Vec<f64>,
    borders: Vec<Vec<Vec<[f64; 2]>>>,
    patches: Vec<BullsEyePatch>,
    values: Vec<f32>,
    segments: [Option<f64>; Segment::COUNT],
    moment: String,
    without_axis: Option<String>,
    oriented: bool,
}

/// Ratios at the ends of the colours, unless others were typed.
const LIMITS: [f64; 2] = [0.5, 2.0];

fn patch_name(found: &SubjectThickening, standing: PatchStanding, index: usize) -> String {
    let share = found
        .thickening
        .patches
        .get(index)
        .map_or(0.0, |patch| patch.share);
    let what = match standing {
        PatchStanding::Untold => "",
        PatchStanding::Abnormal => " · abnormal",
        PatchStanding::ThickensLittle => " · thickens little",
    };
    let part = part_name(standing, index);
    format!("{part}{what} · {} of the LV", percent(share))
}

impl BullsEyeData {
    /// Lays the wall flat again where it changed, and takes the values of the pose on screen.
    pub fn refresh(&mut self, state: &State) {
        let Some((Ok(found), _)) = state.wall_of(state.document.subject) else {
            *self = Self::default();
            return;
        };
        let made = self.made_from.as_ref();
        if !made.is_some_and(|made| Arc::ptr_eq(made, found)) {
            self.lay(found);
        }
        self.take_values(state, found);
        let selected = match state.document.part {
            Some(WallPart::Patch(patch)) => Some(patch),
            _ => None,
        };
        let standing = state.patch_standing(state.document.subject);
        self.patches = (self.borders.iter().enumerate())
            .filter(|_| state.document.visibility.patches)
            .map(|(index, borders)| BullsEyePatch {
                borders: borders.clone(),
                name: patch_name(found, standing, index),
                faint: standing == PatchStanding::ThickensLittle,
                selected: selected == Some(index),
            })
            .collect();
    }

    fn lay(&mut self, found: &Arc<SubjectThickening>) {
        *self = Self {
            made_from: Some(Arc::clone(found)),
            without_axis: found.without_axis.clone(),
            ..Self::default()
        };
        let beat = &found.beat;
        let rest = beat.frames.get(found.thickening.end_diastole);
        let (Some(axis), Some(rest)) = (found.axis, rest) else {
            return;
        };
        self.oriented = axis.is_oriented();
        let centres: Vec<Point3> = rest.atoms.iter().map(|atom| atom.position).collect();
        let places: Vec<Polar> = centres.iter().map(|&centre| polar(&axis, centre)).collect();
        let triangles = beat.faces.triangles();
        let map = flat_map(&places, &centres, triangles);
        self.weights = vertex_areas(&centres, triangles);
        for (weight, &regular) in self.weights.iter_mut().zip(&beat.regular) {
            if !regular {
                *weight = 0.0;
            }
        }
        self.borders = (found.thickening.patches.iter())
            .map(|patch| {
                let borders = patch.border.iter().map(|border| {
                    let places = border.iter().filter_map(|&atom| places.get(atom as usize));
                    places.map(|&place| plot_point(place)).collect()
                });
                borders.collect()
            })
            .collect();
        self.points = map.points;
        self.faces = map.faces;
    }

    /// PT of the nearest frame, or what the whole beat tells.
    fn take_values(&mut self, state: &State, found: &SubjectThickening) {
        let document = &state.document;
        let (beat, told) = (&found.beat, &found.thickening);
        let frame = nearest_frame(document.position, beat.frames.len());
        let phase = phase_name(state.phases_of(document.subject), frame);
        self.moment = phase.map_or_else(|| format!("frame {frame}"), str::to_owned);
        let count = beat.regular.len();
        let part = |atom: usize| beat.regular[atom];
        match document.bulls_eye {
            BullsEyeQuantity::Ratio => {
                let radii = |frame: usize| {
                    let atoms = beat.frames[frame].atoms.iter();
                    atoms.map(|atom| atom.radius).collect::<Vec<f64>>()
                };
                let (now, rest) = (radii(frame), radii(told.end_diastole));
                self.values = (0..count)
                    .map(|atom| {
                        if part(atom) {
                            (now[atom] / rest[atom]) as f32
                        } else {
                            f32::NAN
                        }
                    })
                    .collect();
                // The ratio of means, in which thin places do not weigh more.
                let [now, rest] =
                    [now, rest].map(|radii| segment_means(&found.segments, &self.weights, &radii));
                self.segments = std::array::from_fn(|index| Some(now[index]? / rest[index]?));
            }
            BullsEyeQuantity::Thickening => {
                self.values = (0..count)
                    .map(|atom| {
                        if part(atom) {
                            told.thickening[atom].exp() as f32
                        } else {
                            f32::NAN
                        }
                    })
                    .collect();
                self.segments = segment_means(&found.segments, &self.weights, &told.thickening)
                    .map(|mean| mean.map(f64::exp));
            }
        }
    }

    /// What the pane shows.
    pub fn view<'a>(&'a self, state: &'a State, wall: &'a WallState) -> BullsEyeView<'a> {
        let document = &state.document;
        BullsEyeView {
            subject: document.selected().map(|subject| &*subject.id),
            state: wall,
            without_axis: self.without_axis.as_deref(),
            quantity: document.bulls_eye,
            moment: &self.moment,
            by_segment: document.bulls_eye_segments,
            points: &self.points,
            faces: &self.faces,
            values: &self.values,
            segments: self.segments,
            patches: &self.patches,
            selected: match document.part {
                Some(WallPart::Segment(segment)) => Some(segment),
                _ => None,
            },
            oriented: self.oriented,
            limits: document
                .limits_of(Quantity::ThicknessRatio)
                .filter(|limits| limits[0] > 0.0 && limits[1] > limits[0])
                .unwrap_or(LIMITS),
        }
    }
}

//! Shapes of the labels of a study: each label has its own, so that colour is never alone. Maps on screen and in the report
//! mark subjects alike.

use crate::picture::tokens::{PictureTheme, srgb};
use crate::study::{LabelClass, Study};

/// How subjects of one label are marked in tables, maps and legends.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum LabelMark {
    /// Any label that counts as normal: a circle.
    Normal,
    /// Another label of the study, by its place among them.
    Label(u8),
    /// No label: a square.
    #[default]
    Unlabelled,
}

/// A shape around the origin, in radii of its mark, x to the right and y down.
#[derive(Clone, Debug, PartialEq)]
pub enum MarkShape {
    /// A disc of radius 1.
    Disc,
    /// A square with this half side.
    Square(f32),
    /// Lines from end to end.
    Arms(Vec<[[f32; 2]; 2]>),
    /// Convex polygons.
    Polygons(Vec<Vec<[f32; 2]>>),
}

/// Colours of labels other than normal on paper.
const ON_PAPER: [[f32; 3]; 8] = [
    srgb(0xa6_5210),
    srgb(0x0d_8f64),
    srgb(0x3c_25b7),
    srgb(0xc3_3ae0),
    srgb(0x6b_2a12),
    srgb(0xd8_1e52),
    srgb(0x00_414d),
    srgb(0x7c_1678),
];

/// The same on dark ground, as in the dark theme of the window.
const ON_DARK: [[f32; 3]; 8] = [
    srgb(0xe7_885c),
    srgb(0x4f_d6ae),
    srgb(0xa3_6cf7),
    srgb(0xfe_b1d8),
    srgb(0x2f_9a3f),
    srgb(0xf2_3a6e),
    srgb(0xdf_f5e4),
    srgb(0x9a_8a00),
];

impl LabelMark {
    /// The mark of every subject of a study. Labels other than normal are counted in alphabetical order whatever their
    /// case, so that the order of subjects changes no mark: those of abnormal subjects first, and from the second mark on
    /// those of neither, for the first is the cross of what is ill.
    pub fn of_subjects(study: &Study) -> Vec<Self> {
        let read = study.all().map(|subject| &subject.label);
        // Shapes go by all labels of the study: they stay the same while it is read.
        let labels = read.chain(study.unread.iter().map(|unread| &unread.label));
        let labels: Vec<_> = labels
            .map(|label| {
                (
                    label.as_deref(),
                    study.label_classes.class_of(label.as_deref()),
                )
            })
            .collect();
        let mut marks = Self::of_study(&labels);
        marks.truncate(study.count());
        marks
    }

    /// The same of labels with their classes.
    pub fn of_study<'a>(labels: &[(Option<&'a str>, LabelClass)]) -> Vec<Self> {
        let other = |&(label, class): &(Option<&'a str>, LabelClass)| {
            let label = label.filter(|_| class != LabelClass::Normal)?;
            Some((class != LabelClass::Abnormal, label.to_lowercase()))
        };
        let mut known: Vec<(bool, String)> = labels.iter().filter_map(other).collect();
        known.sort();
        known.dedup();
        let first = usize::from(known.first().is_some_and(|(neither, _)| *neither));
        let mark = |subject: &(Option<&'a str>, LabelClass)| match (subject.1, other(subject)) {
            (LabelClass::Normal, _) => Self::Normal,
            (_, Some(label)) => {
                let place = first + known.binary_search(&label).unwrap_or_default();
                Self::Label(u8::try_from(place).unwrap_or(u8::MAX))
            }
            (_, None) => Self::Unlabelled,
        };
        labels.iter().map(mark).collect()
    }

    /// Its name in a legend: the label as a subject has it; normal labels share a mark.
    pub fn name(self, label: Option<&str>) -> String {
        match (self, label) {
            (Self::Normal, _) => "normal".to_owned(),
            (Self::Label(_), Some(label)) => label.to_owned(),
            (Self::Label(_) | Self::Unlabelled, _) => "no label".to_owned(),
        }
    }

    /// Its shape.
    pub fn shape(self) -> MarkShape {
        // Corners on a circle, the first one up.
        let regular = |count: usize, turn: f32, reach: f32| {
            let corner = |index: usize| {
                let angle = std::f32::consts::TAU * (index as f32 / count as f32 + turn);
                [reach * angle.sin(), -reach * angle.cos()]
            };
            MarkShape::Polygons(vec![(0..count).map(corner).collect()])
        };
        let arms = |ends: &[[f32; 2]]| {
            let arm = |&[x, y]: &[f32; 2]| [[-x, -y], [x, y]];
            MarkShape::Arms(ends.iter().map(arm).collect())
        };
        let place = match self {
            Self::Normal => return MarkShape::Disc,
            Self::Unlabelled => return MarkShape::Square(0.9),
            Self::Label(place) => place,
        };
        match place % 8 {
            0 => arms(&[[0.85, 0.85], [0.85, -0.85]]),
            1 => regular(3, 0.0, 1.25),
            2 => arms(&[[1.1, 0.0], [0.0, 1.1]]),
            3 => regular(3, 0.5, 1.25),
            4 => regular(4, 0.0, 1.2),
            5 => {
                let arm = |turn: f32| [1.1 * turn.sin(), 1.1 * turn.cos()];
                let third = std::f32::consts::FRAC_PI_3;
                arms(&[arm(0.0), arm(third), arm(2.0 * third)])
            }
            6 => regular(5, 0.0, 1.1),
            // An hourglass.
            _ => MarkShape::Polygons(
                [-1.0, 1.0]
                    .map(|side| vec![[0.0, 0.0], [-1.0, side], [1.0, side]])
                    .into(),
            ),
        }
    }

    /// Its colour in a figure of a theme.
    pub fn colour_on(self, theme: &PictureTheme) -> [f32; 3] {
        match self {
            _ if !theme.is_dark() => self.on_paper(),
            Self::Normal => srgb(0x5a_b0f2),
            Self::Unlabelled => srgb(0x8a_94a1),
            Self::Label(place) => ON_DARK[label_colour_of(place, ON_DARK.len())],
        }
    }

    /// Its colour on paper.
    pub fn on_paper(self) -> [f32; 3] {
        match self {
            Self::Normal => srgb(0x1e_6baf),
            Self::Unlabelled => srgb(0x60_6975),
            Self::Label(place) => ON_PAPER[label_colour_of(place, ON_PAPER.len())],
        }
    }
}

/// Which of `count` colours a label has. Past the last one the shapes come again, each in another colour.
pub fn label_colour_of(place: u8, count: usize) -> usize {
    let place = usize::from(place);
    (place + place / count) % count
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_label_of_a_study_has_its_own_mark_whatever_the_order_of_subjects() {
        let study = [
            (Some("MINF"), LabelClass::Abnormal),
            (Some("DCM"), LabelClass::Abnormal),
            (Some("NOR"), LabelClass::Normal),
            (Some("RV"), LabelClass::Neither),
            (Some("dcm"), LabelClass::Abnormal),
            (None, LabelClass::Neither),
        ];
        let marks = LabelMark::of_study(&study);
        let [dcm, minf, rv] = [0, 1, 2].map(LabelMark::Label);
        let wanted = [minf, dcm, LabelMark::Normal, rv, dcm, LabelMark::Unlabelled];
        assert_eq!(marks, wanted);
        let turned: Vec<_> = study.into_iter().rev().collect();
        let mut again = LabelMark::of_study(&turned);
        again.reverse();
        assert_eq!(again, marks);
    }

    #[test]
    fn the_cross_is_that_of_the_ill_whatever_other_labels_are_called() {
        let abnormal = (Some("abnormal"), LabelClass::Abnormal);
        let other = (Some("a follow-up"), LabelClass::Neither);
        let crossed = LabelMark::Label(0);
        assert_eq!(LabelMark::of_study(&[abnormal, other])[0], crossed);
        assert_ne!(LabelMark::of_study(&[other])[0], crossed);
    }

    #[test]
    fn shapes_of_eight_labels_differ_from_each_other_and_from_the_rest() {
        let labels = (0..8).map(LabelMark::Label);
        let marks = labels.chain([LabelMark::Normal, LabelMark::Unlabelled]);
        let shapes: Vec<MarkShape> = marks.map(LabelMark::shape).collect();
        for (index, shape) in shapes.iter().enumerate() {
            assert!(!shapes[index + 1..].contains(shape), "{shape:?}");
        }
        assert_ne!(
            LabelMark::Label(0).on_paper(),
            LabelMark::Label(8).on_paper()
        );
    }
}

//! Poses between the frames of motions: which were computed, and what is said of them on screen.

use std::borrow::Cow;
use std::sync::Arc;

use crate::analysis::geodesics::{GeodesicParams, GeodesicPath};
use crate::mesh::Point3;
use crate::study::Subject;

use crate::document::document::Document;
use crate::document::play::is_between;

/// Motions whose interpolated poses are kept: the subjects side by side, and those looked at before.
const MAX_MOTIONS: usize = 6;

/// Number of intervals with a path: every frame leads to the next, and the last to the first where
/// there are more than two.
pub fn interval_count(subject: &Subject) -> usize {
    match subject.sequence.frame_count() {
        0 | 1 => 0,
        2 => 1,
        frames => frames,
    }
}

/// The poses between the frames of one motion, as far as they were computed.
#[derive(Clone, Debug)]
pub struct InterpolatedMotion {
    subject: Arc<Subject>,
    params: GeodesicParams,
    paths: Vec<Option<Arc<GeodesicPath>>>,
}

impl InterpolatedMotion {
    /// Whether they are those of this motion with these settings.
    pub fn are_of(&self, subject: &Arc<Subject>, params: &GeodesicParams) -> bool {
        Arc::ptr_eq(&self.subject, subject) && self.params == *params
    }

    /// The metric whose geodesics they lie on, as it is written within a sentence.
    fn metric_name(&self) -> String {
        self.params.metric.kind.words().name.to_lowercase()
    }

    /// The path of an interval, ends included; `None` while it is not computed.
    pub fn path(&self, interval: usize) -> Option<&GeodesicPath> {
        self.paths.get(interval)?.as_deref()
    }

    /// The poses within every interval; empty where they are not computed.
    pub fn inner_poses(&self) -> Vec<&[Vec<Point3>]> {
        (0..self.paths.len())
            .map(|interval| self.path(interval).map_or(&[][..], inner))
            .collect()
    }

    /// Whether every interval was computed.
    pub fn complete(&self) -> bool {
        (0..self.paths.len()).all(|interval| self.path(interval).is_some())
    }

    /// Positions in the cycle of all interpolated poses, ascending.
    pub fn positions(&self) -> Vec<f64> {
        let of_interval = |interval: usize| {
            let count = self.path(interval).map_or(0, |path| inner(path).len());
            (1..=count).map(move |step| interval as f64 + step as f64 / (count + 1) as f64)
        };
        (0..self.paths.len()).flat_map(of_interval).collect()
    }

    /// Vertices of all poses that were computed, to bound memory by.
    pub fn vertices(&self) -> usize {
        let poses = self.inner_poses();
        poses
            .iter()
            .flat_map(|poses| poses.iter())
            .map(Vec::len)
            .sum()
    }
}

fn inner(path: &GeodesicPath) -> &[Vec<Point3>] {
    match path.poses.len() {
        0..=2 => &[],
        count => &path.poses[1..count - 1],
    }
}

/// Interpolated poses of the motions looked at lately, put together from the paths that are known: the same value as long as
/// these stay, so that a subject is prepared once.
#[derive(Clone, Debug, Default)]
pub struct MotionMemo {
    /// The one used last stands last.
    motions: Vec<Arc<InterpolatedMotion>>,
}

impl MotionMemo {
    /// The interpolated poses of a motion with these settings, if any interval of it was computed.
    pub fn get(
        &self,
        subject: &Arc<Subject>,
        params: &GeodesicParams,
    ) -> Option<&Arc<InterpolatedMotion>> {
        self.motions
            .iter()
            .find(|motion| motion.are_of(subject, params))
    }

    /// Takes in the paths of intervals from `first` on. Says whether anything is new.
    pub fn put(
        &mut self,
        subject: &Arc<Subject>,
        params: &GeodesicParams,
        first: usize,
        paths: &[Arc<GeodesicPath>],
    ) -> bool {
        let known = self.get(subject, params);
        let mut motion = known.map_or_else(
            || InterpolatedMotion {
                subject: Arc::clone(subject),
                params: *params,
                paths: vec![None; interval_count(subject)],
            },
            |motion| InterpolatedMotion::clone(motion),
        );
        let mut news = false;
        for (slot, path) in motion.paths.iter_mut().skip(first).zip(paths) {
            if !slot.as_ref().is_some_and(|known| Arc::ptr_eq(known, path)) {
                *slot = Some(Arc::clone(path));
                news = true;
            }
        }
        if news {
            self.motions.retain(|other| !other.are_of(subject, params));
            self.motions.push(Arc::new(motion));
            if self.motions.len() > MAX_MOTIONS {
                self.motions.remove(0);
            }
        }
        news
    }
}

/// Settings of the interpolated poses that the document asks for; `None` where they are switched off.
pub fn geodesic_params(document: &Document) -> Option<GeodesicParams> {
    (document.interpolated_poses > 0).then(|| GeodesicParams {
        metric: document.map.distances.metric.of_paths(),
        interpolated_poses: document.interpolated_poses,
        ..GeodesicParams::default()
    })
}

/// What is said of a pose between two frames.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct BetweenWords {
    /// `interpolated` or `linear interpolation`; `None` on a frame.
    pub short: Option<&'static str>,
    /// What `short` says, by which metric, and what is wrong with the pose: the most important first.
    pub badge: Option<Cow<'static, str>>,
    /// How it was found, and what is wrong with it; empty on a frame.
    pub note: String,
}

/// Words for the pose at a position. `interpolated_poses` are those of the motion, if there are any;
/// `pending` says why there are none, and is empty where nothing is known.
pub fn between_words(
    interpolated_poses: Option<&InterpolatedMotion>,
    position: f64,
    pending: &str,
) -> BetweenWords {
    if !is_between(position) {
        return BetweenWords::default();
    }
    let path = interpolated_poses
        .and_then(|motion| Some((motion, motion.path(position.floor() as usize)?)));
    let Some((motion, path)) = path else {
        let mut note =
            "Every vertex moves along a straight line from one frame to the next".to_owned();
        if !pending.is_empty() {
            note.push_str(". ");
            note.push_str(pending);
        }
        return BetweenWords {
            short: Some("linear interpolation"),
            badge: Some("linear interpolation".into()),
            note,
        };
    };
    let mut note = match inner(path).len() {
        1 => "1 interpolated pose between these frames".to_owned(),
        count => format!("{count} interpolated poses between these frames"),
    };
    let metric = motion.metric_name();
    note.push_str(&format!(", on the geodesic of the {metric} metric"));
    let mut badge = vec!["interpolated".to_owned(), format!("{metric} metric")];
    match path.self_intersections {
        0 => {}
        1 => note.push_str(". 1 pair of faces intersects"),
        pairs => note.push_str(&format!(". {pairs} pairs of faces intersect")),
    }
    if path.self_intersections > 0 {
        badge.push("faces intersect".to_owned());
    }
    if path.fell_back {
        note.push_str(
            ". No path of less energy than the straight line was found, and that line is shown",
        );
        badge.push("straight line".to_owned());
    } else if path.converged {
        note.push_str(". The optimisation converged");
    } else {
        note.push_str(". The optimisation ended before it reached its tolerance");
        badge.push("not converged".to_owned());
    }
    BetweenWords {
        short: Some("interpolated"),
        badge: Some(badge.join(" · ").into()),
        note,
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::analysis::metrics::{MetricKind, MetricParams};
    use crate::document::testing::subject_with_frames;

    /// Paths with `count` poses within every interval, on the straight line.
    pub fn straight_paths(subject: &Subject, count: usize) -> Vec<Arc<GeodesicPath>> {
        let frames = subject.sequence.frame_count();
        let path = |interval: usize| {
            let start = subject.sequence.pose(interval).unwrap();
            let end = subject.sequence.pose((interval + 1) % frames).unwrap();
            let pose = |step: usize| {
                let share = step as f64 / (count + 1) as f64;
                let pairs = start.iter().zip(&end);
                pairs.map(|(a, b)| a + share * (b - a)).collect()
            };
            Arc::new(GeodesicPath {
                poses: (0..count + 2).map(pose).collect(),
                energy_linear: 2.0,
                energy: 1.0,
                step_lengths: vec![1.0; count + 1],
                iterations: 3,
                self_intersections: 0,
                converged: true,
                fell_back: false,
                stopped: false,
            })
        };
        (0..interval_count(subject)).map(path).collect()
    }

    #[test]
    fn the_interval_on_screen_comes_first_and_the_others_after() {
        let subject = Arc::new(subject_with_frames("a", 4));
        let params = GeodesicParams::default();
        let mut store = MotionMemo::default();
        let all = straight_paths(&subject, 3);
        assert!(store.put(&subject, &params, 2, &all[2..3]));
        let motion = store.get(&subject, &params).unwrap();
        assert!(!motion.complete());
        assert_eq!(motion.positions(), [2.25, 2.5, 2.75]);
        assert_eq!(motion.inner_poses().map_lengths(), [0, 0, 3, 0]);
        assert!(store.put(&subject, &params, 0, &all));
        assert!(!store.put(&subject, &params, 0, &all), "nothing is new");
        let motion = store.get(&subject, &params).unwrap();
        assert!(motion.complete());
        assert_eq!(motion.positions().len(), 12);
        let other = GeodesicParams {
            interpolated_poses: 7,
            ..params
        };
        assert!(store.get(&subject, &other).is_none());
    }

    trait Lengths {
        fn map_lengths(&self) -> Vec<usize>;
    }

    impl Lengths for Vec<&[Vec<Point3>]> {
        fn map_lengths(&self) -> Vec<usize> {
            self.iter().map(|poses| poses.len()).collect()
        }
    }

    #[test]
    fn only_the_beats_of_late_are_kept() {
        let mut store = MotionMemo::default();
        let params = GeodesicParams::default();
        let subjects: Vec<_> = (0..MAX_MOTIONS + 2)
            .map(|_| Arc::new(subject_with_frames("a", 3)))
            .collect();
        for subject in &subjects {
            store.put(subject, &params, 0, &straight_paths(subject, 1));
        }
        let kept = subjects.iter().filter(|s| store.get(s, &params).is_some());
        assert_eq!(kept.count(), MAX_MOTIONS);
        assert!(store.get(&subjects[0], &params).is_none());
    }

    #[test]
    fn a_frame_says_nothing_and_a_crossing_is_not_hidden() {
        let subject = Arc::new(subject_with_frames("a", 3));
        let params = GeodesicParams::default();
        let mut store = MotionMemo::default();
        let mut paths = straight_paths(&subject, 3);
        paths[1] = Arc::new(GeodesicPath {
            self_intersections: 2,
            ..GeodesicPath::clone(&paths[1])
        });
        store.put(&subject, &params, 0, &paths);
        let motion = store.get(&subject, &params).unwrap();
        assert_eq!(
            between_words(Some(motion), 1.0, ""),
            BetweenWords::default()
        );
        let words = between_words(Some(motion), 0.25, "");
        let by_metric = "interpolated · isometric metric";
        assert_eq!(words.badge.as_deref(), Some(by_metric));
        assert!(words.note.ends_with("The optimisation converged"));
        assert!(
            words
                .note
                .starts_with("3 interpolated poses between these frames")
        );
        let words = between_words(Some(motion), 1.5, "");
        assert!(
            words.note.contains("2 pairs of faces intersect"),
            "{}",
            words.note
        );
        let wanted = format!("{by_metric} · faces intersect");
        assert_eq!(words.badge, Some(wanted.into()));
        let words = between_words(None, 1.5, "Interpolated poses are off");
        assert_eq!(words.badge.as_deref(), Some("linear interpolation"));
        assert!(words.note.ends_with("are off"));
    }

    #[test]
    fn a_path_that_did_not_converge_says_so_with_its_metric() {
        let subject = Arc::new(subject_with_frames("a", 3));
        let params = GeodesicParams {
            metric: MetricParams::of(MetricKind::QuasiConformal),
            ..GeodesicParams::default()
        };
        let mut store = MotionMemo::default();
        let mut paths = straight_paths(&subject, 1);
        for (place, fell_back) in [false, true].into_iter().enumerate() {
            paths[place] = Arc::new(GeodesicPath {
                converged: false,
                fell_back,
                ..GeodesicPath::clone(&paths[place])
            });
        }
        store.put(&subject, &params, 0, &paths);
        let motion = store.get(&subject, &params).unwrap();
        let badge = |position| between_words(Some(motion), position, "").badge.unwrap();
        let metric = "interpolated · quasi-conformal metric";
        assert_eq!(badge(0.5), format!("{metric} · not converged"));
        assert_eq!(badge(1.5), format!("{metric} · straight line"));
        assert_eq!(badge(2.5), metric);
    }
}

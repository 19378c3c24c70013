//! What a figure says beside the heart: name, moment, numbers, colours, scale, orientation.

use crate::analysis::measures::SubjectMeasures;
use crate::picture::axes::CubeFace;
use crate::picture::frame_words::{is_between, position_words, share_words};
use crate::picture::legend::ColourLegend;
use crate::report::{Column, SubjectRow};
use crate::study::Subject;
use crate::units::LengthUnit;

/// The subject and moment that a figure shows.
#[derive(Clone, Copy, Debug)]
pub struct FigureSubject<'a> {
    /// The heart.
    pub subject: &'a Subject,
    /// Its measures, if they could be made.
    pub measures: Option<&'a SubjectMeasures>,
    /// The frame.
    pub frame: usize,
}

/// All text and marks of a figure, ready to be laid out.
#[derive(Clone, Debug, PartialEq)]
pub struct FigureContent {
    /// The pseudonym.
    pub title: String,
    /// Label, frame and phase.
    pub moment: String,
    /// Ejection fraction; empty where no volume can be told.
    pub ejection_fraction: String,
    /// Volumes at end-diastole and end-systole; empty where none can be told.
    pub volumes: String,
    /// The colour bars, of surfaces before that of atoms; none where colours are tissue.
    pub legends: Vec<ColourLegend>,
    /// What lengths are counted in, for the scale bar.
    pub unit: LengthUnit,
    /// Sides of the orientation cube; none where names are not known.
    pub cube: Vec<CubeFace>,
    /// Program, version, and what the picture is not for.
    pub footer: String,
}

impl FigureContent {
    /// Gathers what is known. A subject has a pseudonym; nothing else names a person.
    /// `position` is the place in the cycle, counted in frames.
    pub fn of(
        shown: FigureSubject<'_>,
        position: f64,
        legends: Vec<ColourLegend>,
        cube: Vec<CubeFace>,
    ) -> Self {
        let unit = shown.subject.unit;
        let row = shown
            .measures
            .map(|measured| SubjectRow::new(String::new(), None, measured));
        let named = |row: &SubjectRow, column: Column<SubjectRow>| {
            format!("{} {}", column.heading, column.shown(row))
        };
        let ejection_fraction =
            (row.as_ref())
                .filter(|row| row.ef.is_some())
                .map_or_else(String::new, |row| {
                    format!(
                        "{} {}",
                        named(row, SubjectRow::EF),
                        SubjectRow::EF.unit.symbol(unit)
                    )
                });
        let volumes = (row.as_ref())
            .filter(|row| row.edv.is_some() && row.esv.is_some())
            .map_or_else(String::new, |row| {
                let [edv, esv] =
                    [SubjectRow::EDV, SubjectRow::ESV].map(|column| named(row, column));
                format!("{edv} · {esv} {}", unit.volume_symbol())
            });
        Self {
            title: shown.subject.id.clone(),
            moment: moment(shown, position),
            ejection_fraction,
            volumes,
            legends,
            unit: shown.subject.unit,
            cube,
            footer: format!(
                "Cardiomorph {} · research use, not for diagnosis",
                env!("CARGO_PKG_VERSION")
            ),
        }
    }
}

/// `MINF · frame 3 (0–7) · ES · 312 ms · 37 % R-R`; `MINF · between frames 3 and 4 · 330 ms · 40 % R-R`.
fn moment(shown: FigureSubject<'_>, position: f64) -> String {
    let FigureSubject {
        subject,
        measures,
        frame,
    } = shown;
    let count = subject.sequence.frame_count();
    let mut parts: Vec<String> = subject.label.iter().cloned().collect();
    if count > 1 {
        parts.push(position_words(position, count));
    }
    let diastole = measures
        .and_then(|m| m.end_diastole)
        .or(subject.end_diastole);
    let systole = measures.and_then(|m| m.end_systole).or(subject.end_systole);
    if is_between(position) {
        // A phase is that of a frame.
    } else if diastole == Some(frame) {
        parts.push("ED".to_owned());
    } else if systole == Some(frame) {
        parts.push("ES".to_owned());
    }
    if let Some(time) = subject.timing.time_at(position, count) {
        parts.push(format!("{:.0} ms", 1000.0 * time.0));
    }
    // Two frames are end-diastole and end-systole; their share of the beat is not known.
    if subject.timing.rr.is_some() || count > 2 {
        let share = subject.timing.phase(position, count);
        parts.push(share_words(share, subject.timing.rr.is_some()));
    }
    parts.join(" · ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::measures::PhaseSource;
    use crate::mesh::phantom;
    use crate::study::{CycleTiming, MeshSequence, SurfaceKind, SurfaceSequence};
    use crate::units::Seconds;

    fn subject(frames: usize) -> Subject {
        let meshes = vec![phantom::sphere(1, 20.0); frames];
        let surface = SurfaceSequence::new(SurfaceKind::Cavity, meshes).unwrap();
        let sequence = MeshSequence::new(vec![surface]).unwrap();
        Subject::new("P-041", sequence, LengthUnit::Millimetre)
    }

    fn measures() -> SubjectMeasures {
        SubjectMeasures {
            unit: LengthUnit::Millimetre,
            frames: Vec::new(),
            end_diastole: Some(0),
            end_systole: Some(3),
            phase_source: PhaseSource::VolumeCurve,
            edv: Some(104.2),
            esv: Some(66.4),
            sv: Some(37.8),
            ef: Some(0.3628),
            mass: None,
            notes: Vec::new(),
        }
    }

    #[test]
    fn a_figure_says_who_when_and_how_much() {
        let mut heart = subject(8);
        heart.label = Some("MINF".to_owned());
        heart.timing = CycleTiming {
            frame_times_s: None,
            rr: Some(Seconds(0.8)),
        };
        let measures = measures();
        let shown = FigureSubject {
            subject: &heart,
            measures: Some(&measures),
            frame: 3,
        };
        let content = FigureContent::of(shown, 3.0, Vec::new(), Vec::new());
        assert_eq!(content.title, "P-041");
        assert_eq!(
            content.moment,
            "MINF · frame 3 (0–7) · ES · 300 ms · 38 % R-R"
        );
        assert_eq!(content.ejection_fraction, "EF 36 %");
        assert_eq!(content.volumes, "EDV 104 · ESV 66 ml");
        assert!(content.footer.contains("not for diagnosis"));
    }

    #[test]
    fn a_pose_between_frames_has_no_phase_and_no_share_of_an_unknown_interval() {
        let heart = subject(8);
        let measures = measures();
        let shown = FigureSubject {
            subject: &heart,
            measures: Some(&measures),
            frame: 3,
        };
        let moment = |position| FigureContent::of(shown, position, Vec::new(), Vec::new()).moment;
        assert_eq!(
            moment(3.2),
            "between frames 3 and 4 · 40 % of the cycle by frames"
        );
        assert_eq!(
            moment(3.0),
            "frame 3 (0–7) · ES · 38 % of the cycle by frames"
        );
    }

    #[test]
    fn what_is_not_known_is_not_said() {
        let heart = subject(2);
        let shown = FigureSubject {
            subject: &heart,
            measures: None,
            frame: 0,
        };
        let content = FigureContent::of(shown, 0.0, Vec::new(), Vec::new());
        assert_eq!(content.moment, "frame 0 (0–1)");
        assert_eq!(content.ejection_fraction, "");
        assert_eq!(content.volumes, "");
    }
}

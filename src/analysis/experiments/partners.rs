//! Is the other sequence of the same patient nearer than those of other patients?

use rayon::prelude::*;

use crate::analysis::alignment::comparable_subjects;
use crate::analysis::deformations::{Comparison, DeformationDistances};
use crate::analysis::pose_distances::PoseDistanceParams;
use crate::analysis::transport::CohortTransportParams;
use crate::numeric::median;
use crate::progress::Progress;
use crate::study::Study;

use super::one_motion::one_motion_study;
use super::{ExperimentError, Method, MetricComparisonParams};

/// What is done to motions before they are compared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TransportOption {
    /// What tables call it.
    pub name: &'static str,
    /// Onto what all motions are transported; `None`: compared where they are.
    pub transport: Option<CohortTransportParams>,
    /// Whether all subjects are given the motion of the first one beforehand: what then still tells patients
    /// apart is their shape, which a perfect transport would take away.
    pub one_motion: bool,
}

/// What is compared.
#[derive(Clone, Debug, PartialEq)]
pub struct PartnerParams {
    /// Ways of comparing poses, under each of `transport_options`.
    pub methods: Vec<Method>,
    /// What is done to motions before.
    pub transport_options: Vec<TransportOption>,
    /// Ways of comparing poses that are tried on subjects as they are alone.
    pub untransported: Vec<Method>,
}

impl PartnerParams {
    /// All kinds and forms, Procrustes of poses and the quasi-conformal metric without smoothing; as they are, transported
    /// onto the mean along geodesics or linear interpolation as given, and with one motion for all. As they are
    /// also what smoothing, area weights and λ bring, and deformations with and without shape.
    pub fn all_metrics(transport: CohortTransportParams) -> Self {
        // Without poses in between the path is the straight line: what geodesics add shows against it.
        let straight = CohortTransportParams {
            interpolated_poses: 0,
            ..transport
        };
        let option = |name, transport, one_motion| TransportOption {
            name,
            transport,
            one_motion,
        };
        let smoothing = PoseDistanceParams::default().smoothing;
        let printed = Method::printed();
        let smoothed = Method {
            name: "printed, raw corners, unweighted",
            distances: PoseDistanceParams {
                smoothing,
                ..printed.distances
            },
            ..printed
        };
        let all = MetricComparisonParams::all_metrics(None).methods;
        // Deformations are transported anyway: they stand once.
        let (mut methods, parts): (Vec<Method>, Vec<Method>) = all
            .into_iter()
            .partition(|method| method.comparison == Comparison::Poses);
        methods.push(Method::quasi_conformal_unsmoothed());
        Self {
            methods,
            transport_options: vec![
                option("none", None, false),
                option("geodesics", Some(transport), false),
                option("linear interpolation", Some(straight), false),
                option("same motion for all, none", None, true),
                option("same motion for all, geodesics", Some(transport), true),
            ],
            untransported: [
                smoothed,
                Method {
                    name: "printed, raw corners, unweighted, not smoothed",
                    ..printed
                },
            ]
            .into_iter()
            .chain(parts)
            .collect(),
        }
    }
}

/// Ranks of partners by one method. A pair is a sequence with one other of the same patient, in this order;
/// its others are the sequences of other patients.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PartnerRanks {
    /// Pairs that were ranked.
    pub pairs: usize,
    /// Pairs of which the partner is nearer than the median of the others.
    pub nearer_than_median: usize,
    /// Pairs of which the partner is nearer than every other.
    pub nearest: usize,
    /// Mean of 1 + how many others are as near as the partner or nearer.
    pub mean_rank: f64,
    /// How many would be nearest in a random order, on average.
    pub nearest_by_chance: f64,
    /// The mean rank in a random order, on average.
    pub mean_rank_by_chance: f64,
    /// Mean distance of two sequences, whosever they are, in the unit of the pose distances.
    pub mean_distance: f64,
}

/// One method after one transport.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PartnerRow {
    /// What the method is called.
    pub method: &'static str,
    /// What was done before.
    pub transport: &'static str,
    /// What came out.
    pub ranks: PartnerRanks,
}

/// By transport, then by method.
#[derive(Clone, Debug, PartialEq)]
pub struct PartnerStudy {
    /// The settings with which it was run.
    pub params: PartnerParams,
    /// The table.
    pub rows: Vec<PartnerRow>,
}

/// What says whose sequence it is: the id up to its last `_`, as `P7` of `P7_rest` and `P7_stress`;
/// `None` where nothing stands before or there is none. Labels say what a subject has, not whose it is.
pub fn patient_of(id: &str) -> Option<&str> {
    let (patient, _) = id.rsplit_once('_')?;
    (!patient.is_empty()).then_some(patient)
}

/// Ranks partners by the distance of whole deformations ([`crate::analysis::deformations::deformation_distances`]). Ties count against the
/// partner. The same bits for any number of threads.
///
#[doc = include_str!("PARTNERS.md")]
///
/// # Errors
/// If no sequence has a partner or all are of one patient, settings are out of range, it was stopped, or
/// a method has no answer.
pub fn partner_study(
    study: &Study,
    params: &PartnerParams,
    progress: &Progress,
) -> Result<PartnerStudy, ExperimentError> {
    let (members, _) = comparable_subjects(study);
    let members: Vec<usize> = members.iter().map(|member| member.index).collect();
    refuse_without_partners(&ids_of(study, &members))?;
    let moved_alike = one_motion_study(study)?;
    let own = TransportOption {
        name: "none",
        transport: None,
        one_motion: false,
    };
    let mut tasks: Vec<(TransportOption, Method)> = Vec::new();
    for option in &params.transport_options {
        tasks.extend(params.methods.iter().map(|method| (*option, *method)));
    }
    tasks.extend(params.untransported.iter().map(|method| (own, *method)));
    progress.expect_steps(tasks.len());
    let rows = tasks
        .par_iter()
        .map(|(option, method)| {
            progress.check()?;
            let study = if option.one_motion {
                &moved_alike
            } else {
                study
            };
            let mut method = *method;
            // Methods with a transport of their own keep it.
            method.distances.transport = option.transport.or(method.distances.transport);
            let whole = method.whole(study, &progress.within())?;
            let ids = ids_of(study, &whole.subjects);
            refuse_without_partners(&ids)?;
            progress.step()?;
            Ok(PartnerRow {
                method: method.name,
                transport: option.name,
                ranks: ranked(&ids, &whole),
            })
        })
        .collect::<Result<_, ExperimentError>>()?;
    Ok(PartnerStudy {
        params: params.clone(),
        rows,
    })
}

fn ids_of<'a>(study: &'a Study, subjects: &[usize]) -> Vec<&'a str> {
    (subjects.iter())
        .map(|&subject| study.subjects[subject].id.as_str())
        .collect()
}

/// A sequence of an id without a patient is an other to all.
fn are_partners(a: &str, b: &str) -> bool {
    patient_of(a).is_some_and(|patient| patient_of(b) == Some(patient))
}

fn refuse_without_partners(ids: &[&str]) -> Result<(), ExperimentError> {
    let sequences = ids.len();
    let mut with_partner = (ids.iter().enumerate())
        // Being partners is mutual, so that the later ones are enough.
        .filter(|(i, id)| (ids[i + 1..].iter()).any(|other| are_partners(id, other)));
    let Some((_, id)) = with_partner.next() else {
        return Err(ExperimentError::NoPartners { sequences });
    };
    if ids.iter().all(|other| are_partners(id, other)) {
        return Err(ExperimentError::OnePatient {
            sequences,
            patient: patient_of(id).unwrap_or_default().to_owned(),
        });
    }
    Ok(())
}

fn ranked(ids: &[&str], whole: &DeformationDistances) -> PartnerRanks {
    let mut found = PartnerRanks::default();
    let (mut ranks, mut ranks_by_chance) = (0.0, 0.0);
    for (i, id) in ids.iter().enumerate() {
        // Other sequences of the same patient are no competitors.
        let (partners, others): (Vec<usize>, Vec<usize>) = (0..ids.len())
            .filter(|&j| j != i)
            .partition(|&j| are_partners(id, ids[j]));
        let mut others: Vec<f64> = (others.into_iter())
            .map(|j| whole.distances.get(i, j))
            .collect();
        others.sort_by(f64::total_cmp);
        let count = others.len() as f64;
        let middle = median(others.clone()).unwrap_or(0.0);
        for distance in partners.into_iter().map(|j| whole.distances.get(i, j)) {
            // Ties count against the partner, so that distances that are all equal give the last rank.
            let as_near = others.partition_point(|other| *other <= distance);
            found.pairs += 1;
            found.nearest += usize::from(as_near == 0);
            found.nearer_than_median += usize::from(distance < middle);
            // One of count + 1 places, all equally likely.
            found.nearest_by_chance += 1.0 / (count + 1.0);
            ranks += 1.0 + as_near as f64;
            // The mean of the places 1 to count + 1.
            ranks_by_chance += 1.0 + 0.5 * count;
        }
    }
    found.mean_rank = ranks / found.pairs.max(1) as f64;
    found.mean_rank_by_chance = ranks_by_chance / found.pairs.max(1) as f64;
    let distances = (0..ids.len()).flat_map(|i| (0..i).map(move |j| whole.distances.get(i, j)));
    let count = ids.len() * ids.len().saturating_sub(1) / 2;
    found.mean_distance = distances.sum::<f64>() / count.max(1) as f64;
    found
}

#[cfg(test)]
mod tests;

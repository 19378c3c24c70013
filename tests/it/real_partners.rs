//! Two sequences of one patient, at rest and under stress, are near each other.

use cardiomorph::analysis::experiments::{PartnerParams, partner_study};
use cardiomorph::analysis::transport::CohortTransportParams;
use cardiomorph::progress::Progress;

use crate::shared::{opened, shared_data};

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn rest_and_stress_of_one_patient_are_nearer_than_most_others_by_the_defaults() {
    let folder = shared_data("gated_spect/meshes");
    let progress = Progress::default();
    let study = opened(folder);
    let all = PartnerParams::all_metrics(CohortTransportParams::default());
    let params = PartnerParams {
        methods: all.methods[..1].to_vec(),
        transport_options: all.transport_options[..2].to_vec(),
        untransported: Vec::new(),
    };
    let found = partner_study(&study, &params, &progress).unwrap();
    for row in &found.rows {
        println!(
            "{}, transfer {}: {:?}",
            row.method, row.transport, row.ranks
        );
        assert_eq!(row.ranks.pairs, 20);
    }
    let [own, transported] = [found.rows[0].ranks, found.rows[1].ranks];
    assert!(own.nearer_than_median >= 18, "{own:?}");
    assert!(own.nearest >= 9, "{own:?}");
    assert!(own.mean_rank < 2.0, "{own:?}");
    // Motion alone tells a patient less surely, but by far more than chance.
    assert!(
        transported.nearer_than_median >= 14 && transported.nearest >= 4,
        "{transported:?}"
    );
}

//! What a distance is made of.

use super::*;

#[test]
fn shares_are_what_a_distance_loses_without_the_part() {
    let a = bowl();
    let b = bent(a.vertices(), 0.1, 2.0);
    let default = MetricParams::default();
    for params in all_params(default.corners, default.area_weights, default.lambda) {
        let energy = |params| norms(a.faces(), params, a.vertices(), &b).energy();
        let whole = energy(params);
        let metric = Metric::new(a.faces(), params.check().unwrap());
        let [pose, other] = [a.vertices(), &b].map(|points| metric.prepare(points).unwrap());
        let shares = (metric.shares(&pose, &other, &mut PairScratch::default())).unwrap();
        let without_regulariser = energy(MetricParams {
            lambda: 0.0,
            ..params
        });
        assert!(
            near(1.0 - shares.displacement, without_regulariser / whole, 1e-9),
            "{params:?}"
        );
        if params.form == Form::Additive {
            let without_curvature = energy(MetricParams { mu: 0.0, ..params });
            assert!(
                near(1.0 - shares.curvature, without_curvature / whole, 1e-9),
                "{params:?}"
            );
        }
        assert!(near(
            shares.own + shares.curvature + shares.displacement,
            1.0,
            1e-12
        ));
        assert_eq!(
            metric.shares(&pose, &pose, &mut PairScratch::default()),
            None
        );
    }
}

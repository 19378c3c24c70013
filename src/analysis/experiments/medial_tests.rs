//! Medial surfaces with and without a patch: known answers without noise, laws, stop, refusals.

use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

use super::noise::coordinate_variance;
use super::*;
use crate::progress::{Progress, Stopped};

fn coarse() -> SheetParams {
    SheetParams {
        rings: 15,
        ..SheetParams::default()
    }
}

fn small() -> MedialNoiseParams {
    MedialNoiseParams {
        sheets: coarse(),
        per_class: 6,
        families: vec![NoiseFamily::Gaussian],
        percents: vec![2.5, 2000.0],
        redraws: 2,
        restarts: 10,
        ..MedialNoiseParams::default()
    }
}

fn places(shares: &[f64]) -> LocalisationParams {
    LocalisationParams {
        sheets: coarse(),
        shares: vec![Vec::new(), shares.to_vec()],
        percents: Vec::new(),
        per_kind: 2,
        redraws: 2,
        ..LocalisationParams::default()
    }
}

#[test]
fn a_sheet_thickens_everywhere_but_in_patches_of_the_size_asked_for() {
    for share in [0.05, 0.2, 0.6] {
        let sheet = sheet(&SheetParams::default(), &[share], 3, 0).unwrap();
        assert_eq!((sheet.positions.len(), sheet.radii.len()), (8, 8));
        let [patch] = sheet.patches.as_slice() else {
            panic!()
        };
        let areas = sheet_patches::regular_areas(
            &sheet.positions[0],
            sheet.faces.triangles(),
            &sheet.regular,
        );
        let inside: f64 = patch.iter().map(|&atom| areas[atom as usize]).sum();
        let found = inside / areas.iter().sum::<f64>();
        assert!((found - share).abs() < 0.01, "{share} {found}");
        let grown = |atom: usize| sheet.radii[3][atom] / sheet.radii[0][atom];
        let still = patch
            .iter()
            .filter(|&&atom| grown(atom as usize) < 1.0 + 1e-12);
        assert!(still.count() * 3 > patch.len());
        let ill = |atom: usize| patch.binary_search(&(atom as u32)).is_ok();
        let mut well = (0..areas.len()).filter(|&atom| sheet.regular[atom] && !ill(atom));
        assert!(well.all(|atom| grown(atom) > 1.08));
        // Outwards normals, from the inner to the outer side.
        let beat = sheet.beat();
        let frame = &beat.frames[3];
        let middle = sheet.axis.unwrap();
        let half = middle.apex + 0.5 * (middle.base - middle.apex);
        let outwards = (frame.atoms.iter().zip(&frame.normals))
            .filter(|(atom, normal)| normal.dot(&(atom.position - half)) > 0.0);
        assert!(outwards.count() == frame.atoms.len());
        assert!(
            frame
                .atoms
                .iter()
                .all(|a| (a.spokes[0].norm() - 1.0).abs() < 1e-9)
        );
    }
}

#[test]
fn noise_has_the_variance_asked_for_in_positions_and_radii() {
    let clean = sheet(&SheetParams::default(), &[0.1], 5, 1).unwrap();
    let all: Vec<f64> = clean.radii.concat();
    let mean = all.iter().sum::<f64>() / all.len() as f64;
    let of_radii = all.iter().map(|r| (r - mean).powi(2)).sum::<f64>() / all.len() as f64;
    for family in [NoiseFamily::Uniform, NoiseFamily::Gaussian] {
        let mut random = ChaCha8Rng::seed_from_u64(8);
        let noisy = clean.noisy(family, 10.0, &mut random);
        let radii: f64 = (noisy.radii.concat().iter().zip(&all))
            .map(|(a, b)| (a - b).powi(2))
            .sum();
        let ways: f64 = (noisy
            .positions
            .concat()
            .iter()
            .zip(&clean.positions.concat()))
        .map(|(a, b)| (a - b).norm_squared() / 3.0)
        .sum();
        let count = all.len() as f64;
        assert!((radii / count / (0.1 * of_radii) - 1.0).abs() < 0.06);
        let variance = coordinate_variance(&clean.positions[0]);
        assert!((ways / count / (0.1 * variance) - 1.0).abs() < 0.04);
        assert_eq!(noisy.patches, clean.patches);
    }
}

#[test]
fn without_noise_patches_are_told_and_past_all_measure_nothing_is() {
    let params = small();
    let result = noise_medial(&params, &Progress::default()).unwrap();
    assert_eq!(result.cells.len(), 4 * 3);
    let gaussian = Some(NoiseFamily::Gaussian);
    let of = |family, percent| {
        result
            .cell(MedialMethod::PatchFound, family, percent)
            .unwrap()
    };
    let clean = of(None, 0.0);
    assert!(clean.tau > 0.95 && clean.specificity == 1.0, "{clean:?}");
    assert!((0.4..0.6).contains(&clean.baseline), "{clean:?}");
    let low = of(gaussian, 2.5);
    assert!(low.tau > 0.85 && low.published == Some(0.82), "{low:?}");
    assert!(of(gaussian, 2000.0).tau < 0.8);
    for cell in &result.cells {
        let mean = 0.5 * (cell.specificity + cell.sensitivity);
        assert!((cell.tau - mean).abs() < 1e-12, "{cell:?}");
    }
    // By the best match two clusters are never below chance where every sheet has a path.
    let cell = result.cell(MedialMethod::Paths, None, 0.0).unwrap();
    assert!(cell.tau >= 0.5 && cell.baseline > 0.5, "{cell:?}");
    assert!(
        result
            .protocol()
            .iter()
            .any(|line| line.contains("2 redraws"))
    );
}

#[test]
fn without_noise_one_patch_and_two_are_found_where_they_are() {
    for shares in [vec![0.12], vec![0.1, 0.1]] {
        let rows = localisation(&places(&shares), &Progress::default()).unwrap();
        let [none, some] = rows.as_slice() else {
            panic!()
        };
        assert_eq!(
            (none.patches, none.found, none.false_patches),
            (0, None, (0.0, 0.0))
        );
        assert_eq!((some.patches, some.sheets), (shares.len(), 4));
        assert_eq!(
            (some.found, some.false_patches),
            (Some((1.0, 0.0)), (0.0, 0.0))
        );
        assert!(some.dice.unwrap().0 > 0.8, "{some:?}");
        assert!(some.centroid_mm.unwrap().0 < 4.0, "{some:?}");
        assert!(some.segments.unwrap().0 > 0.6, "{some:?}");
        assert!(some.gaps_percent[1].unwrap() < 8.0, "{some:?}");
    }
}

#[test]
fn seeds_tell_all_and_threads_nothing() {
    let params = MedialNoiseParams {
        percents: vec![5.0],
        per_class: 3,
        ..small()
    };
    let places = LocalisationParams {
        percents: vec![5.0],
        redraws: 1,
        ..places(&[0.1])
    };
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        let pool = pool.build().unwrap();
        pool.install(|| {
            let progress = Progress::default();
            (
                noise_medial(&params, &progress),
                localisation(&places, &progress),
            )
        })
    };
    assert_eq!(on(1), on(4));
    let of = |seed| sheet(&coarse(), &[0.1], seed, 2).unwrap();
    assert_eq!(of(1), of(1));
    assert_ne!(of(1).patches, of(2).patches);
}

#[test]
fn a_stopped_study_says_so_and_settings_without_sense_are_refused() {
    let progress = Progress::default();
    progress.stop();
    let stopped = ExperimentError::Stopped(Stopped);
    assert_eq!(noise_medial(&small(), &progress).unwrap_err(), stopped);
    assert_eq!(
        localisation(&places(&[0.1]), &progress).unwrap_err(),
        stopped
    );
    let refused = |params: MedialNoiseParams| {
        noise_medial(&params, &Progress::default())
            .unwrap_err()
            .to_string()
    };
    let none = MedialNoiseParams {
        redraws: 0,
        ..small()
    };
    assert!(refused(none).contains("redraws"));
    let level = MedialNoiseParams {
        percents: vec![f64::NAN],
        ..small()
    };
    assert!(refused(level).contains("NaN"));
    let whole = MedialNoiseParams {
        patch_shares: [0.1, 0.95],
        ..small()
    };
    assert!(refused(whole).contains("0.95"));
    let jitter = SheetParams {
        shape_jitter: 2.0,
        ..coarse()
    };
    let error = sheet(&jitter, &[], 1, 0).unwrap_err();
    assert!(error.to_string().contains("shape jitter"), "{error}");
    let error = sheet(
        &SheetParams {
            rings: 2,
            ..coarse()
        },
        &[],
        1,
        0,
    )
    .unwrap_err();
    assert!(error.to_string().contains("rings"), "{error}");
    assert!(sheet(&coarse(), &[0.0], 1, 0).is_err());
}

#[test]
fn table_4_2_is_as_printed() {
    let of = |family| [1.0, 2.5, 5.0, 10.0].map(|p| published_medial_tau(family, p).unwrap());
    let close = |a: [f64; 4], b: [f64; 4]| a.iter().zip(b).all(|(x, y)| (x - y).abs() < 1e-12);
    assert!(close(of(NoiseFamily::Uniform), [0.886, 0.833, 0.77, 0.643]));
    assert!(close(
        of(NoiseFamily::Gaussian),
        [0.857, 0.82, 0.789, 0.731]
    ));
    assert_eq!(published_medial_tau(NoiseFamily::Poisson, 1.0), None);
    assert_eq!(published_medial_tau(NoiseFamily::Uniform, 3.0), None);
}

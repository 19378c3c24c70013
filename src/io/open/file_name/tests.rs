//! Names of files, usual and odd.

use super::*;
use FrameName::{EndDiastole, EndSystole};
use SurfaceKind::{Cavity, Endocardium, Epicardium, Wall};

/// A whole number as a frame.
fn frame(number: u32) -> FrameName {
    FrameName::Number(FrameNumber::whole(number))
}

fn decimal(text: &str) -> FrameName {
    FrameName::Number(FrameNumber::parse(text).unwrap())
}

fn parts(stem: &str) -> (String, Option<SurfaceKind>, Option<FrameName>) {
    let name = mesh_name(stem);
    (name.case, name.surface, name.frame)
}

#[test]
fn every_naming_scheme_is_understood() {
    for (stem, case, surface, frame) in [
        ("endo_g1", "", Some(Endocardium), Some(frame(1))),
        ("epi_10", "", Some(Epicardium), Some(frame(10))),
        ("lv_endo_007", "", Some(Endocardium), Some(frame(7))),
        ("N01_wall_3", "N01", Some(Wall), Some(frame(3))),
        ("p_12_cavity_frame-04", "p_12", Some(Cavity), Some(frame(4))),
        (
            "subj0062_ED_endo",
            "subj0062",
            Some(Endocardium),
            Some(EndDiastole),
        ),
        (
            "subj0062_ES_epi",
            "subj0062",
            Some(Epicardium),
            Some(EndSystole),
        ),
        ("p01_endo", "p01", Some(Endocardium), None),
        ("frame_03_epi", "", Some(Epicardium), Some(frame(3))),
        (
            "phantom_03_epi",
            "phantom",
            Some(Epicardium),
            Some(frame(3)),
        ),
        ("endo12", "", Some(Endocardium), Some(frame(12))),
        ("LVEndo_5", "", Some(Endocardium), Some(frame(5))),
        ("horse_04", "horse", None, Some(frame(4))),
        ("horse04", "horse", None, Some(frame(4))),
        ("0007", "", None, Some(frame(7))),
        ("LV_ED_mean", "mean", None, Some(EndDiastole)),
        ("torso", "torso", None, None),
    ] {
        assert_eq!(parts(stem), (case.to_owned(), surface, frame), "{stem}");
    }
}

#[test]
fn a_word_for_the_ventricle_is_noticed() {
    assert!(mesh_name("LV_ED_mean").ventricle);
    assert!(mesh_name("endo_3").ventricle);
    assert!(!mesh_name("horse_04").ventricle);
}

#[test]
fn end_diastole_comes_first() {
    assert!(EndDiastole < EndSystole && frame(2) < frame(10));
}

#[test]
fn odd_names_are_no_trouble() {
    for (stem, case, surface, frame) in [
        ("", "", None, None),
        ("_", "", None, None),
        ("___", "", None, None),
        ("é_endo", "é", Some(Endocardium), None),
        // More digits than a frame number has: a name like any other.
        (
            "99999999999999999999999",
            "99999999999999999999999",
            None,
            None,
        ),
        ("-1", "", None, Some(decimal("-1"))),
    ] {
        assert_eq!(parts(stem), (case.to_owned(), surface, frame), "{stem}");
    }
}

#[test]
fn times_shares_and_totals_are_frames() {
    for (stem, case, shown) in [
        ("endo_0.05", "", "0.05"),
        ("endo_0.05s", "", "0.05 s"),
        ("endo_50ms", "", "0.05 s"),
        ("endo_50 ms", "", "0.05 s"),
        ("p1_endo_t=0.05", "p1", "0.05"),
        ("t0.05_endo", "", "0.05"),
        ("0.05_endo", "", "0.05"),
        ("endo_-0.05", "", "-0.05"),
        ("endo-25pct", "", "25 %"),
        ("endo_25%", "", "25 %"),
        ("p1_endo_25 %", "p1", "25 %"),
        ("endo_phase_25", "", "25"),
        ("endo_2_of_4", "", "2"),
        ("endo_2of4", "", "2"),
        ("endo 2 of 4", "", "2"),
        ("endo (2)", "", "2"),
        ("endo[2]", "", "2"),
        ("endo_frame-02", "", "2"),
        ("endo_5e-02", "", "0.05"),
    ] {
        let name = mesh_name(stem);
        let Some(FrameName::Number(number)) = name.frame else {
            panic!("{stem}: no number");
        };
        assert_eq!(
            (name.case.as_str(), number.to_string().as_str()),
            (case, shown),
            "{stem}"
        );
        assert_eq!(name.surface, Some(Endocardium), "{stem}");
    }
}

#[test]
fn the_right_ventricle_and_other_parts_are_never_the_left() {
    for (stem, structure, case) in [
        ("patient1_RV_ENDOCARDIAL_000", "right ventricle", "patient1"),
        ("patient1_RV_SEPTUM_000", "right ventricle", "patient1"),
        ("patient1_RV_FREEWALL_000", "right ventricle", "patient1"),
        ("patient1_RV_free_wall_000", "free wall", "patient1"),
        ("RVEndo_3", "right ventricle", ""),
        ("rvendo3", "right ventricle", ""),
        ("RV_3", "right ventricle", ""),
        ("endo_RV_3", "right ventricle", ""),
        ("endo_p2_RV_3", "right ventricle", "p2"),
        ("right_endo_3", "right ventricle", ""),
        ("right_ventricle_3", "right ventricle", ""),
        ("right_ventricular_endo_3", "right ventricle", ""),
        ("left_atrium_endo_3", "left atrium", ""),
        ("LA_endo_3", "left atrium", ""),
        ("ra_wall_3", "right atrium", ""),
        ("patient1_MITRAL_VALVE_000", "mitral valve", "patient1"),
        (
            "patient1_THRU_WALL_000",
            "surface through the wall",
            "patient1",
        ),
        ("BiV_epi_0", "both ventricles", ""),
        ("LV_septum_0", "septum", ""),
    ] {
        let name = mesh_name(stem);
        let found = (name.structure, name.case.as_str(), name.ventricle);
        if stem == "LV_septum_0" {
            // A part of the left ventricle's wall has no surface's name, and is no wall of it either.
            assert_eq!(name.surface, None, "{stem}");
        } else {
            assert_eq!(found, (Some(structure), case, false), "{stem}");
        }
    }
}

#[test]
fn initials_and_words_that_hold_other_words_stay_names() {
    for (stem, case, surface, frame) in [
        ("EDWARD_endo_1", "EDWARD", Some(Endocardium), Some(frame(1))),
        ("Endo_epi_1", "Endo", Some(Epicardium), Some(frame(1))),
        ("Endo_endo_1", "Endo", Some(Endocardium), Some(frame(1))),
        ("Wall_endo_1", "Wall", Some(Endocardium), Some(frame(1))),
        ("RV_LV_endo_1", "RV", Some(Endocardium), Some(frame(1))),
        ("RA_LV_endo_1", "RA", Some(Endocardium), Some(frame(1))),
        ("RV1_endo_2", "RV1", Some(Endocardium), Some(frame(2))),
        ("RA_p_endo_2", "RA_p", Some(Endocardium), Some(frame(2))),
        ("ES_ED_endo", "ES", Some(Endocardium), Some(EndDiastole)),
        ("ES_endo_ES", "ES", Some(Endocardium), Some(EndSystole)),
        ("left_endo_1", "", Some(Endocardium), Some(frame(1))),
        (
            "left_ventricle_endo_1",
            "",
            Some(Endocardium),
            Some(frame(1)),
        ),
        (
            "lv_endo_end_systole",
            "",
            Some(Endocardium),
            Some(EndSystole),
        ),
        ("endoED", "", Some(Endocardium), Some(EndDiastole)),
        ("inner_wall_1", "", Some(Endocardium), Some(frame(1))),
        (
            "scar_p1_endo_1",
            "scar_p1",
            Some(Endocardium),
            Some(frame(1)),
        ),
    ] {
        assert_eq!(parts(stem), (case.to_owned(), surface, frame), "{stem}");
        assert_eq!(mesh_name(stem).structure, None, "{stem}");
    }
}

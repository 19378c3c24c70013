//! Names of columns are a promise to scripts: the complete list of every table that a command writes.

use std::path::Path;

use cardiomorph::report::all_tables;

/// `subjects.csv`, and its twin under the name of the first release.
const MEASURES: &str = "subject,label,end_diastole,end_systole,edv,esv,sv,ef,mass_g,volume_unit,phase_source,outside_range,notes";

/// Files with their columns. What stands here is never renamed, removed or moved; new columns go to the end.
const COLUMNS: &[(&str, &str)] = &[
    (
        "frames.csv",
        "subject,frame,endo_volume,epi_volume,volume_unit,wall_volume,endo_area,epi_area,area_unit,time_s",
    ),
    ("subjects.csv", MEASURES),
    ("measures.csv", MEASURES),
    ("distances.csv", "subject,frame"),
    ("poses_mds.csv", "subject,frame,x,y"),
    ("poses_smacof.csv", "subject,frame,x,y"),
    ("poses_isomap.csv", "subject,frame,x,y"),
    (
        "deformations_lle.csv",
        "subject,label,x,y,nearest,distance,deformation,shape,shape_share",
    ),
    (
        "verdicts.csv",
        "subject,label,verdict,probability,assessed,reason,finding,calibrated,alike_normal,alike_abnormal,distance_from_seen,usual_distance,still_share,median_ln_pt,spread_ln_pt,relative_spread,weakest_tenth_ln_pt,well_ln_pt,reach_ln_pt,patch_share,patch_confidence,patch_relative_thickening,patch_compactness,pose_distance,normal_spread_rad,gap_sizes,outside_range,ejection_fraction,edv_index,esv_index,mass_index,mass_to_edv,wall_ed_mm,wall_p95_ed_mm,wall_ratio_ed,wall_es_mm,wall_p95_es_mm,sphericity_ed,sphericity_es,inward_sd,inward_p10,kind,kind_probability,kind_probabilities,reasons,outside_training",
    ),
    ("medial_mds.csv", "subject,step_from,step_to,patch,x,y"),
    (
        "fit.csv",
        "subject,frame,surface,mean_mm,p95_mm,foldovers,volume_ml,mask_volume_ml",
    ),
    (
        "atoms.csv",
        "subject,frame,vertex,x,y,z,r,pt,in_patch,regular,patch",
    ),
    (
        "patches.csv",
        "subject,patch,area_cm2,share,segments,x,y,z,confidence,segment_shares,area,area_unit,atoms,pt,thickening_percent",
    ),
    (
        "segments.csv",
        "subject,segment,name,thickness_ed,thickness_es,length_unit,thickening_percent,pt,patch_share",
    ),
    (
        "patch_segments.csv",
        "subject,patch,segment,name,share_of_patch,share_of_segment",
    ),
    (
        "the file of `medial --out`",
        "vertex,x,y,z,r,s0x,s0y,s0z,s1x,s1y,s1z,nx,ny,nz,end",
    ),
    (
        "the file of `curvature --out`",
        "vertex,gaussian,mean,k1,k2,shape_index,curvedness",
    ),
    (
        "noise.csv",
        "method,family,percent,percent_of,object,tau_percent,standard_error,baseline,published",
    ),
    (
        "transfer.csv",
        "source,target,motion,relative_error,cosine,norm_ratio,flipped_faces,followed",
    ),
    (
        "interpolation.csv",
        "object,motion,energy_over_linear,longest_over_shortest_step,least_volume_ratio,greatest_volume_ratio,midpoint_error,self_intersections",
    ),
    (
        "metrics.csv",
        "noise_percent,method,labelled,copies,nearest_neighbour_percent,nearest_neighbour_standard_error,nearest_neighbour_baseline,linear_rule_percent,linear_rule_standard_error,linear_rule_baseline,plane_rule_percent,plane_rule_standard_error,plane_rule_baseline,tau_percent,tau_standard_error,tau_baseline",
    ),
    (
        "partners.csv",
        "transfer,method,pairs,nearer_than_median,nearest,mean_rank,nearest_by_chance,mean_rank_by_chance,mean_distance",
    ),
    (
        "noise_medial.csv",
        "method,family,percent,tau_percent,standard_error,baseline,specificity_percent,sensitivity_percent,published",
    ),
    (
        "localisation.csv",
        "patches,patch_percent,family,percent,sheets,found_percent,found_percent_standard_error,false_patches,false_patches_standard_error,dice,dice_standard_error,centroid_mm,centroid_mm_standard_error,segments_agreeing_percent,segments_agreeing_percent_standard_error,main_segment_percent,main_segment_percent_standard_error,gap_of_all_percent,gap_of_patch_percent,normal_spread_of_all_rad,normal_spread_of_patch_rad",
    ),
];
/// The table whose further columns are the poses themselves.
const MATRIX: &str = "distances.csv";

fn columns_of(file: &str) -> Vec<&'static str> {
    let found = COLUMNS.iter().find(|(name, _)| *name == file);
    let (_, columns) = found.unwrap_or_else(|| panic!("{file} is not in the list of tables"));
    columns.split(',').collect()
}

/// Whether a file that a command wrote has the columns of the list.
pub fn check(path: &Path) {
    let name = path.file_name().unwrap().to_str().unwrap();
    check_as(path, name);
}

/// The same for a file whose name the caller chose.
pub fn check_as(path: &Path, table: &str) {
    let (mut found, expected) = (super::header(path), columns_of(table));
    if table == MATRIX {
        assert!(
            found.len() > expected.len() && found[2].ends_with(":0"),
            "{found:?}"
        );
        found.truncate(expected.len());
    }
    assert_eq!(found, expected, "{}", path.display());
}

fn check_folder(folder: &Path) -> usize {
    let files = std::fs::read_dir(folder).unwrap();
    let paths = files.map(|entry| entry.unwrap().path());
    let tables: Vec<_> = paths
        .filter(|path| path.extension().is_some_and(|e| e == "csv"))
        .collect();
    tables.iter().for_each(|path| check(path));
    tables.len()
}

#[test]
fn every_table_of_the_dictionary_has_the_columns_of_the_list_and_no_other_table_is_there() {
    let mut listed: Vec<&str> = COLUMNS.iter().map(|(file, _)| *file).collect();
    for table in all_tables() {
        for file in table.files {
            let keys: Vec<&str> = table.columns.iter().map(|column| column.key).collect();
            assert_eq!(keys, columns_of(file), "{file}");
            listed.retain(|name| name != file);
        }
    }
    assert!(listed.is_empty(), "not in the dictionary: {listed:?}");
}

#[test]
fn files_that_commands_write_have_the_columns_of_the_list() {
    let folder = tempfile::tempdir().unwrap();
    let (report, measures) = (folder.path().join("report"), folder.path().join("measures"));
    let demo = super::text(super::demo());
    let run = |arguments: &[&str]| {
        let output = super::cardiomorph(arguments);
        assert_eq!(super::code(&output), 0, "{}", super::said(&output));
    };
    let out = super::text(&report);
    run(&[
        "analyze",
        demo,
        "--out",
        out,
        "--figures",
        "off",
        "--isomap",
        "5",
    ]);
    assert_eq!(check_folder(&report), 14);
    run(&["measure", demo, "--out", super::text(&measures)]);
    assert_eq!(check_folder(&measures), 2);
    let atoms = folder.path().join("one_wall.csv");
    let [endo, epi] = ["endo", "epi"].map(|side| format!("{demo}/N01/{side}_000.ply"));
    run(&[
        "medial",
        "--endo",
        &endo,
        "--epi",
        &epi,
        "--out",
        super::text(&atoms),
    ]);
    check_as(&atoms, "the file of `medial --out`");
    let curvatures = folder.path().join("curvatures.csv");
    run(&["curvature", &endo, "--out", super::text(&curvatures)]);
    check_as(&curvatures, "the file of `curvature --out`");

    let columns = std::fs::read_to_string(report.join("columns.md")).unwrap();
    for (file, keys) in COLUMNS
        .iter()
        .filter(|(file, _)| report.join(file).exists())
    {
        assert!(columns.contains(&format!("`{file}`")), "{file}");
        for key in keys.split(',') {
            assert!(columns.contains(&format!("| `{key}` |")), "{file}: {key}");
        }
    }
    assert!(!columns.contains("noise.csv"));
}

#[test]
fn the_dictionary_is_printed_with_every_column_and_its_unit() {
    let output = super::cardiomorph(&["--columns"]);
    assert_eq!(super::code(&output), 0, "{}", super::said(&output));
    let text = String::from_utf8(output.stdout).unwrap();
    for (file, keys) in COLUMNS {
        assert!(text.contains(&format!("`{file}`")), "{file}");
        for key in keys.split(',') {
            assert!(text.contains(&format!("| `{key}` |")), "{file}: {key}");
        }
    }
    assert!(text.contains("| `time_s` | Time | s | "));
    let demo = super::text(super::demo());
    let folder = tempfile::tempdir().unwrap();
    let out = super::text(folder.path());
    let output = super::cardiomorph(&["measure", demo, "--out", out]);
    assert_eq!(super::code(&output), 0);
    let written = std::fs::read_to_string(folder.path().join("columns.md")).unwrap();
    assert!(written.contains("`time_s`") && !written.contains("atoms.csv"));
}

#[test]
fn subjects_and_measures_are_one_table_and_distances_name_their_metric() {
    let folder = tempfile::tempdir().unwrap();
    let report = folder.path().join("report");
    let demo = super::text(super::demo());
    let out = super::text(&report);
    let options = [
        "analyze",
        demo,
        "--out",
        out,
        "--figures",
        "off",
        "--metric",
        "rigid",
    ];
    let summary = super::json_of(&super::cardiomorph(&[&options[..], &["--json"]].concat()));
    let read = |name: &str| std::fs::read_to_string(report.join(name)).unwrap();
    assert_eq!(read("subjects.csv"), read("measures.csv"));
    let metric: serde_json::Value = serde_json::from_str(&read("distances.json")).unwrap();
    // Its name before is still heard.
    assert_eq!(metric["metric"], "displacement");
    let shares = &summary["shares"];
    assert_eq!(shares["frame_to_frame"]["own"], 1.0);
    assert_eq!(metric["in_words"], summary["metric"]);
    let files = summary["files"].as_array().unwrap();
    assert!(
        ["distances.json", "columns.md"]
            .iter()
            .all(|name| files.iter().any(|file| file == name))
    );
}

//! Registration from the command line: what moves, what is written, and refusals.

use std::fs;
use std::path::{Path, PathBuf};

use cardiomorph::io::{Limits, read_mesh, write_obj};
use cardiomorph::mesh::{Point3, TriMesh, phantom};
use nalgebra::{Rotation3, Vector3};

use super::{cardiomorph, code, json_of, said, text};

fn written(folder: &Path, name: &str, mesh: &TriMesh) -> PathBuf {
    let mut bytes = Vec::new();
    write_obj(&mut bytes, mesh).unwrap();
    let path = folder.join(name);
    fs::write(&path, bytes).unwrap();
    path
}

/// A surface without symmetry.
fn shape() -> TriMesh {
    let sphere = phantom::sphere(3, 30.0);
    let bent = |p: &Point3| {
        Point3::new(
            p.x + 0.006 * p.z * p.z,
            0.8 * p.y,
            1.7 * p.z + 0.01 * p.x * p.y,
        )
    };
    let points: Vec<Point3> = sphere.vertices().iter().map(bent).collect();
    TriMesh::new(points, sphere.faces().clone()).unwrap()
}

fn turn(p: &Point3) -> Point3 {
    Rotation3::from_euler_angles(0.1, -0.05, 0.12) * p + Vector3::new(2.0, -1.0, 3.0)
}

fn turned(mesh: &TriMesh) -> TriMesh {
    let points: Vec<Point3> = mesh.vertices().iter().map(turn).collect();
    TriMesh::new(points, mesh.faces().clone()).unwrap()
}

fn landmarks(folder: &Path, mesh: &TriMesh) -> PathBuf {
    let mut rows = "ax,ay,az,bx,by,bz\n".to_owned();
    for p in mesh.vertices().iter().step_by(41) {
        let q = turn(p);
        rows += &format!("{},{},{},{},{},{}\n", p.x, p.y, p.z, q.x, q.y, q.z);
    }
    let path = folder.join("landmarks.csv");
    fs::write(&path, rows).unwrap();
    path
}

#[test]
fn every_method_finds_a_motion_again_and_writes_the_moved_mesh() {
    let folder = tempfile::tempdir().unwrap();
    let (a, b) = (shape(), turned(&shape()));
    let pairs = landmarks(folder.path(), &a);
    let (from, onto) = (
        written(folder.path(), "a.obj", &a),
        written(folder.path(), "b.obj", &b),
    );
    let out = folder.path().join("moved.ply");
    for (options, tolerance) in [
        (vec!["rigid"], 1e-4),
        (vec!["rigid", "--landmarks", text(&pairs)], 1e-4),
        (vec!["similarity", "--landmarks", text(&pairs)], 1e-4),
        (vec!["tps", "--landmarks", text(&pairs)], 1e-4),
        (
            vec!["tps", "--landmarks", text(&pairs), "--smoothing", "5"],
            1e-4,
        ),
        (vec!["icp", "--landmarks", text(&pairs)], 1e-3),
        (vec!["icp"], 0.2),
        (vec!["icp", "--kept", "0.9"], 0.5),
    ] {
        let mut all = vec![
            "register",
            text(&from),
            text(&onto),
            "--out",
            text(&out),
            "--json",
            "--method",
        ];
        all.extend(&options);
        let answer = json_of(&cardiomorph(&all));
        assert_eq!(answer["method"], options[0]);
        let [mean, p95] = ["mean_mm", "p95_mm"].map(|key| answer[key].as_f64().unwrap());
        assert!(
            mean < tolerance && p95 < 2.0 * tolerance,
            "{options:?}: {mean} {p95}"
        );
        let matrix = if options[0] == "tps" {
            "linear"
        } else {
            "rotation"
        };
        assert_eq!(answer[matrix].as_array().unwrap().len(), 3);
        let moved = read_mesh("moved.ply", &fs::read(&out).unwrap(), &Limits::default()).unwrap();
        assert_eq!(moved.frames[0].triangles(), a.triangles());
        for (p, q) in moved.frames[0].vertices().iter().zip(b.vertices()) {
            assert!(
                (p - q).norm() < 10.0 * tolerance,
                "{options:?}: {}",
                (p - q).norm()
            );
        }
    }
}

#[test]
fn what_cannot_be_registered_is_refused_with_a_reason() {
    let folder = tempfile::tempdir().unwrap();
    let a = written(folder.path(), "a.obj", &shape());
    let other = written(folder.path(), "other.obj", &phantom::bowl(20.0, 8, 16));
    let short = folder.path().join("short.csv");
    fs::write(&short, "1,2,3,4,5,6\n1,2,3\n").unwrap();
    let flat = folder.path().join("flat.csv");
    fs::write(
        &flat,
        "0,0,0,1,0,0\n1,0,0,2,0,0\n0,1,0,1,1,0\n1,1,0,2,1,0\n",
    )
    .unwrap();
    let out = folder.path().join("moved.ply");
    for (options, expected, reason) in [
        (vec!["tps"], 2, "--landmarks"),
        (vec!["rigid"], 2, "do not correspond"),
        (vec!["rigid", "--smoothing", "1"], 2, "--smoothing"),
        (vec!["icp", "--kept", "-1"], 2, "share"),
        (vec!["tps", "--landmarks", text(&short)], 1, "line 2"),
        (vec!["tps", "--landmarks", text(&flat)], 1, "one plane"),
        (
            vec!["rigid", "--landmarks", "/nowhere.csv"],
            1,
            "/nowhere.csv",
        ),
        (vec!["affine"], 2, "affine"),
    ] {
        let mut all = vec![
            "register",
            text(&a),
            text(&other),
            "--out",
            text(&out),
            "--method",
        ];
        all.extend(&options);
        let output = cardiomorph(&all);
        assert_eq!(code(&output), expected, "{options:?}: {}", said(&output));
        assert!(
            said(&output).contains(reason),
            "{options:?}: {}",
            said(&output)
        );
        assert!(!out.exists());
    }
}

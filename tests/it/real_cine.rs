//! Walls from raw cine MR of a patient whose ventricle others have fitted a model to: from three clicks, and after touches.

use std::path::PathBuf;
use std::time::Instant;

use cardiomorph::analysis::walls_from_cine::{CineParams, CineSegmentation, segment_cine};
use cardiomorph::analysis::walls_from_contours::masks_of_contours;
use cardiomorph::analysis::walls_from_masks::{WallParams, Walls, walls_from_masks};
use cardiomorph::image::{Contour, ContourPart, Image, MarkedPoints};
use cardiomorph::io::{Limits, read_dicom};
use cardiomorph::mesh::{ClosestPoint, Point3, Vector3, mean_point};
use cardiomorph::progress::Progress;

use crate::shared::shared_data;

const INSTANTS: usize = 25;
const END_SYSTOLE: usize = 9;

/// Vertices and triangles of a surface of the model.
type Surface = (Vec<Point3>, Vec<[u32; 3]>);

fn surface(name: &str, instant: usize) -> Surface {
    let path: PathBuf = shared_data(&format!("cine_mri/bivme_patient1/{name}_{instant:03}.obj"));
    let text = std::fs::read_to_string(path).unwrap();
    let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
    for line in text.lines() {
        let mut words = line.split_whitespace();
        match words.next() {
            Some("v") => {
                let [x, y, z] = [0; 3].map(|_| words.next().unwrap().parse::<f64>().unwrap());
                vertices.push(Point3::new(x, y, z));
            }
            Some("f") => triangles.push([0; 3].map(|_| {
                let corner = words.next().unwrap();
                corner.split('/').next().unwrap().parse::<u32>().unwrap() - 1
            })),
            _ => {}
        }
    }
    (vertices, triangles)
}

fn cine() -> Image {
    let folder = shared_data("images/bivme_cine/sax_full");
    let mut reading = read_dicom(&[folder], &Limits::default(), &Progress::default()).unwrap();
    assert_eq!(reading.series.len(), 1);
    reading.series.remove(0).image
}

/// The ring of the valve: vertices of edges that have one triangle.
fn ring((vertices, triangles): &Surface) -> Vec<Point3> {
    let mut edges = std::collections::HashMap::<[u32; 2], usize>::new();
    for [a, b, c] in triangles {
        for [from, to] in [[a, b], [b, c], [c, a]] {
            *edges.entry([*from.min(to), *from.max(to)]).or_default() += 1;
        }
    }
    let single = edges.iter().filter(|(_, count)| **count == 1);
    single
        .flat_map(|(edge, _)| edge.map(|v| vertices[v as usize]))
        .collect()
}

/// What a person would click in the first frame: the middle of the valve, the tip, and blood off the axis.
fn clicks() -> MarkedPoints {
    let endo = surface("lv_endo", 0);
    let base = mean_point(ring(&endo).into_iter());
    let epi = surface("lv_epi", 0).0;
    let away = |p: &&Point3| (**p - base).norm();
    let apex = *epi
        .iter()
        .max_by(|a, b| away(a).total_cmp(&away(b)))
        .unwrap();
    let blood = base + (apex - base) * 0.45 + Vector3::new(3.0, -2.0, 4.0);
    MarkedPoints {
        apex: Some(apex),
        base: Some(base),
        septum: None,
        blood: Some(blood),
    }
}

/// The outline of a surface in a slice of the image: where it crosses the plane, in the order of the angle.
fn cross_section(image: &Image, (vertices, triangles): &Surface, slice: usize) -> Vec<Point3> {
    let frame = image.frame();
    let height = |p: &Point3| frame.voxel(*p).z - slice as f64;
    let mut crossings = Vec::new();
    for triangle in triangles {
        let corners = triangle.map(|v| vertices[v as usize]);
        for n in 0..3 {
            let (from, to) = (corners[n], corners[(n + 1) % 3]);
            let (a, b) = (height(&from), height(&to));
            if (a < 0.0) != (b < 0.0) {
                crossings.push(from + (to - from) * (a / (a - b)));
            }
        }
    }
    let middle = mean_point(crossings.iter().copied());
    let [x, y, _] = frame.directions();
    crossings.sort_by(|a, b| {
        let angle = |p: &Point3| (p - middle).dot(&y).atan2((p - middle).dot(&x));
        angle(a).total_cmp(&angle(b))
    });
    crossings
}

fn segmented(image: &Image, edits: &[Contour]) -> CineSegmentation {
    let params = CineParams::default().check().unwrap();
    segment_cine(image, &clicks(), edits, &params, &Progress::default()).unwrap()
}

fn walls(image: &Image, contours: &[Contour]) -> Walls {
    let masks = masks_of_contours(image.frame(), INSTANTS, contours).unwrap();
    let params = WallParams::default().check().unwrap();
    walls_from_masks(&masks, &params, &Progress::default()).unwrap()
}

/// Means over the vertices of the wall of their distances to the model, by frame: endocardium, epicardium.
fn distances_mm(walls: &Walls) -> Vec<[f64; 2]> {
    let at = |instant: usize| {
        let mut means = [0.0; 2];
        for ((mean, own), name) in means
            .iter_mut()
            .zip(walls.sequence.surfaces())
            .zip(["lv_endo", "lv_epi"])
        {
            let (vertices, triangles) = surface(name, instant);
            let model = ClosestPoint::new(&vertices, &triangles).unwrap();
            let own = own.frames()[instant].vertices();
            *mean = own.iter().map(|&p| model.distance(p)).sum::<f64>() / own.len() as f64;
        }
        means
    };
    (0..INSTANTS).map(at).collect()
}

/// Volumes of the endocardium in millilitres, by frame.
fn volumes_ml(walls: &Walls) -> Vec<f64> {
    let fits = walls.fits.chunks(2);
    fits.map(|pair| pair[0].volume_ml).collect()
}

fn ejection_fraction(volumes: &[f64]) -> f64 {
    let greatest = volumes.iter().copied().fold(0.0, f64::max);
    let least = volumes.iter().copied().fold(f64::MAX, f64::min);
    1.0 - least / greatest
}

fn report(name: &str, walls: &Walls) -> ([f64; 2], f64) {
    let (distances, volumes) = (distances_mm(walls), volumes_ml(walls));
    for (instant, ([endo, epi], ml)) in distances.iter().zip(&volumes).enumerate() {
        println!(
            "{name} frame {instant}: endocardium {endo:.2} mm, epicardium {epi:.2} mm, {ml:.0} ml"
        );
    }
    let mean = [0, 1].map(|n| distances.iter().map(|d| d[n]).sum::<f64>() / INSTANTS as f64);
    let fraction = ejection_fraction(&volumes);
    println!(
        "{name}: means {:.2} and {:.2} mm, ejection fraction {fraction:.3}",
        mean[0], mean[1]
    );
    (mean, fraction)
}

/// The model's own outlines at end-diastole and end-systole in the slices from the second to the fifth from the base.
fn touches(image: &Image) -> Vec<Contour> {
    let mut touches = Vec::new();
    for instant in [0, END_SYSTOLE] {
        for slice in 1..5 {
            for (part, name) in [
                (ContourPart::Endocardium, "lv_endo"),
                (ContourPart::Epicardium, "lv_epi"),
            ] {
                let number = image.frame().size()[2] - 1 - slice;
                let points = cross_section(image, &surface(name, instant), number);
                if points.len() >= 3 {
                    touches.push(Contour {
                        instant,
                        part,
                        points,
                    });
                }
            }
        }
    }
    touches
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn raw_cine_gives_a_wall_near_the_fitted_model() {
    let image = cine();
    let begun = Instant::now();
    let untouched = segmented(&image, &[]);
    println!(
        "segmented in {:?}: {:?}",
        begun.elapsed(),
        untouched.notices
    );
    let (clicked, fraction) = report("clicks alone", &walls(&image, &untouched.contours));
    assert!(
        clicked[0] < CLICKED_MM[0] && clicked[1] < CLICKED_MM[1],
        "{clicked:?}"
    );
    assert!(fraction > 0.4, "{fraction}");
    let touches = touches(&image);
    let touched = segmented(&image, &touches);
    for touch in &touches {
        assert!(touched.contours.contains(touch));
    }
    let (after, fraction) = report("after touches", &walls(&image, &touched.contours));
    assert!(
        after[0] < clicked[0] && after[0] < TOUCHED_MM[0] && after[1] < TOUCHED_MM[1],
        "{after:?}"
    );
    // The model has 0.59 to 0.60.
    assert!((fraction - 0.595).abs() < 0.05, "{fraction}");
}

/// Mean distances of endocardium and epicardium to the model, at most: what is reached, and a little more.
const CLICKED_MM: [f64; 2] = [3.3, 3.0];
/// The same after touches.
const TOUCHED_MM: [f64; 2] = [2.4, 2.1];

//! What a picture costs: sending 8 poses × 40,962 vertices, recording the draws while they play, and drawing in software.

use std::hint::black_box;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Instant;

use cardiomorph::mesh::{phantom, vertex_normals};
use cardiomorph::render::{
    Bounds, Camera, Geometry, GeometryPose, Headless, Renderer, Resolution, Scene, Shading,
    Surface, SurfaceColour, ViewId, pick,
};
use criterion::{Criterion, criterion_group, criterion_main};

const POSES: usize = 8;

/// A sphere of 40,962 vertices that shrinks over its poses.
fn geometry() -> Geometry {
    let sphere = phantom::sphere(6, 1.0);
    let normals: Vec<[f32; 3]> = vertex_normals(sphere.vertices(), sphere.triangles())
        .iter()
        .map(|n| [n.x as f32, n.y as f32, n.z as f32])
        .collect();
    let at = |scale: f64| {
        let scaled = sphere.vertices().iter().map(|p| p.coords * scale);
        scaled
            .map(|p| [p.x as f32, p.y as f32, p.z as f32])
            .collect()
    };
    Geometry {
        triangles: sphere.triangles().to_vec(),
        positions: (0..POSES)
            .map(|pose| at(1.0 - 0.05 * pose as f64))
            .collect(),
        normals: vec![normals; POSES],
    }
}

fn scene(geometry: &Geometry) -> Scene {
    let surface = |opacity, silhouette| Surface {
        geometry: Arc::new(geometry.clone()),
        pose: GeometryPose::default(),
        colour: SurfaceColour::Uniform([0.7, 0.3, 0.3]),
        opacity,
        shading: Shading::Smooth,
        wireframe: None,
        silhouette,
        pickable: true,
    };
    Scene {
        surfaces: vec![surface(1.0, 0.5)],
        lines: Vec::new(),
        points: Vec::new(),
        background: [0.1, 0.1, 0.1, 1.0],
    }
}

fn render(criterion: &mut Criterion) {
    let geometry = geometry();
    let camera = Camera::default();
    let mut played = scene(&geometry);
    let size = glam::Vec2::new(640.0, 480.0);
    criterion.bench_function("pick on 81,920 triangles", |bencher| {
        bencher.iter(|| black_box(pick(&played, &camera, 0.5 * size, size)));
    });
    let (device, queue) = match Headless::new() {
        Ok(headless) => headless.into_gpu(),
        Err(error) => {
            eprintln!("skipped: {error}");
            return;
        }
    };
    let mut renderer = Renderer::new(&device, wgpu::TextureFormat::Rgba8Unorm);
    let encoder = || device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    // Small pictures: the card's own time is not what is measured here.
    let mut prepare = |scene: &Scene| {
        let mut encoder = encoder();
        let view = ViewId(0);
        renderer.prepare(
            &device,
            &queue,
            &mut encoder,
            view,
            scene,
            &camera,
            Resolution::full([8, 8], 1.0),
        );
        encoder.finish()
    };
    let mut group = criterion.benchmark_group("8 poses × 40,962 vertices");
    group.sample_size(20);
    group.bench_function("send and record", |bencher| {
        bencher.iter_batched(
            || scene(&geometry),
            |fresh| {
                black_box(prepare(&fresh));
                queue.submit([]);
                // Let the copies run now, or staging memory piles up over the iterations.
                device.poll(wgpu::PollType::wait_indefinitely()).ok();
            },
            criterion::BatchSize::PerIteration,
        );
    });
    group.bench_function("record while playing", |bencher| {
        bencher.iter(|| {
            let pose = &mut played.surfaces[0].pose;
            pose.blend = (pose.blend + 0.01) % 1.0;
            pose.to = 1;
            black_box(prepare(&played))
        });
    });
    group.bench_function("nothing changed", |bencher| {
        bencher.iter(|| black_box(prepare(&played)));
    });
    group.finish();
}

/// An open wall, as of a ventricle: an opaque inside, a translucent outside.
fn wall() -> Scene {
    let surface = |radius, opacity| {
        let bowl = phantom::bowl(radius, 24, 48);
        let single = |v: [f64; 3]| v.map(|x| x as f32);
        let normals = vertex_normals(bowl.vertices(), bowl.triangles());
        let positions = bowl.vertices().iter().map(|p| single(p.coords.into()));
        Surface {
            geometry: Arc::new(Geometry {
                triangles: bowl.triangles().to_vec(),
                positions: vec![positions.collect()],
                normals: vec![normals.into_iter().map(|n| single(n.into())).collect()],
            }),
            pose: GeometryPose::default(),
            colour: SurfaceColour::Uniform([0.7, 0.3, 0.3]),
            opacity,
            shading: Shading::Smooth,
            wireframe: None,
            silhouette: 0.6,
            pickable: true,
        }
    };
    Scene {
        surfaces: vec![surface(0.75, 1.0), surface(1.0, 0.22)],
        lines: Vec::new(),
        points: Vec::new(),
        background: [0.1, 0.1, 0.1, 1.0],
    }
}

/// Time until a picture is there, as a window sees it; on a software adapter all of it is the processor's.
fn picture(criterion: &mut Criterion) {
    let headless = match Headless::new() {
        Ok(headless) => headless,
        Err(error) => {
            eprintln!("skipped: {error}");
            return;
        }
    };
    let mut group = criterion.benchmark_group(format!("1280 × 800 on {}", headless.adapter_name()));
    group.sample_size(10);
    let (device, queue) = headless.into_gpu();
    let mut renderer = Renderer::new(&device, wgpu::TextureFormat::Rgba8Unorm);
    let both = wall();
    let mut inside = both.clone();
    inside.surfaces.truncate(1);
    let level = Camera::default().look_from(glam::Vec3::new(0.0, 1.0, 0.3), glam::Vec3::Z);
    let Some(bounds) = Bounds::of_scene(&both) else {
        return;
    };
    let mut turn = 0.0;
    for (name, scene) in [("inside alone", inside), ("inside and outside", both)] {
        group.bench_function(name, |bencher| {
            bencher.iter(|| {
                turn += 0.01;
                let camera = level.turned(glam::Vec3::Z, turn, 0.0).fitted(&bounds, 1.6);
                let descriptor = wgpu::CommandEncoderDescriptor::default();
                let mut encoder = device.create_command_encoder(&descriptor);
                let (view, size) = (ViewId(0), Resolution::full([1280, 800], 1.0));
                renderer.prepare(&device, &queue, &mut encoder, view, &scene, &camera, size);
                queue.submit([encoder.finish()]);
                device.poll(wgpu::PollType::wait_indefinitely()).ok();
            });
        });
    }
    group.finish();
}

/// When the pass before ended, and the passes of a picture with their times in ms.
type Passes = (Instant, Vec<(&'static str, f64)>);

fn locked(passes: &Mutex<Passes>) -> MutexGuard<'_, Passes> {
    passes.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Where the time of one picture goes: every pass submitted alone and waited for, the median of eleven pictures.
#[expect(
    clippy::print_stdout,
    reason = "the table is what the bench is run for"
)]
fn passes(_: &mut Criterion) {
    let headless = match Headless::new() {
        Ok(headless) => headless,
        Err(error) => {
            eprintln!("skipped: {error}");
            return;
        }
    };
    println!("1280 × 800 on {}, ms a picture:", headless.adapter_name());
    let (device, queue) = headless.into_gpu();
    let scene = wall();
    let level = Camera::default().look_from(glam::Vec3::new(0.0, 1.0, 0.3), glam::Vec3::Z);
    let Some(bounds) = Bounds::of_scene(&scene) else {
        return;
    };
    let full = Resolution::full([1280, 800], 1.0);
    for (name, resolution) in [("at rest", full), ("moving", full.moving(1.0))] {
        let taken = Arc::new(Mutex::new((Instant::now(), Vec::new())));
        let mut renderer = Renderer::new(&device, wgpu::TextureFormat::Rgba8Unorm);
        let (own, its) = ((device.clone(), queue.clone()), Arc::clone(&taken));
        renderer.tell_passes(Box::new(move |pass, encoder| {
            let next = own.0.create_command_encoder(&Default::default());
            own.1.submit([std::mem::replace(encoder, next).finish()]);
            own.0.poll(wgpu::PollType::wait_indefinitely()).ok();
            let mut taken = locked(&its);
            let ms = 1e3 * taken.0.elapsed().as_secs_f64();
            taken.1.push((pass, ms));
            taken.0 = Instant::now();
        }));
        let mut by_pass: Vec<(&str, Vec<f64>)> = Vec::new();
        for picture in 0..12 {
            let turn = 0.01 * f64::from(picture) as f32;
            let camera = level.turned(glam::Vec3::Z, turn, 0.0).fitted(&bounds, 1.6);
            let mut encoder = device.create_command_encoder(&Default::default());
            locked(&taken).0 = Instant::now();
            let view = ViewId(0);
            renderer.prepare(
                &device,
                &queue,
                &mut encoder,
                view,
                &scene,
                &camera,
                resolution,
            );
            queue.submit([encoder.finish()]);
            let mut sums: Vec<(&str, f64)> = Vec::new();
            for (pass, ms) in locked(&taken).1.drain(..) {
                match sums.iter_mut().find(|(known, _)| *known == pass) {
                    Some((_, sum)) => *sum += ms,
                    None => sums.push((pass, ms)),
                }
            }
            // The first picture makes pipelines and sends the surfaces.
            for (pass, ms) in sums.into_iter().filter(|_| picture > 0) {
                match by_pass.iter_mut().find(|(known, _)| *known == pass) {
                    Some((_, all)) => all.push(ms),
                    None => by_pass.push((pass, vec![ms])),
                }
            }
        }
        println!("  {name}");
        for (pass, mut all) in by_pass {
            all.sort_by(f64::total_cmp);
            println!("    {pass:<45} {:6.1}", all[all.len() / 2]);
        }
    }
}

criterion_group!(benches, render, picture, passes);
criterion_main!(benches);

//! scratch
use cardiomorph::study::built_in::*;
use cardiomorph::analysis::measures::*;
#[test]
fn dump() {
    let t = std::time::Instant::now();
    let made = cohort(&BuiltInParams::default()).unwrap();
    println!("made in {:?}", t.elapsed());
    let t = std::time::Instant::now();
    let ms = measure_study(&made.study, &Default::default()).unwrap();
    println!("measured in {:?}", t.elapsed());
    for ((s, m), tr) in made.study.subjects.iter().zip(&ms).zip(&made.truths) {
        println!("{} {:?} edv {:.1} esv {:.1} ef {:.3} (design {:.3}) es {:?} mass {:.0} rr {:.2} seg {:?} h {:?} w {:?}", s.id, tr.abnormality, m.edv.unwrap(), m.esv.unwrap(), m.ef.unwrap(), tr.ejection_fraction, m.end_systole, m.mass.unwrap().0, s.timing.rr.unwrap().0, tr.segments, s.height_cm, s.weight_kg);
        if let Ok(dir) = std::env::var("DUMP") {
            for surf in s.sequence.surfaces() { for (f, mesh) in surf.frames().iter().enumerate() {
                let mut o = String::new();
                for v in mesh.vertices() { o += &format!("v {} {} {}\n", v.x, v.y, v.z); }
                for t in mesh.triangles() { o += &format!("f {} {} {}\n", t[0]+1, t[1]+1, t[2]+1); }
                std::fs::write(format!("{dir}/{}_{}_{f}.obj", s.id, surf.kind().name()), o).unwrap();
            } }
        }
    }
}
fn shade(made: &BuiltInCohort, which: &[(usize, usize)], cols: usize, size: usize, out: &str, view: u8, open: bool) {
    use nalgebra::Vector3;
    let rows = which.len().div_ceil(cols);
    let mut img = image::RgbImage::from_pixel((cols*size) as u32, (rows*size) as u32, image::Rgb([30,32,36]));
    for (k, &(si, f)) in which.iter().enumerate() {
        let (ox, oy) = ((k % cols)*size, (k / cols)*size);
        let s = &made.study.subjects[si];
        let tr = &made.truths[si];
        let mut zb = vec![f64::NEG_INFINITY; size*size];
        let a = s.anatomy.unwrap();
        let c = a.apex + (a.base - a.apex)*0.5;
        // screen axes
        let (r,u,d) = match view { 0 => (-a.septal, a.long_axis(), a.anterior), 1 => (-a.anterior, a.long_axis(), -a.septal), 3 => (a.anterior, a.long_axis(), a.septal), _ => (-a.septal, a.anterior, -a.long_axis()) };
        for (surf, truth) in s.sequence.surfaces().iter().zip(&tr.surfaces) {
            let m = &surf.frames()[f];
            let n = cardiomorph::mesh::vertex_normals(m.vertices(), m.triangles());
            let endo = surf.kind() == cardiomorph::study::SurfaceKind::Endocardium;
            for t in m.triangles() {
                if open { // cut: drop faces towards the viewer
                    let cc: f64 = t.iter().map(|&v| (m.vertices()[v as usize]-c).dot(&d)).sum::<f64>()/3.0;
                    if cc > 2.0 { continue; }
                }
                let p: Vec<(f64,f64,f64)> = t.iter().map(|&v| { let q = m.vertices()[v as usize]-c; (q.dot(&r), q.dot(&u), q.dot(&d)) }).collect();
                let sc = size as f64/130.0;
                let px: Vec<(f64,f64,f64)> = p.iter().map(|q| (size as f64/2.0+q.0*sc, size as f64/2.0-q.1*sc, q.2)).collect();
                let (x0,x1)=(px.iter().map(|p|p.0).fold(1e9,f64::min).max(0.0) as usize, px.iter().map(|p|p.0).fold(-1e9,f64::max).min(size as f64-1.0).max(0.0) as usize);
                let (y0,y1)=(px.iter().map(|p|p.1).fold(1e9,f64::min).max(0.0) as usize, px.iter().map(|p|p.1).fold(-1e9,f64::max).min(size as f64-1.0).max(0.0) as usize);
                let den=(px[1].1-px[2].1)*(px[0].0-px[2].0)+(px[2].0-px[1].0)*(px[0].1-px[2].1);
                if den.abs()<1e-12 {continue;}
                for y in y0..=y1 { for x in x0..=x1 {
                    let (fx,fy)=(x as f64+0.5,y as f64+0.5);
                    let w0=((px[1].1-px[2].1)*(fx-px[2].0)+(px[2].0-px[1].0)*(fy-px[2].1))/den;
                    let w1=((px[2].1-px[0].1)*(fx-px[2].0)+(px[0].0-px[2].0)*(fy-px[2].1))/den;
                    let w2=1.0-w0-w1;
                    if w0< -1e-9||w1< -1e-9||w2< -1e-9 {continue;}
                    let z=w0*px[0].2+w1*px[1].2+w2*px[2].2;
                    if z<=zb[y*size+x]{continue;}
                    zb[y*size+x]=z;
                    let nn: Vector3<f64> = n[t[0] as usize]*w0+n[t[1] as usize]*w1+n[t[2] as usize]*w2;
                    let nn=nn.normalize();
                    let l=(d*0.7+u*0.4-r*0.4).normalize();
                    let edge = if w0.min(w1).min(w2) < 0.04 {0.8} else {1.0};
                    let b=(0.25+0.75*nn.dot(&l).abs().powi(1))*edge;
                    let sev=truth.severity[t[0] as usize]*w0+truth.severity[t[1] as usize]*w1+truth.severity[t[2] as usize]*w2;
                    let base= if endo {[220.0,120.0,110.0]} else {[200.0,150.0,140.0]};
                    let col: Vec<u8> = (0..3).map(|i| ((base[i]*(1.0-0.7*sev)+[60.0,90.0,230.0][i]*0.7*sev)*b).min(255.0) as u8).collect();
                    img.put_pixel((ox+x) as u32,(oy+y) as u32, image::Rgb([col[0],col[1],col[2]]));
                }}
            }
        }
    }
    img.save(out).unwrap();
}
#[test]
fn pictures() {
    let made = cohort(&BuiltInParams::default()).unwrap();
    let es: Vec<usize> = measure_study(&made.study, &Default::default()).unwrap().iter().map(|m| m.end_systole.unwrap()).collect();
    let four = |i: usize| vec![(i,0),(i,es[i])];
    let list: Vec<_> = [0,3,4].into_iter().flat_map(four).collect();
    shade(&made,&list,6,330,"/tmp/dump/n_front.png",0,false);
    shade(&made,&list,6,330,"/tmp/dump/n_cut.png",0,true);
    let list: Vec<_> = [11,13,15].into_iter().flat_map(four).collect();
    shade(&made,&list,6,330,"/tmp/dump/p_front.png",0,false);
    shade(&made,&list,6,330,"/tmp/dump/p_cut.png",0,true);
    shade(&made,&list,6,330,"/tmp/dump/p_side.png",1,true);
    let list: Vec<_> = [17,18,16].into_iter().flat_map(four).collect();
    shade(&made,&list,6,330,"/tmp/dump/q_front.png",3,false);
    let list: Vec<_> = (0..8).map(|f| (1,f)).collect();
    shade(&made,&list,8,250,"/tmp/dump/beat.png",0,false);
}

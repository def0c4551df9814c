//! Wall: a shock runs around a bend between two circles. Under its foot on the outer wall the mesh is
//! refined, wall and all, and behind it made coarser again; all vertices of the wall stay on the circle.
//!
//!     cargo run --example wall -- 4 [wall_]
use alphamst::{Carry, Context, Entity, Mesh, Metric, Options};
use std::{env, error::Error, ops::ControlFlow, process};

const ALONG: usize = 64;
const ACROSS: usize = 16;
const INNER: f64 = 1.0;
const OUTER: f64 = 2.0;

fn length([x, y]: [f64; 2]) -> f64 {
    (x * x + y * y).sqrt()
}

/// Of the bend in ALONG parts, by turning from each to the next: sine and cosine are not the same to the
/// last digit in every language.
fn divided() -> [[f64; 2]; ALONG + 1] {
    let (cosine, sine) = (0.9987954562051724, 0.04906767432741801);
    let mut circle = [[1.0, 0.0]; ALONG + 1];
    for i in 1..=ALONG {
        let [x, y] = circle[i - 1];
        circle[i] = [cosine * x - sine * y, sine * x + cosine * y];
    }
    circle[ALONG][1] = 0.0;
    circle
}

fn bend(circle: &[[f64; 2]]) -> alphamst::Result<Mesh> {
    let row = |at: &[f64; 2]| {
        let at = *at;
        (0..=ACROSS)
            .map(move |j| at.map(|x| (INNER + (OUTER - INNER) * j as f64 / ACROSS as f64) * x))
    };
    let points: Vec<[f64; 2]> = circle.iter().flat_map(row).collect();
    let across = ACROSS as i32;
    let quad = |f: i32| f + f / across;
    let faces: Vec<[i32; 4]> = (0..ALONG as i32 * across)
        .map(quad)
        .map(|v| [v, v + 1, v + across + 2, v + across + 1])
        .collect();
    Mesh::new(&Context::new(), &points, &faces)
}

/// The two ends of the bend are on y = 0, the rest of its boundary on the two circles.
fn project(_: &[i32], points: &[[f64; 2]], projected: &mut [[f64; 2]]) -> ControlFlow<()> {
    for (&point, to) in points.iter().zip(projected) {
        let radius = length(point);
        let near = if radius < (INNER + OUTER) / 2.0 {
            INNER
        } else {
            OUTER
        };
        let scale = if point[1] <= 0.0 { 1.0 } else { near / radius };
        *to = point.map(|x| scale * x);
    }
    ControlFlow::Continue(())
}

/// The field "size" around the foot of the shock; how many faces that asks for.
fn want_sizes(mesh: &mut Mesh, foot: [f64; 2]) -> alphamst::Result<f64> {
    let points = mesh.points::<2>()?;
    let wanted = |p: &[f64; 2]| (0.02 + 0.2 * length([p[0] - foot[0], p[1] - foot[1]])).min(0.08);
    let size: Vec<f64> = points.iter().map(wanted).collect();
    let mut sum = 0.0;
    for (face, area) in mesh.faces().iter().zip(mesh.quality(Metric::Area)) {
        let length = face.iter().map(|v| size[v.index()]).sum::<f64>() / 4.0;
        sum += area / (length * length);
    }
    mesh.set_field(Entity::Vertex, "size", 1, Carry::Linear, &size)?;
    Ok(sum)
}

fn print_row(mesh: &Mesh, step: usize) -> alphamst::Result<()> {
    let (points, sides) = (mesh.points::<2>()?, mesh.edge_faces());
    let (mut on_wall, mut farthest) = (0, 0.0_f64);
    for (edge, sides) in mesh.edges().iter().zip(sides) {
        let [v, w] = edge.map(|v| points[v.index()]);
        if sides.iter().all(Option::is_some)
            || v[1] + w[1] <= 0.0
            || length(v) < (INNER + OUTER) / 2.0
        {
            continue;
        }
        on_wall += 1;
        farthest = farthest
            .max((length(v) - OUTER).abs())
            .max((length(w) - OUTER).abs());
    }
    let quality = mesh.summary(Metric::ScaledJacobian);
    println!(
        "{step:>4} {:>6} {on_wall:>6} {farthest:>15.12} {:>12.4}",
        mesh.n_faces(),
        quality.min
    );
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = env::args().collect();
    if arguments.len() < 2 {
        eprintln!("usage: wall STEPS [PICTURE_PREFIX]");
        process::exit(2);
    }
    let steps: usize = arguments[1].parse()?;
    let circle = divided();
    let mut mesh = bend(&circle)?;
    let options = Options::new().edit_boundary(true);
    mesh.set_projection(project)?;

    println!(
        "{:>4} {:>6} {:>6} {:>15} {:>12}",
        "step", "faces", "edges", "from the wall", "smallest SJ"
    );
    for step in 0..=steps {
        if step > 0 {
            // 0: as it was made
            let foot = circle[step * ALONG / (steps + 1)].map(|x| OUTER * x);
            let n_faces = mesh.n_faces() as f64;
            let alpha = want_sizes(&mut mesh, foot)? / n_faces;
            let _ = mesh.adapt(None, alpha, &options)?;
        }
        print_row(&mesh, step)?;
        if let Some(prefix) = arguments.get(2) {
            mesh.write(format!("{prefix}{step}.svg"))?;
        }
    }
    Ok(())
}

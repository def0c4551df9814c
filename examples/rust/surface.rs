//! Surface: a torus of triangles that lie at random becomes quads, and a fraction alpha of these, with
//! few singular vertices; all vertices stay on the surface.
//!
//!     cargo run --example surface -- 0.5 [after.svg]
use alphamst::{Context, Mesh};
use std::{env, error::Error, process};

const AROUND: usize = 64;
const ACROSS: usize = 24;
const RADIUS: f64 = 1.0; // from the axis to the middle of the tube
const TUBE: f64 = 0.4; // its radius

/// A number of -0.5 to 0.5 at random, the same in every language.
fn noise(state: &mut i64) -> f64 {
    *state = (1103515245 * *state + 12345) % 2147483648;
    *state as f64 / 2147483648.0 - 0.5
}

fn distance(p: &[f64; 3]) -> f64 {
    let off = (p[0] * p[0] + p[1] * p[1]).sqrt() - RADIUS;
    ((off * off + p[2] * p[2]).sqrt() - TUBE).abs()
}

/// The point of the torus that is nearest to p.
fn projected(p: [f64; 3]) -> [f64; 3] {
    let around = (p[0] * p[0] + p[1] * p[1]).sqrt();
    let off = around - RADIUS;
    let across = (off * off + p[2] * p[2]).sqrt();
    let wide = (RADIUS + off / across * TUBE) / around;
    [p[0] * wide, p[1] * wide, p[2] / across * TUBE]
}

/// Of a circle in N parts, by turning from each to the next: sine and cosine are not the same to the
/// last digit in every language.
fn divided<const N: usize>(cosine: f64, sine: f64) -> [[f64; 2]; N] {
    let mut circle = [[1.0, 0.0]; N];
    for i in 1..N {
        let [x, y] = circle[i - 1];
        circle[i] = [cosine * x - sine * y, sine * x + cosine * y];
    }
    circle
}

fn torus() -> (Vec<[f64; 3]>, Vec<[i32; 3]>) {
    let long_way: [_; AROUND] = divided(0.9951847266721969, 0.0980171403295606);
    let short_way: [_; 2 * ACROSS] = divided(0.9914448613738104, 0.13052619222005157);
    let (mut points, mut triangles) = (Vec::new(), Vec::new());
    let mut state = 1;
    let number = |i: usize, j: usize| (i % AROUND * ACROSS + j % ACROSS) as i32;
    for i in 0..AROUND {
        for j in 0..ACROSS {
            let at = short_way[2 * j + i % 2]; // every other row by half a cell
            let wide = RADIUS + TUBE * at[0];
            let mut p = [wide * long_way[i][0], wide * long_way[i][1], TUBE * at[1]];
            p.iter_mut().for_each(|x| *x += 0.04 * noise(&mut state));
            points.push(projected(p));
            let (a, b) = (number(i, j), number(i + 1, j));
            let (c, d) = (number(i + 1, j + 1), number(i, j + 1));
            triangles.extend(if i % 2 == 0 {
                [[a, b, d], [b, c, d]] // the short diagonals are those from b to d
            } else {
                [[a, b, c], [a, c, d]]
            });
        }
    }
    (points, triangles)
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = env::args().collect();
    if arguments.len() < 2 {
        eprintln!("usage: surface ALPHA [PICTURE]");
        process::exit(2);
    }
    let (points, triangles) = torus();
    let mut mesh = Mesh::new(&Context::new(), &points, &triangles)?;
    let n_sharp = mesh.detect_features(60.0)?;
    mesh.set_surface(&points, &triangles)?;
    let report = mesh.adapt(None, arguments[1].parse()?, None)?;

    let all = report.all();
    let farthest = mesh.points::<3>()?.iter().map(distance).fold(0.0, f64::max);
    println!("{} triangles, {n_sharp} sharp edges", triangles.len());
    println!("{:<24} {:>6} {:>6}", "", "before", "after");
    println!(
        "{:<24} {:>6} {:>6}",
        "faces",
        all.faces_before(),
        all.faces_after()
    );
    println!(
        "{:<24} {:>6} {:>6}",
        "singular vertices",
        all.singular_before(),
        all.singular_after()
    );
    println!(
        "{:<24} {:>6.3} {:>6.3}",
        "smallest scaled Jacobian",
        all.quality_before(),
        all.quality_after()
    );
    println!("{farthest:.4} from the torus at most");
    if let Some(picture) = arguments.get(2) {
        mesh.write(picture)?;
    }
    Ok(())
}

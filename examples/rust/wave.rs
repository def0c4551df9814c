//! Wave: adapt while you solve. A ring around the middle of a square runs outwards; before each step the
//! field "size" asks for small faces near it, and the mesh changes only where its faces are off that. An
//! energy and a temperature come along: the sum of the one and the linear values of the other stay.
//!
//!     cargo run --example wave -- 6 [wave_]
use alphamst::{Carry, Context, Entity, Mesh, Metric, Options, Report};
use std::{env, error::Error, process};

const SIDE: usize = 32;
const MIDDLE: f64 = 16.0;
const FIRST: i32 = 5; // radius

/// A square of unit squares with the two fields.
fn square() -> alphamst::Result<Mesh> {
    let side = SIDE as i32;
    let points: Vec<[f64; 2]> = (0..=SIDE)
        .flat_map(|y| (0..=SIDE).map(move |x| [x as f64, y as f64]))
        .collect();
    let faces: Vec<[i32; 4]> = (0..side * side)
        .map(|f| f + f / side)
        .map(|v| [v, v + 1, v + side + 2, v + side + 1])
        .collect();
    let hump = |f: usize| {
        let x = (f % SIDE) as f64 + 0.5 - MIDDLE;
        let y = (f / SIDE) as f64 + 0.5 - MIDDLE;
        1.0 / (1.0 + (x * x + y * y) / 32.0)
    };
    let energy: Vec<f64> = (0..SIDE * SIDE).map(hump).collect();
    let temperature: Vec<f64> = points.iter().map(|[x, y]| x + 2.0 * y).collect();
    let mut mesh = Mesh::new(&Context::new(), &points, &faces)?;
    mesh.set_field(Entity::Face, "energy", 1, Carry::Conserve, &energy)?;
    mesh.set_field(
        Entity::Vertex,
        "temperature",
        1,
        Carry::Linear,
        &temperature,
    )?;
    Ok(mesh)
}

/// The field "size" around the ring: half an edge within 1.5 of it, a whole one from 5 on.
fn want_sizes(mesh: &mut Mesh, radius: i32) -> alphamst::Result<()> {
    let wanted = |p: &[f64; 2]| {
        let [x, y] = p.map(|x| x - MIDDLE);
        let away = ((x * x + y * y).sqrt() - f64::from(radius)).abs();
        (0.5 + 0.5 * (away - 1.5) / 3.5).clamp(0.5, 1.0)
    };
    let size: Vec<f64> = mesh.points::<2>()?.iter().map(wanted).collect();
    mesh.set_field(Entity::Vertex, "size", 1, Carry::Linear, &size)
}

fn total_energy(mesh: &Mesh) -> alphamst::Result<f64> {
    let energy = mesh.field(Entity::Face, "energy")?;
    let areas = mesh.quality(Metric::Area);
    Ok(energy.iter().zip(areas).map(|(e, area)| e * area).sum())
}

fn temperature_error(mesh: &Mesh) -> alphamst::Result<f64> {
    let temperature = mesh.field(Entity::Vertex, "temperature")?;
    let errors = temperature
        .iter()
        .zip(mesh.points::<2>()?)
        .map(|(t, [x, y])| (t - x - 2.0 * y).abs());
    Ok(errors.fold(0.0, f64::max))
}

/// The power of ten above a value: its digits are those of rounding, and differ between languages.
fn bound(value: f64) -> String {
    let (mut power, mut limit) = (-12, 1e-12);
    while power < 0 && value >= limit {
        power += 1;
        limit *= 10.0;
    }
    format!("< 1e{power}")
}

fn print_row(mesh: &Mesh, report: &Report, radius: i32, energy: f64) -> alphamst::Result<()> {
    let all = report.all();
    println!(
        "{radius:>6} {:>6} {:>6} {:>6} {:>9} {:>12.4} {:>8} {:>12}",
        all.faces_before(),
        all.faces_wanted(),
        all.faces_after(),
        all.singular_after(),
        all.quality_after(),
        bound((total_energy(mesh)? / energy - 1.0).abs()),
        bound(temperature_error(mesh)?)
    );
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = env::args().collect();
    if arguments.len() < 2 {
        eprintln!("usage: wave STEPS [PICTURE_PREFIX]");
        process::exit(2);
    }
    let last = FIRST + arguments[1].parse::<i32>()? - 1;
    let mut mesh = square()?;
    let energy = total_energy(&mesh)?;
    let options = Options::new().size_band(0.7)?;

    println!(
        "{:>6} {:>6} {:>6} {:>6} {:>9} {:>12} {:>8} {:>12}",
        "radius", "before", "wanted", "after", "singular", "smallest SJ", "energy", "temperature"
    );
    for radius in FIRST..=last {
        want_sizes(&mut mesh, radius)?;
        let report = mesh.adapt(None, 1.0, &options)?;
        print_row(&mesh, &report, radius, energy)?;
        if let Some(prefix) = arguments.get(2) {
            mesh.write(format!("{prefix}{radius}.svg"))?;
        }
    }
    want_sizes(&mut mesh, last)?; // the last call again
    let before = mesh.checksum();
    let _ = mesh.adapt(None, 1.0, &options)?;
    let same = mesh.checksum() == before;
    println!(
        "again: {}",
        if same {
            "nothing changed"
        } else {
            "the mesh changed"
        }
    );
    Ok(())
}

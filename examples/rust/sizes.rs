//! Sizes: what the report tells of the faces of two patches and of both together, for several alphas.
//!
//!     cargo run --example sizes -- ../../examples/data/coast_small.msh [after_]
use alphamst::{Context, Mesh, Outcome, Patches};
use std::{env, error::Error, process};

fn print_row(alpha: f64, name: &str, outcome: &Outcome) {
    println!(
        "{alpha:>5.1} {name:>5} {:>6} {:>9} {:>7.2} {:>7.2} {:>7.2} {:>7.2} {:>7.2} {:>7.2}",
        outcome.faces_after(),
        outcome.singular_after(),
        outcome.size_error_before(),
        outcome.size_error_after(),
        outcome.least_area_after(),
        outcome.shortest_edge_after(),
        outcome.aspect_ratio_after(),
        outcome.time_step()
    );
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = env::args().collect();
    if arguments.len() < 2 {
        eprintln!("usage: sizes MESH [PICTURE_PREFIX]");
        process::exit(2);
    }
    let mut mesh = Mesh::read(&Context::new(), &arguments[1], None)?;
    let begun = mesh.mark()?;

    println!(
        "{:>5} {:>5} {:>6} {:>9} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7}",
        "alpha", "patch", "faces", "singular", "before", "after", "area", "edge", "aspect", "step"
    );
    for (i, alpha) in [0.5, 1.0, 2.0, 4.0].into_iter().enumerate() {
        mesh.rollback(begun)?;
        let mut patches = Patches::new(&mesh, None);
        let first = patches.add_ball([4.2, 5.2, 0.0], 0.7)?;
        let second = patches.add_ball([6.0, 5.0, 0.0], 0.7)?;
        let report = mesh.adapt(&mut patches, alpha, None)?;
        print_row(alpha, "1", &report.patch(first)?);
        print_row(alpha, "2", &report.patch(second)?);
        print_row(alpha, "both", &report.all());
        if let Some(prefix) = arguments.get(2) {
            patches.write(format!("{prefix}{i}.svg"))?;
        }
    }
    Ok(())
}

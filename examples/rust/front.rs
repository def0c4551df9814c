//! Refine around a moving front: at every step the mesh is fine where the front is and as it was
//! everywhere else.
//!
//!     cargo run --example front -- ../../examples/data/coast_small.msh [front_]
use alphamst::{Context, Mesh, Patches};
use std::{env, error::Error, process};

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = env::args().collect();
    if arguments.len() < 2 {
        eprintln!("usage: front MESH [PICTURE_PREFIX]");
        process::exit(2);
    }
    let mut mesh = Mesh::read(&Context::new(), &arguments[1], None)?;
    let coarse = mesh.mark()?;

    println!(
        "{:>4} {:>6} {:>6} {:>9} {:>12}",
        "step", "near", "faces", "singular", "smallest SJ"
    );
    for step in 0..5 {
        let front = [
            4.2 + 0.3 * f64::from(step),
            5.2 + 0.05 * f64::from(step),
            0.0,
        ];
        mesh.rollback(coarse)?; // the front has moved on
        let mut patches = Patches::new(&mesh, None);
        patches.add_ball(front, 0.8)?;
        let report = mesh.adapt(&mut patches, 2.0, None)?;
        let all = report.all();
        println!(
            "{step:>4} {:>6} {:>6} {:>9} {:>12.4}",
            all.faces_after(),
            mesh.n_faces(),
            all.singular_after(),
            all.quality_after()
        );
        if let Some(prefix) = arguments.get(2) {
            patches.write(format!("{prefix}{step}.svg"))?;
        }
    }
    Ok(())
}

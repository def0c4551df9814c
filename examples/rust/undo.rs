//! Undo: two changes, each taken back, and the mesh is bit for bit what it was.
//!
//!     cargo run --example undo -- ../../examples/data/coast_small.msh
use alphamst::{Context, Mesh, Patches};
use std::{env, error::Error, process};

fn print_row(what: &str, mesh: &Mesh, digest_at_start: i64) {
    let state = if mesh.checksum() == digest_at_start {
        "as at the start"
    } else {
        "changed"
    };
    println!(
        "{what:<16} {:>6} {:>9}   {state}",
        mesh.n_faces(),
        mesh.singularities().len()
    );
}

fn adapt_ball(mesh: &mut Mesh, x: f64, y: f64, alpha: f64) -> Result<(), alphamst::Error> {
    let mut patches = Patches::new(mesh, None);
    patches.add_ball([x, y, 0.0], 0.8)?;
    let _ = mesh.adapt(&mut patches, alpha, None)?;
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let Some(path) = env::args().nth(1) else {
        eprintln!("usage: undo MESH");
        process::exit(2);
    };
    let mut mesh = Mesh::read(&Context::new(), path, None)?;
    let digest = mesh.checksum();
    println!("{:<16} {:>6} {:>9}", "mesh", "faces", "singular");
    print_row("read", &mesh, digest);

    let first = mesh.mark()?;
    adapt_ball(&mut mesh, 4.9, 5.3, 3.0)?;
    print_row("refined", &mesh, digest);
    let second = mesh.mark()?;
    let _ = mesh.smooth(None, None)?;
    print_row("smoothed", &mesh, digest);
    mesh.rollback(second)?;
    print_row("not smoothed", &mesh, digest);
    mesh.rollback(first)?;
    print_row("not refined", &mesh, digest);
    mesh.forget(first)?;
    Ok(())
}

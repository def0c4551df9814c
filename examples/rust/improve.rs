//! Improve a region: fewer singular vertices and better corners with the same number of faces.
//!
//!     cargo run --example improve -- ../../examples/data/coast_small.msh [after.svg]
use alphamst::{Context, Mesh, Patches};
use std::{env, error::Error, process};

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = env::args().collect();
    if arguments.len() < 2 {
        eprintln!("usage: improve MESH [PICTURE]");
        process::exit(2);
    }
    let mut mesh = Mesh::read(&Context::new(), &arguments[1], None)?;
    let mut patches = Patches::new(&mesh, None);
    let patch = patches.add_box([3.8, 4.4, 0.0], [6.2, 6.4, 0.0])?;
    let report = mesh.adapt(&mut patches, 1.0, None)?;

    let region = report.patch(patch)?;
    let print_row = |state, faces: usize, singular: usize, quality: f64| {
        println!("{state:<8} {faces:>6} {singular:>9} {quality:>12.4}");
    };
    println!(
        "{:<8} {:>6} {:>9} {:>12}",
        "region", "faces", "singular", "smallest SJ"
    );
    print_row(
        "before",
        region.faces_before(),
        region.singular_before(),
        region.quality_before(),
    );
    print_row(
        "after",
        region.faces_after(),
        region.singular_after(),
        region.quality_after(),
    );
    if let Some(picture) = arguments.get(2) {
        patches.write(picture)?;
    }
    Ok(())
}

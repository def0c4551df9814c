//! Simplify: three faces where there were four, patch by patch over the whole mesh. A patch that
//! cannot have its wanted faces is left as it was.
//!
//!     cargo run --example simplify -- ../../examples/data/coast_small.msh [after.svg]
use alphamst::{Context, Decomposition, Mesh, Options, Patches};
use std::{env, error::Error, process};

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = env::args().collect();
    if arguments.len() < 2 {
        eprintln!("usage: simplify MESH [PICTURE]");
        process::exit(2);
    }
    let options = Options::new().patch_faces(80.0)?.seed(7);
    let mut mesh = Mesh::read(&Context::new(), &arguments[1], &options)?;
    let mut patches = Patches::new(&mesh, &options);
    patches.decompose(Decomposition::Clusters)?;
    let report = mesh.adapt(&mut patches, 0.75, &options)?;

    println!(
        "{:>5} {:>6} {:>6} {:>6} {:>9}",
        "patch", "before", "wanted", "after", "singular"
    );
    let mut left = 0;
    for (number, patch) in (1..).zip(report.patches()) {
        let is_left = patch.status().is_failure();
        left += usize::from(is_left);
        println!(
            "{number:>5} {:>6} {:>6} {:>6} {:>9}{}",
            patch.faces_before(),
            patch.faces_wanted(),
            patch.faces_after(),
            patch.singular_after(),
            if is_left { "  left" } else { "" }
        );
    }
    println!("{left} of {} patches left", patches.len());
    if let Some(picture) = arguments.get(2) {
        patches.write(picture)?;
    }
    Ok(())
}

//! Choose the faces of a patch by hand and ask what would come with corners set by hand and with
//! those of the library; then take the latter.
//!
//!     cargo run --example corners -- ../../examples/data/coast_small.msh [after.svg]
use alphamst::{Context, FaceId, Mesh, PatchId, Patches};
use std::{env, error::Error, process};

/// Faces whose centroid is in the ellipse around (4.9, 5.3).
fn choose(mesh: &Mesh) -> Result<Vec<FaceId>, alphamst::Error> {
    let points = mesh.points::<2>()?;
    let is_inside = |corners: [alphamst::VertexId; 4]| {
        let centroid = |c: usize| {
            corners
                .iter()
                .map(|v| points[v.index()][c] / 4.0)
                .sum::<f64>()
        };
        let (x, y) = (centroid(0), centroid(1));
        (x - 4.9) * (x - 4.9) / 1.2 + (y - 5.3) * (y - 5.3) / 0.7 < 1.0
    };
    let faces = (0..).map(FaceId::new).zip(mesh.faces());
    Ok(faces
        .filter(|(_, corners)| is_inside(*corners))
        .map(|(face, _)| face)
        .collect())
}

/// Four boundary vertices, a quarter of the boundary from one to the next.
fn set_corners(patches: &mut Patches, patch: PatchId) -> Result<(), alphamst::Error> {
    let boundary = patches.patch(patch)?.boundary()?;
    let corners = [0, 1, 2, 3].map(|k| boundary[k * boundary.len() / 4]);
    patches.set_corners(patch, &corners)
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = env::args().collect();
    if arguments.len() < 2 {
        eprintln!("usage: corners MESH [PICTURE]");
        process::exit(2);
    }
    let mut mesh = Mesh::read(&Context::new(), &arguments[1], None)?;
    let chosen = choose(&mesh)?;
    let mut patches = Patches::new(&mesh, None);
    let patch = patches.add_faces(&chosen)?;
    let (defects, convexity) = patches.patch(patch)?.check()?;
    println!(
        "{} faces chosen, defects {}, convexity {convexity:.3}",
        chosen.len(),
        defects.bits()
    );

    println!(
        "{:>5} {:>6} {:>18} {:>18}",
        "alpha", "faces", "singular, by hand", "by the library"
    );
    for alpha in [0.75, 1.0, 1.5, 2.0] {
        set_corners(&mut patches, patch)?;
        let by_hand = patches.patch(patch)?.predict(alpha, None)?;
        patches.set_corners(patch, &[])?;
        let by_library = patches.patch(patch)?.predict(alpha, None)?;
        println!(
            "{alpha:>5.2} {:>6} {:>18} {:>18}",
            by_library.faces, by_hand.singularities, by_library.singularities
        );
    }
    let report = mesh.adapt(&mut patches, 1.5, None)?;
    let done = report.patch(patch)?;
    println!(
        "{:>5} {:>6} {:>18} {:>18}",
        "done",
        done.faces_after(),
        "",
        done.singular_after()
    );
    if let Some(picture) = arguments.get(2) {
        patches.write(picture)?;
    }
    Ok(())
}

// An outside program in Rust.
use alphamst::{Context, Mesh, Patches};

fn main() -> Result<(), alphamst::Error> {
    let n = 8;
    let mut points = Vec::new();
    let mut faces = Vec::new();
    for j in 0..=n {
        for i in 0..=n {
            points.push([f64::from(i), f64::from(j)]);
        }
    }
    for j in 0..n {
        for i in 0..n {
            let v = j * (n + 1) + i;
            faces.push([v, v + 1, v + n + 2, v + n + 1]);
        }
    }
    let mut mesh = Mesh::new(&Context::new(), &points, &faces)?;
    let mut patches = Patches::new(&mesh, None);
    patches.add_ball([4.0, 4.0, 0.0], 2.5)?;
    let _ = mesh.adapt(&mut patches, 2.0, None)?;
    mesh.check()?;
    println!("{} faces", mesh.n_faces());
    assert!(mesh.n_faces() > faces.len(), "the mesh is no finer");
    Ok(())
}

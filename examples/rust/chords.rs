//! Chords: those of a plate with a hole in colour; two rings more around the hole, and one less.
//!
//!     cargo run --example chords -- ../../examples/data/plate.off [chords_]
use alphamst::{Carry, ChordProperty, Context, EdgeId, Entity, Mesh};
use std::{env, error::Error, process};

/// An edge of the shortest closed chord, and how many of them there are.
fn ring(mesh: &Mesh) -> (Option<EdgeId>, usize) {
    let lengths = mesh.chords(ChordProperty::Length, None);
    let closed = mesh.chords(ChordProperty::Closed, None);
    let rings = (0..lengths.len()).filter(|&i| closed[i] == 1);
    let shortest = rings.clone().min_by_key(|&i| lengths[i]);
    let edges = mesh.chords(ChordProperty::Edge, None);
    (
        shortest.map(|i| EdgeId::new(edges[i] as i32)),
        rings.count(),
    )
}

/// A row of the table and, if there is a prefix, a picture with the chords in colour.
fn show(
    what: &str,
    mesh: &mut Mesh,
    prefix: Option<&str>,
    name: &str,
) -> Result<(), alphamst::Error> {
    let (ids, n_chords) = mesh.chord_ids();
    let (_, n_closed) = ring(mesh);
    let (faces, singular) = (mesh.n_faces(), mesh.singularities().len());
    println!("{what:<16} {faces:>6} {singular:>9} {n_chords:>7} {n_closed:>7}");
    if let Some(prefix) = prefix {
        let colours: Vec<f64> = ids.into_iter().map(f64::from).collect();
        mesh.set_field(Entity::Edge, "chord", 1, Carry::Drop, &colours)?;
        mesh.write(format!("{prefix}{name}.svg"))?;
    }
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let Some(path) = env::args().nth(1) else {
        eprintln!("usage: chords MESH [PREFIX]");
        process::exit(2);
    };
    let prefix = env::args().nth(2);
    let prefix = prefix.as_deref();
    let mut mesh = Mesh::read(&Context::new(), path, None)?;
    println!(
        "{:<16} {:>6} {:>9} {:>7} {:>7}",
        "mesh", "faces", "singular", "chords", "closed"
    );
    show("read", &mut mesh, prefix, "read")?;
    let edge = ring(&mesh).0.ok_or("no closed chord")?;
    let _ = mesh.split_chord(edge, 2, None)?;
    show("two rings in", &mut mesh, prefix, "in")?;
    let edge = ring(&mesh).0.ok_or("no closed chord")?;
    let _ = mesh.collapse_chord(edge, None)?;
    show("one ring out", &mut mesh, prefix, "out")?;
    Ok(())
}

//! Meshes that the tests share.
#![allow(dead_code)] // every test program uses its own part

use alphamst::{Context, FaceId, Mesh, PatchId, Patches, VertexId};

/// Vertex (i, j) has number j * (nx + 1) + i and lies there.
pub fn points(nx: i32, ny: i32) -> Vec<[f64; 2]> {
    (0..(nx + 1) * (ny + 1)).map(|v| [f64::from(v % (nx + 1)), f64::from(v / (nx + 1))]).collect()
}

/// Face (i, j) has number j * nx + i.
pub fn faces(nx: i32, ny: i32) -> Vec<[i32; 4]> {
    (0..nx * ny).map(|f| f + f / nx).map(|v| [v, v + 1, v + nx + 2, v + nx + 1]).collect()
}

pub fn mesh(context: &Context, nx: i32, ny: i32) -> Mesh {
    Mesh::new(context, &points(nx, ny), &faces(nx, ny)).unwrap()
}

/// The faces (i, j) with low <= i, j < high of a grid of nx columns.
pub fn square(nx: i32, low: i32, high: i32) -> Vec<FaceId> {
    (low..high).flat_map(|j| (low..high).map(move |i| FaceId::new(j * nx + i))).collect()
}

/// A grid of n x n faces with one patch: the square from low to high.
pub fn patched(context: &Context, n: i32, low: i32, high: i32) -> (Mesh, Patches) {
    let mesh = mesh(context, n, n);
    let mut patches = Patches::new(&mesh, None);
    assert_eq!(patches.add_faces(&square(n, low, high)), Ok(PatchId::new(0)));
    (mesh, patches)
}

pub fn vertices<const N: usize>(ids: [i32; N]) -> [VertexId; N] {
    ids.map(VertexId::new)
}

/// A file name of this test's own.
pub fn path(name: &str) -> std::path::PathBuf {
    std::env::temp_dir().join(format!("alphamst_{}_{name}", std::process::id()))
}

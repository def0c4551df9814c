//! What a solver needs of faces and edges.
mod grid;

use alphamst::{Context, FaceId, Status};

#[test]
fn normals_point_out_of_the_first_face() {
    let mesh = grid::mesh(&Context::new(), 4, 4);
    let (points, edges, centroids) =
        (mesh.points::<2>().unwrap(), mesh.edges(), mesh.centroids::<2>().unwrap());
    let normals = mesh.normals::<2>().unwrap();
    assert!(mesh.lengths().iter().all(|&length| length == 1.0));
    for ((edge, sides), normal) in edges.iter().zip(mesh.edge_faces()).zip(normals) {
        let [v, w] = edge.map(|vertex| points[vertex.index()]);
        let from = centroids[sides[0].expect("a face inside").index()];
        let out: f64 = (0..2).map(|c| normal[c] * ((v[c] + w[c]) / 2.0 - from[c])).sum();
        assert_eq!(out, 0.5);
    }
    assert_eq!(mesh.centroids::<3>().unwrap_err().status, Status::Argument);
}

#[test]
fn faces_are_around_their_vertices() {
    let mesh = grid::mesh(&Context::new(), 4, 4);
    let (offsets, around) = mesh.vertex_faces();
    assert_eq!((offsets.len(), around.len(), offsets[25]), (26, 64, 64));
    assert_eq!(around[offsets[0]..offsets[1]], [FaceId::new(0)]);
    let faces = mesh.faces();
    for v in 0..25 {
        for face in &around[offsets[v]..offsets[v + 1]] {
            assert!(faces[face.index()].iter().any(|corner| corner.index() == v));
        }
    }
}

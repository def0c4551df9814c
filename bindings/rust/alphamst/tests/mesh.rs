//! Making meshes and asking them.
mod grid;

use alphamst::*;
use grid::vertices;

#[test]
fn counts_tell_the_entities_apart() {
    let mesh = grid::mesh(&Context::new(), 3, 2);
    assert_eq!((mesh.n_vertices(), mesh.n_edges(), mesh.n_faces()), (12, 17, 6));
    let counts = [Entity::Vertex, Entity::Edge, Entity::Face].map(|entity| mesh.count(entity));
    assert_eq!(counts, [12, 17, 6]);
    assert_eq!((mesh.dim(), mesh.revision()), (2, 0));
    assert!(format!("{mesh:?}").contains("n_faces: 6"));
}

#[test]
fn ids_count_from_0_and_arrays_come_back() {
    let mesh = grid::mesh(&Context::new(), 3, 2);
    assert_eq!(mesh.points::<2>().unwrap(), grid::points(3, 2));
    assert_eq!(mesh.faces(), grid::faces(3, 2).iter().map(|&f| vertices(f)).collect::<Vec<_>>());
    assert_eq!(mesh.valences(), [2, 3, 3, 2, 3, 4, 4, 3, 2, 3, 3, 2]);
}

#[test]
fn points_have_the_components_asked_for() {
    let context = Context::new();
    let flat = grid::mesh(&context, 2, 1);
    let lifted = flat.points::<3>().unwrap();
    assert_eq!(lifted[4], [1.0, 1.0, 0.0]);
    assert_eq!(flat.points::<4>().unwrap_err().status, Status::Argument);
    let deep = Mesh::new(
        &context,
        &lifted.iter().map(|[x, y, _]| [*x, *y, x * y]).collect::<Vec<_>>(),
        &grid::faces(2, 1),
    );
    let mut deep = deep.unwrap();
    assert_eq!(deep.dim(), 3);
    assert_eq!(deep.points::<3>().unwrap()[5], [2.0, 1.0, 2.0]);
    assert_eq!(deep.points::<2>().unwrap_err().status, Status::Argument);
    assert_eq!(deep.set_points(&[[0.0, 0.0]; 6]).unwrap_err().status, Status::Argument);
    deep.set_points(&lifted).unwrap();
    assert_eq!(deep.points::<3>().unwrap(), lifted);
}

#[test]
fn arrays_go_into_slices() {
    let mesh = grid::mesh(&Context::new(), 2, 1);
    let mut numbers = [9.0; 14];
    assert_eq!(mesh.points_into(&mut numbers), Ok(12));
    assert_eq!(numbers, [0., 0., 1., 0., 2., 0., 0., 1., 1., 1., 2., 1., 9., 9.]);
    let mut short = [9.0; 11];
    assert_eq!(mesh.points_into(&mut short).unwrap_err().status, Status::BufferTooSmall);
    assert_eq!(short, [9.0; 11]);
    let mut faces = [vertices([9; 4]); 3];
    assert_eq!(mesh.faces_into(&mut faces), Ok(2));
    assert_eq!(faces, [vertices([0, 1, 4, 3]), vertices([1, 2, 5, 4]), vertices([9; 4])]);
    assert_eq!(mesh.faces_into(&mut faces[..1]).unwrap_err().status, Status::BufferTooSmall);
}

#[test]
fn new_points_are_taken_whole_or_not() {
    let mut mesh = grid::mesh(&Context::new(), 2, 2);
    let mut points = grid::points(2, 2);
    points[4] = [1.25, 0.75];
    mesh.set_points(&points).unwrap();
    assert_eq!(mesh.points::<2>().unwrap(), points);
    let digest = mesh.checksum();
    assert_eq!(mesh.set_points(&points[1..]).unwrap_err().status, Status::Range);
    points[7] = [0.0, f64::INFINITY];
    let error = mesh.set_points(&points).unwrap_err();
    assert_eq!((error.status, error.place), (Status::NotFinite, Some(Place::Vertex(VertexId::new(7)))));
    assert_eq!(mesh.checksum(), digest);
}

#[test]
fn edges_have_vertices_and_faces() {
    let mesh = grid::mesh(&Context::new(), 2, 1);
    let (edges, sides) = (mesh.edges(), mesh.edge_faces());
    assert_eq!((edges.len(), sides.len()), (7, 7));
    let edge = |a, b| mesh.find_edges(&[vertices([a, b])]).unwrap()[0];
    let face = |f| Some(FaceId::new(f));
    let middle = edge(1, 4).unwrap().index();
    assert_eq!(edges[middle], vertices([1, 4]));
    assert_eq!(sides[middle], [face(0), face(1)]); // left and right of the way up
    let left = edge(3, 0).unwrap().index();
    assert_eq!((edges[left], sides[left]), (vertices([0, 3]), [face(0), None])); // though it is at the right
    assert_eq!(edge(0, 4), None);
    assert_eq!(mesh.find_edges(&[]), Ok(vec![]));
    let error = mesh.find_edges(&[vertices([0, 6])]).unwrap_err();
    assert_eq!((error.status, error.place), (Status::Range, Some(Place::Vertex(VertexId::new(6)))));
    for (e, pair) in edges.iter().enumerate() {
        assert_eq!(mesh.find_edges(&[*pair]).unwrap()[0].unwrap().index(), e);
    }
}

#[test]
fn singularities_are_interior_and_ascending() {
    let context = Context::new();
    // Three quads around a vertex.
    let points = [[0., 0.], [2., 0.], [2., 2.], [0., 2.], [-2., 1.], [-2., -2.], [1., -2.]];
    let faces = [[0, 1, 2, 3], [0, 3, 4, 5], [0, 5, 6, 1]];
    let mesh = Mesh::new(&context, &points, &faces).unwrap();
    assert_eq!(mesh.singularities().collect::<Vec<_>>(), vertices([0]));
    assert_eq!(grid::mesh(&context, 4, 4).singularities().len(), 0);
}

#[test]
fn corners_may_be_32_and_64_bits_wide() {
    let context = Context::new();
    let points = grid::points(3, 2);
    let narrow = grid::mesh(&context, 3, 2);
    let wide: Vec<[i64; 4]> = grid::faces(3, 2).iter().map(|face| face.map(i64::from)).collect();
    assert_eq!(Mesh::new(&context, &points, &wide).unwrap().checksum(), narrow.checksum());
    assert_eq!(Mesh::new(&context, &points, &narrow.faces()).unwrap().checksum(), narrow.checksum());
    let error = Mesh::new(&context, &points, &[[0, 1, 5, 4 + (1_i64 << 32)]]).unwrap_err();
    assert_eq!(error.status, Status::Range);
}

#[test]
fn strided_arrays_are_read_in_place() {
    let context = Context::new();
    let packed = grid::mesh(&context, 3, 2);
    let (points, faces) = (grid::points(3, 2), grid::faces(3, 2));
    let (n, m) = (points.len(), faces.len());
    let mut columns = vec![0.0; 2 * n];
    for (v, [x, y]) in points.iter().enumerate() {
        (columns[v], columns[n + v]) = (*x, *y);
    }
    let mut padded = vec![-7_i64; 5 * m];
    for (f, face) in faces.iter().enumerate() {
        for (k, corner) in face.iter().enumerate() {
            padded[5 * f + k] = (*corner).into();
        }
    }
    let by_column = Strided::new(&columns, n, 2, 1, n).unwrap();
    let by_row = Strided::new(&padded, m, 4, 5, 1).unwrap();
    let mesh = Mesh::from_strided(&context, by_column, by_row, &Options::new()).unwrap();
    assert_eq!(mesh.checksum(), packed.checksum());
    let narrow: Vec<i32> = padded.iter().map(|&corner| corner as i32).collect();
    let by_row = Strided::new(&narrow, m, 4, 5, 1).unwrap();
    let mesh = Mesh::from_strided(&context, by_column, by_row, None).unwrap();
    assert_eq!(mesh.checksum(), packed.checksum());

    let pairs = Strided::packed(&[0, 1, 1, 0], 2).unwrap();
    assert_eq!(Mesh::from_strided(&context, by_column, pairs, None).unwrap_err().status, Status::Argument);
    assert_eq!(Mesh::new(&context, &[[0.0; 5]; 4], &[[0, 1, 2, 3]]).unwrap_err().status, Status::Argument);
    assert_eq!(Mesh::new(&context, &[[0.0; 0]; 4], &[[0, 1, 2, 3]]).unwrap_err().status, Status::Argument);
}

#[test]
fn triangles_become_quads() {
    let context = Context::new();
    let points = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [2.0, 0.0], [2.0, 1.0]];
    let triangles = [[0, 1, 2], [0, 2, 3], [1, 4, 5], [1, 5, 2]];
    let mesh = Mesh::new(&context, &points, &triangles).unwrap();
    assert_eq!((mesh.n_vertices(), mesh.n_faces()), (6, 2));
    assert_eq!(mesh.points::<2>().unwrap(), points);
    let mixed = [[0_i64, 1, 2, 3], [1, 4, 5, -1], [1, 5, 2, -1]];
    assert_eq!(Mesh::new(&context, &points, &mixed).unwrap().n_faces(), 2);
    let split = Options::new().quadrangulate(1).unwrap();
    let rows = Strided::packed(triangles.as_flattened(), 3).unwrap();
    let coords = Strided::packed(points.as_flattened(), 2).unwrap();
    let mesh = Mesh::from_strided(&context, coords, rows, &split).unwrap();
    assert_eq!((mesh.n_vertices(), mesh.n_faces()), (6 + 9 + 4, 12));
}

#[test]
fn strides_stay_inside_the_slice() {
    let data = [0; 24];
    assert!(Strided::new(&data, 6, 4, 4, 1).is_ok());
    assert!(Strided::new(&data, 6, 4, 1, 6).is_ok());
    assert!(Strided::new(&data[..23], 6, 4, 4, 1).is_err());
    assert!(Strided::new(&data[..23], 5, 4, 5, 1).is_err());
    assert!(Strided::new(&data, 2, 2, usize::MAX, 1).is_err());
    assert!(Strided::new(&data, 2, 2, usize::MAX - 1, 2).is_err());
    assert!(Strided::new(&data, usize::MAX, 4, 4, 1).is_err());
    assert!(Strided::new(&data, 6, 4, 0, 1).is_err());
    assert!(Strided::new(&data, 6, 4, 4, 0).is_err());
    assert!(Strided::new(&data[..0], 0, 4, 4, 1).is_ok());
    assert!(Strided::packed(&data, 0).is_err());
    assert!(Strided::packed(&data, 5).is_err());
}

#[test]
fn bad_meshes_are_refused() {
    let context = Context::new();
    let square = [[0., 0.], [1., 0.], [1., 1.], [0., 1.]];
    let status =
        |points: &[[f64; 2]], faces: &[[i32; 4]]| Mesh::new(&context, points, faces).unwrap_err().status;
    assert_eq!(status(&square, &[]), Status::Range);
    assert_eq!(status(&[], &[[0, 1, 2, 3]]), Status::Range);
    assert_eq!(status(&square, &[[0, 1, 2, 2]]), Status::NotQuad);
    assert_eq!(status(&[[f64::NAN, 0.], [1., 0.], [1., 1.], [0., 1.]], &[[0, 1, 2, 3]]), Status::NotFinite);
    let fan = [[0., 0.], [0., 1.], [1., 1.], [1., 0.], [-1., 1.], [-1., 0.], [2., 1.], [2., 0.]];
    let faces = [[0, 3, 2, 1], [0, 1, 4, 5], [1, 0, 7, 6]];
    assert_eq!(status(&fan, &faces), Status::NotManifold);
}

#[test]
fn check_names_the_fault() {
    let mut mesh = grid::mesh(&Context::new(), 3, 3);
    mesh.check().unwrap();
    let mut points = grid::points(3, 3);
    points[15] = [-9.0, -9.0]; // a corner of the last face only
    mesh.set_points(&points).unwrap();
    assert_eq!(mesh.check().unwrap_err().place, Some(Place::Face(FaceId::new(8))));
}

#[test]
fn clones_are_meshes_of_their_own() {
    let context = Context::new();
    let mut mesh = grid::mesh(&context, 3, 3);
    mesh.set_flags(&[VertexId::new(5)], Flags::FIXED, Flags::FIXED).unwrap();
    let revision = mesh.mark().unwrap();
    let mut copy = mesh.clone();
    assert_eq!((copy.checksum(), copy.revision()), (mesh.checksum(), mesh.revision()));
    assert_eq!(copy.rollback(revision).unwrap_err().status, Status::NotFound);
    copy.set_all_flags(Entity::Vertex, Flags::FIXED, Flags::NONE).unwrap();
    assert_ne!(copy.checksum(), mesh.checksum());
}

#[test]
fn files_come_back() {
    let context = Context::new();
    let mesh = grid::mesh(&context, 4, 3);
    for name in ["mesh.off", "mesh.obj", "mesh.ply", "mesh.msh", "mesh.vtk", "mesh.vtu", "mesh.amst"] {
        let path = grid::path(name);
        mesh.write(&path).unwrap();
        let again = Mesh::read(&context, &path, &Options::new()).unwrap();
        assert_eq!((again.dim(), again.n_faces()), (2, 12), "{name}");
        assert_eq!(again.points::<2>().unwrap(), grid::points(4, 3), "{name}");
        std::fs::remove_file(path).unwrap();
    }
    assert_eq!(mesh.write("mesh.xyz").unwrap_err().status, Status::Unsupported);
    assert_eq!(mesh.write(grid::path("no folder/mesh.off")).unwrap_err().status, Status::Io);
    assert_eq!(mesh.write("zero\0byte.off").unwrap_err().status, Status::Argument);
    let path = grid::path("bad.off");
    std::fs::write(&path, "OFF\nthree points\n").unwrap();
    assert_eq!(Mesh::read(&context, &path, None).unwrap_err().status, Status::Format);
    std::fs::remove_file(path).unwrap();
}

#[cfg(unix)]
#[test]
fn paths_are_utf8() {
    use std::os::unix::ffi::OsStrExt;
    let path = std::path::Path::new(std::ffi::OsStr::from_bytes(b"\xff.off"));
    assert_eq!(Mesh::read(&Context::new(), path, None).unwrap_err().status, Status::Argument);
}

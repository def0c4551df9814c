//! The triangles that a curved mesh keeps to.
mod grid;

use alphamst::*;

const CORNERS: [[f64; 2]; 4] = [[0.0, 0.0], [3.0, 0.0], [3.0, 3.0], [0.0, 3.0]];

#[test]
fn a_surface_is_no_change_of_the_mesh() {
    let mut mesh = grid::mesh(&Context::new(), 3, 3);
    let digest = mesh.checksum();
    mesh.set_surface_to_mesh().unwrap();
    mesh.set_surface(&CORNERS, &[[0, 1, 2], [0, 2, 3]]).unwrap();
    assert_eq!((mesh.checksum(), mesh.revision()), (digest, 0));
    assert_eq!(mesh.clone().checksum(), digest);
}

#[test]
fn bad_triangles_are_named() {
    let mut mesh = grid::mesh(&Context::new(), 3, 3);
    let error = mesh.set_surface(&CORNERS, &[[0, 1, 2], [0, 2, 4]]).unwrap_err();
    assert_eq!((error.status, error.place), (Status::Range, None));
    assert!(error.message.contains("triangle 1 of the surface has corner 4"), "{error}");
    assert_eq!(mesh.set_surface(&CORNERS, &[[0, -1, 2]]).unwrap_err().status, Status::Range);
    assert_eq!(mesh.set_surface(&CORNERS, &[]).unwrap_err().status, Status::Range);
    let none: [[f64; 2]; 0] = []; // none, not the mesh
    assert_eq!(mesh.set_surface(&none, &[[0, 1, 2]]).unwrap_err().status, Status::Range);
    let infinite = [[0.0, f64::NAN], [3.0, 0.0], [3.0, 3.0]];
    assert_eq!(mesh.set_surface(&infinite, &[[0, 1, 2]]).unwrap_err().status, Status::NotFinite);
    assert_eq!(mesh.set_surface(&[[0.0; 3]; 3], &[[0, 1, 2]]).unwrap_err().status, Status::Argument);
}

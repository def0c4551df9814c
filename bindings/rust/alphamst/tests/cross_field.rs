//! The cross field of a mesh.
mod grid;

use alphamst::*;

#[test]
fn it_follows_the_boundary() {
    let mut mesh = grid::mesh(&Context::new(), 4, 3);
    assert_eq!(mesh.alignment().unwrap_err().status, Status::NotFound);
    mesh.compute_cross_field(None).unwrap();
    assert!(mesh.alignment().unwrap() < 1e-9);
    let cross = mesh.field(Entity::Face, "cross").unwrap();
    assert_eq!(cross.len(), 36);
    for direction in cross.chunks(3) {
        let largest = direction.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        assert!((largest - 1.0).abs() < 1e-12, "{direction:?}"); // along x or y
    }
    let options = Options::new().smooth_steps(0).unwrap();
    mesh.compute_cross_field(&options).unwrap();
    assert!(mesh.alignment().unwrap() < 1e-9);
    assert_eq!(mesh.revision(), 0);
}

#[test]
fn it_can_be_given() {
    let mut mesh = grid::mesh(&Context::new(), 2, 2);
    let (sin, cos) = 30_f64.to_radians().sin_cos();
    mesh.set_field(Entity::Face, "cross", 3, Carry::Inherit, &[cos, sin, 0.0].repeat(4)).unwrap();
    assert!((mesh.alignment().unwrap() - 30.0).abs() < 1e-9);
    let mut status = |entity, components, values: &[f64]| {
        mesh.set_field(entity, "cross", components, Carry::Inherit, values).unwrap_err().status
    };
    assert_eq!(status(Entity::Face, 1, &[1.0; 4]), Status::Range);
    assert_eq!(status(Entity::Edge, 3, &[1.0; 36]), Status::Argument);
    assert!((mesh.alignment().unwrap() - 30.0).abs() < 1e-9);
}

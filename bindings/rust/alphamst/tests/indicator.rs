//! Sizes from an error.
mod grid;

use alphamst::{Context, Entity, Options, Status};

#[test]
fn sizes_follow_the_indicator() {
    let mut mesh = grid::mesh(&Context::new(), 4, 4);
    let asked = mesh.size_from_indicator(&[1.0; 16], 0.0, 64, None).unwrap();
    assert!((asked - 64.0).abs() < 0.1);
    let sizes = mesh.field(Entity::Vertex, "size").unwrap();
    assert!(sizes.iter().all(|size| (size - 0.5).abs() < 1e-3));
    let options = Options::new().error_order(2.0).unwrap().min_edge(1.0).unwrap();
    assert_eq!(mesh.size_from_indicator(&[1.0; 16], 0.25, 0, Some(&options)), Ok(16.0));
    let limited = mesh.size_from_indicator(&[1.0; 16], 0.25, 32, None).unwrap();
    assert!((limited - 32.0).abs() < 0.1);
    assert_eq!(mesh.size_from_indicator(&[1.0; 16], 0.0, 0, None).unwrap_err().status, Status::Range);
}

//! Fields of vertices, edges and faces.
mod grid;

use alphamst::*;

const ENTITIES: [Entity; 3] = [Entity::Vertex, Entity::Edge, Entity::Face];

#[test]
fn each_entity_has_fields_of_its_own() {
    let mut mesh = grid::mesh(&Context::new(), 3, 2);
    for entity in ENTITIES {
        let n = mesh.count(entity);
        let values: Vec<f64> = (0..2 * n).map(|i| i as f64 + 0.5).collect();
        mesh.set_field(entity, "höhe", 2, Carry::Inherit, &values).unwrap();
        assert_eq!(mesh.field(entity, "höhe").unwrap(), values);
        mesh.set_field(entity, "höhe", 1, Carry::Drop, &values[..n]).unwrap();
        assert_eq!(mesh.field(entity, "höhe").unwrap(), values[..n]);
        let mut out = [-1.0; 30];
        assert_eq!(mesh.field_into(entity, "höhe", &mut out), Ok(n));
        assert_eq!((&out[..n], out[n]), (&values[..n], -1.0));
        let short = mesh.field_into(entity, "höhe", &mut out[..n - 1]).unwrap_err();
        assert_eq!(short.status, Status::BufferTooSmall);
        assert_eq!(mesh.clone().field(entity, "höhe").unwrap(), values[..n]);
    }
    mesh.remove_field(Entity::Edge, "höhe").unwrap();
    for entity in ENTITIES {
        let kept = entity != Entity::Edge;
        assert_eq!(mesh.field(entity, "höhe").is_ok(), kept);
    }
    assert_eq!(mesh.revision(), 0);
}

#[test]
fn an_operation_carries_them() {
    let (mut mesh, mut patches) = grid::patched(&Context::new(), 10, 2, 8);
    let linear =
        |points: Vec<[f64; 2]>| -> Vec<f64> { points.into_iter().map(|[x, y]| 2.0 + x - 3.0 * y).collect() };
    let mass: Vec<f64> = (0..100).map(|f| f64::from(f).sin()).collect();
    let number: Vec<f64> = (0..100).map(f64::from).collect();
    let sum = |mesh: &Mesh| -> f64 {
        let areas = mesh.quality(Metric::Area);
        mesh.field(Entity::Face, "mass").unwrap().iter().zip(areas).map(|(value, area)| value * area).sum()
    };
    let before = linear(mesh.points().unwrap());
    mesh.set_field(Entity::Vertex, "linear", 1, Carry::Linear, &before).unwrap();
    mesh.set_field(Entity::Face, "mass", 1, Carry::Conserve, &mass).unwrap();
    mesh.set_field(Entity::Face, "number", 1, Carry::Inherit, &number).unwrap();
    mesh.set_field(Entity::Edge, "gone", 1, Carry::Drop, &[1.0; 220]).unwrap();
    let whole = sum(&mesh);
    let start = mesh.mark().unwrap();
    let report = mesh.adapt(&mut patches, 2.0, None).unwrap();
    let wanted = linear(mesh.points().unwrap());
    let found = mesh.field(Entity::Vertex, "linear").unwrap();
    assert!(found.iter().zip(&wanted).all(|(a, b)| (a - b).abs() < 1e-12));
    assert!((sum(&mesh) - whole).abs() < 1e-12);
    let numbers = mesh.field(Entity::Face, "number").unwrap();
    assert_eq!(numbers.len(), mesh.n_faces());
    for (origin, number) in report.face_origins().iter().zip(numbers) {
        assert!(origin.map_or(true, |face| face.index() as f64 == number));
    }
    assert_eq!(mesh.field(Entity::Edge, "gone").unwrap_err().status, Status::NotFound);
    mesh.rollback(start).unwrap();
    assert_eq!(mesh.field(Entity::Vertex, "linear").unwrap(), before);
    assert_eq!(mesh.field(Entity::Edge, "gone").unwrap(), [1.0; 220]);
}

#[test]
fn means_keep_their_range_on_faces_and_vertices() {
    let (mut mesh, mut patches) = grid::patched(&Context::new(), 10, 2, 8);
    let values: Vec<f64> = (0..121).map(|i| f64::from(i).sin()).collect();
    for (entity, n) in [(Entity::Face, 100), (Entity::Vertex, 121)] {
        mesh.set_field(entity, "linear", 1, Carry::Conserve, &values[..n]).unwrap();
        mesh.set_field(entity, "constant", 1, Carry::Average, &values[..n]).unwrap();
    }
    let _ = mesh.adapt(&mut patches, 2.0, None).unwrap();
    for entity in [Entity::Face, Entity::Vertex] {
        let linear = mesh.field(entity, "linear").unwrap();
        let constant = mesh.field(entity, "constant").unwrap();
        assert_ne!(linear, constant);
        assert!(linear.iter().chain(&constant).all(|value| value.abs() <= 1.0));
    }
}

#[test]
fn rows_of_overlaps_sum_up_to_areas() {
    let (mut mesh, mut patches) = grid::patched(&Context::new(), 10, 2, 8);
    let old = mesh.clone();
    let _ = mesh.adapt(&mut patches, 2.0, None).unwrap();
    let elsewhere = grid::mesh(&Context::new(), 10, 10); // of another context
    for before in [&old, &elsewhere] {
        let rows = before.overlap(&mesh).unwrap();
        assert!(rows
            .windows(2)
            .all(|pair| (pair[0].after, pair[0].before) < (pair[1].after, pair[1].before)));
        let mut sums = vec![0.0; mesh.n_faces()];
        rows.iter().for_each(|row| sums[row.after.index()] += row.area);
        assert!(sums.iter().zip(mesh.quality(Metric::Area)).all(|(sum, area)| (sum - area).abs() < 1e-12));
    }
    let space = [[0., 0., 0.], [1., 0., 0.], [1., 1., 1.], [0., 1., 1.]];
    let curved = Mesh::new(&Context::new(), &space, &[[0, 1, 2, 3]]).unwrap();
    assert_eq!(mesh.overlap(&curved).unwrap_err().status, Status::Argument);
}

#[test]
fn refusals_change_nothing() {
    let mut mesh = grid::mesh(&Context::new(), 2, 2);
    let mut refusal = |entity, name: &str, components, carry, values: &[f64]| {
        mesh.set_field(entity, name, components, carry, values).unwrap_err()
    };
    let status = |error: Error| error.status;
    assert_eq!(status(refusal(Entity::Face, "", 1, Carry::Drop, &[1.0; 4])), Status::Argument);
    assert_eq!(status(refusal(Entity::Face, "a\0b", 1, Carry::Drop, &[1.0; 4])), Status::Argument);
    assert_eq!(status(refusal(Entity::Face, "a", 0, Carry::Drop, &[])), Status::Range);
    assert_eq!(status(refusal(Entity::Face, "a", 1, Carry::Drop, &[1.0; 5])), Status::Range);
    assert_eq!(status(refusal(Entity::Face, "a", 2, Carry::Drop, &[1.0; 7])), Status::Argument);
    assert_eq!(status(refusal(Entity::Face, "a", 1, Carry::Linear, &[1.0; 4])), Status::Argument);
    assert_eq!(status(refusal(Entity::Edge, "a", 1, Carry::Conserve, &[1.0; 12])), Status::Argument);
    assert_eq!(status(refusal(Entity::Face, "a", 1, Carry::Drop, &[f64::NAN; 4])), Status::NotFinite);
    assert_eq!(status(refusal(Entity::Face, "size", 1, Carry::Drop, &[1.0; 4])), Status::Argument);
    let error = refusal(Entity::Vertex, "size", 1, Carry::Linear, &[1., 1., 1., 1., 0., 1., 1., 1., 1.]);
    assert_eq!((error.status, error.place), (Status::Range, Some(Place::Vertex(VertexId::new(4)))));
    assert_eq!(mesh.field(Entity::Face, "a").unwrap_err().status, Status::NotFound);
    assert_eq!(mesh.remove_field(Entity::Face, "a").unwrap_err().status, Status::NotFound);
}

#[test]
fn carries_are_numbers_of_the_header() {
    assert_eq!(Carry::try_from(3), Ok(Carry::Conserve));
    assert_eq!(Carry::try_from(4), Ok(Carry::Average));
    assert_eq!(Carry::try_from(5), Err(UnknownValue(5)));
    assert_eq!(i32::from(Carry::Linear), 2);
}

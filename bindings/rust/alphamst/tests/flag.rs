//! Flags of vertices, edges and faces.
mod grid;

use alphamst::*;

#[test]
fn each_entity_has_flags_of_its_own() {
    let mut mesh = grid::mesh(&Context::new(), 3, 2);
    mesh.set_flags(&[VertexId::new(1), VertexId::new(11)], Flags::FIXED, Flags::FIXED).unwrap();
    mesh.set_flags(&[EdgeId::new(2)], Flags::FEATURE, Flags::FEATURE).unwrap();
    let both = Flags::CORNER | Flags::FIXED;
    mesh.set_flags(&[FaceId::new(3)], both, both).unwrap();
    let set = |entity| -> Vec<(usize, i32)> {
        let flags = mesh.flags(entity);
        assert_eq!(flags.len(), mesh.count(entity));
        flags.iter().map(|flags| flags.bits()).enumerate().filter(|(_, bits)| *bits != 0).collect()
    };
    assert_eq!(set(Entity::Vertex), [(1, 1), (11, 1)]);
    assert_eq!(set(Entity::Edge), [(2, 2)]);
    assert_eq!(set(Entity::Face), [(3, 5)]);
    assert_eq!(mesh.revision(), 0);
}

#[test]
fn only_the_bits_of_the_mask_are_set() {
    let mut mesh = grid::mesh(&Context::new(), 2, 2);
    let face = [FaceId::new(1)];
    mesh.set_flags(&face, Flags::FIXED | Flags::FEATURE, Flags::FIXED).unwrap();
    mesh.set_flags(&face, Flags::CORNER, Flags::CORNER | Flags::FEATURE).unwrap();
    assert_eq!(mesh.flags(Entity::Face)[1], Flags::FIXED | Flags::CORNER);
    mesh.set_flags(&face, Flags::FIXED, Flags::NONE).unwrap();
    assert_eq!(mesh.flags(Entity::Face)[1], Flags::CORNER);
}

#[test]
fn no_ids_are_none_and_not_all() {
    let mut mesh = grid::mesh(&Context::new(), 2, 2);
    mesh.set_flags::<VertexId>(&[], Flags::FIXED, Flags::FIXED).unwrap();
    assert!(mesh.flags(Entity::Vertex).iter().all(|flags| flags.is_empty()));
    mesh.set_all_flags(Entity::Vertex, Flags::FIXED, Flags::FIXED).unwrap();
    assert!(mesh.flags(Entity::Vertex).iter().all(|flags| *flags == Flags::FIXED));
    assert!(mesh.flags(Entity::Edge).iter().all(|flags| flags.is_empty()));
}

#[test]
fn refusals_change_nothing() {
    let mut mesh = grid::mesh(&Context::new(), 2, 2);
    let digest = mesh.checksum();
    let ids = [FaceId::new(0), FaceId::new(4)];
    let error = mesh.set_flags(&ids, Flags::FIXED, Flags::FIXED).unwrap_err();
    assert_eq!((error.status, error.place), (Status::Range, Some(Place::Face(FaceId::new(4)))));
    let unknown = Flags::from_bits(8);
    assert_eq!(mesh.set_all_flags(Entity::Face, unknown, unknown).unwrap_err().status, Status::Range);
    assert_eq!(mesh.checksum(), digest);
}

#[test]
fn features_are_where_faces_meet_at_an_angle() {
    // Folded upwards by 45 degrees from the third column of vertices on.
    let points: Vec<[f64; 3]> =
        grid::points(4, 3).iter().map(|&[x, y]| [x, y, f64::max(x - 2.0, 0.0)]).collect();
    let faces: Vec<[i32; 4]> = (0..12).map(|f| f + f / 4).map(|v| [v, v + 1, v + 6, v + 5]).collect();
    let mut mesh = Mesh::new(&Context::new(), &points, &faces).unwrap();
    assert_eq!(mesh.detect_features(46.0).unwrap(), 0);
    assert!(mesh.flags(Entity::Edge).iter().all(|flags| flags.is_empty()));
    assert_eq!(mesh.detect_features(44.0).unwrap(), 3);
    for (flags, ends) in mesh.flags(Entity::Edge).iter().zip(mesh.edges()) {
        let on_fold = ends.iter().all(|end| end.index() % 5 == 2);
        assert_eq!(*flags, if on_fold { Flags::FEATURE } else { Flags::NONE });
    }
    for (v, flags) in mesh.flags(Entity::Vertex).iter().enumerate() {
        assert_eq!(*flags, if v == 2 || v == 17 { Flags::CORNER } else { Flags::NONE });
    }
    assert_eq!(mesh.detect_features(-1.0).unwrap_err().status, Status::Range);
    assert_eq!(mesh.detect_features(f64::NAN).unwrap_err().status, Status::NotFinite);
}

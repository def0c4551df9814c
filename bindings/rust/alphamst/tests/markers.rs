//! Markers of vertices, edges and faces, and their names.
mod grid;

use alphamst::*;

#[test]
fn each_entity_has_markers_of_its_own() {
    let mut mesh = grid::mesh(&Context::new(), 3, 2);
    mesh.set_markers(&[VertexId::new(1)], 77).unwrap();
    mesh.set_markers(&[EdgeId::new(2), EdgeId::new(3)], 7).unwrap();
    mesh.set_all_markers(Entity::Face, 20).unwrap();
    mesh.set_markers(&[FaceId::new(3)], -1).unwrap();
    mesh.set_markers::<FaceId>(&[], 9).unwrap(); // none, not all
    assert_eq!(mesh.markers(Entity::Vertex)[..3], [0, 77, 0]);
    assert_eq!(mesh.markers(Entity::Edge)[..5], [0, 0, 7, 7, 0]);
    assert_eq!(mesh.markers(Entity::Face), [20, 20, 20, -1, 20, 20]);
    assert_eq!(mesh.marker_list(Entity::Face), [-1, 20]);
    assert_eq!(mesh.flags(Entity::Vertex)[1], Flags::CORNER);
    assert_eq!(mesh.revision(), 0);
    let copy = mesh.clone();
    assert_eq!(copy.markers(Entity::Edge), mesh.markers(Entity::Edge));
}

#[test]
fn names_are_kept_in_copies_and_files() {
    let context = Context::new();
    let mut mesh = grid::mesh(&context, 3, 2);
    mesh.set_markers(&[EdgeId::new(0)], 7).unwrap();
    mesh.set_marker_name(Entity::Edge, 7, "Überlauf 1").unwrap();
    let path = std::env::temp_dir().join(format!("alphamst_markers_{}.msh", std::process::id()));
    mesh.write(&path).unwrap();
    let back = Mesh::read(&context, &path, None).unwrap();
    std::fs::remove_file(&path).unwrap();
    for same in [&mesh.clone(), &back] {
        assert_eq!(same.marker_name(Entity::Edge, 7), "Überlauf 1");
        assert_eq!(same.marker_name(Entity::Face, 7), "");
    }
    assert_eq!(back.checksum(), mesh.checksum());
    mesh.set_marker_name(Entity::Edge, 7, "").unwrap();
    assert_eq!(mesh.marker_name(Entity::Edge, 7), "");
}

#[test]
fn what_is_wrong_is_refused() {
    let mut mesh = grid::mesh(&Context::new(), 2, 2);
    let before = mesh.checksum();
    assert_eq!(mesh.set_markers(&[FaceId::new(4)], 1).unwrap_err().status, Status::Range);
    for (marker, name) in [(0, "none"), (1, "a \"b\""), (1, "a\nb"), (1, "a\0b")] {
        let refused = mesh.set_marker_name(Entity::Edge, marker, name).unwrap_err();
        assert_eq!(refused.status, Status::Argument, "{marker} {name}");
    }
    assert_eq!(mesh.checksum(), before);
}

//! Undoing.
mod grid;

use alphamst::*;

#[test]
fn savepoints_nest() {
    let context = Context::new();
    let (mut mesh, mut patches) = grid::patched(&context, 8, 2, 6);
    let (first, at_first) = (mesh.mark().unwrap(), mesh.checksum());
    assert_eq!(first, mesh.revision());
    let _ = mesh.adapt(&mut patches, 2.0, None).unwrap();
    let (second, at_second) = (mesh.mark().unwrap(), mesh.checksum());
    assert!(second > first);
    let _ = mesh.adapt(&mut patches, 0.5, None).unwrap();
    assert!(mesh.revision() > second);

    mesh.rollback(second).unwrap();
    assert_eq!((mesh.revision(), mesh.checksum()), (second, at_second));
    assert_eq!(patches.add_rings(VertexId::new(0), 1).unwrap_err().status, Status::Stale);
    mesh.rollback(first).unwrap();
    assert_eq!((mesh.revision(), mesh.checksum(), mesh.n_faces()), (first, at_first, 64));
    assert_eq!(mesh.rollback(second).unwrap_err().status, Status::NotFound);
    mesh.forget(first).unwrap();
    assert_eq!(mesh.checksum(), at_first);
    assert_eq!(mesh.rollback(first).unwrap_err().status, Status::NotFound);
    assert_eq!(mesh.forget(first).unwrap_err().status, Status::NotFound);
}

#[test]
fn patches_of_the_revision_are_current_again() {
    let context = Context::new();
    let (mut mesh, mut patches) = grid::patched(&context, 8, 2, 6);
    let mut other = Patches::new(&mesh, None);
    other.add_rings(VertexId::new(0), 1).unwrap();
    let start = mesh.mark().unwrap();
    let _ = mesh.adapt(&mut patches, 2.0, None).unwrap();
    let error = other.patch(PatchId::new(0)).unwrap_err();
    assert_eq!(error.status, Status::Stale);
    mesh.rollback(start).unwrap();
    assert_eq!(other.patch(PatchId::new(0)).unwrap().faces(), Ok(vec![FaceId::new(0)]));
}

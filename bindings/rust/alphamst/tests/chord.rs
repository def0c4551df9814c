//! Chords: queries, and operations that know their result.
mod grid;

use alphamst::*;

#[test]
fn lengths_sum_up_to_twice_the_faces() {
    let mesh = grid::mesh(&Context::new(), 5, 3);
    let (ids, n_chords) = mesh.chord_ids();
    assert_eq!((ids.len(), n_chords), (mesh.n_edges(), 8));
    assert_eq!(mesh.chords(ChordProperty::Length, None).iter().sum::<i64>(), 30);
    for edge in mesh.chords(ChordProperty::Edge, None) {
        let chord = mesh.chord(EdgeId::new(edge as i32)).unwrap();
        assert!(!chord.closed && chord.crossings == 0);
        assert!(chord.edges.iter().all(|e| ids[e.index()] == ids[edge as usize]));
    }
    assert_eq!(mesh.chord(EdgeId::new(99)).unwrap_err().status, Status::Range);
}

#[test]
fn rings_go_in_and_out() {
    let (mut mesh, mut patches) = grid::patched(&Context::new(), 8, 2, 6);
    let mark = mesh.mark().unwrap();
    let digest = mesh.checksum();
    let report = mesh.insert_chords(&mut patches, 2, None).unwrap();
    assert_eq!((report.all().faces_after(), mesh.n_faces()), (48, 96));
    let closed = mesh.chords(ChordProperty::Closed, None);
    let ring = closed.iter().position(|&c| c == 1).unwrap();
    assert_eq!(mesh.chords(ChordProperty::Refusal, None)[ring], 0);
    let after = mesh.chords(ChordProperty::SingularAfter, None)[ring];
    let edge = EdgeId::new(mesh.chords(ChordProperty::Edge, None)[ring] as i32);
    let _ = mesh.collapse_chord(edge, None).unwrap();
    assert_eq!((mesh.n_faces(), mesh.singularities().len() as i64), (80, after));
    mesh.rollback(mark).unwrap();
    assert_eq!(mesh.checksum(), digest);
}

#[test]
fn refusals_change_nothing_and_say_why() {
    let mut mesh = grid::mesh(&Context::new(), 5, 3);
    let digest = mesh.checksum();
    let error = mesh.collapse_chord(EdgeId::new(0), None).unwrap_err();
    assert_eq!(error.status, Status::Chord);
    assert!(error.message.contains("boundary"), "{error}");
    assert_eq!(mesh.split_chord(EdgeId::new(0), 1, None).unwrap_err().status, Status::Chord);
    assert_eq!(mesh.split_chord(EdgeId::new(0), 0, None).unwrap_err().status, Status::Range);
    let bits = mesh.chords(ChordProperty::Refusal, None)[0] as i32;
    assert!(Refusals::from_bits(bits).contains(Refusals::BOUNDARY));
    assert_eq!(mesh.checksum(), digest);
}

#[test]
fn whole_meshes_adapt_by_chords() {
    let mut mesh = grid::mesh(&Context::new(), 8, 8);
    let options = Options::new().strategy(1).unwrap().edit_boundary(true);
    let _ = mesh.adapt(None, 42.0 / 64.0, &options).unwrap(); // seven rows and six columns
    assert_eq!((mesh.n_faces(), mesh.singularities().len()), (42, 0));
}

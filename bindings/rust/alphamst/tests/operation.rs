//! Operations, told apart by what they do to a mesh.
mod grid;

use alphamst::*;

/// A grid whose middle face is divided by a vertex of valence 2.
fn with_doublet(context: &Context) -> Mesh {
    let (mut points, mut faces) = (grid::points(7, 7), grid::faces(7, 7));
    points.push([3.5, 3.5]);
    let [a, b, c, d] = faces[24];
    faces[24] = [a, b, c, 64];
    faces.push([a, 64, c, d]);
    Mesh::new(context, &points, &faces).unwrap()
}

#[test]
fn adapt_changes_the_number_of_faces() {
    let context = Context::new();
    let (mut mesh, mut patches) = grid::patched(&context, 10, 2, 7);
    let report = mesh.adapt(&mut patches, 2.0, &Options::new().seed(3)).unwrap();
    mesh.check().unwrap();
    assert_eq!((mesh.n_faces(), mesh.revision()), (125, 1));
    assert!(!report.is_partial() && mesh.singularities().len() >= 4);
    // The patches moved along to the new faces.
    let faces = patches.patch(PatchId::new(0)).unwrap().faces().unwrap();
    assert_eq!(faces.len(), 50);

    // And the same square is a grid again.
    let report = mesh.reduce_singularities(&mut patches, &Options::new()).unwrap();
    assert_eq!((mesh.n_faces(), mesh.singularities().len()), (100, 0));
    assert_eq!((report.all().faces_before(), report.all().faces_after()), (50, 25));
    assert!(mesh.adapt(&mut patches, 0.0, None).unwrap_err().status == Status::Argument);
    assert!(mesh.adapt(&mut patches, f64::NAN, None).unwrap_err().status == Status::NotFinite);
}

#[test]
fn smooth_moves_vertices_only() {
    let context = Context::new();
    let (mut mesh, patches) = grid::patched(&context, 10, 1, 5);
    let mut points = grid::points(10, 10);
    points[3 * 11 + 3] = [3.4, 2.7];
    points[7 * 11 + 7] = [7.4, 6.7];
    mesh.set_points(&points).unwrap();
    let (faces, revision) = (mesh.faces(), mesh.revision());
    let moved = |mesh: &Mesh| {
        let now = mesh.points::<2>().unwrap();
        [36, 84].map(|v| now[v] != points[v])
    };
    let report = mesh.smooth(&patches, None).unwrap();
    assert_eq!(moved(&mesh), [true, false]); // inside and outside of the patch
    assert_eq!(report.patches().len(), 1);
    let report = mesh.smooth(None, &Options::new().smooth_steps(40).unwrap()).unwrap();
    assert_eq!(moved(&mesh), [true, true]);
    assert_eq!(report.patches().len(), 0);
    assert_eq!((mesh.faces(), mesh.revision()), (faces, revision));
}

#[test]
fn clean_removes_doublets() {
    let context = Context::new();
    let mut mesh = with_doublet(&context);
    assert_eq!(mesh.valences()[64], 2);
    let report = mesh.clean(None).unwrap();
    assert_eq!((report.all().faces_before(), report.all().faces_after()), (50, mesh.n_faces()));
    assert_eq!((report.all().valence_before(2), report.all().valence_after(2)), (1, 0));
    assert!(mesh.revision() > 0);
    mesh.check().unwrap();
}

#[test]
fn a_defect_makes_it_partial() {
    let context = Context::new();
    let mut mesh = grid::mesh(&context, 12, 12);
    let mut patches = Patches::new(&mesh, &Options::new().repair_patches(false));
    patches.add_faces(&[0, 2].map(FaceId::new)).unwrap();
    patches.add_faces(&grid::square(12, 5, 9)).unwrap();
    let report = mesh.adapt(&mut patches, 2.0, None).unwrap();
    assert!(report.is_partial());
    let statuses: Vec<Status> = report.patches().map(|patch| patch.status()).collect();
    assert_eq!(statuses, [Status::Patch, Status::Ok]);
    assert_eq!(mesh.n_faces(), 160);
}

#[test]
fn patches_must_be_of_the_mesh_and_current() {
    let (context, elsewhere) = (Context::new(), Context::new());
    let (mut mesh, mut patches) = grid::patched(&context, 6, 1, 5);
    for other in [&context, &elsewhere] {
        let (_, mut foreign) = grid::patched(other, 6, 1, 5);
        assert_eq!(mesh.adapt(&mut foreign, 2.0, None).unwrap_err().status, Status::Argument);
        assert_eq!(mesh.smooth(&foreign, None).unwrap_err().status, Status::Argument);
    }
    let mut old = Patches::new(&mesh, None);
    old.add_rings(VertexId::new(0), 1).unwrap();
    let _ = mesh.adapt(&mut patches, 2.0, None).unwrap();
    assert_eq!(mesh.reduce_singularities(&mut old, None).unwrap_err().status, Status::Stale);
}

#[test]
fn results_are_the_same_for_any_number_of_threads() {
    let digest = |threads| {
        let context = Context::new();
        context.set_threads(threads).unwrap();
        let (mut mesh, mut patches) = grid::patched(&context, 12, 1, 5);
        patches.add_faces(&grid::square(12, 6, 11)).unwrap();
        let _ = mesh.adapt(&mut patches, 1.5, None).unwrap();
        mesh.checksum()
    };
    assert_eq!(digest(1), digest(0));
    assert_eq!(digest(1), digest(4));
}

#[test]
fn without_patches_the_whole_mesh_changes() {
    let context = Context::new();
    let (mut mesh, mut patches) = grid::patched(&context, 10, 2, 7);
    let _ = mesh.adapt(&mut patches, 2.0, None).unwrap();
    let report = mesh.adapt(None, 1.2, None).unwrap();
    assert_eq!((report.all().faces_before(), report.all().faces_wanted(), mesh.n_faces()), (125, 150, 150));
    let before = mesh.singularities().len();
    let report = mesh.reduce_singularities(None, &Options::new().seed(1)).unwrap();
    assert_eq!(report.all().singular_before(), before);
    assert_eq!(report.all().singular_after(), mesh.singularities().len());
    assert!(report.all().singular_after() <= before && report.patches().len() == 0);
    assert_eq!(mesh.adapt(None, -1.0, None).unwrap_err().status, Status::Argument);
}

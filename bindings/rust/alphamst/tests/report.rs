//! What a report tells.
mod grid;

use alphamst::*;

/// Two patches, of which the second is left, since it is in three pieces.
fn report() -> (Mesh, Mesh, Report) {
    let context = Context::new();
    let mut mesh = grid::mesh(&context, 12, 12);
    let before = mesh.clone();
    let mut patches = Patches::new(&mesh, &Options::new().repair_patches(false));
    patches.add_faces(&grid::square(12, 5, 9)).unwrap();
    patches.add_faces(&[0, 2, 4].map(FaceId::new)).unwrap();
    let report = mesh.adapt(&mut patches, 2.0, None).unwrap();
    (before, mesh, report)
}

#[test]
fn keys_have_values_of_their_own() {
    let (_, mesh, report) = report(); // which outlives patches and context
    let [first, second] = [0, 1].map(|patch| report.patch(PatchId::new(patch)).unwrap());
    assert_eq!(
        (first.id(), second.id(), report.all().id()),
        (Some(PatchId::new(0)), Some(PatchId::new(1)), None)
    );
    assert_eq!(
        (first.status(), second.status(), report.all().status()),
        (Status::Ok, Status::Patch, Status::Partial)
    );
    assert_eq!((first.faces_before(), first.faces_wanted(), first.faces_after()), (16, 32, 32));
    assert_eq!((second.faces_before(), second.faces_wanted(), second.faces_after()), (3, 6, 3));
    let all = report.all();
    assert_eq!((all.faces_before(), all.faces_wanted(), all.faces_after()), (19, 38, 35));
    assert_eq!((all.singular_before(), all.singular_after()), (0, mesh.singularities().len()));
    assert!(first.singular_after() >= 4 && first.singular_before() == 0 && first.singular_bound() == 0);
    assert_eq!((first.alpha(), second.alpha()), (2.0, 1.0));
    assert!((all.alpha() - 35.0 / 19.0).abs() < 1e-12);
    assert!((first.quality_before() - 1.0).abs() < 1e-12);
    let worst = mesh.summary(Metric::ScaledJacobian).min;
    assert!((first.quality_after() - worst).abs() < 1e-12 && worst < 0.99);
    assert!(first.size_error_after() < first.size_error_before());
    assert!(first.least_area_before() > first.least_area_after() && first.least_area_after() > 0.125);
    assert!(first.time_step() > 0.1 && first.time_step() < 1.0);
    assert!(first.shortest_edge_before() > first.shortest_edge_after() && first.shortest_edge_after() > 0.2);
    assert!((first.aspect_ratio_before() - 1.0).abs() < 1e-12 && first.aspect_ratio_after() > 1.01);
    assert_eq!(all.aspect_ratio_after(), first.aspect_ratio_after());
    assert!(second.shortest_edge_after().is_nan() && (second.aspect_ratio_after() - 1.0).abs() < 1e-12);
    assert!((first.time_step() - all.time_step()).abs() < 1e-12);
    assert!(second.size_error_after().is_nan() && second.least_area_before().is_nan());
    assert_eq!((second.time_step(), all.least_area_after()), (1.0, first.least_area_after()));
    assert!((all.size_error_after() - first.size_error_after()).abs() < 1e-12);
    assert!(all.seconds() > 0.0 && all.seconds() < 60.0 && all.seconds() >= first.seconds());
    assert_eq!(first.candidate() as i64, first.get_int(7).unwrap());
    assert_eq!(report.patches().map(|patch| patch.faces_before()).collect::<Vec<_>>(), [16, 3]);
    assert!(format!("{report:?}").contains("n_patches: 2"));
}

#[test]
fn getters_are_those_of_their_keys() {
    let (_, _, report) = report();
    for outcome in report.patches().chain([report.all()]) {
        let integers = [
            i32::from(outcome.status()) as i64,
            outcome.faces_before() as i64,
            outcome.faces_after() as i64,
            outcome.faces_wanted() as i64,
            outcome.singular_before() as i64,
            outcome.singular_after() as i64,
            outcome.singular_bound() as i64,
            outcome.candidate() as i64,
            outcome.unused_option().map_or(-1, |key| i32::from(key) as i64),
        ];
        assert_eq!(integers, [0, 1, 2, 3, 4, 5, 6, 7, 8].map(|key| outcome.get_int(key).unwrap()));
        let reals = [
            outcome.alpha(),
            outcome.quality_before(),
            outcome.quality_after(),
            outcome.seconds(),
            outcome.size_error_before(),
            outcome.size_error_after(),
            outcome.least_area_before(),
            outcome.least_area_after(),
            outcome.time_step(),
            outcome.shortest_edge_before(),
            outcome.shortest_edge_after(),
            outcome.aspect_ratio_before(),
            outcome.aspect_ratio_after(),
        ];
        // By their bits, as what is not known is NaN.
        let by_key = [1000, 1001, 1002, 1003, 1004, 1005, 1006, 1007, 1008, 1009, 1010, 1011, 1012]
            .map(|key| outcome.get_real(key).unwrap());
        assert_eq!(reals.map(f64::to_bits), by_key.map(f64::to_bits));
        assert_eq!(outcome.get_int(ResultKey::Alpha).unwrap_err().status, Status::NotFound);
        assert_eq!(outcome.get_real(ResultKey::FacesAfter).unwrap_err().status, Status::NotFound);
    }
    for patch in [2, -1, -2] {
        assert_eq!(report.patch(PatchId::new(patch)).unwrap_err().status, Status::Range);
    }
}

#[test]
fn valences_before_and_after() {
    let (_, mesh, report) = report();
    let all = report.all();
    assert_eq!((all.valence_before(4), all.valence_before(3)), (121, 0));
    assert_eq!(all.valence_after(3), all.valence_after(5)); // the mesh around is flat
    assert_eq!(all.valence_after(3) + all.valence_after(5), mesh.singularities().len());
    assert_eq!(report.patch(PatchId::new(0)).unwrap().valence_after(-8), 0);
}

#[test]
fn origins_tell_old_from_new() {
    let (before, mesh, report) = report();
    let vertices = report.vertex_origins();
    let (old_points, points) = (before.points::<2>().unwrap(), mesh.points::<2>().unwrap());
    assert_eq!(vertices.len(), mesh.n_vertices());
    for (v, origin) in vertices.iter().enumerate() {
        if let Some(old) = origin {
            assert_eq!(points[v], old_points[old.index()]);
        }
    }
    assert_eq!(vertices.iter().flatten().count(), 169 - 9); // all but those inside the square

    let faces = report.face_origins();
    let (old_corners, corners) = (before.faces(), mesh.faces());
    assert_eq!((faces.len(), faces.iter().flatten().count()), (mesh.n_faces(), 144 - 16));
    for (f, origin) in faces.iter().enumerate() {
        if let Some(old) = origin {
            let came_from = corners[f].map(|v| vertices[v.index()].unwrap());
            assert!(came_from.iter().all(|v| old_corners[old.index()].contains(v)));
        }
    }

    let edges = report.edge_origins();
    assert_eq!((edges.len(), edges.iter().flatten().count()), (mesh.n_edges(), 312 - 24));
    for (pair, origin) in mesh.edges().iter().zip(&edges) {
        if origin.is_some() {
            let old = pair.map(|v| vertices[v.index()].unwrap());
            assert_eq!(before.find_edges(&[old]).unwrap()[0], *origin);
        }
    }
}

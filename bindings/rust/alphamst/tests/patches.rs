//! Choosing patches, and what a patch is asked.
mod grid;

use alphamst::*;
use grid::vertices;

fn plain() -> Options {
    Options::new().repair_patches(false)
}

fn sizes(patches: &Patches) -> Vec<usize> {
    patches.iter().map(|patch| patch.faces().unwrap().len()).collect()
}

#[test]
fn every_way_of_choosing() {
    let mesh = grid::mesh(&Context::new(), 10, 10);
    let mut patches = Patches::new(&mesh, None);
    assert!(patches.is_empty());
    let ids = [
        patches.add_rings(VertexId::new(2 * 11 + 2), 2),
        patches.add_ball([8.0, 8.0, 0.0], 1.0),
        patches.add_box([0.0, 6.0, -1.0], [3.0, 9.0, 1.0]),
        patches.add_faces(&[18, 8, 18].map(FaceId::new)),
    ];
    assert_eq!(ids, [0, 1, 2, 3].map(|id| Ok(PatchId::new(id))));
    assert_eq!(sizes(&patches), [16, 4, 9, 2]);
    assert_eq!((patches.len(), patches.is_empty()), (4, false));
    let last = patches.patch(PatchId::new(3)).unwrap();
    assert_eq!((last.id(), last.faces().unwrap()), (PatchId::new(3), vec![FaceId::new(8), FaceId::new(18)]));
    assert_eq!(patches.iter().map(|patch| patch.id().index()).collect::<Vec<_>>(), [0, 1, 2, 3]);
    assert!(format!("{patches:?}").contains("len: 4"));
}

#[test]
fn options_are_copied() {
    let mesh = grid::mesh(&Context::new(), 10, 10);
    let frame = [0, 1, 2, 10, 12, 20, 21, 22].map(FaceId::new); // around face 11
    let mut repaired = Patches::new(&mesh, None);
    repaired.add_faces(&frame).unwrap();
    assert_eq!(sizes(&repaired), [9]);
    let mut whole = Patches::new(&mesh, &plain());
    whole.add_faces(&frame).unwrap();
    assert_eq!(sizes(&whole), [8]);
    let patch = whole.patch(PatchId::new(0)).unwrap();
    let (defects, convexity) = patch.check().unwrap();
    assert!(defects.contains(Defects::NOT_DISK) && convexity == 0.0);
    for error in [patch.boundary().unwrap_err(), patch.corners().unwrap_err()] {
        assert_eq!((error.status, error.patch), (Status::Patch, Some(PatchId::new(0))));
    }
    assert_eq!(patch.predict(1.0, None).unwrap().faces, 8); // a ring is refilled in parts
}

#[test]
fn boundary_corners_and_convexity() {
    let mesh = grid::mesh(&Context::new(), 10, 10);
    let mut patches = Patches::new(&mesh, &Options::new().min_convexity(0.8).unwrap());
    let square = patches.add_faces(&grid::square(10, 2, 5)).unwrap();
    let cross = patches.add_faces(&[65, 64, 66, 55, 75].map(FaceId::new)).unwrap();
    let patch = patches.patch(square).unwrap();
    assert_eq!(patch.boundary().unwrap().len(), 12);
    assert_eq!(patch.boundary().unwrap()[0], patch.corners().unwrap()[0]);
    let mut corners = patch.corners().unwrap();
    corners.sort();
    assert_eq!(corners, vertices([24, 27, 57, 60]));
    let (defects, convexity) = patch.check().unwrap();
    assert!(defects.is_empty() && (convexity - 1.0).abs() < 1e-12);
    let (defects, convexity) = patches.patch(cross).unwrap().check().unwrap();
    assert!(defects == Defects::NOT_CONVEX && (convexity - 5.0 / 7.0).abs() < 1e-12);

    let given = vertices([60, 57, 25]);
    patches.set_corners(square, &given).unwrap();
    let patch = patches.patch(square).unwrap();
    assert_eq!(patch.corners().unwrap(), given);
    assert_eq!(patch.boundary().unwrap()[..4], vertices([60, 59, 58, 57]));
    patches.set_corners(square, &vertices([24, 27, 36])).unwrap();
    assert_eq!(patches.patch(square).unwrap().check().unwrap().0, Defects::CORNERS);
    assert_eq!(patches.set_corners(square, &given[..2]).unwrap_err().status, Status::Range);
    patches.set_corners(square, &[]).unwrap();
    assert_eq!(patches.patch(square).unwrap().corners().unwrap().len(), 4);
}

#[test]
fn decompositions_cover_the_rest() {
    let mesh = grid::mesh(&Context::new(), 10, 10);
    let options = Options::new().patch_faces(12.0).unwrap();
    for method in [Decomposition::Clusters, Decomposition::Partition, Decomposition::Voronoi] {
        let mut patches = Patches::new(&mesh, &options);
        patches.add_faces(&grid::square(10, 0, 3)).unwrap();
        let added = patches.decompose(method).unwrap();
        assert!(added >= 4);
        assert_eq!(patches.len(), added + 1);
        let mut faces: Vec<FaceId> = patches.iter().flat_map(|patch| patch.faces().unwrap()).collect();
        let n = faces.len();
        faces.sort();
        faces.dedup();
        assert!(faces.len() == n && n >= 89, "{method:?}");
    }
}

#[test]
fn discs_and_singularities_take_some_faces() {
    let mesh = grid::mesh(&Context::new(), 10, 10);
    let options = Options::new().patch_faces(12.0).unwrap();
    let mut patches = Patches::new(&mesh, &options);
    assert_eq!(patches.decompose(Decomposition::Singularities), Ok(0)); // a grid has none
    assert!(patches.decompose(Decomposition::Medial).unwrap() >= 2);
    for disc in patches.iter() {
        assert!((3..=12).contains(&disc.faces().unwrap().len()));
    }
}

#[test]
fn alpha_is_of_a_patch_or_of_all() {
    let context = Context::new();
    let (mut mesh, mut patches) = grid::patched(&context, 12, 1, 5);
    let second = patches.add_faces(&grid::square(12, 7, 11)).unwrap();
    patches.set_alpha(second, 3.0).unwrap();
    let report = mesh.adapt(&mut patches, 2.0, None).unwrap();
    let wanted = |report: &Report| report.patches().map(|patch| patch.faces_wanted()).collect::<Vec<_>>();
    assert_eq!(wanted(&report), [32, 48]);
    patches.set_all_alphas(1.0).unwrap();
    assert_eq!(wanted(&mesh.adapt(&mut patches, 2.0, None).unwrap()), [32, 48]);
    patches.set_all_alphas(0.0).unwrap();
    assert_eq!(wanted(&mesh.adapt(&mut patches, 0.5, None).unwrap()), [16, 24]);
    assert_eq!(patches.set_alpha(second, -0.5).unwrap_err().status, Status::Argument);
    assert_eq!(patches.set_all_alphas(f64::NAN).unwrap_err().status, Status::NotFinite);
    assert_eq!(patches.set_alpha(PatchId::new(2), 1.0).unwrap_err().status, Status::Range);
}

#[test]
fn predictions_come_true() {
    let context = Context::new();
    let (mut mesh, mut patches) = grid::patched(&context, 10, 2, 6);
    let patch = patches.patch(PatchId::new(0)).unwrap();
    assert_eq!(patch.predict(1.0, None), Ok(Prediction { faces: 16, singularities: 0 }));
    let prediction = patch.predict(2.0, &Options::new()).unwrap();
    assert_eq!(prediction.faces, 32);
    assert_eq!(patch.predict(0.0, None).unwrap_err().status, Status::Argument);
    assert_eq!(patch.predict(f64::NAN, None).unwrap_err().status, Status::NotFinite);
    let report = mesh.adapt(&mut patches, 2.0, None).unwrap();
    if report.all().candidate() == 0 {
        assert_eq!(prediction.singularities, mesh.singularities().len());
    }
}

#[test]
fn refusals_add_nothing() {
    let mesh = grid::mesh(&Context::new(), 10, 10);
    let mut patches = Patches::new(&mesh, None);
    let status = |result: Result<PatchId>| result.unwrap_err().status;
    assert_eq!(status(patches.add_faces(&[5, 100].map(FaceId::new))), Status::Range);
    assert_eq!(status(patches.add_faces(&[])), Status::Patch);
    assert_eq!(status(patches.add_rings(VertexId::new(0), 0)), Status::Range);
    assert_eq!(status(patches.add_ball([1.0, f64::NAN, 0.0], 1.0)), Status::NotFinite);
    assert_eq!(status(patches.add_ball([1.0, 1.0, 0.0], -1.0)), Status::Argument);
    assert_eq!(status(patches.add_box([5.0; 3], [1.0; 3])), Status::Argument);
    assert_eq!(patches.len(), 0);
    assert_eq!(patches.patch(PatchId::new(0)).unwrap_err().status, Status::Range);
    assert_eq!(patches.patch(PatchId::new(-2)).unwrap_err().status, Status::Range);
    // the number of "all"
}

#[test]
fn pictures_show_the_outlines() {
    let context = Context::new();
    let (mesh, patches) = grid::patched(&context, 6, 1, 5);
    let (with, without) = (grid::path("with.svg"), grid::path("without.svg"));
    patches.write(&with).unwrap();
    mesh.write(&without).unwrap();
    let read = |path| std::fs::read_to_string(path).unwrap();
    assert!(read(&with).contains("<svg") && read(&with).len() > read(&without).len());
    assert_eq!(patches.write("patches.off").unwrap_err().status, Status::Unsupported);
    std::fs::remove_file(with).unwrap();
    std::fs::remove_file(without).unwrap();
}

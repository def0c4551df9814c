//! The library itself, its errors and its numbers.
mod grid;

use alphamst::*;

#[test]
fn version_and_features() {
    assert_eq!(version(), 100);
    assert_eq!(version_string(), "0.1.0");
    assert!(has("threads"));
    assert!(!has("") && !has("threads\0"));
}

#[test]
fn statuses_have_their_numbers_and_names() {
    let known = [
        (-99, Status::Internal, "AMST_ERR_INTERNAL"),
        (-20, Status::Projection, "AMST_ERR_PROJECTION"),
        (-19, Status::Chord, "AMST_ERR_CHORD"),
        (-18, Status::Geometry, "AMST_ERR_GEOMETRY"),
        (-17, Status::NoFilling, "AMST_ERR_NO_FILLING"),
        (-16, Status::State, "AMST_ERR_STATE"),
        (-15, Status::NoMemory, "AMST_ERR_NO_MEMORY"),
        (-14, Status::Cancelled, "AMST_ERR_CANCELLED"),
        (-13, Status::Unsupported, "AMST_ERR_UNSUPPORTED"),
        (-12, Status::Format, "AMST_ERR_FORMAT"),
        (-11, Status::Io, "AMST_ERR_IO"),
        (-10, Status::NotFound, "AMST_ERR_NOT_FOUND"),
        (-9, Status::Stale, "AMST_ERR_STALE"),
        (-8, Status::Patch, "AMST_ERR_PATCH"),
        (-7, Status::NotManifold, "AMST_ERR_NOT_MANIFOLD"),
        (-6, Status::NotQuad, "AMST_ERR_NOT_QUAD"),
        (-5, Status::NotFinite, "AMST_ERR_NOT_FINITE"),
        (-4, Status::BufferTooSmall, "AMST_ERR_BUFFER_TOO_SMALL"),
        (-3, Status::Range, "AMST_ERR_RANGE"),
        (-2, Status::Argument, "AMST_ERR_ARGUMENT"),
        (-1, Status::Null, "AMST_ERR_NULL"),
        (0, Status::Ok, "AMST_OK"),
        (1, Status::Partial, "AMST_PARTIAL"),
    ];
    for (number, status, name) in known {
        assert_eq!(Status::from(number), status);
        assert_eq!(i32::from(status), number);
        assert_eq!(status.name(), name);
        assert_eq!(status.to_string(), name);
        assert_eq!(status.is_failure(), number < 0);
    }
    assert_eq!(Status::from(-1234), Status::Other(-1234));
    assert!(Status::Other(-1234).is_failure());
    assert_eq!(Status::Other(7).name(), "unknown status");
}

#[test]
fn enumerations_have_the_numbers_of_the_header() {
    fn is<T: TryFrom<i32> + Into<i32> + Copy + PartialEq + std::fmt::Debug>(number: i32, value: T)
    where
        T::Error: std::fmt::Debug,
    {
        assert_eq!(T::try_from(number).unwrap(), value);
        assert_eq!(value.into(), number);
    }
    is(0, Entity::Vertex);
    is(1, Entity::Edge);
    is(2, Entity::Face);
    is(0, Decomposition::Clusters);
    is(1, Decomposition::Partition);
    is(-1, LogLevel::Off);
    is(0, LogLevel::Error);
    is(1, LogLevel::Warning);
    is(2, LogLevel::Info);
    is(3, LogLevel::Debug);
    is(0, OptionKey::Seed);
    is(1, OptionKey::SmoothSteps);
    is(2, OptionKey::RepairPatches);
    is(3, OptionKey::Candidates);
    is(4, OptionKey::NodeLimit);
    is(1000, OptionKey::MinQuality);
    is(1001, OptionKey::MinConvexity);
    is(1002, OptionKey::PatchFaces);
    is(0, ResultKey::Status);
    is(1, ResultKey::FacesBefore);
    is(2, ResultKey::FacesAfter);
    is(3, ResultKey::FacesWanted);
    is(4, ResultKey::SingularBefore);
    is(5, ResultKey::SingularAfter);
    is(6, ResultKey::SingularBound);
    is(7, ResultKey::Candidate);
    is(1000, ResultKey::Alpha);
    is(1001, ResultKey::QualityBefore);
    is(1002, ResultKey::QualityAfter);
    is(1003, ResultKey::Seconds);
    is(1004, ResultKey::SizeErrorBefore);
    is(1005, ResultKey::SizeErrorAfter);
    is(1006, ResultKey::LeastAreaBefore);
    is(1007, ResultKey::LeastAreaAfter);
    is(1008, ResultKey::TimeStep);
    is(1009, ResultKey::ShortestEdgeBefore);
    is(1010, ResultKey::ShortestEdgeAfter);
    is(1011, ResultKey::AspectRatioBefore);
    is(1012, ResultKey::AspectRatioAfter);
    assert_eq!(Entity::try_from(-1), Err(UnknownValue(-1)));
    assert_eq!(UnknownValue(8).to_string(), "8 is no value of this enumeration");
    let flags = [Flags::FIXED, Flags::FEATURE, Flags::CORNER];
    assert_eq!(flags.map(Flags::bits), [1, 2, 4]);
    let defects = [
        Defects::EMPTY,
        Defects::NOT_CONNECTED,
        Defects::NOT_DISK,
        Defects::PINCHED,
        Defects::OVERLAP,
        Defects::CROSSES_FEATURE,
        Defects::ODD_BOUNDARY,
        Defects::CORNERS,
        Defects::NOT_CONVEX,
    ];
    assert_eq!(defects.map(Defects::bits), [1, 2, 4, 8, 16, 32, 64, 128, 256]);
    assert_eq!((Flags::FIXED | Flags::CORNER).bits(), 5);
}

#[test]
fn errors_name_the_place_and_the_patch() {
    let context = Context::new();
    let mesh = grid::mesh(&context, 10, 10);
    let mut patches = Patches::new(&mesh, &Options::new().repair_patches(false));
    patches.add_faces(&[FaceId::new(4), FaceId::new(5)]).unwrap();
    patches.add_faces(&[FaceId::new(15), FaceId::new(16)]).unwrap();
    let error = patches.add_faces(&[FaceId::new(17), FaceId::new(16)]).unwrap_err();
    assert_eq!((error.status, error.code()), (Status::Patch, -8));
    assert_eq!(error.place, Some(Place::Face(FaceId::new(16))));
    assert_eq!(error.patch, Some(PatchId::new(1)));
    assert!(error.message.contains("16") && error.to_string() == error.message);

    let error = patches.add_rings(VertexId::new(121), 1).unwrap_err();
    assert_eq!((error.status, error.place), (Status::Range, Some(Place::Vertex(VertexId::new(121)))));
    assert_eq!(error.patch, None);
    let error = mesh.clone().set_flags(&[EdgeId::new(220)], Flags::FIXED, Flags::FIXED).unwrap_err();
    assert_eq!(error.place, Some(Place::Edge(EdgeId::new(220))));
    let error = Mesh::read(&context, "no such file.off", None).unwrap_err();
    assert_eq!((error.status, error.place, error.patch), (Status::Io, None, None));
    let error: Box<dyn std::error::Error + Send + Sync> = error.into();
    assert!(error.to_string().contains("no such file.off"));
}

#[test]
fn errors_are_of_their_own_thread() {
    let context = Context::new();
    let here = Mesh::read(&context, "here.off", None).unwrap_err();
    let there =
        std::thread::spawn(|| Mesh::read(&Context::new(), "there.off", None).unwrap_err()).join().unwrap();
    assert!(here.message.contains("here.off") && there.message.contains("there.off"));
}

#[test]
fn ids_are_numbers_from_0() {
    assert_eq!(i32::from(VertexId::from(7)), 7);
    assert_eq!(FaceId::new(3).index(), 3);
    assert_eq!(PatchId::new(2).to_string(), "2");
    assert!(std::panic::catch_unwind(|| EdgeId::new(-1).index()).is_err());
}

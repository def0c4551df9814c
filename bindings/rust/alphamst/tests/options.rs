//! Settings: every key by its own setter, and the generic ones.
use alphamst::*;

#[test]
fn defaults_are_those_of_the_header() {
    let options = Options::default();
    let integers = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12].map(|key| options.get_int(key).unwrap());
    assert_eq!(integers, [0, 20, 1, 16, 1000, 0, 0, 0, 0, 0, 0, 1, 2]);
    let reals = [1000, 1001, 1002, 1003, 1004, 1005, 1006, 1007, 1008, 1009, 1010, 1011, 1012, 1013]
        .map(|key| options.get_real(key).unwrap());
    assert_eq!(reals, [0.0, 0.6, 100.0, 0.5, 1.0, 0.7, 0.5, 0.125, 40.0, 0.0, 0.0, 0.0, 0.2, 1.0]);
}

#[test]
fn every_setter_sets_its_own_key() {
    let options = Options::new()
        .seed(i64::MIN)
        .smooth_steps(11)
        .unwrap()
        .repair_patches(false)
        .candidates(13)
        .unwrap()
        .node_limit(1_000_000_000)
        .unwrap()
        .quadrangulate(1)
        .unwrap()
        .min_quality(0.25)
        .unwrap()
        .min_convexity(0.75)
        .unwrap()
        .patch_faces(12.5)
        .unwrap()
        .edit_boundary(true)
        .strategy(1)
        .unwrap()
        .align(true)
        .chart(2)
        .unwrap()
        .tolerance(0.125)
        .unwrap()
        .effort(4.0)
        .unwrap()
        .size_weight(0.3)
        .unwrap()
        .transition(0.875)
        .unwrap()
        .least_size(0.0625)
        .unwrap()
        .keep_boundary(true)
        .starts(3)
        .unwrap()
        .sharp_angle(25.0)
        .unwrap()
        .size_band(0.75)
        .unwrap()
        .buffer_layers(5)
        .unwrap()
        .min_edge(0.5)
        .unwrap()
        .max_edge(7.0)
        .unwrap()
        .gradation(0.3)
        .unwrap()
        .error_order(2.0)
        .unwrap();
    let integers = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12].map(|key| options.get_int(key).unwrap());
    assert_eq!(integers, [i64::MIN, 11, 0, 13, 1_000_000_000, 1, 1, 1, 1, 2, 1, 3, 5]);
    let reals = [1000, 1001, 1002, 1003, 1004, 1005, 1006, 1007, 1008, 1009, 1010, 1011, 1012, 1013]
        .map(|key| options.get_real(key).unwrap());
    assert_eq!(reals, [0.25, 0.75, 12.5, 0.125, 4.0, 0.3, 0.875, 0.0625, 25.0, 0.75, 0.5, 7.0, 0.3, 2.0]);
    assert!(format!("{options:?}").contains("SmoothSteps"));
}

#[test]
fn generic_setters_take_keys_and_numbers() {
    let mut options = Options::new();
    options.set_int(OptionKey::Candidates, 3).unwrap();
    options.set_int(4, 5).unwrap();
    options.set_real(1002, 7.0).unwrap();
    options.set_real(OptionKey::MinQuality, 0.5).unwrap();
    assert_eq!(options.get_int(3), Ok(3));
    assert_eq!(options.get_int(OptionKey::NodeLimit), Ok(5));
    assert_eq!(options.get_real(OptionKey::PatchFaces), Ok(7.0));
    assert_eq!(options.get_real(1000), Ok(0.5));
}

#[test]
fn refusals_leave_the_value() {
    let mut options = Options::new();
    let status = |result: Result<()>| result.unwrap_err().status;
    assert_eq!(status(options.set_int(OptionKey::SmoothSteps, 1001)), Status::Range);
    assert_eq!(status(options.set_real(OptionKey::MinQuality, 1.5)), Status::Range);
    assert_eq!(status(options.set_real(OptionKey::MinQuality, f64::NAN)), Status::NotFinite);
    assert_eq!(status(options.set_int(OptionKey::MinQuality, 1)), Status::NotFound);
    assert_eq!(status(options.set_real(OptionKey::Seed, 1.0)), Status::NotFound);
    assert_eq!(options.get_int(999).unwrap_err().status, Status::NotFound);
    assert_eq!(options.get_real(1999).unwrap_err().status, Status::NotFound);
    assert_eq!(options.get_int(OptionKey::SmoothSteps), Ok(20));
    assert_eq!(options.get_real(OptionKey::MinQuality), Ok(0.0));
}

#[test]
fn edges_are_not_crossed() {
    let edge = |v, w| [VertexId::new(v), VertexId::new(w)];
    let make = |options: &Options| {
        let points = Strided::packed(&[0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0], 2)?;
        let faces = Strided::packed(&[0, 1, 2, 2, 3, 0], 3)?;
        Mesh::from_strided(&Context::new(), points, faces, options)
    };
    let options = Options::new();
    assert!(options.get_edges().is_empty());
    assert_eq!(make(&options).unwrap().faces().len(), 1);
    assert!(make(&options).unwrap().crossed_edges().is_empty());
    let split = make(&Options::new().quadrangulate(1).unwrap()).unwrap().split_edges();
    assert!(split.len() == 5 && split.iter().any(|[v, w, _]| [*v, *w] == edge(0, 2)));
    let options = options.edges(&[edge(1, 3)]).edges(&[edge(2, 0)]);
    assert_eq!(options.get_edges(), [edge(2, 0)]);
    assert!(make(&options).unwrap().faces().len() > 1);
    let options = options.edges(&[edge(1, 3)]);
    assert_eq!(make(&options).unwrap_err().status, Status::NotFound);
    assert_eq!(make(&options.edges(&[])).unwrap().faces().len(), 1);
}

//! Words with better ones, line by line as the terms were agreed: standard English, the field's terms, one name for one thing.

use Phrase::{Part, Whole};

/// What is looked for.
#[derive(Clone, Copy, Debug)]
pub enum Phrase {
    /// These words anywhere in a text, given in small letters and found in any.
    Part(&'static str),
    /// A text of these words alone, such as that of a button, in these letters.
    Whole(&'static str),
}

/// Phrases whose words mean something else in comments on the code, where they are plain English or names of the code.
pub const FREE_IN_COMMENTS: &[&str] = &[
    "carries",
    "carry",
    "chance",
    "elsewhere",
    "found again",
    "has seen",
    "missed",
    "notice",
    "stated",
];

/// What is not said, and what is said instead.
pub const PHRASES: &[(Phrase, &str)] = &[
    // Classification
    (
        Part("told apart"),
        "classified, classification (leave-one-out)",
    ),
    (Part("tell apart"), "classify"),
    (Part("tells apart"), "classifies"),
    (
        Part("chance"),
        "permutation mean (of an accuracy), p-value, random",
    ),
    (Part("linear rule"), "linear classifier"),
    (
        Part("rule in this plane"),
        "classifier on the 2-D embedding",
    ),
    (Part("rule in the plane"), "classifier on the 2-D embedding"),
    (Part("clusters, τ"), "cluster agreement τ"),
    (Part("right answers"), "accuracy"),
    (Part("right in"), "accuracy: 21 of 23"),
    (Part("right for"), "accuracy: 21 of 23"),
    (Part("false alarm"), "false positive"),
    (Part("false alarms"), "false positives"),
    (Part("missed"), "false negatives"),
    (
        Part("probability of being abnormal"),
        "predicted probability of abnormal",
    ),
    (
        Part("probability, abnormal"),
        "predicted probability of abnormal",
    ),
    (Part("score, no probability"), "uncalibrated score"),
    (
        Part("not seen this heart"),
        "leave-one-out (this subject was not in the training set)",
    ),
    (
        Part("not seen the heart"),
        "leave-one-out (this subject was not in the training set)",
    ),
    (Part("learnt"), "trained"),
    (
        Part("learnt without"),
        "leave-one-out, trained without this subject",
    ),
    (Part("by a rule"), "by a classifier"),
    (Part("the rule"), "the classifier"),
    (Part("rules"), "classifiers, thresholds"),
    (Part("fixed rule"), "default thresholds"),
    (Part("has seen"), "within the training distribution"),
    (Part("usual distance"), "median distance"),
    (Part("lie as far"), "percentile"),
    (Part("lies as far"), "percentile"),
    (Part("beside the rule"), "other features"),
    (Part("least to greatest"), "range of the normal subjects"),
    (Part("judge"), "classify"),
    (Part("judged"), "classified"),
    (Part("judges"), "classifies"),
    (Part("judging"), "classifying"),
    (Part("counts as abnormal"), "class abnormal"),
    (Part("count as abnormal"), "class abnormal"),
    (Part("hearts alike"), "most similar subjects"),
    (Part("most alike"), "most similar"),
    // Regions of the wall
    (Part("global failure"), "global hypokinesia"),
    (Part("(alone)"), "abnormal patch"),
    (Part("still part"), "akinetic or hypokinetic region"),
    (Part("still parts"), "akinetic or hypokinetic regions"),
    (Part("stands still"), "akinetic region (thickening < 10 %)"),
    (Part("stand still"), "akinetic region (thickening < 10 %)"),
    (Part("stood still"), "akinetic"),
    (Part("as still"), "akinetic, hypokinetic"),
    (Part("well part"), "remote myocardium"),
    (Part("well wall"), "remote myocardium"),
    (Part("elsewhere"), "remote myocardium"),
    (Part("rest of the wall"), "remote myocardium"),
    (Part("as the rest"), "as the remote myocardium"),
    (Part("over well"), "ratio of patch to remote thickening"),
    (
        Part("found again"),
        "detection stability (share of noise redraws)",
    ),
    (Part("conf."), "detection stability"),
    (Part("would have been found"), "smallest detectable area"),
    (Part("unevenness"), "thickening heterogeneity"),
    (Part("unsteadiness"), "angular SD of ANV"),
    (Part("unsteady"), "angular SD"),
    (Part("distance of poses"), "mean pose distance"),
    (Whole("Border"), "extent threshold"),
    (Part("border 0"), "extent threshold 0"),
    (Part("border {}"), "extent threshold {}"),
    (Part("set by noise"), "estimated from noise"),
    (Part("by noise"), "estimated from noise"),
    (Part("none told"), "no value"),
    // Spheres and thickness
    (Part("ball"), "sphere"),
    (Part("balls"), "spheres"),
    (
        Part("pt × end-diastole"),
        "thickness ratio PT to end-diastole",
    ),
    (Part("× end-diastole"), "ratio to end-diastole"),
    (Part("laid flat"), "polar map"),
    // Buttons
    (Whole("Inner"), "Endocardium"),
    (Whole("Wall"), "Epicardium"),
    (Whole("17"), "Segment values"),
    // Transport and interpolation
    (Part("this beat on that heart"), "transport motion (A → B)"),
    (Part("beat on"), "motion transported to"),
    (Part("carried"), "transported"),
    (Part("carry"), "transport"),
    (Part("carries"), "transports"),
    (Part("carrying"), "transporting, transport"),
    (Part("own beat"), "the subject's own motion"),
    (Part("straight in-between"), "linear interpolation"),
    (Part("straight in-betweens"), "linear interpolation"),
    (Part("in-between"), "interpolated pose"),
    (Part("in-betweens"), "interpolated (geodesic) poses"),
    (
        Part("poses between frames"),
        "interpolated (geodesic) poses",
    ),
    (Part("transfer onto no heart"), "transport: off"),
    (Part("onto no heart"), "transport: off"),
    // Metrics
    (
        Part("× mean"),
        "contribution to the distance, relative to the mean",
    ),
    (Part("size does not matter"), "scale-invariant"),
    (Part("count by area"), "area-weighted"),
    (Part("counts by area"), "area-weighted"),
    (Part("charges"), "penalises"),
    (Part("charge"), "penalise"),
    (Part("charged"), "penalised"),
    // Settings and notes
    (Part("draws that noise"), "random seed"),
    (Part("draws the noise"), "random seed"),
    (Part("stated"), "set by the user (or by the study)"),
    (Part("notice"), "note"),
    (Part("notices"), "notes"),
    (Part("remark"), "note"),
    (Part("remarks"), "notes"),
    (Part("lie upon each other"), "subjects appear pre-aligned"),
    (Part("upon each other"), "pre-aligned"),
    (Part("without area"), "degenerate"),
    (Part("took up"), "view restored"),
    (Part("take up"), "restore"),
    (Part("takes up"), "restores"),
    (Part("taken up"), "restored"),
    (Part("poses through time"), "spatiotemporal plot"),
];

/// Where a phrase may stand: the end of the file's path, a part of the text, and why.
pub const EXCEPTIONS: &[(&str, &str, &str)] = &[
    (
        "src/report/measures.rs",
        "stated",
        "value of a column that scripts read, and its explanation",
    ),
    (
        "src/report/verdict_json.rs",
        "learnt",
        "value that scripts read",
    ),
    (
        "src/report/verdict_json.rs",
        "chance",
        "key that scripts read",
    ),
    (
        "src/report/verdict_json.rs",
        "missed",
        "key that scripts read",
    ),
    ("src/cli/info.rs", "notices", "key that scripts read"),
    ("src/cli/image.rs", "notices", "key that scripts read"),
    ("src/cli/mesh.rs", "notices", "key that scripts read"),
    (
        "src/cli/register_study.rs",
        "notices",
        "key that scripts read",
    ),
    ("src/cli/args.rs", "in-betweens", "option that scripts use"),
    (
        "src/cli/experiment_args.rs",
        "in-betweens",
        "option that scripts use",
    ),
    (
        "src/picture/quantity.rs",
        "carried-distance",
        "word in views saved within pictures",
    ),
];

/// Names in the code that have better ones, with the room in which they have; empty for all rooms. A trial step of a line search is its own term.
pub const NAMES: &[(&str, &str, &str)] = &[
    ("flattest", "bottom_eigenvectors", ""),
    ("freed_of", "orthogonalise_against", ""),
    ("unfold", "ritz_vectors", ""),
    ("LowerColumns", "LowerCsc", ""),
    ("FaceCharge", "FaceEnergy", ""),
    ("carry_back", "backpropagate", ""),
    ("slopes_back", "backpropagate", ""),
    ("Along", "PathState", ""),
    ("Slopes", "Gradients", ""),
    ("steadiness", "temporal_consistency", ""),
    ("at_rest", "at_end_diastole", ""),
    ("ThicknessWay", "ThicknessMethod", ""),
    ("WayAnswer", "MethodResult", ""),
    ("FlatWall", "PolarMap", ""),
    ("flat_wall", "polar_map", ""),
    ("HeartNumbers", "SurfaceScalars", ""),
    ("MadeNumbers", "ScalarCache", ""),
    ("OnStage", "VisiblePose", ""),
    ("trial", "driver_probe", "src/render/"),
    ("Means", "Capabilities", "src/render/"),
    ("Watch", "ErrorScope", "src/render/"),
];

/// Names begin with the word that all know.
pub const NAME_STARTS: &[(&str, &str)] = &[
    ("least_", "min_"),
    ("LEAST_", "MIN_"),
    ("most_", "max_"),
    ("MOST_", "MAX_"),
    ("carry_", "transport_"),
];

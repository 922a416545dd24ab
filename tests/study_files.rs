//! Every study that is shipped, in its glance size: it reads, runs and reports, so that no figure can rot.
#![cfg(not(target_arch = "wasm32"))]

use std::fs;
use std::path::Path;
use swarm_playground::study::{Claims, Results, Size, Study, figure, report};

fn texts(folder: &str) -> Vec<(String, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let files = fs::read_dir(folder).expect("the folder is there").flatten().map(|entry| entry.path());
    let files = files.filter(|path| path.extension().is_some_and(|ending| ending == "json"));
    let name = |path: &Path| path.file_stem().expect("a name").to_string_lossy().into_owned();
    files.map(|path| (name(&path), fs::read_to_string(&path).expect("readable"))).collect()
}

fn read(name: &str) -> Study {
    let presets = texts("scenarios");
    let presets: Vec<(&str, &str)> = presets.iter().map(|(name, text)| (name.as_str(), text.as_str())).collect();
    let text = texts("studies").into_iter().find(|study| study.0 == name).expect("the study is there").1;
    let study = Study::read(&text, &presets).unwrap_or_else(|error| panic!("{name}: {error}"));
    assert_eq!(study.name, name, "a study is called as its file is");
    study
}

fn glance(name: &str) {
    let study = read(name);
    let class = study.sized(Size::Class).expect("every study has a class size");
    assert!(class.run_count() < study.run_count());
    let glance = study.sized(Size::Glance).expect("and a glance size");
    let mut results = Results::new(glance.clone());
    for run in 0..glance.run_count() {
        let row = glance.make(run);
        assert!(row.end.is_ok(), "{name}, run {run}: {:?}", row.end);
        results.add(row);
    }
    let text = report(&results);
    let first = study.metrics[0].label();
    assert!(text.starts_with(&format!("# {}\n", study.title)) && text.contains(&format!("## {first}\n")), "{text}");
    assert!(text.contains("## Tests") && !text.contains("NaN"), "{text}");
    let drawn = figure(&results).expect("every study has a figure");
    assert!(drawn.contains(&format!("<title>{}</title>", study.title)) && !drawn.contains("NaN"), "{drawn}");
}

#[test]
fn glance_of_agents() {
    glance("agents");
}

#[test]
fn glance_of_algorithms() {
    glance("algorithms");
}

#[test]
fn glance_of_crowds() {
    glance("crowds");
}

#[test]
fn glance_of_depth() {
    glance("depth");
}

#[test]
fn glance_of_archive() {
    glance("archive");
}

#[test]
fn glance_of_coverage() {
    glance("coverage");
}

#[test]
fn glance_of_figure_2a() {
    glance("figure-2a");
}

#[test]
fn glance_of_figure_2b() {
    glance("figure-2b");
}

#[test]
fn glance_of_fixed_programs() {
    glance("fixed-programs");
}

#[test]
fn glance_of_multiplexed() {
    glance("multiplexed");
}

#[test]
fn glance_of_mutation() {
    glance("mutation");
}

#[test]
fn glance_of_navigation() {
    glance("navigation");
}

#[test]
fn glance_of_published_switches() {
    glance("published-switches");
}

#[test]
fn glance_of_random_programs() {
    glance("random-programs");
}

#[test]
fn glance_of_robust_switches() {
    glance("robust-switches");
}

#[test]
fn glance_of_search_variants() {
    glance("search-variants");
}

#[test]
fn glance_of_sequences() {
    glance("sequences");
}

#[test]
fn glance_of_success() {
    glance("success");
}

#[test]
fn glance_of_threshold() {
    glance("threshold");
}

#[test]
fn glance_of_turning() {
    glance("turning");
}

#[test]
fn glance_of_coaches() {
    glance("coaches");
}

#[test]
fn glance_of_hysteresis() {
    glance("hysteresis");
}

#[test]
fn glance_of_substeps() {
    glance("substeps");
}

#[test]
fn glance_of_tournament() {
    glance("tournament");
}

#[test]
fn no_study_is_left_out() {
    let source = include_str!("study_files.rs");
    for (name, _) in texts("studies") {
        assert!(source.contains(&format!("glance(\"{name}\")")), "studies/{name}.json has no test here");
    }
}

#[test]
fn the_claims_name_studies_cells_and_metrics_that_exist() {
    for (name, text) in texts("studies/claims") {
        let claims = Claims::read(&text).unwrap_or_else(|error| panic!("{name}: {error}"));
        let results = claims.studies().into_iter().map(|study| (study.to_owned(), Results::new(read(study))));
        let document = claims.document(&results.collect(), &name).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert!(document.contains("## At a glance") && document.contains("| open |"), "{document}");
    }
}

//! Documents that a command makes are what the command makes from the committed results.
#![cfg(all(not(target_arch = "wasm32"), feature = "cli"))]

use std::fs;
use std::path::Path;
use std::process::Command;

fn printed(words: &[&str]) -> String {
    let output = Command::new(env!("CARGO_BIN_EXE_swarm-playground"))
        .args(words)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .expect("it starts");
    assert!(output.status.success(), "{words:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("text")
}

/// Names without their endings of the files in a folder that end so.
fn names(folder: &str, ending: &str) -> Vec<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let files = fs::read_dir(folder).expect("the folder is there").flatten();
    let names = files.filter_map(|file| file.file_name().into_string().ok()?.strip_suffix(ending).map(str::to_owned));
    names.collect()
}

fn committed(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs").join(name);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

#[test]
fn what_is_reproduced_is_what_the_command_prints() {
    for name in names("studies/claims", ".json") {
        let document = match name.as_str() {
            "betr-geese" => "reproduction.md".to_owned(),
            other => format!("reproduction-{other}.md"),
        };
        let claims = format!("studies/claims/{name}.json");
        let made = printed(&["reproduction", &claims]);
        assert!(committed(&document) == made, "docs/{document} is not what `reproduction {claims}` prints");
        assert!(committed("reproduction.md").contains(&document) || name == "betr-geese", "{document} is not linked");
    }
}

#[test]
fn reports_are_what_the_command_prints() {
    for name in names("results", ".csv") {
        let made = printed(&["report", &format!("results/{name}.csv")]);
        assert!(
            committed(&format!("{name}.md")) == made,
            "docs/{name}.md is not what `report results/{name}.csv` prints"
        );
    }
}

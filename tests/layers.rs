//! The floors of the house: no module uses one that stands above it.
#![cfg(not(target_arch = "wasm32"))]

use std::fs;
use std::path::{Path, PathBuf};

fn files(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).expect("the folder is there").flatten() {
        let path = entry.path();
        if path.is_dir() && !path.ends_with("engine") {
            found.extend(files(&path, ending));
        } else if path.extension().is_some_and(|extension| extension == ending) {
            found.push(path);
        }
    }
    found
}

fn floor(module: &str) -> u32 {
    match module {
        "random" | "fingerprint" | "parameter" | "nearest" | "place" | "verdict" => 0,
        "bt" | "evolution" => 1,
        "geese" | "workbench" | "sequencing" | "soccer" => 2,
        "scenario" => 3,
        "study" => 4,
        "web" | "main" | "cli" => 5,
        other => panic!("src/{other} stands on no floor: name it here"),
    }
}

#[test]
fn nothing_in_src_points_upward() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut uses = 0;
    for path in files(&root, "rs") {
        let own = path.strip_prefix(&root).expect("below src").iter().next().expect("a name").to_string_lossy();
        let own = own.trim_end_matches(".rs");
        if own == "lib" {
            continue;
        }
        let text = fs::read_to_string(&path).expect("readable");
        for (number, line) in text.lines().enumerate() {
            for rest in line.split("crate::").skip(1).filter(|_| !line.trim_start().starts_with("//")) {
                let module = rest.split(|c: char| !c.is_alphanumeric() && c != '_').next().expect("a word");
                uses += 1;
                let upward =
                    floor(module) > floor(own) || (floor(module) == floor(own) && module != own && floor(own) > 0);
                assert!(!upward, "{}:{}: {own} uses {module}", path.display(), number + 1);
            }
        }
    }
    assert!(uses > 20, "the test sees the uses: {uses}");
}

#[test]
fn nothing_in_www_points_upward() {
    // draw: pure functions; ui: controls that know the schema; views compose both.
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("www");
    let floor = |folder: &str| match folder {
        "draw" => 0,
        "ui" => 1,
        "views" => 2,
        _ => 3,
    };
    let mut imports = 0;
    for path in files(&root, "js") {
        let below = path.strip_prefix(&root).expect("below www");
        let own = below.iter().next().expect("a name").to_string_lossy().into_owned();
        let text = fs::read_to_string(&path).expect("readable");
        for line in text.lines().filter(|line| line.trim_start().starts_with("import") || line.starts_with("} from")) {
            for folder in ["draw", "ui", "views"] {
                if line.contains(&format!("/{folder}/")) || (line.contains("'./") && own == folder) {
                    imports += 1;
                    assert!(floor(folder) <= floor(&own), "{}: {own} imports from {folder}", path.display());
                }
            }
        }
    }
    assert!(imports > 10, "the test sees the imports: {imports}");
}

//! Studies. Every worker of a pool holds the same study and makes the runs it is told; rows are lines of the results
//! file, so that what the page keeps is what the command line writes.

use super::{answer, error};
use crate::study;
use serde_json::{Value, json};
use wasm_bindgen::prelude::*;

/// Every metric with its words, as JSON.
#[wasm_bindgen]
#[must_use]
pub fn metrics() -> String {
    let metric =
        |(name, metric): &(&str, study::Metric)| json!({"name": name, "label": metric.label(), "help": metric.help()});
    Value::Array(study::Metric::ALL.iter().map(metric).collect()).to_string()
}

/// A study in one of its sizes.
#[wasm_bindgen]
#[derive(Debug)]
pub struct Study {
    study: study::Study,
}

#[wasm_bindgen]
impl Study {
    /// Reads a study.
    ///
    /// - `spec`: the study file, or what [`Study::complete`] returned.
    /// - `presets`: the texts of the scenarios it may name, as a JSON object by name.
    /// - `size`: `glance`, `class` or `paper`.
    ///
    /// # Errors
    /// The study is not valid, or has no such size; the message says where and why.
    #[wasm_bindgen(constructor)]
    pub fn new(spec: &str, presets: &str, size: &str) -> Result<Study, JsError> {
        let presets: std::collections::BTreeMap<String, String> =
            serde_json::from_str(presets).map_err(|fault| error(&fault))?;
        let presets: Vec<(&str, &str)> = presets.iter().map(|(name, text)| (name.as_str(), text.as_str())).collect();
        let size = study::Size::ALL.iter().find(|known| known.0 == size).map(|known| known.1);
        let size = size.ok_or_else(|| JsError::new("expected a size, one of \"glance\", \"class\", \"paper\""))?;
        let study = study::Study::read(spec, &presets).and_then(|study| study.sized(size));
        Ok(Study { study: study.map_err(|fault| error(&fault))? })
    }

    /// The study as JSON that needs no presets, for the other workers and for beside the results.
    #[must_use]
    pub fn complete(&self) -> String {
        self.study.to_value().to_string()
    }

    /// What there is to do, as JSON: the cells' names, the number of runs, the hash by which results are kept, and the
    /// header of the results file.
    #[must_use]
    pub fn plan(&self) -> String {
        let study = &self.study;
        let plan = json!({
            "cells": study.cells.iter().map(|cell| cell.name.as_str()).collect::<Vec<_>>(),
            "runs": study.run_count(),
            "hash": format!("{:016x}", study.hash()),
            "version": study::VERSION,
            "header": study::Results::new(study.clone()).header(),
        });
        plan.to_string()
    }

    /// Makes a run; returns its line of the results file.
    ///
    /// # Errors
    /// The study has no such run.
    pub fn make(&self, run: u32) -> Result<String, JsError> {
        if run >= self.study.run_count() {
            return Err(JsError::new(&format!("expected a run below {}, found {run}", self.study.run_count())));
        }
        let row = self.study.make(run);
        Ok(study::Results::new(self.study.clone()).line(&row))
    }

    /// The report on a results file, complete or not, as JSON: the file with its rows in order, the runs that are missing,
    /// the report as Markdown, and the figure as SVG or null.
    ///
    /// # Errors
    /// It is no results file of this study; the message says where and why.
    pub fn report(&self, results: &str) -> Result<String, JsError> {
        let (results, _) =
            study::Results::read(self.study.clone(), results.as_bytes()).map_err(|fault| error(&fault))?;
        Ok(answer(Some(json!({
            "results": results.text(),
            "missing": results.missing(),
            "report": study::report(&results),
            "figure": study::figure(&results),
        }))))
    }
}

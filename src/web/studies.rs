//! Studies. Every worker of a pool holds the same study and makes the runs it is told; rows are lines of the results
//! file, so that what the page keeps is what the command line writes.

use super::{answer, error};
use crate::study;
use serde_json::{Value, json};
use std::rc::Rc;
use wasm_bindgen::prelude::*;

/// Every metric with its words, as JSON.
#[wasm_bindgen]
#[must_use]
pub fn metrics() -> String {
    let metric = |(name, metric): &(&str, study::Metric)| json!({"name": name, "world": metric.world(), "label": metric.label(), "help": metric.help()});
    Value::Array(study::Metric::all().iter().map(metric).collect()).to_string()
}

/// What a study file says, as JSON: `{"outline": ...}` with its words, cells, factors and the runs of each size, or
/// `{"fault": ...}` with the path of the field and the message.
///
/// - `presets`: the texts of the scenarios it may name, as a JSON object by name.
///
/// # Errors
/// The presets are no such object.
#[wasm_bindgen]
pub fn check(spec: &str, presets: &str) -> Result<String, JsError> {
    let study = match with_presets(presets, |presets| study::Study::read(spec, presets))? {
        Ok(study) => study,
        Err(fault) => return Ok(json!({"fault": {"path": fault.path, "message": fault.message}}).to_string()),
    };
    let size = |(name, size): &(&str, study::Size)| {
        let sized = study.sized(*size).ok()?;
        Some(json!({"size": name, "runs": sized.run_count(), "seeds": sized.seeds, "robot_steps": sized.robot_steps(),
            "hash": format!("{:016x}", sized.hash())}))
    };
    let outline = json!({
        "name": study.name, "title": study.title, "about": study.about, "world": world_of(&study),
        "cells": study.cells.iter().map(|cell| cell.name.as_str()).collect::<Vec<_>>(),
        "factors": study.factors(),
        "sizes": study::Size::ALL.iter().filter_map(size).collect::<Vec<_>>(),
    });
    Ok(json!({"outline": outline}).to_string())
}

/// The name of the world that all cells of a study are of.
fn world_of(study: &study::Study) -> &'static str {
    study.cells[0].scenario.world.name()
}

fn with_presets<T>(presets: &str, read: impl FnOnce(&study::Presets) -> T) -> Result<T, JsError> {
    let presets: std::collections::BTreeMap<String, String> =
        serde_json::from_str(presets).map_err(|fault| error(&fault))?;
    let presets: Vec<(&str, &str)> = presets.iter().map(|(name, text)| (name.as_str(), text.as_str())).collect();
    Ok(read(&presets))
}

/// A study in one of its sizes.
#[wasm_bindgen]
#[derive(Debug)]
pub struct Study {
    /// Results without a row: the study, and how its rows are written.
    empty: Rc<study::Results>,
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
        let size = study::Size::ALL.iter().find(|known| known.0 == size).map(|known| known.1);
        let size = size.ok_or_else(|| JsError::new("expected a size, one of \"glance\", \"class\", \"paper\""))?;
        let study =
            with_presets(presets, |presets| study::Study::read(spec, presets).and_then(|study| study.sized(size)))?;
        let study = study.map_err(|fault| error(&fault))?;
        Ok(Study { empty: Rc::new(study::Results::new(study)) })
    }

    /// The study as JSON that needs no presets, for the other workers; the bytes of the file that the command line writes
    /// beside results.
    #[must_use]
    pub fn complete(&self) -> String {
        format!("{:#}\n", self.empty.study().to_value())
    }

    /// What there is to do, as JSON: the cells' names, the number of runs and of seeds, robots times steps of a run of
    /// each cell, the hash by which results are kept, and the header of the results file. Run `i` is of cell `i` modulo the cells.
    #[must_use]
    pub fn plan(&self) -> String {
        let study = self.empty.study();
        let plan = json!({
            "world": world_of(study),
            "cells": study.cells.iter().map(|cell| cell.name.as_str()).collect::<Vec<_>>(),
            "runs": study.run_count(),
            "seeds": study.seeds,
            "robot_steps": study.cells.iter().map(study::Cell::robot_steps).collect::<Vec<_>>(),
            "hash": format!("{:016x}", study.hash()),
            "version": study::VERSION,
            "header": self.empty.header(),
        });
        plan.to_string()
    }

    /// A run at its start.
    ///
    /// # Errors
    /// The study has no such run.
    pub fn start(&self, run: u32) -> Result<Job, JsError> {
        self.known(run)?;
        Ok(Job { job: self.empty.study().start(run), empty: Rc::clone(&self.empty) })
    }

    /// The line of the results file for a run that gave no numbers.
    ///
    /// # Errors
    /// The study has no such run.
    pub fn failed(&self, run: u32, reason: &str) -> Result<String, JsError> {
        self.known(run)?;
        Ok(self.empty.line(&study::Row::failed(self.empty.study(), run, reason)))
    }

    /// The report on a results file, complete or not, as JSON: the file with its rows in order, the runs that are missing,
    /// the report as data and as Markdown, and the figure as SVG or null.
    ///
    /// # Errors
    /// It is no results file of this study; the message says where and why.
    pub fn report(&self, results: &str) -> Result<String, JsError> {
        let results = study::Results::read(self.empty.study().clone(), results.as_bytes());
        let (results, _) = results.map_err(|fault| error(&fault))?;
        let report = study::Report::of(&results);
        Ok(answer(Some(json!({
            "results": results.text(),
            "missing": results.missing(),
            "markdown": report.markdown(),
            "report": report,
            "figure": study::figure(&results),
        }))))
    }

    fn known(&self, run: u32) -> Result<(), JsError> {
        let count = self.empty.study().run_count();
        if run < count { Ok(()) } else { Err(JsError::new(&format!("expected a run below {count}, found {run}"))) }
    }
}

/// A run of a study on its way.
#[wasm_bindgen]
#[derive(Debug)]
pub struct Job {
    job: study::Job,
    empty: Rc<study::Results>,
}

#[wasm_bindgen]
impl Job {
    /// Makes up to `steps` steps; returns whether the run is over.
    pub fn advance(&mut self, steps: u32) -> bool {
        self.job.advance(steps)
    }

    /// The run's line of the results file, once it is over.
    #[must_use]
    pub fn line(&self) -> String {
        self.empty.line(&self.job.row())
    }
}

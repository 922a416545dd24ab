//! The wasm face: each method converts and calls, nothing more.
//!
//! Configuration, queries and answers cross as JSON text, errors as `Error` with the core's message. There are five
//! faces, each a wasm file of its own, so that the page loads all but the worlds only when they are opened.

#[cfg(feature = "sequence")]
mod sequence;
#[cfg(feature = "soccer-page")]
mod soccer;
#[cfg(feature = "studies")]
mod studies;
#[cfg(feature = "trees")]
mod trees;
#[cfg(feature = "worlds")]
mod worlds;

use wasm_bindgen::prelude::*;

/// Turns a panic into an exception with its message; the page then ends the worker.
#[wasm_bindgen(start)]
pub fn start() {
    std::panic::set_hook(Box::new(|info| wasm_bindgen::throw_str(&format!("the engine stopped: {info}"))));
}

/// The version of the engine.
#[wasm_bindgen]
#[must_use]
pub fn version() -> String {
    env!("CARGO_PKG_VERSION").to_owned()
}

/// Every parameter as JSON.
#[cfg(feature = "studies")]
#[wasm_bindgen]
#[must_use]
pub fn schema() -> String {
    crate::scenario::schema().to_string()
}

#[cfg(any(feature = "worlds", feature = "trees", feature = "studies", feature = "sequence", feature = "soccer-page"))]
fn error(error: &impl ToString) -> JsError {
    JsError::new(&error.to_string())
}

/// An answer as JSON; serialising our own types cannot fail.
#[cfg(any(feature = "worlds", feature = "trees", feature = "studies", feature = "sequence", feature = "soccer-page"))]
fn answer(value: Option<impl serde::Serialize>) -> String {
    value.and_then(|value| serde_json::to_string(&value).ok()).unwrap_or_else(|| "null".to_owned())
}

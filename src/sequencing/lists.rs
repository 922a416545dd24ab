//! Reading what stands in the lists of a scenario: areas, obstacles, behaviours.

use super::behaviours::{Behaviour, Meta, RADII, Shape};
use super::map::{Bounds, Form};
use crate::parameter::shown;
use serde::Deserialize;
use serde_json::Value;

/// Exactly so many numbers of a size that maps have, or `None`.
#[must_use]
pub fn numbers<const N: usize>(value: &Value) -> Option<[f64; N]> {
    let list: Option<Vec<f64>> = value.as_array()?.iter().map(Value::as_f64).collect();
    let list: [f64; N] = list?.try_into().ok()?;
    list.iter().all(|number| number.abs() <= FARTHEST).then_some(list)
}

/// No coordinate is greater, metres.
const FARTHEST: f64 = 1e6;

/// A value as messages show it.
#[must_use]
pub fn found(value: &Value) -> String {
    let text = value.to_string();
    if text.len() <= 60 { text } else { shown(value) }
}

/// A rectangle from left, right, bottom and top.
///
/// # Errors
/// The field, and what was found.
pub fn area(field: &'static str, list: &[Value]) -> Result<Bounds, (&'static str, String)> {
    let value = Value::from(list.to_vec());
    match numbers(&value) {
        Some([left, right, bottom, top]) if left < right && bottom < top => Ok(Bounds { left, right, bottom, top }),
        _ => Err((field, format!("expected [left, right, bottom, top] with an inside, found {}", found(&value)))),
    }
}

/// An obstacle of a list.
///
/// # Errors
/// What was found and what is expected.
pub fn read_form(item: &Value) -> Result<Form, String> {
    let expected = || {
        let forms = "{\"disc\": [x, y, radius]}, {\"box\": [left, bottom, right, top]} or {\"polygon\": [[x, y], ...]}";
        format!("expected {forms}, found {}", found(item))
    };
    let fields = item.as_object().filter(|fields| fields.len() == 1).ok_or_else(expected)?;
    let (kind, value) = fields.iter().next().ok_or_else(expected)?;
    let form = match kind.as_str() {
        "disc" => numbers(value).map(Form::Disc),
        "box" => numbers(value).map(Form::Box),
        "polygon" => value.as_array().and_then(|corners| corners.iter().map(numbers).collect()).map(Form::Polygon),
        _ => None,
    };
    let form = form.ok_or_else(expected)?;
    form.check().map(|()| form)
}

/// A behaviour of the user's own.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Own {
    letter: char,
    name: Option<String>,
    flock: Option<OwnFlock>,
    consensus: Option<f64>,
    row: Option<[f64; 2]>,
    points: Option<Vec<[f64; 2]>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
struct OwnFlock {
    bias: [f64; 2],
    radii: Option<[f64; 3]>,
    least_speed: Option<f64>,
}

/// The most that a gain, bias or place of a formation may be.
const GREATEST: f64 = 1000.0;

/// A behaviour of a list.
///
/// # Errors
/// What was found and what is expected.
pub fn read_behaviour(item: &Value) -> Result<Behaviour, String> {
    let own: Own = serde_json::from_value(item.clone()).map_err(|error| error.to_string())?;
    let fits = |numbers: &[f64]| {
        if numbers.iter().all(|number| number.abs() <= GREATEST) {
            Ok(())
        } else {
            Err(format!("expected numbers from -{GREATEST} to {GREATEST}, found {numbers:?}"))
        }
    };
    let meta = match (own.flock, own.consensus, own.row, own.points) {
        (Some(OwnFlock { bias, radii, least_speed }), None, None, None) => {
            let (radii, least) = (radii.unwrap_or(RADII), least_speed.unwrap_or(1.0));
            fits(&bias)?;
            fits(&radii)?;
            fits(&[least])?;
            if radii[0] < 0.0 || radii[0] > radii[1] || radii[1] > radii[2] {
                return Err(format!("radii: expected three that do not decrease, found {radii:?}"));
            }
            Meta::Flock { bias, radii, least }
        }
        (None, Some(gain), None, None) => {
            fits(&[gain])?;
            Meta::Consensus(gain)
        }
        (None, None, Some(row), None) => {
            fits(&row)?;
            Meta::Formation(Shape::Row(row))
        }
        (None, None, None, Some(points)) => {
            if points.is_empty() {
                return Err("points: expected at least one, found none".to_owned());
            }
            points.iter().try_for_each(|point| fits(point))?;
            Meta::Formation(Shape::Points(points))
        }
        _ => return Err("expected exactly one of flock, consensus, row, points".to_owned()),
    };
    let name = own.name.unwrap_or_else(|| format!("Own {}", own.letter));
    Ok(Behaviour { letter: own.letter, name, meta })
}

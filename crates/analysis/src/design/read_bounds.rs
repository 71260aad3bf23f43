//! Parser of bounds files (TOML); it reports all faults of a file at once.

use std::ops::Range;
use std::path::Path;

use flight::release::{Reader, ReleaseError, Value, number_of, read_text};
use flight::throw::{FIELDS, Throw};
use nalgebra::Vector2;
use toml::de::DeValue;

use crate::design::bounds::Bounds;
use crate::design::goal::{Obstacle, Side};
use crate::design::throw_flight::ThrownBody;

/// Maximum size of a bounds file (ranges and constraints for the search of a throw), bytes.
const MAX_FILE_BYTES: u64 = 1 << 20;

impl Bounds {
    /// Reads a bounds file (TOML): ranges of the quantities of a throw, obstacle, landing circle and scatter. Its
    /// values replace those of [`Bounds::standard`].
    ///
    /// # Errors
    /// [`ReleaseError`] with all faults of the file, or if the file cannot be read, is not UTF-8 or is larger than 1
    /// MiB.
    pub fn read_file(path: &Path, body: &ThrownBody) -> Result<Bounds, ReleaseError> {
        read_text(path, "a file of bounds", MAX_FILE_BYTES, |file, text| {
            Bounds::read(file, text, body)
        })
    }

    /// Parses the text of a bounds file (TOML); its values replace those of [`Bounds::standard`]. `file` is the file's
    /// name in messages.
    ///
    /// # Errors
    /// [`ReleaseError`] with all faults of the file.
    pub fn read(file: &str, text: &str, body: &ThrownBody) -> Result<Bounds, ReleaseError> {
        let mut reader = BoundsReader(Reader::new(text));
        let bounds = reader.bounds(body);
        reader.0.finish(file, bounds)
    }
}

/// Reader of a bounds file for the search of a throw, which collects the faults of the file.
struct BoundsReader<'t>(Reader<'t>);

impl<'t> BoundsReader<'t> {
    fn bounds(&mut self, body: &ThrownBody) -> Option<Bounds> {
        let document = self.0.document()?;
        let mut bounds = Bounds::standard(body);
        for (key, value) in document.get_ref() {
            let (name, span) = (&**key.get_ref(), key.span());
            match name {
                "obstacle" => bounds.obstacle = self.obstacle(value),
                "circle" => bounds.circle = self.circle(value).unwrap_or(bounds.circle),
                "scatter" => self.scatter(value, body, &mut bounds),
                _ => match self.field(name, span, body) {
                    Some(field) => {
                        if let Some((least, greatest)) = self.range(value, field) {
                            bounds.set(name, least, greatest);
                        }
                    }
                    None => continue,
                },
            }
        }
        Some(bounds)
    }

    /// Index in [`FIELDS`] (list of the quantities of a throw) of the quantity called `name`. `None` after reporting a
    /// fault if there is no such quantity or a throw of the body cannot have it.
    fn field(&mut self, name: &str, span: Range<usize>, body: &ThrownBody) -> Option<usize> {
        let Some(field) = FIELDS.iter().position(|(known, ..)| *known == name) else {
            let names = FIELDS.map(|(name, ..)| name).join(", ");
            let message =
                format!("unknown key {name:?}; expected {names}, obstacle, circle or scatter");
            self.0.fault(span, message);
            return None;
        };
        if !body.fields().contains(&field) {
            let model = &body.model.name;
            let message = format!(
                "found {name}, but the model {model} is a point mass, which has no attitude; expected speed, heading, launch \
                 and height alone"
            );
            self.0.fault(span, message);
            return None;
        }
        Some(field)
    }

    /// Minimum and maximum of a quantity of a throw, in the unit that [`FIELDS`] states for it; `field` is the index of
    /// the quantity in this list. `value` is a list of two numbers, or a single number, which fixes the quantity.
    /// `None` after reporting a fault.
    fn range(&mut self, value: &Value<'t>, field: usize) -> Option<(f64, f64)> {
        let (name, unit, ..) = FIELDS[field];
        let (least, greatest) = match value.get_ref().as_array() {
            None => {
                let number = self.number(
                    value,
                    name,
                    &format!("a number or a range in {unit}, as in [1, 2]"),
                )?;
                (number, number)
            }
            Some(items) => {
                let items: Vec<&Value<'t>> = items.iter().collect();
                let [least, greatest] = items[..] else {
                    let message = format!(
                        "{name} is a list of {}; expected the least and the greatest value, as in [1, 2]",
                        items.len()
                    );
                    self.0.fault(value.span(), message);
                    return None;
                };
                (
                    self.number(least, name, "a number")?,
                    self.number(greatest, name, "a number")?,
                )
            }
        };
        if least > greatest {
            let message =
                format!("{name} is from {least} to {greatest}; expected the least value first");
            self.0.fault(value.span(), message);
            return None;
        }
        for end in [least, greatest] {
            if let Err(fault) = Throw::check_field(name, end) {
                self.0.fault(value.span(), fault.to_string());
                return None;
            }
        }
        Some((least, greatest))
    }

    fn obstacle(&mut self, value: &Value<'t>) -> Option<Obstacle> {
        let names = ["x", "y", "radius", "side"];
        let table = self.0.as_table(value, "obstacle")?;
        self.0
            .known_keys(table, " in [obstacle]", names.into_iter());
        let mut metres = |name| {
            let absent = format!("found no {name} in [obstacle]; expected x, y and radius, m");
            let given = self.0.required(table, name, value.span(), absent)?;
            self.number(given, name, "a number of metres")
        };
        let (radius, x, y) = (metres("radius"), metres("x"), metres("y"));
        let side = match table.get("side") {
            None => None,
            Some(value) => match value.get_ref().as_str() {
                Some("left") => Some(Side::Left),
                Some("right") => Some(Side::Right),
                _ => {
                    self.0.fault(value.span(), "side is something else; expected \"left\" or \"right\", or none for either");
                    None
                }
            },
        };
        let (x, y, radius) = (x?, y?, radius?);
        if radius <= 0.0 {
            let message =
                format!("the radius of the obstacle is {radius}; expected a number above 0");
            self.0.fault(value.span(), message);
            return None;
        }
        Some(Obstacle {
            place: Vector2::new(x, y),
            radius,
            side,
        })
    }

    fn circle(&mut self, value: &Value<'t>) -> Option<f64> {
        let table = self.0.as_table(value, "circle")?;
        self.0
            .known_keys(table, " in [circle]", ["radius"].into_iter());
        let absent = "found no radius in [circle]; expected radius = … (m)";
        let radius = self.0.required(table, "radius", value.span(), absent)?;
        let number = self.number(radius, "radius", "a number of metres")?;
        if number <= 0.0 {
            self.0.fault(
                radius.span(),
                format!("the radius is {number}; expected a number above 0"),
            );
            return None;
        }
        Some(number)
    }

    fn scatter(&mut self, value: &Value<'t>, body: &ThrownBody, bounds: &mut Bounds) {
        let mut names: Vec<&str> = FIELDS.map(|(name, ..)| name).to_vec();
        names.push("wind");
        let layout = body.compiled.layout();
        let Some(table) = self.0.as_table(value, "scatter") else {
            return;
        };
        bounds.scatter.release.clear();
        for (key, value) in table {
            let name = &**key.get_ref();
            if name == "wind" {
                let items: Vec<&Value<'t>> = value
                    .get_ref()
                    .as_array()
                    .map(|a| a.iter().collect())
                    .unwrap_or_default();
                if items.len() != 3 {
                    self.0.fault(
                        value.span(),
                        "wind has other than three standard deviations; expected [x, y, z], m/s",
                    );
                    continue;
                }
                for (k, item) in items.into_iter().enumerate() {
                    bounds.scatter.wind[k] = self.deviation(item, "wind").unwrap_or(0.0);
                }
            } else if FIELDS.iter().any(|(field, ..)| *field == name) {
                if let Some(field) = self.field(name, key.span(), body)
                    && let Some(sd) = self.deviation(value, name)
                {
                    bounds.scatter.release.push((field, sd));
                }
            } else if let Some(parameter) = layout.parameter(name)
                && let Some(sd) = self.deviation(value, name)
            {
                bounds.scatter.parameters.push((parameter.index(), sd));
            } else if layout.parameter(name).is_none() {
                let message = format!(
                    "unknown key {name:?} in [scatter]; expected {}, or a parameter or coefficient of the model",
                    names.join(", ")
                );
                self.0.fault(key.span(), message);
            }
        }
        bounds.scatter.release.sort_by_key(|(field, _)| *field);
        bounds.scatter.parameters.sort_by_key(|(index, _)| *index);
    }

    fn deviation(&mut self, value: &Value<'t>, name: &str) -> Option<f64> {
        let sd = self.number(value, name, "a standard deviation")?;
        if sd < 0.0 {
            self.0.fault(
                value.span(),
                format!("the standard deviation of {name} is {sd}; expected 0 or a number above"),
            );
            return None;
        }
        Some(sd)
    }

    fn number(&mut self, value: &Value<'t>, name: &str, expected: &str) -> Option<f64> {
        match number_of(value).filter(|number| number.is_finite()) {
            Some(number) => Some(number),
            None => {
                let found = match value.get_ref() {
                    DeValue::Float(float) => float.as_str().to_owned(),
                    DeValue::Integer(integer) => integer.as_str().to_owned(),
                    other => format!("a {}", other.type_str()),
                };
                self.0.fault(
                    value.span(),
                    format!("{name} is {found}; expected {expected}"),
                );
                None
            }
        }
    }
}

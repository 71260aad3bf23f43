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

const MAX_FILE_BYTES: u64 = 1 << 20;

impl Bounds {
    /// Reads a bounds file (TOML), whose values replace those of [`Bounds::standard`].
    ///
    /// # Errors
    /// [`ReleaseError`] with all faults of the file, or if it cannot be read.
    pub fn read_file(path: &Path, body: &ThrownBody) -> Result<Bounds, ReleaseError> {
        read_text(path, "a file of bounds", MAX_FILE_BYTES, |file, text| {
            Bounds::read(file, text, body)
        })
    }

    /// Parses the text of a bounds file; `file` is its name in messages.
    ///
    /// # Errors
    /// [`ReleaseError`] with all faults of the file.
    pub fn read(file: &str, text: &str, body: &ThrownBody) -> Result<Bounds, ReleaseError> {
        let mut reader = BoundsReader(Reader::new(text));
        let bounds = reader.bounds(body);
        reader.0.finish(file, bounds)
    }
}

struct BoundsReader<'t>(Reader<'t>);

impl<'t> BoundsReader<'t> {
    fn bounds(&mut self, body: &ThrownBody) -> Option<Bounds> {
        let document = self.0.document()?;
        let mut bounds = Bounds::standard(body);
        for (key, value) in document.get_ref() {
            let name = &**key.get_ref();
            match name {
                "obstacle" => bounds.obstacle = self.obstacle(value),
                "circle" => bounds.circle = self.circle(value).unwrap_or(bounds.circle),
                "scatter" => self.scatter(value, body, &mut bounds),
                _ => {
                    if let Some(field) = self.field(name, key.span(), body)
                        && let Some((least, greatest)) = self.range(value, field)
                    {
                        bounds.set(name, least, greatest);
                    }
                }
            }
        }
        Some(bounds)
    }

    /// Index in [`FIELDS`] of the quantity called `name`; a fault if a throw of the body does not have it.
    fn field(&mut self, name: &str, span: Range<usize>, body: &ThrownBody) -> Option<usize> {
        let known = FIELDS.iter().position(|(known, ..)| *known == name);
        match known.filter(|field| body.fields().contains(field)) {
            Some(field) => Some(field),
            None if known.is_none() => {
                let names = FIELDS.map(|(name, ..)| name).join(", ");
                let message =
                    format!("unknown key {name:?}; expected {names}, obstacle, circle or scatter");
                self.0.refuse(span, message)
            }
            None => {
                let model = &body.model.name;
                let message = format!(
                    "found {name}, but the model {model} is a point mass, which has no attitude; expected speed, heading, \
                     launch and height alone"
                );
                self.0.refuse(span, message)
            }
        }
    }

    /// Range of a quantity: a list of two numbers, or a single number, which fixes it.
    fn range(&mut self, value: &Value<'t>, field: usize) -> Option<(f64, f64)> {
        let (name, unit, ..) = FIELDS[field];
        let items = value.get_ref().as_array();
        let items = items.map(|items| items.iter().collect::<Vec<&Value<'t>>>());
        let (least, greatest) = match items.as_deref() {
            None => {
                let expected = format!("a number or a range in {unit}, as in [1, 2]");
                let number = self.number(value, name, &expected)?;
                (number, number)
            }
            Some([least, greatest]) => {
                let least = self.number(least, name, "a number")?;
                (least, self.number(greatest, name, "a number")?)
            }
            Some(items) => {
                let message = format!(
                    "{name} is a list of {}; expected the least and the greatest value, as in [1, 2]",
                    items.len()
                );
                return self.0.refuse(value.span(), message);
            }
        };
        if least > greatest {
            let message =
                format!("{name} is from {least} to {greatest}; expected the least value first");
            return self.0.refuse(value.span(), message);
        }
        let faults = [least, greatest].map(|end| Throw::check_field(name, end).err());
        match faults.into_iter().flatten().next() {
            Some(fault) => self.0.refuse(value.span(), fault.to_string()),
            None => Some((least, greatest)),
        }
    }

    fn obstacle(&mut self, value: &Value<'t>) -> Option<Obstacle> {
        let names = ["x", "y", "radius", "side"].into_iter();
        let table = self.0.as_table(value, "obstacle")?;
        self.0.known_keys(table, " in [obstacle]", names);
        let mut metres = |name| {
            let absent = format!("found no {name} in [obstacle]; expected x, y and radius, m");
            let given = self.0.required(table, name, value.span(), absent)?;
            self.number(given, name, "a number of metres")
        };
        let (radius, x, y) = (metres("radius"), metres("x"), metres("y"));
        let side = table.get("side");
        let side = side.and_then(|value| match value.get_ref().as_str() {
            Some("left") => Some(Side::Left),
            Some("right") => Some(Side::Right),
            _ => {
                let expected = "expected \"left\" or \"right\", or none for either";
                self.0
                    .refuse(value.span(), format!("side is something else; {expected}"))
            }
        });
        let (x, y, radius) = (x?, y?, radius?);
        if radius <= 0.0 {
            let message =
                format!("the radius of the obstacle is {radius}; expected a number above 0");
            return self.0.refuse(value.span(), message);
        }
        Some(Obstacle {
            place: Vector2::new(x, y),
            radius,
            side,
        })
    }

    fn circle(&mut self, value: &Value<'t>) -> Option<f64> {
        let names = ["radius"].into_iter();
        let table = self.0.as_table(value, "circle")?;
        self.0.known_keys(table, " in [circle]", names);
        let absent = "found no radius in [circle]; expected radius = … (m)";
        let radius = self.0.required(table, "radius", value.span(), absent)?;
        let number = self.number(radius, "radius", "a number of metres")?;
        if number <= 0.0 {
            let message = format!("the radius is {number}; expected a number above 0");
            return self.0.refuse(radius.span(), message);
        }
        Some(number)
    }

    fn scatter(&mut self, value: &Value<'t>, body: &ThrownBody, bounds: &mut Bounds) {
        let layout = body.compiled.layout();
        let Some(table) = self.0.as_table(value, "scatter") else {
            return;
        };
        let scatter = &mut bounds.scatter;
        scatter.release.clear();
        for (key, value) in table {
            let name = &**key.get_ref();
            if name == "wind" {
                scatter.wind = self.wind(value).unwrap_or(scatter.wind);
            } else if FIELDS.iter().any(|(field, ..)| *field == name) {
                let field = self.field(name, key.span(), body);
                let sd = field.and_then(|_| self.deviation(value, name));
                scatter.release.extend(field.zip(sd));
            } else if let Some(parameter) = layout.parameter(name) {
                let sd = self.deviation(value, name);
                let sd = sd.map(|sd| (parameter.index(), sd));
                scatter.parameters.extend(sd);
            } else {
                let names = FIELDS.map(|(name, ..)| name).join(", ");
                let message = format!(
                    "unknown key {name:?} in [scatter]; expected {names}, wind, or a parameter or coefficient of the model"
                );
                self.0.fault(key.span(), message);
            }
        }
        scatter.release.sort_by_key(|(field, _)| *field);
        scatter.parameters.sort_by_key(|(index, _)| *index);
    }

    fn wind(&mut self, value: &Value<'t>) -> Option<[f64; 3]> {
        let items = value.get_ref().as_array();
        let Some(items) = items.filter(|items| items.len() == 3) else {
            let message = "wind has other than three standard deviations; expected [x, y, z], m/s";
            return self.0.refuse(value.span(), message);
        };
        let mut wind = [0.0; 3];
        for (sd, item) in wind.iter_mut().zip(items.iter()) {
            *sd = self.deviation(item, "wind").unwrap_or(0.0);
        }
        Some(wind)
    }

    fn deviation(&mut self, value: &Value<'t>, name: &str) -> Option<f64> {
        let sd = self.number(value, name, "a standard deviation")?;
        if sd < 0.0 {
            let message =
                format!("the standard deviation of {name} is {sd}; expected 0 or a number above");
            return self.0.refuse(value.span(), message);
        }
        Some(sd)
    }

    fn number(&mut self, value: &Value<'t>, name: &str, expected: &str) -> Option<f64> {
        let number = number_of(value).filter(|number| number.is_finite());
        number.or_else(|| {
            let found = match value.get_ref() {
                DeValue::Float(float) => float.as_str().to_owned(),
                DeValue::Integer(integer) => integer.as_str().to_owned(),
                other => format!("a {}", other.type_str()),
            };
            self.0.refuse(
                value.span(),
                format!("{name} is {found}; expected {expected}"),
            )
        })
    }
}

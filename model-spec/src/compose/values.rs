//! Replacement of the default values of parameters, coefficients and inputs, for example by the estimates of a fit.

use std::sync::Arc;

use super::ModelTree;
use crate::check;
use crate::location::Span;
use crate::model::Model;
use crate::syntax::ast::{
    Check, CheckPart, File, Input, ItemKind, Name, Number, Parameter, Quantity, UnitExpr,
};
use crate::syntax::spelling::joined;

use crate::unit::Unit;

/// Error of [`Model::with_values`], which replaces default values of parameters, coefficients and inputs.
#[derive(Clone, Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ValueError {
    /// The model has no parameter, coefficient or component of an input of this name.
    #[error("the model has no parameter, coefficient or component of an input `{name}`")]
    UnknownName {
        /// Name, as passed to [`Model::with_values`], that the model does not declare.
        name: String,
    },
    /// A value passed to [`Model::with_values`] is infinite or not a number.
    #[error("the value of `{name}` is {value}, expected a finite number")]
    NotFinite {
        /// Name of the quantity whose new value is invalid, as passed to [`Model::with_values`].
        name: String,
        /// The invalid value, as passed to [`Model::with_values`]: infinite or NaN.
        value: f64,
    },
}

impl Model {
    /// Returns a copy of the model's tree in which parameters, coefficients and components of inputs (such as `wind_x`) have
    /// the default values in `values`: pairs of name and value, SI. After a check of the copy, its default values equal
    /// these values bit for bit.
    ///
    /// Each value is written in the unit of its declaration. If no literal in that unit represents the value exactly,
    /// it is written in SI units. Bounds that a value violates are removed. A check case that relies on a replaced
    /// default gets a `set` statement with the previous value, so that its expected results remain valid.
    ///
    /// ```
    /// use model_spec::ModelTree;
    ///
    /// let disc = ModelTree::load("disc")?.check()?;
    /// let fitted = disc.with_values([("C_D0", 0.0812)]).unwrap().check()?;
    /// let drag = fitted.coefficients.iter().find(|c| c.name == "C_D0").unwrap();
    /// assert_eq!(drag.value, 0.0812);
    /// # Ok::<(), model_spec::LoadError>(())
    /// ```
    ///
    /// # Errors
    /// [`ValueError`] if a name is unknown or a value is not finite.
    pub fn with_values<'v>(
        &self,
        values: impl IntoIterator<Item = (&'v str, f64)>,
    ) -> Result<ModelTree, ValueError> {
        let mut file = File::clone(&self.tree);
        let mut replaced = Vec::new();
        for (name, value) in values {
            if !value.is_finite() {
                let name = name.to_owned();
                return Err(ValueError::NotFinite { name, value });
            }
            let before = replace(&mut file, self, &joined(name), value);
            let before = before.ok_or_else(|| ValueError::UnknownName {
                name: name.to_owned(),
            })?;
            replaced.extend(before);
        }
        for item in &mut file.items {
            if let ItemKind::Check(case) = &mut item.kind {
                keep_defaults(case, &replaced);
            }
        }
        Ok(ModelTree {
            file: Arc::new(file),
            sources: self.sources.clone(),
        })
    }
}

/// A replaced default value, in the form of the statement `set NAME = literals unit;` of a check case.
struct Default {
    name: Name,
    literals: Vec<Number>,
    unit: Option<UnitExpr>,
}

/// Replaces a default by `value`, SI. Returns the previous one if it differs, `None` for an unknown name.
fn replace(file: &mut File, model: &Model, name: &str, value: f64) -> Option<Option<Default>> {
    file.items.iter_mut().find_map(|item| match &mut item.kind {
        ItemKind::Parameter(parameter) if parameter.name.text == name => {
            let mut declared = model.params.iter().chain(&model.coefficients);
            let declared = declared.find(|declared| declared.name == name)?;
            let before = Default {
                name: parameter.name.clone(),
                literals: vec![parameter.value.number.clone()],
                unit: if declared.inferred {
                    Some(UnitExpr::of(declared.unit, parameter.value.span))
                } else {
                    parameter.value.unit.clone()
                },
            };
            let current = si_value(&parameter.value.number, parameter.value.unit.as_ref());
            let changed = current.to_bits() != value.to_bits();
            if changed {
                set_parameter(parameter, declared, value);
            }
            Some(changed.then_some(before))
        }
        ItemKind::Input(input) => {
            let component = name.strip_prefix(&input.name.text)?.strip_prefix('_')?;
            let axis = ["x", "y", "z"].iter().position(|axis| *axis == component)?;
            let declared = model.inputs.iter().find(|d| d.name == input.name.text)?;
            let before = Default {
                name: input.name.clone(),
                literals: input.value.to_vec(),
                unit: input
                    .unit
                    .clone()
                    .or_else(|| Some(UnitExpr::of(declared.unit, input.name.span))),
            };
            let mut si = input
                .value
                .each_ref()
                .map(|number| si_value(number, input.unit.as_ref()));
            let changed = si[axis].to_bits() != value.to_bits();
            si[axis] = value;
            if changed {
                set_input(input, declared.unit, si);
            }
            Some(changed.then_some(before))
        }
        _ => None,
    })
}

fn set_parameter(parameter: &mut Parameter, declared: &crate::model::Parameter, value: f64) {
    let Quantity { number, unit, span } = &mut parameter.value;
    match literal(value, unit.as_ref()) {
        Some(text) => number.text = text,
        None => {
            // A bound without a unit has the unit of the default value, which changes here.
            let (old, at) = (unit.clone(), *span);
            for bound in parameter.bounds.iter_mut().flat_map(|(a, b)| [a, b]) {
                bound.unit = bound.unit.take().or_else(|| old.clone());
            }
            number.text = shortest(value);
            *unit = Some(UnitExpr::of(declared.unit, at));
        }
    }
    let within = |(low, high): (f64, f64)| low <= value && value <= high;
    if !declared.bounds.is_none_or(within) {
        parameter.bounds = None;
    }
}

fn set_input(input: &mut Input, unit: Unit, si: [f64; 3]) {
    let texts = si.map(|value| literal(value, input.unit.as_ref()));
    let texts = match texts {
        [Some(x), Some(y), Some(z)] => [x, y, z],
        _ => {
            input.unit = Some(UnitExpr::of(unit, input.name.span));
            si.map(shortest)
        }
    };
    for (number, text) in input.value.iter_mut().zip(texts) {
        number.text = text;
    }
}

/// Sets in a check case the earlier defaults that it relies on.
fn keep_defaults(case: &mut Check, earlier: &[Default]) {
    let is_set = |case: &Check, default: &Default| {
        case.parts.iter().any(|part| match part {
            CheckPart::Set { name, .. } => {
                let whole = name.text == default.name.text;
                let axis = name.text.strip_prefix(&default.name.text);
                whole || (default.literals.len() == 3 && axis.is_some_and(|a| a.len() == 2))
            }
            CheckPart::Expect { .. } => false,
        })
    };
    for (k, default) in earlier.iter().enumerate() {
        // If a value was replaced several times, the first entry is the default of the model.
        let is_first = earlier[..k]
            .iter()
            .all(|e| e.name.text != default.name.text);
        if is_first && !is_set(case, default) {
            let set = CheckPart::Set {
                name: default.name.clone(),
                value: default.literals.clone(),
                unit: default.unit.clone(),
                span: default.name.span,
            };
            case.parts.insert(0, set);
        }
    }
}

/// Literal that, in the unit `unit`, has exactly the SI value `value`, bit for bit; `None` if there is no such literal.
fn literal(value: f64, unit: Option<&UnitExpr>) -> Option<String> {
    let of = |text: &str| si_value(&Quantity::new(text, None, Span::default()).number, unit);
    let nearest = value / of("1");
    // Conversion rounds: the exact literal, if any, is the nearest floating-point number or one of its neighbours.
    let mut near = [nearest; 5];
    near[1] = nearest.next_up();
    near[2] = nearest.next_down();
    near[3] = near[1].next_up();
    near[4] = near[2].next_down();
    near.into_iter()
        .filter(|number| number.is_finite())
        .map(shortest)
        .find(|text| of(text).to_bits() == value.to_bits())
}

/// Shortest text that parses to `value`; in exponent notation for magnitudes outside 1e-4 to 1e7.
fn shortest(value: f64) -> String {
    match value.abs() {
        0.0 => value.to_string(),
        size if (1e-4..1e7).contains(&size) => value.to_string(),
        _ => format!("{value:e}"),
    }
}

/// SI value of a literal. A missing or unknown unit counts as 1; an invalid literal gives NaN.
fn si_value(number: &Number, unit: Option<&UnitExpr>) -> f64 {
    let of = |unit| check::si_value(number, unit);
    match unit.and_then(of) {
        Some(value) => value,
        None => number.text.parse().unwrap_or(f64::NAN),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::load;

    /// A user-defined model with many kinds of units.
    const OWN: &str = "//! A kite on a string.\n\
        model kite;\nframe N;\n\
        /// Mass of the kite.\nparam m = 320 g in 100 .. 900 g;\n\
        param tilt = 12.5 deg in 0 .. 90;\n\
        param span = 840 mm;\n\
        param turn = 90 rpm;\n\
        param gravity = 9.81 m/s^2;\n\
        param density = 1.2 kg/m^3;\n\
        input wind in N = (18, 0, 0) km/h;\n\
        coefficient C = 0.4 in 0 .. 1;\n\
        coefficient k = -3e-7 /rad;\n\
        point kite { mass m; position (x, y, z) in N; velocity (u, v, w) in N; }\n\
        let air = velocity - wind;\n\
        let drag = density/2*norm(air)*span^2*(C + k*tilt)*cos(tilt) + 0*m*turn;\n\
        force drag = -drag*air;\nforce weight = -m*gravity*N.3;\n\
        marker p in N;\nobserve p_seen = position + p;\n\
        check \"drag\" { set u = 15 m/s; expect der(v) = 0 m/s^2 within 1e-12; expect drag = 0.8 kg/s within 1; }\n";

    fn kite() -> Model {
        load::from_text("kite.hyz", OWN, &[]).unwrap()
    }

    fn defaults(model: &Model) -> Vec<(String, f64)> {
        let each = model.params.iter().chain(&model.coefficients);
        let mut all: Vec<_> = each.map(|p| (p.name.clone(), p.value)).collect();
        for input in &model.inputs {
            for (axis, value) in ["x", "y", "z"].iter().zip(input.value) {
                all.push((format!("{}_{axis}", input.name), value));
            }
        }
        all
    }

    #[test]
    fn the_defaults_are_the_values_to_the_bit_whatever_their_units() {
        let kite = kite();
        let names: Vec<String> = defaults(&kite).into_iter().map(|(name, _)| name).collect();
        let mut seed = 1_u64;
        for round in 0..200 {
            let values: Vec<(String, f64)> = names
                .iter()
                .map(|name| {
                    seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
                    let unit = (seed >> 11) as f64 / (1_u64 << 53) as f64;
                    let scale = [1.0, 1e-6, 1e9, 0.2][round % 4];
                    (name.clone(), 0.1 + unit * scale)
                })
                .collect();
            let each = values.iter().map(|(name, value)| (name.as_str(), *value));
            let changed = kite.with_values(each).unwrap();
            let text = changed.to_text("Fitted.");
            let again = load::from_text("fitted.hyz", &text, &[]);
            let again = again.unwrap_or_else(|error| panic!("{error}\n{text}"));
            for ((name, value), (_, found)) in values.iter().zip(defaults(&again)) {
                assert_eq!(
                    value.to_bits(),
                    found.to_bits(),
                    "{name}: {value} in\n{text}"
                );
            }
        }
    }

    #[test]
    fn comments_units_and_bounds_stay() {
        let changed = kite()
            .with_values([("m", 0.25), ("tilt", 0.25), ("span", 0.5), ("wind_y", 2.5)])
            .unwrap();
        let text = changed.to_text("Fitted.");
        for line in [
            "//! A kite on a string.",
            "/// Mass of the kite.",
            "param m = 250 g in 100 .. 900 g;",
            "param span = 500 mm;",
            "input wind in N = (18, 9, 0) km/h;",
        ] {
            assert!(text.contains(line), "{line} in\n{text}");
        }
        let model = changed.check().unwrap();
        let tilt = model.params.iter().find(|p| p.name == "tilt").unwrap();
        assert_eq!(tilt.bounds.unwrap().1, 90.0 * std::f64::consts::PI / 180.0);
    }

    #[test]
    fn a_check_case_keeps_the_defaults_that_it_was_stated_for() {
        let disc = load::load("disc", &[]).unwrap();
        let changed = disc.with_values([("C_D0", 0.08), ("C_L0", 0.3)]).unwrap();
        let text = changed.to_text("");
        let case = text.split("check \"drag alone").nth(1).unwrap();
        let case = case.split('}').next().unwrap();
        assert_eq!(case.matches("set C_D0 = 0.15").count(), 1, "{case}");
        assert_eq!(case.matches("set C_L0").count(), 1, "{case}");
        assert!(load::from_text("fitted.hyz", &text, &[]).is_ok(), "{text}");
        // Nothing changes if a value equals the default.
        let same = disc.with_values([("C_D0", 0.15)]).unwrap();
        assert_eq!(same.to_text(""), ModelTree::of(&disc).to_text(""));
    }

    #[test]
    fn a_bound_that_the_value_violates_is_dropped() {
        let changed = kite().with_values([("C", 1.5)]).unwrap();
        let model = changed.check().unwrap();
        assert_eq!(model.coefficients[0].bounds, None);
    }

    #[test]
    fn names_and_numbers_that_cannot_be_are_refused() {
        let error = kite().with_values([("C_X", 1.0)]).unwrap_err();
        assert!(matches!(error, ValueError::UnknownName { name } if name == "C_X"));
        let error = kite().with_values([("wind_w", 1.0)]).unwrap_err();
        assert!(matches!(error, ValueError::UnknownName { .. }));
        let error = kite().with_values([("C", f64::NAN)]).unwrap_err();
        assert!(matches!(error, ValueError::NotFinite { .. }));
    }
}

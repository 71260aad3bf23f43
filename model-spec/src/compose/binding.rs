//! Test of whether an effect can be applied to a model, by names, kinds and units, without applying it.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use thiserror::Error;

use super::EffectTree;
use crate::effect::{self, FRAMES, INERTIA, MASS, PREVIOUS};
use crate::model::{Model, Shape};
use crate::syntax::ast::{
    EffectPart, Expr, ExprKind, File, ItemKind, LoadClass, Need, UnitExpr, UnitFactor,
};
use crate::unit::{Unit, symbol};

const POSITION: &str = "position";
const VELOCITY: &str = "velocity";
const ANGULAR_VELOCITY: &str = "angular_velocity";
const SPECIFIC_FORCE: &str = "specific_force";
const ANGULAR_ACCELERATION: &str = "angular_acceleration";

/// Named in messages where a model lacks one.
const BODY: &str = "a body or a point";
/// Named in messages where a model lacks one.
const TURNING: &str = "a body that turns";

/// Reason why an effect cannot be applied to a model: a requirement of the effect that the model does not meet.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum Unmet {
    /// The effect states by `on MODEL, …` that it applies to certain models only, and this model is not one of them.
    #[error("it is made for {}", .models.join(", "))]
    OtherModel {
        /// Names of the models to which the effect can be applied.
        models: Vec<String>,
    },
    /// The model lacks a quantity, frame or body that the effect needs or uses.
    #[error("it needs {what}")]
    Lacking {
        /// Description of the missing quantity, frame or body, such as ``a vector `wind` in m/s``.
        what: String,
    },
    /// A quantity of the model differs in kind or unit from the quantity of the same name that the effect needs.
    #[error("it needs {what}; here `{name}` is {found}")]
    Differs {
        /// Name of the quantity, which is the same in the model and in the effect.
        name: String,
        /// Description of the needed quantity, such as ``a vector `wind` in m/s``.
        what: String,
        /// Kind and unit of the model's quantity, such as `a vector in m/s`.
        found: String,
    },
    /// The effect contains a `replace` statement, but the model has no corresponding statement to be replaced.
    #[error("the model has no {what} to replace")]
    Replaced {
        /// Description of the statement that the `replace` statement of the effect is to replace, for messages.
        what: String,
    },
    /// The effect declares a name that the model already declares.
    #[error("the model has a `{name}` of its own")]
    Taken {
        /// Name that both the model and the effect declare.
        name: String,
    },
}

/// Names that a model declares, with kinds and units, against which the requirements of effects are tested.
#[derive(Clone, Debug)]
pub struct Binding {
    file: Arc<File>,
    values: BTreeMap<String, (bool, Unit)>,
    frames: BTreeSet<String>,
    has_body: bool,
    turns: bool,
}

impl Binding {
    /// Collects the names that a checked model declares, with their kinds and units.
    pub fn new(model: &Model) -> Binding {
        let mut values = BTreeMap::new();
        let mut add = |name: &str, is_vector: bool, unit: Unit| {
            values.insert(name.to_owned(), (is_vector, unit));
        };
        for constant in model.params.iter().chain(&model.coefficients) {
            add(&constant.name, false, constant.unit);
        }
        for input in &model.inputs {
            add(&input.name, true, input.unit);
            for axis in ["x", "y", "z"] {
                add(&format!("{}_{axis}", input.name), false, input.unit);
            }
        }
        for state in &model.states {
            add(&state.name, false, state.unit);
        }
        for own in &model.aux_variables {
            add(&own.name, own.value.shape != Shape::Scalar, own.value.unit);
        }
        if let Some(marker) = &model.marker {
            add(&marker.name, true, Unit::METRE);
        }
        let body = model.body.as_ref();
        let turns = body.is_some_and(|body| body.rotation.is_some());
        if body.is_some() {
            add(POSITION, true, Unit::METRE);
            add(VELOCITY, true, Unit::SPEED);
            add(SPECIFIC_FORCE, true, Unit::ACCELERATION);
            values
                .entry(MASS.to_owned())
                .or_insert((false, Unit::KILOGRAM));
        }
        let mut frames: BTreeSet<String> = model.frames.iter().map(|f| f.name.clone()).collect();
        frames.insert(FRAMES[0].to_owned());
        if turns {
            values.insert(ANGULAR_VELOCITY.to_owned(), (true, Unit::RATE));
            let acceleration = (true, Unit::ANGULAR_ACCELERATION);
            values.insert(ANGULAR_ACCELERATION.to_owned(), acceleration);
            for name in INERTIA {
                values
                    .entry(name.to_owned())
                    .or_insert((false, Unit::INERTIA));
            }
            frames.insert(FRAMES[1].to_owned());
        }
        Binding {
            file: Arc::clone(&model.tree),
            frames,
            has_body: body.is_some(),
            turns,
            values,
        }
    }

    /// First requirement of the effect that the model does not meet; `None` if it meets all.
    pub fn unmet(&self, effect: &EffectTree) -> Option<Unmet> {
        self.fits(effect).err()
    }

    fn fits(&self, effect: &EffectTree) -> Result<(), Unmet> {
        let effect = effect.tree();
        if effect.excludes(self.file.model().map_or("", |name| &name.text)) {
            return Err(Unmet::OtherModel {
                models: effect.on.iter().map(|on| on.text.clone()).collect(),
            });
        }
        let mut own: BTreeSet<&str> = BTreeSet::new();
        let mut fallbacks: BTreeMap<&str, &Expr> = BTreeMap::new();
        for part in &effect.parts {
            match part {
                EffectPart::Needs(needs) => {
                    for need in needs {
                        if let (None, Some(e)) = (self.needed(need)?, &need.otherwise) {
                            fallbacks.insert(&need.name.text, e);
                        }
                    }
                }
                EffectPart::Add(item) => {
                    if let Some(name) = self.declared(&item.kind)? {
                        own.insert(name);
                    }
                }
                _ => {}
            }
        }
        let uses = Uses {
            binding: self,
            own,
            fallbacks,
        };
        for part in &effect.parts {
            match part {
                EffectPart::Replace(item) => {
                    // A model without a clock rate has the clock rate 1.
                    let is_clock = matches!(item.kind, ItemKind::Clock(_));
                    if !is_clock && !self.has_replaceable(&item.kind) {
                        return Err(replaced(effect::description(&item.kind)));
                    }
                    item.kind.value().map_or(Ok(()), |e| uses.all_of(e))?;
                }
                EffectPart::Add(item) => {
                    item.kind.value().map_or(Ok(()), |e| uses.all_of(e))?;
                }
                EffectPart::ReplaceInertia(inertia, _) => {
                    if !self.turns {
                        return Err(replaced("moments of inertia"));
                    }
                    self.frame(&inertia.frame.text)?;
                    for moment in inertia.rows.iter().flatten().flatten() {
                        uses.all_of(moment)?;
                    }
                }
                _ => {}
            }
        }
        Ok(())
    }

    /// Tests for a needed quantity; `None` if a fallback replaces it.
    fn needed(&self, need: &Need) -> Result<Option<()>, Unmet> {
        let name = &need.name.text;
        let unit = need.unit.as_ref().map_or(Some(Unit::ONE), si_unit);
        match self.values.get(name) {
            Some((is_vector, own))
                if *is_vector == need.is_vector && unit.is_some_and(|unit| own.agrees(unit)) =>
            {
                Ok(Some(()))
            }
            Some((is_vector, own)) => Err(Unmet::Differs {
                name: name.clone(),
                what: described(need),
                found: format!("a {} in {own}", kind(*is_vector)),
            }),
            None if need.otherwise.is_some() => Ok(None),
            None => Err(lacking(described(need))),
        }
    }

    /// Tests a statement that an effect adds; returns the name that it declares, if any.
    fn declared<'e>(&self, item: &'e ItemKind) -> Result<Option<&'e str>, Unmet> {
        match item {
            // Several effects may declare the same input.
            ItemKind::Input(own) => {
                self.frame(&own.frame.text)?;
                return Ok(Some(&own.name.text));
            }
            ItemKind::Load(load) => {
                let is_force = load.class == LoadClass::Force;
                if !self.has_body {
                    return Err(lacking(BODY));
                }
                if !is_force && !self.turns {
                    return Err(lacking(TURNING));
                }
                if self.has_replaceable(item) {
                    let name = load.name.text.clone();
                    return Err(Unmet::Taken { name });
                }
                return Ok(None);
            }
            _ => {}
        }
        let Some(name) = item.declared() else {
            return Ok(None);
        };
        let is_other = name.text != MASS && !INERTIA.contains(&name.text.as_str());
        if is_other && self.values.contains_key(&name.text) {
            return Err(Unmet::Taken {
                name: name.text.clone(),
            });
        }
        Ok(Some(&name.text))
    }

    /// Whether the model has a statement that the statement `replace new` of an effect can replace.
    fn has_replaceable(&self, new: &ItemKind) -> bool {
        let mut items = self.file.items.iter();
        items.any(|old| effect::replaces(new, &old.kind))
    }

    fn frame(&self, frame: &str) -> Result<(), Unmet> {
        if self.frames.contains(frame) {
            Ok(())
        } else if frame == FRAMES[1] {
            Err(lacking(TURNING))
        } else {
            Err(lacking(format!("a frame `{frame}`")))
        }
    }
}

/// Names that the expressions of an effect may use.
struct Uses<'a> {
    binding: &'a Binding,
    own: BTreeSet<&'a str>,
    fallbacks: BTreeMap<&'a str, &'a Expr>,
}

impl Uses<'_> {
    fn all_of(&self, e: &Expr) -> Result<(), Unmet> {
        match &e.kind {
            ExprKind::Name(name) => return self.value(name),
            ExprKind::Derivative(state) => return self.value(&state.text),
            ExprKind::Components(_, frame) => self.binding.frame(&frame.text)?,
            ExprKind::Call(function, _) => {
                let frame = function.text.strip_prefix("in_");
                if let Some(frame) = frame.filter(|_| function.text != "in_frame_of") {
                    self.binding.frame(frame)?;
                }
            }
            // In `F.3`, `F` is a frame or a vector.
            ExprKind::Part(of, _) => {
                if let ExprKind::Name(name) = &of.kind
                    && self.value(name).is_err()
                {
                    let is_frame = self.binding.frame(name);
                    let of_body = [POSITION, VELOCITY].contains(&name.as_str());
                    return match is_frame {
                        Err(_) if of_body => self.value(name),
                        other => other,
                    };
                }
            }
            _ => {}
        }
        let mut result = Ok(());
        e.children(&mut |child| {
            if result.is_ok() {
                result = self.all_of(child);
            }
        });
        result
    }

    fn value(&self, name: &str) -> Result<(), Unmet> {
        if [PREVIOUS, "pi", "time"].contains(&name) || self.own.contains(name) {
            return Ok(());
        }
        if let Some(otherwise) = self.fallbacks.get(name) {
            // The fallback expression of a quantity must not use that quantity.
            return match &otherwise.kind {
                ExprKind::Name(own) if own == name => Err(lacking(format!("`{name}`"))),
                _ => self.all_of(otherwise),
            };
        }
        match name {
            _ if self.binding.values.contains_key(name) => Ok(()),
            POSITION | VELOCITY | SPECIFIC_FORCE | MASS => Err(lacking(BODY)),
            ANGULAR_VELOCITY | ANGULAR_ACCELERATION => Err(lacking(TURNING)),
            _ if INERTIA.contains(&name) => Err(lacking(TURNING)),
            _ => Err(lacking(format!("a quantity `{name}`"))),
        }
    }
}

fn lacking(what: impl Into<String>) -> Unmet {
    Unmet::Lacking { what: what.into() }
}

fn replaced(what: impl Into<String>) -> Unmet {
    Unmet::Replaced { what: what.into() }
}

fn kind(is_vector: bool) -> &'static str {
    if is_vector { "vector" } else { "number" }
}

/// Text that describes a quantity that an effect needs: kind, name and unit.
fn described(need: &Need) -> String {
    let unit = need.unit.as_ref().map(|unit| format!(" in {unit}"));
    let (kind, name) = (kind(need.is_vector), &need.name.text);
    format!("a {kind} `{name}`{}", unit.unwrap_or_default())
}

/// SI unit of a unit expression, without factor; `None` if it is invalid.
fn si_unit(expression: &UnitExpr) -> Option<Unit> {
    let power = |factor: &UnitFactor| {
        let symbol = symbol::find(&factor.symbol)?;
        symbol.unit.checked_pow_half(factor.doubled)
    };
    let mut factors = expression.factors.iter();
    factors.try_fold(Unit::ONE, |unit, factor| unit.checked_mul(power(factor)?))
}

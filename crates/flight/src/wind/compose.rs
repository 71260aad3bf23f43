//! Composition of a model with a wind: effects of `model-spec/winds`, extended by statements from the data, are applied
//! to the syntax tree of the model.

use std::collections::HashMap;

use model_spec::compose::{EffectTree, ModelTree};
use model_spec::load::{LoadError, WINDS};
use model_spec::model::Model;
use model_spec::syntax::ast::{BinaryOp, EffectPart, Expr, ExprKind, ItemKind};

use super::dryden::{COMPONENTS, gust_spectrum, phase_name};
use super::nodes::{add_let, add_parameter, binary, call, inertial_vector, name, number, sum};
use super::{GustStrength, Gusts, Profile, WindField, table};

/// Height of 20 ft, m, at which the mean wind determines the intensity of low-altitude gusts.
const TWENTY_FEET: f64 = 6.096;

impl WindField {
    /// Adds this wind to the model. The parameters of the wind follow those of the model. With their default values the
    /// wind has no effect; [`parameters`](WindField::parameters) returns the values that represent this wind.
    ///
    /// # Errors
    /// [`LoadError::Faults`] if the model defines neither a velocity of the air `air` nor a velocity through it
    /// `air_velocity`, has no body whose height is known, or already uses names that the wind defines.
    #[doc(hidden)]
    pub fn compose(&self, model: &Model) -> Result<Model, LoadError> {
        let mut tree = ModelTree::of(model);
        let profile = self.profile.as_ref().map(profile).transpose()?;
        let mean = MeanWind {
            has_input: model.inputs.iter().any(|input| input.name == "wind"),
            profile: profile.as_ref(),
        };
        if let Some(profile) = &profile {
            tree = tree.with(profile)?;
        }
        let mut winds = Vec::new();
        winds.extend(profile.is_some().then(|| name("wind_of_profile")));
        if let Some(gusts) = &self.gusts {
            for effect in gust_effects(gusts, &mean)? {
                tree = tree.with(&effect)?;
            }
            winds.push(name("gust_velocity"));
        }
        let Some(added) = sum(winds) else {
            return tree.check();
        };
        let join = |effect| extended(effect, vec![add_let("wind_added", added.clone())]);
        let names = model.aux_variables.iter().map(|own| own.name.as_str());
        let way = match { names }.any(|own| own == "air") {
            true => "wind_in_air",
            false => "wind_in_stream",
        };
        tree.with(&join(way)?)?.check()
    }
}

/// Parses the built-in effect of this name, which adds a wind; its text is a file in `model-spec/winds`.
fn law(name: &str) -> Result<EffectTree, LoadError> {
    let found = WINDS.iter().find(|(own, _)| *own == name);
    let text = found.map_or("", |(_, text)| *text);
    EffectTree::parse(&format!("{name}.hyz"), text)
}

/// Built-in effect of this name that adds a wind, with the statements `parts` appended.
fn extended(name: &str, parts: Vec<EffectPart>) -> Result<EffectTree, LoadError> {
    let mut tree = law(name)?.tree().clone();
    tree.parts.extend(parts);
    Ok(EffectTree::new(tree))
}

fn profile(profile: &Profile) -> Result<EffectTree, LoadError> {
    match profile {
        Profile::Log { .. } => law("log_wind"),
        Profile::Power { .. } => law("power_wind"),
        Profile::Table { rows } => extended("table_wind", table::statements(rows)),
    }
}

/// Mean wind as an expression of the height: the model's constant input `wind` if it has one, plus the wind profile if
/// there is one.
struct MeanWind<'a> {
    has_input: bool,
    profile: Option<&'a EffectTree>,
}

impl MeanWind<'_> {
    /// Expression of the velocity vector of the mean wind at a height; the zero vector if there is neither an input nor
    /// a profile.
    fn at(&self, height: &Expr) -> Expr {
        let input = || call("in_inertial", vec![name("wind")]);
        let of_profile = self.profile.map(|profile| {
            let mut lets = HashMap::new();
            for part in &profile.tree().parts {
                if let EffectPart::Add(item) = part
                    && let ItemKind::Let(own) = &item.kind
                {
                    lets.insert(own.name.text.as_str(), &own.value);
                }
            }
            lets.insert("wind_height", height);
            let mut wind = name("wind_of_profile");
            insert(&mut wind, &lets);
            wind
        });
        let zero = || inertial_vector([0; 3].map(|_| number(0.0, &[("m", 1), ("s", -1)])));
        let all = sum(of_profile.into_iter().chain(self.has_input.then(input)));
        all.unwrap_or_else(zero)
    }
}

/// Replaces, in the expression `e`, each name that is a key of `lets` by the definition in `lets`, recursively; the
/// definitions must not be cyclic.
fn insert(e: &mut Expr, lets: &HashMap<&str, &Expr>) {
    while let ExprKind::Name(own) = &e.kind
        && let Some(value) = lets.get(own.as_str())
    {
        *e = (*value).clone();
    }
    e.children_mut(&mut |child| insert(child, lets));
}

/// The two effects that together define the gust velocity `gust_velocity`. The first one defines the standard
/// deviations and length scales of the gusts, the second one the sinusoids, which are scaled by these quantities.
fn gust_effects(gusts: &Gusts, mean: &MeanWind<'_>) -> Result<[EffectTree; 2], LoadError> {
    let strength = match gusts.strength {
        GustStrength::LowAltitude => {
            let height = number(TWENTY_FEET, &[("m", 1)]);
            extended(
                "low_altitude_gusts",
                vec![add_let("gust_wind_at_20_ft", mean.at(&height))],
            )?
        }
        GustStrength::Stated { .. } => law("stated_gusts")?,
    };
    let mut parts = vec![add_let("gust_wind", mean.at(&name("gust_height")))];
    for (k, component) in COMPONENTS.into_iter().enumerate() {
        let scaled = format!("gust_distance_{component}");
        let length = name(&format!("gust_length_{component}"));
        parts.push(add_let(
            &scaled,
            binary(BinaryOp::Div, name("gust_distance"), length),
        ));
        let mut waves = Vec::new();
        for (term, (wavenumber, amplitude)) in gust_spectrum(k).into_iter().enumerate() {
            let phase = phase_name(component, term + 1);
            parts.push(add_parameter(&phase, "phase of a gust"));
            let angle = binary(BinaryOp::Mul, number(wavenumber, &[]), name(&scaled));
            let angle = binary(BinaryOp::Add, angle, name(&phase));
            let wave = call("sin", vec![angle]);
            waves.push(binary(BinaryOp::Mul, number(amplitude, &[]), wave));
        }
        let all = sum(waves).unwrap_or_else(|| number(0.0, &[]));
        parts.push(add_let(&format!("gust_wave_{component}"), all));
    }
    Ok([strength, extended("dryden_gusts", parts)?])
}

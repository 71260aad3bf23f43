//! Composition of a model with a wind: effects of `model-spec/winds`, extended by statements from the data, are applied
//! to the syntax tree of the model.

use std::collections::HashMap;
use std::fmt::Write;

use model_spec::compose::{EffectTree, ModelTree};
use model_spec::load::{LoadError, WINDS};
use model_spec::model::Model;
use model_spec::syntax::ast::{EffectPart, Expr, ExprKind, ItemKind};

use super::dryden::{COMPONENTS, gust_spectrum, phase_name};
use super::{GustStrength, Gusts, Profile, WindField};

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
        winds.extend(profile.is_some().then_some("wind_of_profile"));
        if let Some(gusts) = &self.gusts {
            for effect in gust_effects(gusts, &mean)? {
                tree = tree.with(&effect)?;
            }
            winds.push("gust_velocity");
        }
        if winds.is_empty() {
            return tree.check();
        }
        let added = format!("let wind_added = {};", winds.join(" + "));
        let has_air = model.aux_variables.iter().any(|own| own.name == "air");
        let way = if has_air {
            "wind_in_air"
        } else {
            "wind_in_stream"
        };
        tree.with(&law(way, &added)?)?.check()
    }
}

/// Built-in effect of this name that adds a wind, with further statements; its text is a file in `model-spec/winds`.
fn law(name: &str, statements: &str) -> Result<EffectTree, LoadError> {
    let found = WINDS.iter().find(|(own, _)| *own == name);
    let text = found.map_or("", |(_, text)| text.trim_end());
    let text = text.strip_suffix('}').unwrap_or(text);
    EffectTree::parse(&format!("{name}.hyz"), &format!("{text}{statements}\n}}"))
}

fn profile(profile: &Profile) -> Result<EffectTree, LoadError> {
    match profile {
        Profile::Log { .. } => law("log_wind", ""),
        Profile::Power { .. } => law("power_wind", ""),
        Profile::Table { rows } => law("table_wind", &table_statements(rows)),
    }
}

/// Statements of the height `wind_height` and, from tables over it, the wind velocity `wind_of_profile`.
fn table_statements(rows: &[[f64; 4]]) -> String {
    let mut text = String::new();
    for axis in 1..=3 {
        let mut knots: Vec<[f64; 2]> = rows.iter().map(|row| [row[0], row[axis]]).collect();
        // A table has at least three knots: the mean of two is inserted between them.
        if let [[low, first], [high, last]] = knots[..] {
            knots.insert(1, [0.5 * (low + high), 0.5 * (first + last)]);
        }
        let knots = knots
            .iter()
            .map(|[height, speed]| format!("{height:?}: {speed:?}"));
        let knots: Vec<String> = knots.collect();
        let _ = writeln!(
            text,
            "table wind_table_{axis}(height: m): m/s = {{ {} }} monotone, constant;",
            knots.join(", ")
        );
    }
    let components = [1, 2, 3].map(|axis| format!("wind_table_{axis}(wind_height)"));
    let components = components.join(", ");
    text + "let wind_height = position.3;\n"
        + &format!("let wind_of_profile = ({components}) in inertial;\n")
}

/// Mean wind as an expression of the height: the model's constant input `wind`, plus the profile, if there are any.
struct MeanWind<'a> {
    has_input: bool,
    profile: Option<&'a EffectTree>,
}

impl MeanWind<'_> {
    /// Velocity of the mean wind at the expression `height`; the zero vector without an input and a profile.
    fn at(&self, height: &str) -> String {
        let mut winds = Vec::new();
        if let Some(profile) = self.profile {
            let mut lets = HashMap::new();
            for part in &profile.tree().parts {
                if let EffectPart::Add(item) = part
                    && let ItemKind::Let(own) = &item.kind
                {
                    lets.insert(own.name.text.as_str(), own.value.kind.clone());
                }
            }
            lets.insert("wind_height", ExprKind::Name(height.to_owned()));
            let mut wind = Expr {
                kind: ExprKind::Name("wind_of_profile".into()),
                span: Default::default(),
            };
            insert(&mut wind, &lets);
            winds.push(format!("({wind})"));
        }
        if self.has_input {
            winds.push("in_inertial(wind)".into());
        }
        if winds.is_empty() {
            winds.push("(0 m/s, 0 m/s, 0 m/s) in inertial".into());
        }
        winds.join(" + ")
    }
}

/// Replaces names in `e` by their definitions in `lets`, recursively; these must not be cyclic.
fn insert(e: &mut Expr, lets: &HashMap<&str, ExprKind>) {
    while let ExprKind::Name(own) = &e.kind
        && let Some(value) = lets.get(own.as_str())
    {
        e.kind = value.clone();
    }
    for child in e.children_mut() {
        insert(child, lets);
    }
}

/// The two effects that together define the gust velocity `gust_velocity`.
fn gust_effects(gusts: &Gusts, mean: &MeanWind<'_>) -> Result<[EffectTree; 2], LoadError> {
    let strength = match gusts.strength {
        GustStrength::LowAltitude => {
            let wind = mean.at(&format!("({TWENTY_FEET} m)"));
            law(
                "low_altitude_gusts",
                &format!("let gust_wind_at_20_ft = {wind};"),
            )?
        }
        GustStrength::Stated { .. } => law("stated_gusts", "")?,
    };
    let wind = mean.at("gust_height");
    let mut text = format!("let gust_wind = {wind};\n");
    for (k, component) in COMPONENTS.into_iter().enumerate() {
        let distance = format!("gust_distance_{component}");
        let _ = writeln!(
            text,
            "let {distance} = gust_distance/gust_length_{component};"
        );
        let mut waves = Vec::new();
        for (term, (wavenumber, amplitude)) in gust_spectrum(k).into_iter().enumerate() {
            let phase = phase_name(component, term + 1);
            let _ = writeln!(text, "/// phase of a gust\nparam {phase} = 0;");
            waves.push(format!(
                "{amplitude:?}*sin({wavenumber:?}*{distance} + {phase})"
            ));
        }
        let _ = writeln!(text, "let gust_wave_{component} = {};", waves.join(" + "));
    }
    Ok([strength, law("dryden_gusts", &text)?])
}

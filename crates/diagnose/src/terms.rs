//! Terms outside the catalogue: a grammar of products of what a flight shows, each on each channel of the loads.
//!
//! A term is tried without a model of its own: where it vanishes, its effect on a flight is that of its channel's load, weighed by the
//! term along the flight.

use flight::BoundModel;
use model_spec::layout::{ParamId, QuantityId};
use model_spec::model::Model;

use crate::catalogue::underscored;
use crate::weighted::Weighted;

/// The effect by which a family of models gets loads that no law gives them.
#[derive(Clone, Copy, Debug)]
pub struct Channels {
    /// The effect's name.
    pub effect: &'static str,
    /// Its text.
    pub text: &'static str,
    /// The coefficient of each channel, where it acts, and how a term is put there.
    pub loads: &'static [(&'static str, &'static str, &'static str)],
    /// Variables of the grammar.
    pub variables: &'static [Variable],
    /// Products of them, by the power of each.
    pub products: &'static [&'static [(usize, i32)]],
}

/// A variable of the grammar.
#[derive(Clone, Copy, Debug)]
pub struct Variable {
    /// The quantity of the channels' effect that holds it.
    pub quantity: &'static str,
    /// How it is written in the notation of the models.
    pub formula: &'static str,
    /// What it is, as reports say it.
    pub word: &'static str,
}

const fn variable(quantity: &'static str, formula: &'static str, word: &'static str) -> Variable {
    Variable {
        quantity,
        formula,
        word,
    }
}

/// The disc's channels, in the D frame.
const DISC: Channels = Channels {
    effect: "loads_of_no_law",
    text: "effect loads_of_no_law {
  site unknown;
  coefficient X_lift = 0 [1]; coefficient X_drag = 0 [1]; coefficient X_side = 0 [1];
  coefficient X_roll = 0 [1]; coefficient X_pitch = 0 [1]; coefficient X_spin = 0 [1];
  let on_spin = ratio(r*d, 2*V, 0);
  let on_speed = log(max(V/(12 [m/s]), 0.01));
  let on_rate_1 = ratio(rate_1*d, 2*V, 0);
  let on_rate_2 = ratio(rate_2*d, 2*V, 0);
  let on_height = z/(1 m);
  let on_time = time/(1 s);
  replace C_L = previous + X_lift;
  replace C_D = previous + X_drag;
  replace roll = previous + q*A*d*X_roll;
  replace pitch = previous + q*A*d*X_pitch;
  replace spin_down = previous + q*A*d*X_spin;
  force side_of_no_law = q*A*X_side*d2;
}",
    loads: &[
        ("X_lift", "lift", "replace C_L = previous + (TERM);"),
        ("X_drag", "drag", "replace C_D = previous + (TERM);"),
        ("X_side", "side", "force NAME = q*A*(TERM)*d2;"),
        ("X_roll", "roll", "replace roll = previous + q*A*d*(TERM);"),
        (
            "X_pitch",
            "pitch",
            "replace pitch = previous + q*A*d*(TERM);",
        ),
        (
            "X_spin",
            "spin",
            "replace spin_down = previous + q*A*d*(TERM);",
        ),
    ],
    variables: &[
        variable("alpha", "alpha", "alpha"),
        variable("on_spin", "ratio(r*d, 2*V, 0)", "spin"),
        variable("on_speed", "log(max(V/(12 [m/s]), 0.01))", "speed"),
        variable("on_rate_1", "ratio(rate_1*d, 2*V, 0)", "rates"),
        variable("on_rate_2", "ratio(rate_2*d, 2*V, 0)", "rates"),
        variable("on_height", "z/(1 m)", "height"),
        variable("on_time", "time/(1 s)", "time"),
    ],
    products: &[
        &[],
        &[(0, 1)],
        &[(0, 2)],
        &[(0, 3)],
        &[(1, 1)],
        &[(1, 2)],
        &[(1, 1), (0, 1)],
        &[(1, 2), (0, 1)],
        &[(1, 1), (0, 2)],
        &[(2, 1)],
        &[(2, 1), (0, 1)],
        &[(2, 1), (1, 1)],
        &[(2, 2)],
        &[(3, 1)],
        &[(4, 1)],
        &[(3, 1), (0, 1)],
        &[(4, 1), (0, 1)],
        &[(5, 1)],
        &[(6, 1)],
        &[(6, 1), (0, 1)],
        &[(6, 1), (1, 1)],
        &[(6, 2)],
    ],
};

/// The ball's channels: against its velocity, up and to the left across it, and across spin and velocity.
const BALL: Channels = Channels {
    effect: "loads_of_no_law",
    text: "effect loads_of_no_law {
  site unknown;
  coefficient X_drag = 0 [1]; coefficient X_lift = 0 [1]; coefficient X_side = 0 [1]; coefficient X_spin = 0 [1];
  let along_of_no_law = unit(air_velocity);
  let left_of_no_law = unit(cross(N.3, air_velocity));
  let on_spin = ratio(norm(omega)*radius, V, 0);
  let on_speed = log(max(V/(5 [m/s]), 0.01));
  let on_height = z/(1 m);
  let on_time = time/(1 s);
  force of_no_law = rho*V^2/2*A*(-X_drag*along_of_no_law + X_side*left_of_no_law
    + X_lift*cross(along_of_no_law, left_of_no_law) + X_spin*cross(unit(omega), along_of_no_law));
}",
    loads: &[
        ("X_drag", "drag", "force NAME = -rho*V^2/2*A*(TERM)*unit(air_velocity);"),
        ("X_lift", "lift", "force NAME = rho*V^2/2*A*(TERM)*cross(unit(air_velocity), unit(cross(N.3, air_velocity)));"),
        ("X_side", "side", "force NAME = rho*V^2/2*A*(TERM)*unit(cross(N.3, air_velocity));"),
        ("X_spin", "lift", "force NAME = rho*V^2/2*A*(TERM)*cross(unit(omega), unit(air_velocity));"),
    ],
    variables: &[
        variable("on_spin", "ratio(norm(omega)*radius, V, 0)", "spin"),
        variable("on_speed", "log(max(V/(5 [m/s]), 0.01))", "speed"),
        variable("on_height", "z/(1 m)", "height"),
        variable("on_time", "time/(1 s)", "time"),
    ],
    products: &[
        &[],
        &[(0, 1)],
        &[(0, 2)],
        &[(1, 1)],
        &[(1, 2)],
        &[(0, 1), (1, 1)],
        &[(2, 1)],
        &[(3, 1)],
        &[(3, 2)],
        &[(0, 1), (3, 1)],
    ],
};

/// Families, the first that fits a model is taken.
pub const FAMILIES: [Channels; 2] = [DISC, BALL];

/// A term on a channel.
#[derive(Clone, Debug, PartialEq)]
pub struct Term {
    /// Index of its channel among the family's loads.
    pub load: usize,
    /// Its factors: variable and power.
    pub product: &'static [(usize, i32)],
}

/// The terms of a family, with where their channels and variables are in a model.
#[derive(Clone, Debug)]
pub struct Grammar {
    /// The family.
    pub channels: Channels,
    /// The terms.
    pub terms: Vec<Term>,
    /// Place of each channel's coefficient among the parameters of the layout.
    pub places: Vec<usize>,
    /// Index of each variable among the quantities of the layout.
    pub quantities: Vec<usize>,
}

impl Grammar {
    /// The grammar in a model that has the channels' effect switched on.
    pub fn new(channels: Channels, layout: &codegen::Layout) -> Option<Self> {
        let load = |(name, ..): &(&str, &str, &str)| layout.parameter(name).map(ParamId::index);
        let places = channels.loads.iter().map(load).collect::<Option<_>>()?;
        let quantity =
            |variable: &Variable| layout.quantity(variable.quantity).map(QuantityId::index);
        let quantities = channels.variables.iter().map(quantity);
        let quantities = quantities.collect::<Option<_>>()?;
        let loads = 0..channels.loads.len();
        let terms = loads.flat_map(|load| {
            let products = channels.products.iter();
            products.map(move |product| Term { load, product })
        });
        Some(Self {
            terms: terms.collect(),
            channels,
            places,
            quantities,
        })
    }

    /// The equations of motion of a body in the conditions of one flight, with the terms' constants from `first` on.
    pub fn motion<'a>(
        &'a self,
        conditions: &'a BoundModel<'a>,
        first: usize,
    ) -> Weighted<'a, impl FnMut(f64, &[f64], &mut [f64])> {
        let loads: Vec<usize> = self.terms.iter().map(|t| self.places[t.load]).collect();
        let mut observer = conditions.observer();
        let mut values = vec![0.0; self.quantities.len()];
        Weighted::new(conditions, &loads, first, move |t, x, weights| {
            let quantities = observer.quantities(t, x);
            for (value, &index) in values.iter_mut().zip(&self.quantities) {
                *value = quantities[index];
            }
            for (weight, term) in weights.iter_mut().zip(&self.terms) {
                let factors = term.product.iter();
                *weight = factors.map(|&(v, power)| values[v].powi(power)).product();
            }
        })
    }

    /// Where a term acts.
    pub fn site(&self, term: usize) -> &'static str {
        self.channels.loads[self.terms[term].load].1
    }

    /// A term in the notation of the models.
    pub fn formula(&self, term: usize) -> String {
        let factor = |&(variable, power): &(usize, i32)| {
            let formula = self.channels.variables[variable].formula;
            match power {
                1 => formula.to_owned(),
                _ => format!("({formula})^{power}"),
            }
        };
        let factors: Vec<String> = self.terms[term].product.iter().map(factor).collect();
        if factors.is_empty() {
            "1".to_owned()
        } else {
            factors.join("*")
        }
    }

    /// What a term depends on.
    pub fn words(&self, term: usize) -> Vec<&'static str> {
        let factors = self.terms[term].product.iter();
        let mut words: Vec<&str> = Vec::new();
        for (variable, _) in factors {
            let word = self.channels.variables[*variable].word;
            if !words.contains(&word) {
                words.push(word);
            }
        }
        words
    }

    /// A short name of a term, as reports have it.
    pub fn name(&self, term: usize) -> String {
        let of = |&(variable, power): &(usize, i32)| {
            let quantity = self.channels.variables[variable].quantity;
            let short = quantity.trim_start_matches("on_").replace('_', "-");
            match power {
                1 => short,
                2 => format!("{short}-squared"),
                _ => format!("{short}-cubed"),
            }
        };
        let factors: Vec<String> = self.terms[term].product.iter().map(of).collect();
        let site = match self.channels.loads[self.terms[term].load].0 {
            "X_spin" if self.channels.loads.len() == 4 => "lift-across-spin",
            _ => self.site(term),
        };
        if factors.is_empty() {
            format!("constant-{site}")
        } else {
            format!("{site}-by-{}", factors.join("-and-"))
        }
    }

    /// The text of an effect that has this term.
    pub fn effect(&self, term: usize, evidence: &str) -> String {
        let name = underscored(&self.name(term));
        let (_, site, load) = self.channels.loads[self.terms[term].load];
        let coefficient = format!("k_{name}");
        let formula = self.formula(term);
        let value = match formula.as_str() {
            "1" => coefficient.clone(),
            _ => format!("{coefficient}*{formula}"),
        };
        let load = load.replace("TERM", &value).replace("NAME", &name);
        let words = self.words(term);
        let variables = match words.is_empty() {
            true => "none".to_owned(),
            false => words.join(", "),
        };
        let doc: String = evidence
            .lines()
            .map(|line| format!("/// {line}\n"))
            .collect();
        format!(
            "{doc}effect {name} {{\n  source \"found in measured flights\";\n  site {site};\n  variables {variables};\n  \
             /// found in measured flights\n  coefficient {coefficient} = 0 [1];\n  {load}\n}}\n"
        )
    }
}

/// The family whose channels a model can have, and the model's text with their effect behind it.
pub fn family(model: &Model, with: &[&str]) -> Option<(Channels, String)> {
    let source = model.sources.first()?;
    FAMILIES.iter().find_map(|channels| {
        let text = format!("{}\n{}\n", source.text, channels.text);
        let with: Vec<&str> = with.iter().copied().chain([channels.effect]).collect();
        model_spec::load::from_text(&source.name, &text, &with).ok()?;
        Some((*channels, text))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::extend::Extension;
    use model_spec::load::load;

    #[test]
    fn every_term_of_the_grammar_can_be_written_into_its_model() {
        for (name, terms) in [("disc", 132), ("ball", 40)] {
            let model = load(name, &[]).expect("a model");
            let (channels, text) = family(&model, &[]).expect("its channels");
            let with = load_with(&model, &text, channels.effect);
            let layout = codegen::Layout::new(&with);
            let grammar = Grammar::new(channels, &layout).expect("its grammar");
            assert_eq!(grammar.terms.len(), terms);
            for term in 0..grammar.terms.len() {
                let names = vec![underscored(&grammar.name(term))];
                let written = vec![grammar.effect(term, "Found.")];
                let extension = Extension::new(&model, &[], names, written);
                let extension = extension.unwrap_or_else(|e| panic!("{}: {e}", grammar.name(term)));
                let text = extension.text(&model, &[], "Extended.").expect("a text");
                let again = model_spec::load::from_text("extended", &text, &[]);
                assert_eq!(
                    again.expect("a model").coefficients.len(),
                    model.coefficients.len() + 1
                );
            }
        }
    }

    fn load_with(model: &Model, text: &str, effect: &str) -> Model {
        model_spec::load::from_text(&model.sources[0].name, text, &[effect]).expect("a model")
    }
}

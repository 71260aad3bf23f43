//! Where each number of a model stands in the plain arrays of generated code.

use model_spec::model::{Expr, ExprKind, Model, Shape};

/// Names of states and parameters in their order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Layout {
    /// The states.
    pub states: Vec<String>,
    /// Parameters, then coefficients, then components of the inputs (`wind_x`, …).
    pub parameters: Vec<String>,
    /// How many of the parameters are constants of the body and the place.
    pub params: usize,
    /// How many are coefficients; the components of the inputs come after them.
    pub coefficients: usize,
    /// Coordinates of the marker; empty where nothing is observed.
    pub marker: Vec<String>,
    /// Named quantities, by component; those of the marker are not among them.
    pub quantities: Vec<String>,
    /// Default values of the parameters.
    pub defaults: Vec<f64>,
    /// Default values of the states.
    pub initial: Vec<f64>,
}

impl Layout {
    /// The layout of a model.
    pub fn new(model: &Model) -> Layout {
        let axes = ["x", "y", "z"];
        let mut parameters: Vec<String> = model.params.iter().map(|p| p.name.clone()).collect();
        parameters.extend(model.coefficients.iter().map(|c| c.name.clone()));
        let mut defaults: Vec<f64> = model.params.iter().map(|p| p.value).collect();
        defaults.extend(model.coefficients.iter().map(|c| c.value));
        for input in &model.inputs {
            parameters.extend(axes.iter().map(|axis| format!("{}_{axis}", input.name)));
            defaults.extend(input.value);
        }
        let states: Vec<String> = model.states.iter().map(|s| s.name.clone()).collect();
        let mut quantities: Vec<String> = Vec::new();
        let scalars: Vec<&str> = model
            .lets
            .iter()
            .filter(|quantity| quantity.value.shape == Shape::Scalar)
            .map(|quantity| quantity.name.as_str())
            .collect();
        for (quantity, of_marker) in model.lets.iter().zip(of_marker(model)) {
            if of_marker {
                continue;
            }
            match quantity.value.shape {
                Shape::Scalar => quantities.push(quantity.name.clone()),
                Shape::Vector(frame) => {
                    for (k, axis) in axes.iter().enumerate() {
                        let plain = if frame == 0 {
                            format!("{}_{axis}", quantity.name)
                        } else {
                            format!("{}_{}", quantity.name, k + 1)
                        };
                        let taken = scalars.contains(&plain.as_str())
                            || states.contains(&plain)
                            || parameters.contains(&plain);
                        quantities.push(if taken {
                            format!("{}_{}{}", quantity.name, model.frames[frame].name, k + 1)
                        } else {
                            plain
                        });
                    }
                }
            }
        }
        Layout {
            states,
            parameters,
            params: model.params.len(),
            coefficients: model.coefficients.len(),
            marker: match &model.marker {
                Some(marker) => axes
                    .iter()
                    .map(|axis| format!("{}_{axis}", marker.name))
                    .collect(),
                None => Vec::new(),
            },
            quantities,
            defaults,
            initial: model.states.iter().map(|s| s.value).collect(),
        }
    }

    /// Place of a parameter of the body.
    pub fn param(&self, k: usize) -> u32 {
        k as u32
    }

    /// Place of a coefficient.
    pub fn coefficient(&self, k: usize) -> u32 {
        (self.params + k) as u32
    }

    /// Place of the first component of an input.
    pub fn input(&self, k: usize) -> u32 {
        (self.params + self.coefficients + 3 * k) as u32
    }

    /// Index of a state by name.
    pub fn state(&self, name: &str) -> Option<usize> {
        self.states.iter().position(|state| state == name)
    }

    /// Index of a parameter, coefficient or input component by name.
    pub fn parameter(&self, name: &str) -> Option<usize> {
        self.parameters
            .iter()
            .position(|parameter| parameter == name)
    }

    /// Indices of the three components of an input by its name.
    pub fn components(&self, input: &str) -> Option<[usize; 3]> {
        let [x, y, z] = ["x", "y", "z"].map(|axis| self.parameter(&format!("{input}_{axis}")));
        Some([x?, y?, z?])
    }

    /// Default values of parameters, coefficients and inputs.
    pub fn default_parameters(&self) -> Vec<f64> {
        self.defaults.clone()
    }

    /// States where a release does not say otherwise.
    pub fn default_states(&self) -> Vec<f64> {
        self.initial.clone()
    }
}

/// Which named quantities depend on the marker: they have a value where one is observed, and none otherwise.
pub fn of_marker(model: &Model) -> Vec<bool> {
    let mut known: Vec<bool> = Vec::new();
    for quantity in &model.lets {
        let found = uses_marker(&quantity.value, &known);
        known.push(found);
    }
    known
}

fn uses_marker(e: &Expr, known: &[bool]) -> bool {
    match e.kind {
        ExprKind::Marker => return true,
        ExprKind::Let(index) => return known.get(index).copied().unwrap_or(false),
        _ => {}
    }
    let mut found = false;
    e.children(&mut |child| found |= uses_marker(child, known));
    found
}

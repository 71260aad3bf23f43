//! Models: how they are loaded and compiled, and their parameter vectors.

use std::sync::{Arc, OnceLock};

use codegen::compile::compile;
use codegen::tape_model::TapeModel;
use flight::{CompiledModel, ModelFunctions};
use model_spec::ModelTree;
use model_spec::compose::ValueError;
use model_spec::layout::Layout;
use model_spec::model::Model as Checked;
use pyo3::prelude::*;
use pyo3::types::PyMapping;

use crate::array::vector;
use crate::errors::{input, raise};

/// A checked model of a flying body.
#[pyclass(subclass, frozen, module = "hyzer._hyzer")]
pub struct Model {
    /// The syntax tree, with effects and values.
    pub tree: ModelTree,
    /// The checked model.
    pub checked: Arc<Checked>,
    /// The layout of states and parameters.
    pub layout: Layout,
    /// Name, path or text by which the model was loaded.
    pub source: String,
    /// Whether effects or values were added to what `source` names.
    pub is_changed: bool,
    compiled: OnceLock<Compiled>,
    tape: OnceLock<TapeModel>,
}

/// A compiled model with the invariants of its default parameters.
pub struct Compiled {
    /// The compiled model.
    pub model: Arc<CompiledModel>,
    /// Invariants of the default parameters.
    pub prepared: Vec<f64>,
}

impl Model {
    /// Loads a model by name, path or text, with effects and values of parameters.
    pub fn load(
        source: String,
        effects: &[String],
        parameters: Option<&Bound<'_, PyMapping>>,
    ) -> PyResult<Model> {
        let tree = match source.contains('\n') {
            true => ModelTree::parse("<text>", &source),
            false => ModelTree::load(&source),
        };
        let mut tree = tree
            .and_then(|tree| tree.with_named(effects))
            .map_err(raise)?;
        if let Some(parameters) = parameters {
            let values = pairs(parameters, "parameters")?;
            let values = values.iter().map(|(name, value)| (name.as_str(), *value));
            tree = tree.with_values(values).map_err(|error| match error {
                ValueError::Load(error) => raise(error),
                other => input(other.to_string()),
            })?;
        }
        let is_changed = parameters.is_some() || !effects.is_empty();
        Ok(Model {
            is_changed,
            ..Model::of(tree, source)?
        })
    }

    /// A model from its syntax tree; `source` is how it was named.
    pub fn of(tree: ModelTree, source: String) -> PyResult<Model> {
        let checked = tree.check().map_err(raise)?;
        Ok(Model {
            layout: Layout::new(&checked),
            checked: Arc::new(checked),
            tree,
            source,
            is_changed: false,
            compiled: OnceLock::new(),
            tape: OnceLock::new(),
        })
    }

    /// Whether the model was loaded from a text.
    pub fn is_text(&self) -> bool {
        self.source.contains('\n')
    }

    /// The compiled model, and what was computed from the default parameters.
    pub fn compiled(&self) -> &Compiled {
        self.compiled.get_or_init(|| {
            let model = Arc::new(CompiledModel::new(&self.checked));
            let mut prepared = vec![0.0; model.functions().prepared_len()];
            model
                .functions()
                .prepare(&self.layout.defaults, &mut prepared);
            Compiled { model, prepared }
        })
    }

    /// The compiled model.
    pub fn compiled_model(&self) -> Arc<CompiledModel> {
        Arc::clone(&self.compiled().model)
    }

    /// The model as a tape, for SIMD lanes. It has all derivatives, so that it hoists what the functions hoist.
    pub fn tape(&self) -> &TapeModel {
        self.tape
            .get_or_init(|| TapeModel::new(&compile(&self.checked)))
    }

    /// The functions of the model.
    pub fn functions(&self) -> &ModelFunctions {
        self.compiled().model.functions()
    }

    /// The parameter vector: an array, or the defaults with the values of a mapping by name.
    pub fn vector_of(&self, p: &Bound<'_, PyAny>) -> PyResult<Vec<f64>> {
        let names = &self.layout.parameters;
        let Ok(mapping) = p.cast::<PyMapping>() else {
            return vector(p, "p", names.len(), |index| names[index].clone());
        };
        let mut values = self.layout.defaults.clone();
        for (name, value) in pairs(mapping, "p")? {
            let index = self.layout.parameter(&name).ok_or_else(|| {
                let known = names.iter().map(String::as_str);
                let hint = flight::release::suggestion(&name, known);
                input(format!(
                    "the model {} has no parameter {name:?}{hint}",
                    self.checked.name
                ))
            })?;
            values[index.index()] = value;
        }
        Ok(values)
    }
}

/// Names and finite numbers of a mapping.
pub fn pairs(mapping: &Bound<'_, PyMapping>, what: &str) -> PyResult<Vec<(String, f64)>> {
    let mut pairs = Vec::new();
    for item in mapping.items()?.iter() {
        let (name, value): (Bound<'_, PyAny>, Bound<'_, PyAny>) = item.extract()?;
        let name: String = name
            .extract()
            .map_err(|_| input(format!("{what}: found the key {name}, expected a name")))?;
        let number: f64 = value
            .extract()
            .map_err(|_| input(format!("{what}: {name} is {value}, expected a number")))?;
        if !number.is_finite() {
            return Err(input(format!(
                "{what}: {name} is {number}, expected a finite number"
            )));
        }
        pairs.push((name, number));
    }
    Ok(pairs)
}

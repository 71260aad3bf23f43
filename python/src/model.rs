//! Models: how they are loaded and compiled, and their parameter vectors.

use std::path::Path;
use std::sync::{Arc, OnceLock};

use codegen::compile::compile;
use codegen::tape_model::TapeModel;
use flight::release::{Name, Vocabulary};
use flight::{CompiledModel, ModelFunctions};
use model_spec::ModelTree;
use model_spec::layout::Layout;
use model_spec::model::Model as Checked;
use pyo3::prelude::*;
use pyo3::types::{PyList, PyMapping};

use crate::array::{labels, vector};
use crate::errors::{input, raise};

/// A checked model of a flying body.
#[pyclass(subclass, frozen, module = "hyzer._hyzer")]
pub struct Model {
    /// The checked model.
    pub checked: Arc<Checked>,
    /// The layout of states and parameters.
    pub layout: Layout,
    /// Name, path or text by which the model was loaded.
    pub source: String,
    /// Whether the model or an effect was read from a file, which may change.
    pub is_of_files: bool,
    /// Effects that were added to what `source` names, as they were named.
    pub added: Vec<String>,
    /// Values that replaced the defaults, SI.
    pub replaced: Vec<(String, f64)>,
    compiled: OnceLock<Compiled>,
    tape: OnceLock<TapeModel>,
    constants: OnceLock<Vec<(usize, Name)>>,
    /// All values that were replaced, once they are asked for.
    overruled: OnceLock<Vec<(String, f64)>>,
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
        // No name and hardly a path has these.
        let tree = match source.contains(['\n', ';']) {
            true => ModelTree::parse("<text>", &source),
            false => ModelTree::load(&source),
        };
        let tree = tree.and_then(|tree| tree.with_named(effects));
        let mut model = Model::of(tree.map_err(raise)?, source)?;
        let is_file = |name: &String| Path::new(name).is_file();
        if let Some(parameters) = parameters {
            let replaced = pairs(parameters, "parameters")?;
            let known = Vocabulary::of(&model.checked);
            for (name, value) in &replaced {
                let mut known = known.parameters.iter().chain(&known.coefficients);
                let known = known.find(|known| known.name == *name);
                if let Some(expected) = known.and_then(|own| own.expected_instead_of(*value)) {
                    let found = format!("parameters: {name} is {value}, expected {expected}");
                    return Err(input(found));
                }
            }
            let values = replaced.iter();
            let values = values.map(|(name, value)| (name.as_str(), *value));
            let tree = model.checked.with_values(values);
            let tree = tree.map_err(|error| input(error.to_string()))?;
            model = Model::of(tree, model.source)?;
            model.replaced = replaced;
        }
        Ok(Model {
            is_of_files: is_file(&model.source) || effects.iter().any(is_file),
            added: effects.to_vec(),
            ..model
        })
    }

    /// A model from its syntax tree; `source` is how it was named.
    pub fn of(tree: ModelTree, source: String) -> PyResult<Model> {
        let checked = tree.check().map_err(raise)?;
        Ok(Model {
            layout: Layout::new(&checked),
            checked: Arc::new(checked),
            source,
            is_of_files: false,
            added: Vec::new(),
            replaced: Vec::new(),
            compiled: OnceLock::new(),
            tape: OnceLock::new(),
            constants: OnceLock::new(),
            overruled: OnceLock::new(),
        })
    }

    /// The text of the model, with effects and values.
    pub fn model_text(&self) -> String {
        ModelTree::of(&self.checked).to_text("")
    }

    /// Whether the model was loaded from a text.
    pub fn is_text(&self) -> bool {
        self.source.contains('\n')
    }

    /// The compiled model, and what was computed from the default parameters.
    pub fn compiled(&self) -> &Compiled {
        self.compiled.get_or_init(|| {
            let model = Arc::new(CompiledModel::new(&self.checked));
            let prepared = model.functions().prepared(&self.layout.defaults);
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

    /// Known constants, by their indices among the parameters, with what their values may be.
    fn constants(&self) -> &[(usize, Name)] {
        self.constants.get_or_init(|| {
            let constants = Vocabulary::of(&self.checked).parameters.into_iter();
            let index = |known: &Name| self.layout.parameter(&known.name);
            constants
                .filter_map(|known| Some((index(&known)?.index(), known)))
                .collect()
        })
    }

    /// Values that were replaced, those of a changed built-in model among them.
    pub fn replaced(&self) -> &[(String, f64)] {
        self.overruled.get_or_init(|| {
            let mut values = flight::release::replaced(&self.checked);
            let is_known = |name: &String| values.iter().any(|(known, _)| known == name);
            let own = self.replaced.iter().filter(|(name, _)| !is_known(name));
            let own: Vec<_> = own.cloned().collect();
            values.extend(own);
            values
        })
    }

    /// The functions of the model.
    pub fn functions(&self) -> &ModelFunctions {
        self.compiled().model.functions()
    }

    /// The parameter vector: an array, or the defaults with the values of a mapping or Series by name.
    pub fn vector_of(&self, p: &Bound<'_, PyAny>) -> PyResult<Vec<f64>> {
        let names = &self.layout.parameters;
        let values = match named_items(p)? {
            Some(items) => self.with(items)?,
            None => vector(p, "p", names)?,
        };
        for (index, known) in self.constants() {
            let value = values[*index];
            if let Some(expected) = known.expected_instead_of(value) {
                let name = &known.name;
                return Err(input(format!("p: {name} is {value}, expected {expected}")));
            }
        }
        Ok(values)
    }

    /// The defaults with values by name.
    fn with(&self, items: Bound<'_, PyAny>) -> PyResult<Vec<f64>> {
        let names = &self.layout.parameters;
        let mut values = self.layout.defaults.clone();
        for (name, value) in numbers_of(&items, "p")? {
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

/// Pairs of a mapping, or of a Series whose labels are names; nothing of an array.
fn named_items<'py>(p: &Bound<'py, PyAny>) -> PyResult<Option<Bound<'py, PyAny>>> {
    if let Ok(mapping) = p.cast::<PyMapping>() {
        return Ok(Some(mapping.items()?.into_any()));
    }
    match labels(p)? {
        Some(labels) => {
            let Some(names) = labels.into_iter().collect::<Option<Vec<String>>>() else {
                return Ok(None);
            };
            let numpy = p.py().import("numpy")?;
            let values = numpy.call_method1("asarray", (p,))?.try_iter()?;
            let values: Vec<_> = values.collect::<PyResult<_>>()?;
            if values.len() != names.len() {
                return Ok(None);
            }
            let pairs = PyList::new(p.py(), names.into_iter().zip(values))?;
            Ok(Some(pairs.into_any()))
        }
        None => Ok(None),
    }
}

/// Names and finite numbers of a mapping.
pub fn pairs(mapping: &Bound<'_, PyMapping>, what: &str) -> PyResult<Vec<(String, f64)>> {
    numbers_of(mapping.items()?.as_any(), what)
}

/// Names and finite numbers of pairs.
fn numbers_of(items: &Bound<'_, PyAny>, what: &str) -> PyResult<Vec<(String, f64)>> {
    let mut pairs = Vec::new();
    for item in items.try_iter()? {
        let (name, value): (Bound<'_, PyAny>, Bound<'_, PyAny>) = item?.extract()?;
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

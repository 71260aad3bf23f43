//! Effects generated for the scalar inputs of a model: errors of what was recorded.

use super::EffectTree;
use super::rates::per_second;
use crate::syntax::ast::{File, Item, ItemKind, Parameter, ParameterClass};
use crate::syntax::of_kind;

/// Maximum number of inputs per model for which effects are created.
const MAX_INPUTS: usize = 24;

/// Creates four effects for each scalar input: it acts with an offset, as a multiple, later, or through a lag.
pub(super) fn input_effects(file: &File) -> Vec<EffectTree> {
    // Inputs that effects added, such as the rate of an input, are no recordings; and what stands beside the unknowns of
    // flights is in no text of the model.
    let aside = &file.set_aside;
    let is_beside = |item: &Item| !aside.unknown.is_empty() && item.span.source == aside.source;
    let own = file.items.iter();
    let own = own.filter(|item| item.effect.is_none() && !is_beside(item));
    let inputs =
        of_kind!(own, ItemKind::Parameter).filter(|own| own.class == ParameterClass::Input);
    let inputs: Vec<&Parameter> = inputs.take(MAX_INPUTS).collect();
    let has = |name: &str| inputs.iter().any(|own| own.name.text == name);
    let goes_with_another = |input: &Parameter| {
        let of = ["_rate", "_lagging"].map(|end| input.name.text.strip_suffix(end));
        of.into_iter().flatten().any(has)
    };
    let recorded = inputs.iter().filter(|input| !goes_with_another(input));
    recorded
        .flat_map(|input| errors_of(input, has(&format!("{}_rate", input.name.text))))
        .filter_map(|text| EffectTree::parse("inputs of the model", &text).ok())
        .collect()
}

/// Texts of the effects of one input; `has_rate` tells whether the model itself has its rate as an input.
fn errors_of(input: &Parameter, has_rate: bool) -> [String; 4] {
    let name = &input.name.text;
    let unit = |seconds: i32| match per_second(input.value.unit.as_ref(), seconds) {
        unit if unit.is_empty() => "[1]".to_owned(),
        unit => format!("[{unit}]"),
    };
    let effect = |kind: &str, says: &str, site: &str, statements: String| {
        format!(
            "/// The input {name} {says}.\n\
             effect {kind}_of_{name} {{\n\
             source \"the recording of an input\";\n\
             site {site};\n\
             variables none;\n\
             {statements}\n}}\n"
        )
    };
    let own = unit(0);
    let rate = match has_rate {
        true => String::new(),
        false => format!(
            "/// time derivative of {name}\ninput {name}_rate: {} = 0;\n",
            unit(1)
        ),
    };
    [
        effect(
            "bias",
            "acts with an offset from what was recorded",
            "unknown",
            format!(
                "/// what acts beyond what was recorded\n\
                 coefficient k_bias_of_{name} = 0 {own};\n\
                 negligible k_bias_of_{name} 1e-3 {own};\n\
                 replace {name} = previous + k_bias_of_{name};"
            ),
        ),
        effect(
            "scale",
            "acts as a multiple of what was recorded",
            "scale",
            format!(
                "/// excess of what acts, over what was recorded\n\
                 coefficient k_scale_of_{name} = 0 in -0.95 .. 10;\n\
                 negligible k_scale_of_{name} 1e-3;\n\
                 replace {name} = previous*(1 + k_scale_of_{name});"
            ),
        ),
        effect(
            "delay",
            "acts later than it was recorded",
            "clock",
            format!(
                "{rate}/// time by which it acts later\n\
                 coefficient k_delay_of_{name} = 0 s in -1 .. 1;\n\
                 negligible k_delay_of_{name} 1e-4 s;\n\
                 replace {name}_in_time = previous - k_delay_of_{name}*{name}_rate;"
            ),
        ),
        effect(
            "lag",
            "acts through a lag of first order, as of an actuator",
            "clock",
            format!(
                "/// decrease of what acts with the time constant of the lag\n\
                 input {name}_lagging: {} = 0;\n\
                 /// time constant of the lag\n\
                 coefficient k_lag_of_{name} = 0 s in 0 .. 5;\n\
                 negligible k_lag_of_{name} 1e-4 s;\n\
                 replace {name}_in_time = previous - k_lag_of_{name}*{name}_lagging;",
                unit(1)
            ),
        ),
    ]
}

//! LaTeX names of model variables in the notation of the paper.

use super::piece::braces;

const GREEK: [&str; 25] = [
    "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "iota", "kappa",
    "lambda", "mu", "nu", "xi", "rho", "sigma", "tau", "upsilon", "phi", "chi", "psi", "omega",
    "Gamma", "Delta", "Omega",
];

/// Typeface of a variable name in LaTeX: italic for scalars, bold for vectors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Style {
    Scalar,
    Vector,
}

pub(crate) fn name(name: &str, style: Style) -> String {
    if let Some(state) = name.strip_prefix("der(").and_then(|n| n.strip_suffix(')')) {
        return rate(state);
    }
    // `der_x` is the auxiliary variable of a derivative, `x_dot` its name in generated code.
    if let Some(state) = name
        .strip_prefix("der_")
        .or_else(|| name.strip_suffix("_dot"))
        && !state.is_empty()
    {
        return rate(state);
    }
    if let Some(angle) = name.strip_suffix("dot")
        && is_letter(angle)
    {
        return dotted(r"\dot", angle);
    }
    let (base, index) = split(name);
    let symbol = symbol(&base, style);
    if index.is_empty() {
        symbol
    } else {
        format!("{symbol}_{}", braces(&index))
    }
}

pub(crate) fn rate(state: &str) -> String {
    match state.strip_suffix("dot") {
        Some(angle) if is_letter(angle) => dotted(r"\ddot", angle),
        _ if is_letter(state) => dotted(r"\dot", state),
        _ => format!(r"\dot{{{}}}", name(state, Style::Scalar)),
    }
}

pub(crate) fn words(name: &str) -> String {
    format!(r"\mathrm{{{}}}", name.replace('_', r"\ "))
}

fn dotted(dot: &str, letter: &str) -> String {
    if GREEK.contains(&letter) {
        format!(r"{dot}\{letter}")
    } else {
        format!("{dot}{{{letter}}}")
    }
}

fn is_letter(name: &str) -> bool {
    GREEK.contains(&name) || name.chars().count() == 1
}

/// Splits a name into base symbol and LaTeX of its subscript: `v_x` into `v` and `x`.
fn split(name: &str) -> (String, String) {
    let mut parts: Vec<&str> = name.split('_').filter(|part| !part.is_empty()).collect();
    let mut base = String::new();
    // Consecutive words form the base; parts after a letter form the subscript.
    while let Some(&part) = parts.first() {
        let word = part.chars().count() > 2 && !GREEK.contains(&part) && !ends_in_digit(part);
        if !(base.is_empty() || word && is_word(&base)) {
            break;
        }
        if !base.is_empty() {
            base.push('_');
        }
        base.push_str(part);
        parts.remove(0);
    }
    let mut index: Vec<String> = Vec::new();
    let letters = base.trim_end_matches(|c: char| c.is_ascii_digit());
    if letters.len() < base.len() && is_letter(letters) {
        index.push(base[letters.len()..].to_string());
        base.truncate(letters.len());
    }
    let coefficient = base == "C";
    index.extend(parts.into_iter().map(|part| below(part, coefficient)));
    (base, index.join(","))
}

fn ends_in_digit(part: &str) -> bool {
    part.ends_with(|c: char| c.is_ascii_digit())
}

fn is_word(base: &str) -> bool {
    base.chars().count() > 1 && !GREEK.contains(&base)
}

/// LaTeX of an element of a subscript; of a `coefficient`, `La` becomes `L\alpha`.
fn below(part: &str, coefficient: bool) -> String {
    if GREEK.contains(&part) {
        return format!(r"\{part}");
    }
    let mut letters = part.chars();
    if coefficient
        && let (Some(first), Some('a'), None) = (letters.next(), letters.next(), letters.next())
        && first.is_ascii_uppercase()
    {
        return format!(r"{first}\alpha");
    }
    if part.chars().count() > 2 && part.chars().all(|c| c.is_ascii_lowercase()) {
        return words(part);
    }
    part.to_string()
}

fn symbol(base: &str, style: Style) -> String {
    let greek = GREEK.contains(&base);
    match style {
        Style::Scalar if greek => format!(r"\{base}"),
        Style::Scalar if base.chars().count() == 1 => base.to_string(),
        Style::Scalar => words(base),
        Style::Vector if greek => format!(r"\boldsymbol{{\{base}}}"),
        Style::Vector => format!(r"\mathbf{{{}}}", base.replace('_', r"\ ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_in_the_notation_of_the_paper() {
        for (plain, latex) in [
            ("C_L0", "C_{L0}"),
            ("C_La", r"C_{L\alpha}"),
            ("C_Da", r"C_{D\alpha}"),
            ("C_Ma", r"C_{M\alpha}"),
            ("C_Mq", "C_{Mq}"),
            ("C_L", "C_L"),
            ("I_a", "I_a"),
            ("rho", r"\rho"),
            ("phidot", r"\dot\phi"),
            ("xdot", r"\dot{x}"),
            ("alpha_0", r"\alpha_0"),
            ("der(u)", r"\dot{u}"),
            ("der(phidot)", r"\ddot\phi"),
            ("u_dot", r"\dot{u}"),
            ("der_phidot", r"\ddot\phi"),
            ("wind_x", r"\mathrm{wind}_x"),
            ("rate_1", r"\mathrm{rate}_1"),
            ("lift", r"\mathrm{lift}"),
            ("spin_down", r"\mathrm{spin\ down}"),
            ("air_velocity_1", r"\mathrm{air\ velocity}_1"),
            ("d1_2", "d_{1,2}"),
            ("F_b1", "F_{b1}"),
        ] {
            assert_eq!(name(plain, Style::Scalar), latex, "{plain}");
        }
        for (plain, latex) in [
            ("d1", r"\mathbf{d}_1"),
            ("air_velocity", r"\mathbf{air\ velocity}"),
            ("omega", r"\boldsymbol{\omega}"),
        ] {
            assert_eq!(name(plain, Style::Vector), latex, "{plain}");
        }
    }
}

//! LaTeX formulas as plain text for a terminal.

use std::iter::Peekable;
use std::str::Chars;

/// Deepest nesting of commands and braces that is converted.
const MAX_DEPTH: usize = 400;

/// Commands that are not written as their names, and what is written.
const SIGNS: &str = "alpha α beta β gamma γ delta δ epsilon ε zeta ζ eta η theta θ iota ι kappa κ lambda λ mu μ nu ν xi ξ \
    pi π rho ρ sigma σ tau τ upsilon υ phi φ chi χ psi ψ omega ω Gamma Γ Delta Δ Omega Ω \
    cdot · times × neq ≠ geq ≥ leq ≤ ge ≥ le ≤ infty ∞";

/// Commands that write nothing: fonts, and spaces that are none in text.
const SILENT: &str = "mathbf mathrm boldsymbol operatorname text left right big , .";

const SUPERSCRIPTS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];

/// Text of a formula in the LaTeX that the compiler writes: one line, names as in the model language.
pub fn plain(latex: &str) -> String {
    let mut reader = Reader {
        chars: latex.chars().peekable(),
        depth: 0,
    };
    let mut text = String::new();
    while reader.chars.peek().is_some() {
        text += &reader.sequence();
        // A brace that closes nothing.
        reader.chars.next();
    }
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    text.replace(" ;", ";").replace("if otherwise", "otherwise")
}

struct Reader<'l> {
    chars: Peekable<Chars<'l>>,
    depth: usize,
}

impl Reader<'_> {
    /// Text up to a closing brace or the end.
    fn sequence(&mut self) -> String {
        let mut text = String::new();
        while let Some(&next) = self.chars.peek() {
            if next == '}' {
                break;
            }
            let part = self.item();
            let is_word = |c: char| c.is_alphabetic() || c.is_ascii_digit();
            // The argument of a function without parentheses.
            let runs_on = FUNCTIONS.iter().any(|name| ends_in(&text, name));
            if runs_on && part.starts_with(is_word) {
                text.push(' ');
            }
            text += &part;
        }
        text
    }

    /// One character, command or group, with what is raised or lowered.
    fn item(&mut self) -> String {
        self.depth += 1;
        let item = match self.chars.next() {
            Some(_) if self.depth > MAX_DEPTH => String::new(),
            Some('{') => self.rest_of_group(),
            Some('\\') => self.command(),
            Some('_') => format!("_{}", self.argument()),
            Some('^') => raised(&self.argument()),
            // Of the cases of a definition.
            Some('&') => "if".to_owned(),
            Some(other) => other.to_string(),
            None => String::new(),
        };
        self.depth -= 1;
        item
    }

    /// The next group, command or character.
    fn argument(&mut self) -> String {
        while self.chars.next_if_eq(&' ').is_some() {}
        self.item()
    }

    fn rest_of_group(&mut self) -> String {
        let text = self.sequence();
        self.chars.next_if_eq(&'}');
        text
    }

    fn command(&mut self) -> String {
        let mut name = String::new();
        while let Some(letter) = self.chars.next_if(char::is_ascii_alphabetic) {
            name.push(letter);
        }
        if name.is_empty() {
            name.extend(self.chars.next());
        }
        match name.as_str() {
            "frac" => {
                let (above, below) = (self.argument(), self.argument());
                format!("{}/{}", grouped(&above), grouped(&below))
            }
            "sqrt" => format!("√{}", grouped(&self.argument())),
            "dot" => dotted(&self.argument(), '\u{307}'),
            "ddot" => dotted(&self.argument(), '\u{308}'),
            "begin" => {
                self.argument();
                "{".to_owned()
            }
            "end" => {
                self.argument();
                "}".to_owned()
            }
            "partial" => {
                self.chars.next_if_eq(&' ');
                "∂".to_owned()
            }
            // The language writes names with underscores.
            " " => "_".to_owned(),
            "\\" => "; ".to_owned(),
            known if SILENT.split(' ').any(|silent| silent == known) => String::new(),
            known => {
                let mut words = SIGNS.split(' ').skip_while(|name| *name != known);
                words.nth(1).unwrap_or(known).to_owned()
            }
        }
    }
}

/// Functions whose argument may have no parentheses.
const FUNCTIONS: [&str; 10] = [
    "sin", "cos", "tan", "arcsin", "arccos", "arctan", "ln", "tanh", "min", "max",
];

/// Whether a text ends in a word.
fn ends_in(text: &str, word: &str) -> bool {
    let before = text.strip_suffix(word);
    before.is_some_and(|before| !before.ends_with(|c: char| c.is_alphanumeric() || c == '_'))
}

/// The text in parentheses, unless it is one name, number or quotient of a derivative.
fn grouped(text: &str) -> String {
    let text = text.trim();
    let is_one = !text.contains([' ', '/', '(', '-', '·']) && !text.is_empty();
    match is_one {
        true => text.to_owned(),
        false => format!("({text})"),
    }
}

fn raised(text: &str) -> String {
    let digits: Option<String> = text
        .chars()
        .map(|c| Some(SUPERSCRIPTS[c.to_digit(10)? as usize]))
        .collect();
    match digits {
        Some(digits) if !digits.is_empty() => digits,
        _ => format!("^{}", grouped(text)),
    }
}

fn dotted(text: &str, dot: char) -> String {
    match text.chars().count() {
        1 => format!("{text}{dot}"),
        _ if dot == '\u{307}' => format!("d({text})/dt"),
        _ => format!("d²({text})/dt²"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_are_read_without_their_marks() {
        for (latex, text) in [
            (
                r"\alpha = \operatorname{atan2}(-\mathbf{air\ velocity} \cdot \mathbf{d}_3,\, x)",
                "α = atan2(-air_velocity · d_3, x)",
            ),
            (
                r"\frac{\partial \alpha}{\partial w} = -\frac{\sqrt{\mathrm{a}_1^2 + b^2}}{V^2}",
                "∂α/∂w = -(√(a_1² + b²))/V²",
            ),
            (
                r"\mathrm{lift} = q A C_{L\alpha} \sin\alpha",
                "lift = q A C_Lα sin α",
            ),
            (r"(a^2)^{3/2} \cos^2\theta", "(a²)^(3/2) cos²θ"),
            (
                r"\ddot\phi = \dot{u} + \dot{\mathrm{spin}}",
                "φ\u{308} = u\u{307} + d(spin)/dt",
            ),
            (
                r"\begin{cases} 0 & x = 0 \\ \frac{a}{x} & \text{otherwise} \end{cases}",
                "{ 0 if x = 0; a/x otherwise }",
            ),
            (r"10^{-3} \left[x \neq 0\right]", "10^(-3) [x ≠ 0]"),
        ] {
            assert_eq!(plain(latex), text);
        }
    }

    #[test]
    fn what_is_no_formula_ends_too() {
        assert_eq!(plain(r"}\frac{a"), "a/()");
        plain(&r"\frac{".repeat(100_000));
        plain(&"{".repeat(100_000));
        assert_eq!(plain(r"\"), "");
        plain(&r"\frac".repeat(100_000));
    }

    #[test]
    fn no_mark_of_latex_is_left_in_any_formula() {
        for (name, _) in model_spec::load::MODELS {
            let model = model_spec::load::load(name, &[]).unwrap();
            for variable in &model.aux_variables {
                let latex = codegen::latex::definition(&model, &variable.name).unwrap();
                let text = plain(&latex);
                let marks = ['\\', '&'];
                assert!(!text.contains(marks), "{latex}: {text}");
            }
        }
    }
}

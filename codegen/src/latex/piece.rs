//! LaTeX fragments with operator precedence, so that parentheses are written only where required.

use crate::functions::commands_with_exponent;

/// Precedence of the outermost operator of a LaTeX fragment, loosest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Bind {
    Sum,
    /// Negated scalar or vector product: in parentheses if it is a factor of another product.
    MinusDotted,
    Minus,
    /// Scalar or vector product: in parentheses if it is a factor of another product.
    Dotted,
    Product,
    Atom,
}

#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Piece {
    pub text: String,
    pub bind: Bind,
    /// Whether the text ends in a function whose argument has no parentheses, such as `\sin\alpha`.
    bare: bool,
}

impl Piece {
    pub fn new(text: impl Into<String>, bind: Bind) -> Piece {
        Piece {
            text: text.into(),
            bind,
            bare: false,
        }
    }

    pub fn atom(text: impl Into<String>) -> Piece {
        Piece::new(text, Bind::Atom)
    }

    pub fn number(value: f64) -> Piece {
        let magnitude = value.abs();
        if magnitude == 0.0 {
            return Piece::atom("0");
        }
        let piece = if (1e-4..1e7).contains(&magnitude) {
            Piece::atom(format!("{magnitude}"))
        } else {
            let text = format!("{magnitude:e}");
            let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
            let power = format!("10^{{{exponent}}}");
            match digits {
                "1" => Piece::new(power, Bind::Product),
                _ => Piece::new(format!(r"{digits} \cdot {power}"), Bind::Product),
            }
        };
        if value < 0.0 { piece.neg() } else { piece }
    }

    /// Adds parentheses unless the fragment binds at least as tightly as `bind`.
    pub fn at_least(self, bind: Bind) -> Piece {
        if self.bind >= bind {
            return self;
        }
        Piece::atom(parentheses(&self.text))
    }

    pub fn add(self, other: Piece) -> Piece {
        let other = other.at_least(Bind::Dotted);
        Piece::new(format!("{} + {}", self.text, other.text), Bind::Sum)
    }

    pub fn sub(self, other: Piece) -> Piece {
        let other = other.at_least(Bind::Dotted);
        Piece::new(format!("{} - {}", self.text, other.text), Bind::Sum)
    }

    pub fn neg(self) -> Piece {
        let inner = self.at_least(Bind::Dotted);
        let bind = match inner.bind {
            Bind::Dotted => Bind::MinusDotted,
            _ => Bind::Minus,
        };
        Piece {
            text: format!("-{}", inner.text),
            bind,
            bare: inner.bare,
        }
    }

    pub fn mul(self, other: Piece) -> Piece {
        let (left, bind) = match self.bind {
            // A leading minus may precede the whole product.
            Bind::Minus => (self, Bind::Minus),
            _ => (self.at_least(Bind::Product), Bind::Product),
        };
        let right = other.at_least(Bind::Product);
        let digit = right.text.starts_with(|c: char| c.is_ascii_digit());
        let apart = [r"\sin", r"\cos", r"\tan", r"\frac", r"\mathbf", r"\sqrt"];
        let swallowed = left.bare && !apart.iter().any(|start| right.text.starts_with(start));
        // Separates adjacent upright words by a space.
        let clear = ["(", r"\left", r"\frac", r"\sqrt", r"\sin", r"\cos", r"\tan"];
        let words = (right.text.starts_with(r"\mathrm") || ends_upright(&left.text))
            && !clear.iter().any(|start| right.text.starts_with(start));
        let sign = match () {
            () if digit || swallowed => r" \cdot ",
            () if words => r" \, ",
            () => " ",
        };
        Piece {
            text: format!("{}{sign}{}", left.text, right.text),
            bind,
            bare: right.bare,
        }
    }

    pub fn div(self, other: Piece) -> Piece {
        let (minus, above) = match self.text.strip_prefix('-') {
            Some(rest) if self.bind == Bind::Minus => ("-", rest.to_string()),
            _ => ("", self.text),
        };
        let bind = if minus.is_empty() {
            Bind::Product
        } else {
            Bind::Minus
        };
        Piece::new(format!(r"{minus}\frac{{{above}}}{{{}}}", other.text), bind)
    }

    /// LaTeX of the fragment to the power `doubled / 2`.
    pub fn power(self, doubled: i32) -> Piece {
        if doubled < 0 {
            return Piece::atom("1").div(self.power(-doubled));
        }
        match doubled {
            1 => Piece::atom(format!(r"\sqrt{{{}}}", self.text)),
            2 => self,
            _ => {
                let exponent = match doubled % 2 {
                    0 => (doubled / 2).to_string(),
                    _ => format!("{doubled}/2"),
                };
                self.raised(&exponent)
            }
        }
    }

    /// LaTeX of the fragment to the power with the LaTeX text `exponent`.
    pub fn raised(self, exponent: &str) -> Piece {
        let exponent = braces(exponent);
        if self.bare
            && self.bind == Bind::Product
            && let Some((function, argument)) = split_function(&self.text)
        {
            return Piece {
                text: format!("{function}^{exponent}{argument}"),
                ..self
            };
        }
        let base = self.at_least(Bind::Atom).text;
        // Not an atom: a second exponent would be an error in LaTeX.
        Piece::new(format!("{base}^{exponent}"), Bind::Product)
    }

    pub fn dotted(self, sign: &str, other: Piece) -> Piece {
        let (a, b) = (self.at_least(Bind::Product), other.at_least(Bind::Product));
        Piece::new(format!(r"{} {sign} {}", a.text, b.text), Bind::Dotted)
    }

    /// LaTeX of a function call; the argument has no parentheses if it is a single symbol.
    pub fn function(name: &str, x: Piece) -> Piece {
        if x.bind == Bind::Atom && is_symbol(&x.text) {
            let gap = if x.text.starts_with('\\') { "" } else { " " };
            return Piece {
                text: format!("{name}{gap}{}", x.text),
                bind: Bind::Product,
                bare: true,
            };
        }
        Piece::new(format!("{name}{}", parentheses(&x.text)), Bind::Atom)
    }

    /// LaTeX of a call of an operator written by name, with the arguments in parentheses.
    pub fn operator(name: &str, arguments: &[Piece]) -> Piece {
        let arguments: Vec<&str> = arguments.iter().map(|a| a.text.as_str()).collect();
        let inside = parentheses(&arguments.join(r",\, "));
        Piece::atom(format!(r"\operatorname{{{name}}}{inside}"))
    }

    /// LaTeX of a case distinction: `other` if the condition `case` holds, else `value`.
    pub fn cases(value: Piece, other: Piece, case: &str) -> Piece {
        Piece::atom(format!(
            r"\begin{{cases}} {} & {case} \\ {} & \text{{otherwise}} \end{{cases}}",
            other.text, value.text
        ))
    }
}

fn ends_upright(text: &str) -> bool {
    text.rfind(r"\mathrm{").is_some_and(|at| {
        let word = text[at..].replace(r"\ ", "");
        !word.contains([' ', ')'])
    })
}

pub(crate) fn parentheses(text: &str) -> String {
    let tall = [r"\frac", r"\begin", r"\sqrt", r"\left"];
    if tall.iter().any(|part| text.contains(part)) {
        format!(r"\left({text}\right)")
    } else {
        format!("({text})")
    }
}

/// Text of a subscript or superscript, in braces if longer than one character.
pub(crate) fn braces(text: &str) -> String {
    if text.chars().count() == 1 {
        text.to_string()
    } else {
        format!("{{{text}}}")
    }
}

/// Whether the LaTeX text `text` is a single letter or command, optionally with a dot accent.
fn is_symbol(text: &str) -> bool {
    let text = text.strip_prefix(r"\dot").unwrap_or(text);
    match text.strip_prefix('\\') {
        Some(word) => word.chars().all(|c| c.is_ascii_alphabetic()),
        None => text.chars().count() == 1,
    }
}

/// Splits a call without parentheses: `\sin\alpha` into `\sin` and `\alpha`.
fn split_function(text: &str) -> Option<(&str, &str)> {
    commands_with_exponent().find_map(|command| {
        let argument = text.strip_prefix(command)?;
        is_symbol(argument.trim_start()).then_some((command, argument))
    })
}

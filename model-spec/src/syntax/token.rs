//! Tokens: their kinds, their spelling, and the longest one that a text begins with.

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Token {
    Comment,
    Name,
    Number,
    Text,
    /// A quoted text whose closing quotation mark is missing, up to the end of the line.
    OpenText,
    Superscript,
    /// An operator, bracket or punctuation mark; each of two marks with one meaning is the ASCII one or the first.
    Sign(&'static str),
    Bad,
    End,
}

/// Spellings of [`Token::Sign`]. A longer one precedes the shorter ones that are its prefixes.
const SIGNS: [&str; 25] = [
    "+", "-", "−", "**", "*", "·", "⋅", "×", "/", "^", "(", ")", "[", "]", "?", "{", "}", ",", ";",
    ":", "=", ">", "<", "..", ".",
];

fn is_space(c: char) -> bool {
    matches!(
        c,
        ' ' | '\t' | '\r' | '\n' | '\u{000C}' | '\u{00A0}' | '\u{FEFF}'
    )
}

fn begins_name(c: char) -> bool {
    c.is_ascii_alphabetic()
        || matches!(c, '_' | '°' | 'µ' | 'ż' | 'ġ' | '\u{0370}'..='\u{03FF}' | '\u{1E00}'..='\u{1EFF}')
}

fn continues_name(c: char) -> bool {
    c != '°' && begins_name(c) || c.is_ascii_digit() || matches!(c, '\u{0307}' | '\u{0308}')
}

pub(crate) fn leading_space(text: &str) -> usize {
    prefix_length(text, is_space)
}

fn is_superscript_digit(c: char) -> bool {
    "⁰¹²³⁴⁵⁶⁷⁸⁹".contains(c)
}

/// Number of bytes at the beginning of a text whose characters all satisfy a condition.
fn prefix_length(text: &str, condition: impl Fn(char) -> bool) -> usize {
    text.find(|c| !condition(c)).unwrap_or(text.len())
}

pub(crate) fn first_token(text: &str) -> Option<(Token, usize)> {
    let first = text.chars().next()?;
    if text.starts_with("//") {
        return Some((Token::Comment, prefix_length(text, |c| c != '\n')));
    }
    if begins_name(first) {
        let begin = first.len_utf8();
        return Some((
            Token::Name,
            begin + prefix_length(&text[begin..], continues_name),
        ));
    }
    if first.is_ascii_digit() {
        return Some((Token::Number, number(text)));
    }
    if first == '"' {
        let inside = prefix_length(&text[1..], |c| !matches!(c, '"' | '\n'));
        let is_closed = text[1 + inside..].starts_with('"');
        return Some(if is_closed {
            (Token::Text, inside + 2)
        } else {
            (Token::OpenText, inside + 1)
        });
    }
    let sign = prefix_length(text, |c| matches!(c, '⁺' | '⁻')).min('⁺'.len_utf8());
    let digits = prefix_length(&text[sign..], is_superscript_digit);
    if digits > 0 {
        return Some((Token::Superscript, sign + digits));
    }
    let sign = SIGNS.into_iter().find(|sign| text.starts_with(sign))?;
    let meant = match sign {
        "−" => "-",
        "⋅" => "·",
        other => other,
    };
    Some((Token::Sign(meant), sign.len()))
}

/// Length of the number that a text begins with; a point or exponent needs digits, so that `0..1` is a range.
fn number(text: &str) -> usize {
    let digits = |text: &str| prefix_length(text, |c| c.is_ascii_digit());
    let mut end = digits(text);
    if let Some(fraction) = text[end..].strip_prefix('.')
        && digits(fraction) > 0
    {
        end += 1 + digits(fraction);
    }
    if let Some(exponent) = text[end..].strip_prefix(['e', 'E']) {
        let unsigned = exponent.strip_prefix(['+', '-', '−']).unwrap_or(exponent);
        if digits(unsigned) > 0 {
            end = text.len() - unsigned.len() + digits(unsigned);
        }
    }
    end
}

const MAX_QUOTED: usize = 60;

/// Truncates a text to [`MAX_QUOTED`] characters, of which the last is then `…`; shorter texts are returned unchanged.
pub(crate) fn clip(raw: &str) -> String {
    if raw.chars().nth(MAX_QUOTED).is_none() {
        return raw.to_owned();
    }
    let head: String = raw.chars().take(MAX_QUOTED - 1).collect();
    format!("{head}…")
}

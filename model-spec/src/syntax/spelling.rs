//! ASCII spelling of names written with Greek letters, dots and accents.

/// Names of the Greek letters from α to ω, final sigma included.
const GREEK: [&str; 25] = [
    "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "iota", "kappa",
    "lambda", "mu", "nu", "xi", "omicron", "pi", "rho", "sigma", "sigma", "tau", "upsilon", "phi",
    "chi", "psi", "omega",
];

const DOTTED: [char; 14] = [
    'ẋ', 'ẏ', 'ż', 'ẇ', 'ṗ', 'ṙ', 'ḋ', 'ḟ', 'ġ', 'ḣ', 'ṁ', 'ṅ', 'ṡ', 'ṫ',
];

const UNDOTTED: [char; 14] = [
    'x', 'y', 'z', 'w', 'p', 'r', 'd', 'f', 'g', 'h', 'm', 'n', 's', 't',
];

/// Name of a Greek letter, with a capital for a capital; `None` for other characters.
fn greek(c: char) -> Option<String> {
    let c = match c {
        'ϵ' => 'ε',
        'ϑ' => 'θ',
        'µ' => 'μ',
        'ϕ' => 'φ',
        _ => c,
    };
    let name = |c: char, first: char| GREEK[c as usize - first as usize];
    match c {
        'α'..='ω' => Some(name(c, 'α').to_owned()),
        'Ο' => None,
        'Α'..='Ω' => {
            let (capital, rest) = name(c, 'Α').split_at(1);
            Some(capital.to_uppercase() + rest)
        }
        _ => None,
    }
}

/// How the element of an array is written for which papers write `name,index` with an index in `name`: `s[1, 8]` for
/// `s_1,8`; `None` if that is not meant.
pub(super) fn element_help(name: &str, index: &str) -> Option<String> {
    let (array, first) = name.rsplit_once('_')?;
    let is_index = |text: &str| !text.is_empty() && text.chars().all(|c| c.is_ascii_digit());
    let is_name = array.chars().all(|c| c == '_' || c.is_alphanumeric());
    let is_meant = is_name && !array.is_empty() && is_index(first) && is_index(index);
    is_meant.then(|| {
        format!("an element of an array is written with brackets: `{array}[{first}, {index}]`")
    })
}

/// ASCII spelling of a name: `φ̇` becomes `phidot`, `ρ` becomes `rho`.
pub fn plain(raw: &str) -> String {
    if raw.is_ascii() {
        return raw.to_owned();
    }
    let mut out = String::with_capacity(raw.len() + 8);
    for c in raw.chars() {
        match c {
            '\u{307}' => out.push_str("dot"),
            '\u{308}' => out.push_str("ddot"),
            _ => {
                let dotted = || DOTTED.iter().position(|dotted| *dotted == c);
                if let Some(name) = greek(c) {
                    out.push_str(&name);
                } else if let Some(k) = dotted() {
                    out.push(UNDOTTED[k]);
                    out.push_str("dot");
                } else {
                    out.push(c);
                }
            }
        }
    }
    out
}

/// Name under which a model has what is written so: `φ̇` is `phidot`, and `k[2, 4]` is `k_2_4`.
pub fn joined(raw: &str) -> String {
    let mut rest = plain(raw);
    let mut out = String::with_capacity(rest.len());
    while let Some((before, behind)) = rest.split_once('[') {
        let Some((subscripts, after)) = behind.split_once(']') else {
            break;
        };
        out += before.trim_end();
        for subscript in subscripts.split(',') {
            out += "_";
            out += subscript.trim();
        }
        rest = after.to_owned();
    }
    out + &rest
}

#[cfg(test)]
mod tests {
    use super::{element_help, joined, plain};

    #[test]
    fn elements_have_the_names_of_tables_and_reports() {
        for (written, name) in [
            ("k[1]", "k_1"),
            ("place[2, 4]", "place_2_4"),
            ("der(φ[3])", "der(phi_3)"),
            ("k[1", "k[1"),
            ("C_D0", "C_D0"),
        ] {
            assert_eq!(joined(written), name);
        }
    }

    #[test]
    fn elements_as_papers_write_them_have_brackets() {
        let help = element_help("s_1", "8").unwrap();
        assert!(help.ends_with("`s[1, 8]`"), "{help}");
        for (name, index) in [
            ("s1", "8"),
            ("s_a", "8"),
            ("s_1", "8.5"),
            ("2*s_1", "8"),
            ("1", "8"),
        ] {
            assert_eq!(element_help(name, index), None, "{name},{index}");
        }
    }

    #[test]
    fn greek_letters_and_dots_have_names() {
        for (typed, name) in [
            ("α", "alpha"),
            ("α_0", "alpha_0"),
            ("φ̇", "phidot"),
            ("φ̈", "phiddot"),
            ("ρ", "rho"),
            ("u̇", "udot"),
            ("ẋ", "xdot"),
            ("C_Lα", "C_Lalpha"),
            ("Ω", "Omega"),
        ] {
            assert_eq!(plain(typed), name);
        }
    }
}

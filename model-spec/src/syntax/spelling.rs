//! ASCII spelling of names written with Greek letters, dots and accents.

/// Greek letters with their ASCII spelling.
const GREEK: [(char, &str); 52] = [
    ('α', "alpha"),
    ('β', "beta"),
    ('γ', "gamma"),
    ('δ', "delta"),
    ('ε', "epsilon"),
    ('ϵ', "epsilon"),
    ('ζ', "zeta"),
    ('η', "eta"),
    ('θ', "theta"),
    ('ϑ', "theta"),
    ('ι', "iota"),
    ('κ', "kappa"),
    ('λ', "lambda"),
    ('μ', "mu"),
    ('µ', "mu"),
    ('ν', "nu"),
    ('ξ', "xi"),
    ('ο', "omicron"),
    ('π', "pi"),
    ('ρ', "rho"),
    ('σ', "sigma"),
    ('ς', "sigma"),
    ('τ', "tau"),
    ('υ', "upsilon"),
    ('φ', "phi"),
    ('ϕ', "phi"),
    ('χ', "chi"),
    ('ψ', "psi"),
    ('ω', "omega"),
    ('Α', "Alpha"),
    ('Β', "Beta"),
    ('Γ', "Gamma"),
    ('Δ', "Delta"),
    ('Ε', "Epsilon"),
    ('Ζ', "Zeta"),
    ('Η', "Eta"),
    ('Θ', "Theta"),
    ('Ι', "Iota"),
    ('Κ', "Kappa"),
    ('Λ', "Lambda"),
    ('Μ', "Mu"),
    ('Ν', "Nu"),
    ('Ξ', "Xi"),
    ('Π', "Pi"),
    ('Ρ', "Rho"),
    ('Σ', "Sigma"),
    ('Τ', "Tau"),
    ('Υ', "Upsilon"),
    ('Φ', "Phi"),
    ('Χ', "Chi"),
    ('Ψ', "Psi"),
    ('Ω', "Omega"),
];

/// Precomposed letters with a dot above, and their ASCII spelling.
const DOTTED: [(char, &str); 14] = [
    ('ẋ', "xdot"),
    ('ẏ', "ydot"),
    ('ż', "zdot"),
    ('ẇ', "wdot"),
    ('ṗ', "pdot"),
    ('ṙ', "rdot"),
    ('ḋ', "ddot"),
    ('ḟ', "fdot"),
    ('ġ', "gdot"),
    ('ḣ', "hdot"),
    ('ṁ', "mdot"),
    ('ṅ', "ndot"),
    ('ṡ', "sdot"),
    ('ṫ', "tdot"),
];

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
            _ => match GREEK.iter().chain(&DOTTED).find(|(symbol, _)| *symbol == c) {
                Some((_, name)) => out.push_str(name),
                None => out.push(c),
            },
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::plain;

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

//! Spelling suggestions for misspelt names, by edit distance.

/// Maximum length of a misspelt name, characters; for a longer name, no suggestion is searched. It bounds the run time.
const MAX_NAME_CHARS: usize = 40;

/// First of the names nearest in spelling to `wrong`, by case, prefix or a small edit distance.
pub fn nearest<'a>(wrong: &str, names: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    if wrong.is_empty() || wrong.chars().count() > MAX_NAME_CHARS {
        return None;
    }
    let allowed = match wrong.chars().count() {
        0..=4 => 1,
        5..=6 => 2,
        _ => 3,
    };
    let mut best: Option<(usize, &str)> = None;
    for name in names {
        if name.len().abs_diff(wrong.len()) > 8 || name == wrong {
            continue;
        }
        let shorter = name.len().min(wrong.len());
        let distance = if name.eq_ignore_ascii_case(wrong) {
            0
        } else if shorter >= 4 && (name.starts_with(wrong) || wrong.starts_with(name)) {
            1
        } else {
            // Insertions, deletions, substitutions and adjacent transpositions, whatever the case.
            strsim::osa_distance(&wrong.to_lowercase(), &name.to_lowercase())
        };
        // At least half of a short name must match, or `a` would be suggested for `b`.
        let most = allowed.min(name.chars().count().max(wrong.chars().count()).div_ceil(2));
        let most = if wrong.chars().count() == 1 && name.chars().count() == 1 {
            0
        } else {
            most
        };
        if distance <= most && best.is_none_or(|(d, _)| distance < d) {
            best = Some((distance, name));
        }
    }
    best.map(|(_, name)| name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_names_are_found_and_far_ones_are_not() {
        let names = ["C_L0", "C_La", "C_D0", "air_velocity", "alpha", "V"];
        for (wrong, right) in [
            ("C_LA", Some("C_La")),
            ("air_velocty", Some("air_velocity")),
            ("alhpa", Some("alpha")),
            ("v", Some("V")),
            ("q", None),
            ("thrust", None),
            ("", None),
        ] {
            assert_eq!(nearest(wrong, names.into_iter()), right, "{wrong}");
        }
    }
}

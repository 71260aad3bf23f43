//! Formatting for error messages: quoting of external texts and shortening of long lists as in the crate `takes`, and
//! suggestions of similar names.

pub(super) use flight::table::{listed, shown};
use model_spec::nearest_name;

/// Suggestion ` (did you mean …?)` for an error message, if one of `names` is similar to the misspelt name `wrong`.
pub(super) fn meant<'a>(wrong: &str, names: impl IntoIterator<Item = &'a str>) -> String {
    match nearest_name(wrong, names.into_iter()) {
        Some(name) => format!(" (did you mean {name}?)"),
        None => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_names_are_meant_and_far_ones_are_not() {
        assert_eq!(meant("modle", ["model", "noise"]), " (did you mean model?)");
        assert_eq!(meant("weather", ["model", "noise"]), "");
        assert_eq!(meant("0", ["t"]), "");
    }
}

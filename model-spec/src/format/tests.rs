use std::path::PathBuf;

use proptest::prelude::*;
use proptest::sample::select;
use proptest::test_runner::TestCaseResult;

use super::piece::{Piece, Structure, pieces};
use super::{format, is_same, laid_out, settled};
use crate::read::{BODIES, EFFECTS, MODELS, REFUTED, WINDS};
use crate::syntax::parse_statements;
use crate::syntax::token::Token;

const GALLERY: &str = "../examples/gallery";

/// Texts of the gallery, of its parts, and of those that are built in.
fn texts() -> Vec<String> {
    let tables = [MODELS, BODIES, REFUTED, EFFECTS, WINDS];
    let built_in = tables.into_iter().flatten();
    let built_in = built_in.map(|(_, text)| (*text).to_owned());
    let folders = [GALLERY.to_owned(), format!("{GALLERY}/parts")];
    let files = folders
        .iter()
        .flat_map(|own| std::fs::read_dir(own).unwrap());
    let mut paths: Vec<PathBuf> = files.map(|file| file.unwrap().path()).collect();
    paths.retain(|path| path.extension().is_some_and(|end| end == "hyz"));
    paths.sort();
    let shown = paths
        .iter()
        .map(|path| std::fs::read_to_string(path).unwrap());
    built_in.chain(shown).collect()
}

#[test]
fn models_of_the_repository_are_formatted() {
    for text in texts() {
        let formatted = format("model.hyz", &text).unwrap();
        let changed = text.lines().zip(formatted.lines()).find(|(a, b)| a != b);
        assert!(text == formatted, "{changed:?}");
    }
}

#[test]
fn white_space_is_laid_out_by_rules() {
    let cases = [
        (
            "spaces",
            "let a=b+c *-d/( e-f )^ - 2 ;",
            "let a = b + c*-d/(e - f)^-2;\n",
        ),
        (
            "units",
            "param a=2.4N / m in-1..1;",
            "param a = 2.4 N/m in -1 .. 1;\n",
        ),
        (
            "a unit",
            "param k = 2 /rad;param h = 3/d;",
            "param k = 2 /rad;\nparam h = 3/d;\n",
        ),
        (
            "a negative angle",
            "frame R = C turned -12 deg about 1;",
            "frame R = C turned -12 deg about 1;\n",
        ),
        ("an inch", "let a = 5 in-b;", "let a = 5 in - b;\n"),
        (
            "ranges",
            "let r[ i ] for i in 1 .. 8=i*2 m;",
            "let r[i] for i in 1..8 = i*2 m;\n",
        ),
        (
            "a sum",
            "let f=sum(i in 1 .. 8 ,r[ i+1 ]);",
            "let f = sum(i in 1..8, r[i + 1]);\n",
        ),
        (
            "products of vectors",
            "let a = b × c + d·e;",
            "let a = b × c + d·e;\n",
        ),
        (
            "brackets",
            "body b{position(x,y,z)in N;}",
            "body b { position (x, y, z) in N; }\n",
        ),
        (
            "a block",
            "body b { mass m; fixed in C; }",
            "body b {\n  mass m;\n  fixed in C;\n}\n",
        ),
        (
            "a brace alone",
            "body b\n{\n\n mass m;\n\n}",
            "body b {\n  mass m;\n}\n",
        ),
        ("blank lines", "\n\na 1;\n\n\n\nb 2;\n\n", "a 1;\n\nb 2;\n"),
        (
            "the author's lines",
            "let a = b\n+ max(c,\nd);",
            "let a = b\n  + max(c,\n    d);\n",
        ),
        (
            "a comment inside",
            "let a = // b\n  c; // d",
            "let a = // b\n  c; // d\n",
        ),
        (
            "comments aligned",
            "a 1;   // x\nbc 12; // y",
            "a 1;   // x\nbc 12; // y\n",
        ),
        (
            "comments moved",
            "a  1;  // x\nbc 1;  // y",
            "a 1;   // x\nbc 1;  // y\n",
        ),
        (
            "equals aligned",
            "a x   = 1;\na xyz = 2;",
            "a x   = 1;\na xyz = 2;\n",
        ),
        (
            "equals as they come",
            "a x= 1;\na xyz= 2;",
            "a x = 1;\na xyz = 2;\n",
        ),
        (
            "columns",
            "table t(a) = {\n   1:  2,\n  10: 20 };",
            "table t(a) = {\n   1:  2,\n  10: 20 };\n",
        ),
        ("Windows", "a 1;\r\n\r\n\r\nb  2;", "a 1;\r\n\r\nb 2;\r\n"),
        ("not a range", "let a = b. .c;", "let a = b. .c;\n"),
        (
            "a new statement",
            "include \"aero.hyz\";solve{der(a)=b;}",
            "include \"aero.hyz\";\nsolve { der(a) = b; }\n",
        ),
    ];
    for (what, text, expected) in cases {
        assert_eq!(settled(text).as_deref(), Some(expected), "{what}");
    }
}

#[test]
fn long_lines_break_at_the_loosest_operator() {
    let term = "norm(air_velocity)*dot(air_velocity, d3)*sin(alpha)";
    let text = format!("let a = {term} + {term} - max({term}, {term}, {term});");
    let expected = format!("let a = {term} + {term}\n  - max({term}, {term},\n    {term});\n");
    assert_eq!(settled(&text), Some(expected));
}

#[test]
fn faulty_texts_are_refused() {
    for text in [
        "let a = ;",
        "let a = 1",
        "let ¿ = 1;",
        "body b {",
        "let a = \"b;",
    ] {
        let error = format("faulty.hyz", text).unwrap_err();
        assert!(!error.diagnostics().is_empty(), "{text}");
    }
}

/// White space that may stand between two tokens.
fn space(before: &Piece<'_>, own: &Piece<'_>, chosen: u8) -> &'static str {
    // A name on the next line is no unit and no word behind a table.
    let is_bound = own.token == Token::Name
        && (matches!(
            before.token,
            Token::Number | Token::Text | Token::Superscript
        ) || before.is("}")
            || before.is(",")
            || before.is(")"));
    match chosen {
        _ if before.is_comment() => ["\n", "\n\n\n", "\n\t"][usize::from(chosen) % 3],
        0..170 => " ",
        170..200 => "   ",
        _ if is_bound => "\t",
        200..225 => "\n",
        225..235 => " \n\n\n    ",
        235..245 => " // note\n",
        245.. => "\n  /// note  \r\n",
    }
}

/// A text with other white space is formatted to the statements that it had, and a formatted one stays.
fn check_white_space(text: &str, spaces: &[u8]) -> TestCaseResult {
    let own = pieces(text).unwrap();
    let mut other = String::new();
    for (i, piece) in own.iter().enumerate() {
        if i > 0 {
            let chosen = spaces[i * 7 % 61].wrapping_add((i / 61) as u8);
            other += space(&own[i - 1], piece, chosen);
        }
        other += piece.text;
    }
    let tree = |text: &str| {
        let parsed = parse_statements("random.hyz", text, 0);
        prop_assert_eq!(parsed.diagnostics, []);
        let items = parsed.file.items.into_iter();
        Ok(items.map(|item| item.kind.to_string()).collect::<Vec<_>>())
    };
    let formatted = format("random.hyz", &other).unwrap();
    prop_assert!(is_same(&other, &formatted));
    prop_assert_eq!(tree(&formatted)?, tree(&other)?);
    prop_assert_eq!(format("random.hyz", &formatted).unwrap(), formatted);
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    #[test]
    #[ignore = "takes minutes"]
    fn ten_thousand_texts_are_formatted_to_the_same_function(
        text in select(texts()),
        spaces in proptest::collection::vec(any::<u8>(), 64),
    ) {
        check_white_space(&text, &spaces)?;
    }
}

proptest! {
    #[test]
    fn other_white_space_is_formatted_to_the_same_function(
        text in select(texts()),
        spaces in proptest::collection::vec(any::<u8>(), 64),
    ) {
        check_white_space(&text, &spaces)?;
    }

    #[test]
    fn tokens_in_any_order_are_laid_out(
        parts in proptest::collection::vec((select(SOUP), select(GAPS)), 0..60),
    ) {
        let text: String = parts.into_iter().flat_map(|(part, gap)| [part, gap]).collect();
        let formatted = settled(&text);
        prop_assert_eq!(formatted.is_some(), laid_out(&text).is_some(), "{:?}", text);
        if let Some(formatted) = formatted {
            prop_assert!(is_same(&text, &formatted));
            prop_assert_eq!(settled(&formatted), Some(formatted));
        }
    }
}

const GAPS: &[&str] = &[" ", " ", " ", "", "  ", "\n", "\n\n\n", " // c\n", "\t"];

/// Tokens, with brackets that mostly pair.
const SOUP: &[&str] = &[
    "let", "a", "in", "for", "der", "velocity", "αβ", "φ̇", "1", "2.5e-3", "0", "\"t\"", "²", "+",
    "-", "−", "*", "**", "/", "^", "·", "×", ",", ";", ";", ":", "=", "=", ">", "<", "..", ".",
    "?", "( )", "(a)", "[1]", "{ }", "{ a;", "}", "= {", "(", ")", "// c\n", "/// d\n", "//! e\n",
];

#[test]
fn structure_needs_pairs() {
    for (text, is_paired) in [
        ("a (b [c]) { d }", true),
        ("(a]", false),
        ("a)", false),
        ("{ a", false),
    ] {
        let found = Structure::of(&pieces(text).unwrap());
        assert_eq!(found.is_some(), is_paired, "{text}");
    }
}

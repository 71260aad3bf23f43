//! Words that begin a statement: of a file, and of each block.

/// Words that begin a statement of a file.
pub static STATEMENTS: [&str; 24] = [
    "model",
    "include",
    "reference",
    "param",
    "coefficient",
    "input",
    "state",
    "frame",
    "body",
    "point",
    "claim",
    "function",
    "table",
    "let",
    "force",
    "moment",
    "der",
    "solve",
    "marker",
    "observe",
    "clock",
    "limit",
    "check",
    "effect",
];

/// A block: the word that begins it, how it is written, and the words that begin its statements.
pub struct Block {
    /// Word that begins the block.
    pub word: &'static str,
    /// The block as messages name it, such as `body NAME`.
    pub form: &'static str,
    /// Words that begin a statement inside.
    pub statements: &'static [&'static str],
}

/// All blocks.
pub static BLOCKS: [Block; 7] = [
    block("solve", "solve", &["unknown", "constraint"]),
    block("body", "body NAME", OF_BODY),
    block("point", "point NAME", OF_BODY),
    block(
        "claim",
        "claim body NAME",
        &[
            "mass", "position", "velocity", "force", "inertia", "fixed", "axis", "forward",
            "angular", "moment", "let",
        ],
    ),
    block("check", "check \"…\"", &["set", "expect", "let"]),
    block("function", "function NAME", &["let", "return"]),
    block(
        "effect",
        "effect NAME",
        &[
            "source",
            "needs",
            "generalises",
            "increases",
            "decreases",
            "site",
            "variables",
            "coefficient",
            "param",
            "input",
            "state",
            "der",
            "replace",
            "function",
            "table",
            "let",
            "force",
            "moment",
            "negligible",
        ],
    ),
];

const OF_BODY: &[&str] = &[
    "mass", "inertia", "fixed", "axis", "forward", "position", "velocity", "angular", "let",
];

const fn block(
    word: &'static str,
    form: &'static str,
    statements: &'static [&'static str],
) -> Block {
    Block {
        word,
        form,
        statements,
    }
}

/// Words that begin a statement in the block that begins with `word`; those of a file if it begins none.
pub fn statements_of(word: &str) -> &'static [&'static str] {
    let block = BLOCKS.iter().find(|block| block.word == word);
    block.map_or(&STATEMENTS, |own| own.statements)
}

/// The first block inside which `word` begins a statement, where it begins none of a file.
pub fn inside(word: &str) -> Option<&'static Block> {
    let is_outer = STATEMENTS.contains(&word);
    BLOCKS
        .iter()
        .find(|block| !is_outer && block.statements.contains(&word))
}

/// Whether a line that begins with `word` begins a statement, not the rest of an expression. The words of bodies and of
/// equations are also names of quantities.
pub(crate) fn begins_statement(word: &str) -> bool {
    let mut all = ["", "effect", "check"].into_iter().map(statements_of);
    all.any(|statements| statements.contains(&word))
}

/// `words` as messages list them.
pub(super) fn listed(words: &[&str]) -> String {
    let shown = |word: &&str| match *word {
        "fixed" => "`fixed in`".to_owned(),
        "angular" => "`angular velocity`".to_owned(),
        word => format!("`{word}`"),
    };
    let shown: Vec<String> = words.iter().map(shown).collect();
    match shown.split_last() {
        Some((last, [])) => last.clone(),
        Some((last, others)) => format!("{} or {last}", others.join(", ")),
        None => String::new(),
    }
}

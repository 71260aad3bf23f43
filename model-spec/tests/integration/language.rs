//! Every example of the language's page does what the page says.

use model_spec::load;
use model_spec::syntax::{self, ast::ItemKind};

/// A code block of docs/reference/language.md: word after the opening fence, content, line of the opening fence, and the first
/// line quoted (`> `) after the block.
struct Block {
    kind: String,
    text: String,
    line: usize,
    quoted: Option<String>,
}

fn blocks() -> Vec<Block> {
    let page = std::fs::read_to_string("../docs/reference/language.md").unwrap();
    let mut blocks: Vec<Block> = Vec::new();
    let mut open = false;
    for (number, line) in page.lines().enumerate() {
        match line.strip_prefix("```") {
            Some(kind) if !open => {
                open = true;
                let (kind, text) = (kind.to_owned(), String::new());
                blocks.push(Block {
                    kind,
                    text,
                    line: number + 1,
                    quoted: None,
                });
            }
            Some(_) => open = false,
            None => {
                if let Some(block) = blocks.last_mut() {
                    if open {
                        block.text += line;
                        block.text += "\n";
                    } else if let Some(quoted) = line.strip_prefix("> ")
                        && block.quoted.is_none()
                    {
                        block.quoted = Some(quoted.to_owned());
                    }
                }
            }
        }
    }
    blocks
}

#[test]
fn every_example_of_the_page_does_what_it_says() {
    let blocks = blocks();
    let base = blocks[0].text.clone();
    let (mut right, mut wrong) = (0, 0);
    for block in &blocks {
        let whole = block.text.lines().any(|l| l.starts_with("model "));
        let text = if whole {
            block.text.clone()
        } else {
            format!("{base}{}", block.text)
        };
        let effects: Vec<String> = syntax::parse("page", &text)
            .file
            .items
            .iter()
            .filter_map(|i| match &i.kind {
                ItemKind::Effect(effect) => Some(effect.name.text.clone()),
                _ => None,
            })
            .collect();
        let with: Vec<&str> = effects.iter().map(String::as_str).collect();
        let loaded = load::from_text("language.md", &text, &with);
        let line = block.line;
        match block.kind.as_str() {
            "hyz" => {
                right += 1;
                if let Err(error) = loaded {
                    panic!("the example at line {line} is wrong:\n{error}");
                }
            }
            "hyz-error" => {
                wrong += 1;
                let error = loaded
                    .err()
                    .unwrap_or_else(|| panic!("the example at line {line} is right"));
                assert_eq!(
                    error.to_string().lines().next(),
                    block.quoted.as_deref(),
                    "line {line}"
                );
                assert_eq!(error.diagnostics().len(), 1, "line {line}");
            }
            other => panic!("line {line}: a block of kind `{other}`"),
        }
    }
    assert!(
        right >= 12 && wrong >= 8,
        "{right} right and {wrong} wrong examples"
    );
}

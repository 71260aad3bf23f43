//! Parser state shared by all grammar rules, with token access, error messages and error recovery.

use super::ast::{Expr, File, Item, Name};
use super::lexer::{self, Lexed, Lexeme};
use super::spelling;
use super::token::Token;
use super::words;
use crate::diagnostic::{self, Diagnostic, Kind, MAX_SHOWN, Span};
use crate::suggest;
use crate::unit::symbol;

/// Maximum nesting depth of an expression, which bounds the recursion of the parser.
const MAX_DEPTH: u32 = 64;

/// Error of a grammar rule: a syntax error has already been reported, and the current statement is abandoned.
pub(super) struct Reported;

/// Result of a grammar rule; an `Err` means that the error has already been reported.
pub(super) type Read<T> = Result<T, Reported>;

pub(super) struct Parser<'a> {
    text: &'a str,
    source: u16,
    pub lexed: Lexed,
    at: usize,
    next_doc: usize,
    depth: u32,
    /// Definitions in the block that is being read; they come before its statement.
    pub block_lets: Vec<Item>,
}

impl<'a> Parser<'a> {
    pub fn new(text: &'a str, source: u16) -> Parser<'a> {
        Parser {
            text,
            source,
            lexed: lexer::lex(text, source),
            at: 0,
            next_doc: 0,
            depth: 0,
            block_lets: Vec::new(),
        }
    }

    pub fn file(&mut self) -> File {
        let mut items = Vec::new();
        while self.peek() != Token::End {
            if self.peek() == Token::Sign("}") {
                let span = self.here();
                let fault = Diagnostic::new(Kind::Grammar, span, "this `}` closes nothing");
                self.report(fault.help("remove it, or look for a `{` that is missing before it"));
                self.at += 1;
                continue;
            }
            let before = self.at;
            match self.statement() {
                Ok(item) => {
                    items.append(&mut self.block_lets);
                    items.push(item);
                }
                Err(Reported) => self.recover(before),
            }
        }
        let doc = std::mem::take(&mut self.lexed.file_doc);
        File {
            doc,
            items,
            applied: Vec::new(),
            set_aside: Default::default(),
            end: self.here(),
        }
    }

    /// Returns all lexical and syntax errors, in the order of their source spans.
    pub fn finish(mut self) -> Vec<Diagnostic> {
        diagnostic::sort(&mut self.lexed.diagnostics);
        self.lexed.diagnostics
    }

    pub fn lexeme(&self) -> Lexeme {
        self.lexed.tokens[self.at]
    }

    pub fn peek(&self) -> Token {
        self.lexeme().token
    }

    pub fn peek_at(&self, ahead: usize) -> Token {
        self.lexed
            .tokens
            .get(self.at + ahead)
            .map_or(Token::End, |l| l.token)
    }

    pub fn first_on_line(&self) -> bool {
        self.lexeme().first
    }

    pub fn raw(&self) -> &'a str {
        let lexeme = self.lexeme();
        &self.text[lexeme.start as usize..lexeme.end as usize]
    }

    /// Text of the token `ahead` tokens after the next one; empty at the end.
    pub fn raw_at(&self, ahead: usize) -> &'a str {
        let lexeme = self.lexed.tokens.get(self.at + ahead);
        lexeme.map_or("", |own| &self.text[own.start as usize..own.end as usize])
    }

    fn starts_with(&self, text: &str) -> bool {
        self.text[self.lexeme().start as usize..].starts_with(text)
    }

    pub fn slice_all(&self) -> &'a str {
        self.text
    }

    pub fn slice(&self, span: Span) -> &'a str {
        &self.text[span.range()]
    }

    pub fn here(&self) -> Span {
        self.span_of(self.lexeme())
    }

    /// Source span of the previous token; at the start of the text, source span of the next token.
    pub fn behind(&self) -> Span {
        match self.at.checked_sub(1) {
            Some(i) => self.span_of(self.lexed.tokens[i]),
            None => self.here(),
        }
    }

    fn span_of(&self, Lexeme { start, end, .. }: Lexeme) -> Span {
        let source = self.source;
        Span { start, end, source }
    }

    pub fn advance(&mut self) {
        if self.peek() != Token::End {
            self.at += 1;
        }
    }

    pub fn eat(&mut self, token: Token) -> bool {
        let found = self.peek() == token;
        if found {
            self.advance();
        }
        found
    }

    pub fn list<T>(&mut self, mut item: impl FnMut(&mut Self) -> Read<T>) -> Read<Vec<T>> {
        let mut items = vec![item(self)?];
        while self.eat(Token::Sign(",")) {
            items.push(item(self)?);
        }
        Ok(items)
    }

    /// Parses `(a, b, …)` with `N` items; for messages, `open` describes the start, `one` and `many` the items.
    pub fn tuple<T, const N: usize>(
        &mut self,
        open: &str,
        one: &str,
        many: &str,
        mut item: impl FnMut(&mut Self) -> Read<T>,
    ) -> Read<[T; N]> {
        self.need(Token::Sign("("), open)?;
        let mut items = vec![item(self)?];
        for ordinal in ["second", "third", "fourth"].iter().take(N - 1) {
            self.need(Token::Sign(","), &format!("`,` and the {ordinal} {one}"))?;
            items.push(item(self)?);
        }
        let count = if N == 3 { "three" } else { "four" };
        self.need(Token::Sign(")"), &format!("`)` after {count} {many}"))?;
        items.try_into().map_err(|_| Reported)
    }

    /// Parses `= EXPR;` after `name`, and reports the end of `statement`.
    pub fn definition(&mut self, name: &str, statement: &str) -> Read<Expr> {
        self.need(Token::Sign("="), &format!("`=` after `{name}`"))?;
        let value = self.expr()?;
        self.semicolon(statement)?;
        Ok(value)
    }

    pub fn keyword_and_name(&mut self) -> Read<(&'a str, Name)> {
        let word = self.raw();
        self.advance();
        let name = self.name(&format!("a name after `{word}`"))?;
        Ok((word, name))
    }

    pub fn at_word(&self, word: &str) -> bool {
        self.peek() == Token::Name && self.raw() == word
    }

    pub fn eat_word(&mut self, word: &str) -> bool {
        let found = self.at_word(word);
        if found {
            self.advance();
        }
        found
    }

    pub fn report(&mut self, fault: Diagnostic) {
        self.lexed.diagnostics.push(fault);
    }

    pub fn refuse<T>(&mut self, fault: Diagnostic) -> Read<T> {
        self.report(fault);
        Err(Reported)
    }

    /// Number of errors so far.
    pub fn reports(&self) -> usize {
        self.lexed.diagnostics.len()
    }

    /// Whether the next token is one that the lexer has already reported as an error.
    pub fn reported_by_lexer(&self) -> bool {
        matches!(self.peek(), Token::Bad | Token::OpenText)
    }

    /// Reports "expected `what`, found …" unless the lexer has reported the token; returns `Err`.
    pub fn expected<T>(&mut self, what: &str) -> Read<T> {
        self.expected_help(what, None)
    }

    pub fn expected_help<T>(&mut self, what: &str, help: Option<String>) -> Read<T> {
        let behind = self.slice(self.behind());
        let is_comment = matches!((behind, self.raw()), ("/", "*")) || self.starts_with("/*");
        let help = match is_comment {
            true => Some("a comment begins with `//` and ends with its line".to_owned()),
            false => help,
        };
        let found = lexer::name_of(self.lexeme(), self.text);
        if !self.reported_by_lexer() {
            let message = format!("expected {what}, found {found}");
            let fault = Diagnostic::new(Kind::Grammar, self.here(), message).help_if(help);
            self.report(fault);
        }
        Err(Reported)
    }

    pub fn suggestions<'w>(&self, words: &'w [&'w str]) -> impl Iterator<Item = &'w str> + use<'w> {
        let is_shown = self.lexed.diagnostics.len() < MAX_SHOWN;
        words.iter().copied().filter(move |_| is_shown)
    }

    /// Reports that a statement of the block that begins with `block` was expected, and suggests the nearest word;
    /// returns `Err`.
    pub fn expected_statement_of<T>(&mut self, block: &str) -> Read<T> {
        let words = words::statements_of(block);
        self.expected_or(&words::listed(words), words)
    }

    /// Reports that `what` was expected, and suggests the nearest of `words`; returns `Err`.
    pub fn expected_or<T>(&mut self, what: &str, words: &[&str]) -> Read<T> {
        let near = match self.peek() {
            Token::Name => suggest::nearest(self.raw(), self.suggestions(words)),
            _ => None,
        };
        let Some(near) = near else {
            return self.expected(what);
        };
        let found = lexer::name_of(self.lexeme(), self.text);
        let message = format!("expected {what}, found {found}");
        let fault = Diagnostic::new(Kind::Grammar, self.here(), message);
        self.refuse(fault.suggest(near))
    }

    pub fn need(&mut self, token: Token, what: &str) -> Read<()> {
        if self.eat(token) {
            Ok(())
        } else {
            self.expected(what)
        }
    }

    pub fn need_word(&mut self, word: &str, after: &str) -> Read<()> {
        if self.eat_word(word) {
            Ok(())
        } else {
            self.expected(&format!("`{word}` after {after}"))
        }
    }

    pub fn semicolon(&mut self, after: &str) -> Read<()> {
        if self.eat(Token::Sign(";")) {
            return Ok(());
        }
        if self.reported_by_lexer() {
            return Err(Reported);
        }
        if self.first_on_line() || self.peek() == Token::Sign("}") {
            let end = self.behind();
            let place = Span {
                // Span of the last character of the previous token.
                start: end.end
                    - self
                        .slice(end)
                        .chars()
                        .next_back()
                        .map_or(0, char::len_utf8) as u32,
                ..end
            };
            return self.refuse(
                Diagnostic::new(
                    Kind::Grammar,
                    place,
                    format!("expected `;` at the end of {after}"),
                )
                .help("end the statement with `;`")
                .fix(end.behind(), ";"),
            );
        }
        let help = match self.peek() {
            Token::Name
                if self.slice(self.behind()) == ")" && symbol::find(self.raw()).is_some() =>
            {
                let unit = self.raw();
                Some(format!(
                    "a product is written with `*` or `·`, and a unit stands behind a number: `*(1 {unit})`"
                ))
            }
            Token::Name if self.raw() == "for" => Some(
                "`for …` stands before the `=`, as in `let r[i] for i in 1..8 = …;`".to_owned(),
            ),
            Token::Name | Token::Number | Token::Sign("(") => {
                Some("a product is written with `*` or `·`".to_owned())
            }
            Token::Sign(",") if self.peek_at(1) == Token::Number => {
                let (before, behind) = (self.slice(self.behind()), self.raw_at(1));
                let is_number = before.starts_with(|c: char| c.is_ascii_digit());
                let decimals = || format!("decimals have a point: `{before}.{behind}`");
                spelling::element_help(before, behind).or_else(|| is_number.then(decimals))
            }
            Token::Sign(",") if self.peek_at(1) == Token::Name => {
                Some("each is declared by a statement of its own".to_owned())
            }
            Token::Sign("**") => Some("a power is written `^`".to_owned()),
            Token::Sign(">" | "<") => {
                Some("`step(a - b)` is 1 where a > b, else 0; or use `max`, `min`".to_owned())
            }
            _ => None,
        };
        let condition = "there is no `if`: `step(x)` is 1 where x > 0, else 0; or use `max`, `min`";
        let is_condition = self.slice(self.behind()) == "if";
        let help = if is_condition {
            Some(condition.to_owned())
        } else {
            help
        };
        self.expected_help(&format!("`;` at the end of {after}"), help)
    }

    pub fn name(&mut self, what: &str) -> Read<Name> {
        if self.peek() != Token::Name {
            return self.expected(what);
        }
        let name = Name::new(spelling::plain(self.raw()), self.here());
        self.advance();
        Ok(name)
    }

    pub fn quoted(&mut self, what: &str) -> Read<String> {
        if self.peek() != Token::Text {
            return self.expected(&format!("{what} between quotation marks"));
        }
        let text = self.raw().trim_matches('"').to_owned();
        self.advance();
        Ok(text)
    }

    /// Consumes and joins the `///` lines directly before the next token.
    pub fn doc(&mut self) -> String {
        let mut lines: Vec<&str> = Vec::new();
        while let Some((at, line)) = self.lexed.docs.get(self.next_doc) {
            match at.cmp(&self.at) {
                std::cmp::Ordering::Less => {}
                std::cmp::Ordering::Equal => lines.push(line),
                std::cmp::Ordering::Greater => break,
            }
            self.next_doc += 1;
        }
        lines.join("\n")
    }

    /// Runs a grammar rule one nesting level deeper; reports an error if the depth would exceed [`MAX_DEPTH`].
    pub fn nested<T>(&mut self, read: impl FnOnce(&mut Self) -> Read<T>) -> Read<T> {
        if self.depth >= MAX_DEPTH {
            let message = format!("this is nested more than {MAX_DEPTH} levels deep");
            let fault = Diagnostic::new(Kind::Limit, self.here(), message);
            return self.refuse(fault.help("give parts of it names with `let`"));
        }
        self.depth += 1;
        let result = read(self);
        self.depth -= 1;
        result
    }

    /// Skips the `;` or block of the faulty statement that `started`, or up to a closing `}` or a line with a keyword.
    pub fn recover(&mut self, started: usize) {
        let mut open = 0_u32;
        loop {
            match self.peek() {
                Token::End => return,
                Token::Sign(";") if open == 0 => {
                    self.advance();
                    return;
                }
                Token::Sign("{") => open += 1,
                Token::Sign("}") if open == 0 => return,
                Token::Sign("}") => {
                    open -= 1;
                    if open == 0 {
                        self.advance();
                        self.eat(Token::Sign(";"));
                        return;
                    }
                }
                Token::Name
                    if open == 0
                        && self.at > started
                        && self.first_on_line()
                        && words::begins_statement(self.raw()) =>
                {
                    return;
                }
                _ => {}
            }
            self.advance();
        }
    }

    /// Parses `{ statement… }` of `what` with `read`, and recovers from errors inside.
    pub fn braces<T>(
        &mut self,
        what: &str,
        mut read: impl FnMut(&mut Self) -> Read<T>,
    ) -> Read<Vec<T>> {
        let open = self.here();
        self.need(Token::Sign("{"), &format!("`{{` after {what}"))?;
        let mut parts = Vec::new();
        loop {
            match self.peek() {
                Token::Sign("}") => {
                    self.advance();
                    return Ok(parts);
                }
                Token::End => {
                    let fault = Diagnostic::new(
                        Kind::Grammar,
                        open,
                        format!("the block of {what} is not closed"),
                    );
                    self.report(fault.help("close it with `}`"));
                    return Ok(parts);
                }
                _ => {}
            }
            let before = self.at;
            match read(self) {
                Ok(part) => parts.push(part),
                Err(Reported) => self.recover(before),
            }
        }
    }
}

//! Declarations and uses of names, statement by statement.

use std::collections::HashSet;
use std::ops::Range;

use super::{Declaration, Namespace, SymbolKind};
use crate::syntax::lexer::{Lexeme, lex};
use crate::syntax::spelling::plain;
use crate::syntax::token::Token;
use crate::syntax::words::begins_statement;

/// A word, before it is known what a name refers to.
pub(super) enum Found {
    Keyword,
    Unit,
    Name(Namespace),
    /// Declares the declaration at this index, or, where the index is weak, refers to one of the same name.
    Declares(usize),
}

pub(super) struct Scanned<'a> {
    pub text: &'a str,
    pub words: Vec<(Range<usize>, Found)>,
    pub declarations: Vec<Declaration>,
    /// Whether each declaration gives way to another of the same name: the angle of a frame may be a parameter.
    pub weak: Vec<bool>,
    /// Names of the declarations.
    pub names: HashSet<String>,
}

/// A block around statements.
struct Block {
    word: String,
    /// Indices of the declarations of the block itself: that of its name and of the arguments.
    declarations: Range<usize>,
    scope: usize,
}

pub(super) struct Scanner<'a> {
    pub scanned: Scanned<'a>,
    pub tokens: Vec<Lexeme>,
    docs: Vec<(usize, String)>,
    blocks: Vec<Block>,
    /// Start of the scope of the statements' names.
    scope: usize,
    /// Index of the token that ends the statement.
    end: usize,
    /// First word of the statement.
    begins: &'a str,
    pub doc: String,
}

pub(super) fn scan(text: &str) -> Scanned<'_> {
    let lexed = lex(text, 0);
    let mut scanner = Scanner {
        scanned: Scanned {
            text,
            words: Vec::new(),
            declarations: Vec::new(),
            weak: Vec::new(),
            names: HashSet::new(),
        },
        tokens: lexed.tokens,
        docs: lexed.docs,
        blocks: Vec::new(),
        scope: 0,
        end: 0,
        begins: "",
        doc: String::new(),
    };
    scanner.file();
    scanner.scanned
}

impl<'a> Scanner<'a> {
    fn file(&mut self) {
        let (mut at, mut next_doc) = (0, 0);
        while self.tokens[at].token != Token::End {
            self.doc.clear();
            while let Some((before, line)) = self.docs.get(next_doc).filter(|doc| doc.0 <= at) {
                if *before == at {
                    self.doc += if self.doc.is_empty() { "" } else { "\n" };
                    self.doc += line;
                }
                next_doc += 1;
            }
            let end = self.end_of_statement(at);
            let first = self.scanned.declarations.len();
            self.end = end;
            self.statement(at..end);
            let last = self.tokens[end];
            let stop = last.end as usize;
            for own in &mut self.scanned.declarations[first..] {
                own.statement.end = stop;
            }
            at = end;
            match last.token {
                Token::Sign("{") => self.open(first, stop),
                Token::Sign("}") => self.close(stop),
                Token::Sign(";") => {}
                _ => continue,
            }
            at += 1;
        }
        while !self.blocks.is_empty() {
            self.close(self.scanned.text.len());
        }
    }

    fn open(&mut self, first: usize, start: usize) {
        let own = &self.scanned.declarations[first..];
        let word = own.first().map_or("", |own| match own.kind {
            SymbolKind::Effect => "effect",
            SymbolKind::Function => "function",
            SymbolKind::Body => "body",
            SymbolKind::Solve => "solve",
            _ => "",
        });
        // A block of equations may have no name.
        let word = match word.is_empty() && self.begins == "solve" {
            true => "solve",
            false => word,
        };
        self.blocks.push(Block {
            word: word.to_owned(),
            declarations: first..self.scanned.declarations.len(),
            scope: self.scope,
        });
        if matches!(word, "effect" | "function") {
            self.scope = start;
        }
    }

    fn close(&mut self, end: usize) {
        let Some(block) = self.blocks.pop() else {
            return;
        };
        let first = block.declarations.start;
        for own in &mut self.scanned.declarations[block.declarations] {
            own.statement.end = end;
            if own.kind == SymbolKind::Argument {
                own.scope.end = end;
            }
        }
        if self.scope != block.scope {
            // The names of the block end with it.
            for own in &mut self.scanned.declarations[first..] {
                if own.scope.start >= self.scope && own.scope.end == usize::MAX {
                    own.scope.end = end;
                }
            }
        }
        self.scope = block.scope;
    }

    pub fn is_in(&self, word: &str) -> bool {
        self.blocks.last().is_some_and(|block| block.word == word)
    }

    /// Index of the token that ends a statement: `;`, the brace of a block, or the keyword of the next statement.
    fn end_of_statement(&self, start: usize) -> usize {
        let (mut at, mut braces) = (start, 0_usize);
        loop {
            let own = self.tokens[at];
            match own.token {
                Token::End => return at,
                Token::Sign("{") if braces > 0 || at > start && self.text(at - 1) == "=" => {
                    braces += 1;
                }
                Token::Sign("}") if braces > 0 => braces -= 1,
                Token::Sign(";") if braces > 0 => {}
                Token::Sign(";" | "{" | "}") => return at,
                Token::Name if at > start && own.first && begins_statement(self.text(at)) => {
                    return at;
                }
                _ => {}
            }
            at += 1;
        }
    }

    pub fn text(&self, at: usize) -> &'a str {
        let own = self.tokens.get(at);
        own.map_or("", |own| {
            &self.scanned.text[own.start as usize..own.end as usize]
        })
    }

    pub fn token(&self, at: usize) -> Token {
        self.tokens.get(at).map_or(Token::End, |own| own.token)
    }

    pub fn range(&self, at: usize) -> Range<usize> {
        let own = self.tokens[at.min(self.tokens.len() - 1)];
        own.start as usize..own.end as usize
    }

    pub fn word(&mut self, at: usize, found: Found) {
        if self.token(at) == Token::Name && at < self.end {
            self.scanned.words.push((self.range(at), found));
        }
    }

    pub fn keyword(&mut self, at: usize) {
        self.word(at, Found::Keyword);
    }

    /// Declares the name at a token, in the scope of the statement's block.
    pub fn declare(&mut self, at: usize, kind: SymbolKind) {
        self.declare_in(at, kind, self.scope..usize::MAX, false);
    }

    pub fn declare_in(&mut self, at: usize, kind: SymbolKind, scope: Range<usize>, weak: bool) {
        if self.token(at) != Token::Name || at >= self.end {
            return;
        }
        let namespace = match kind {
            SymbolKind::Frame => Namespace::Frame,
            SymbolKind::Table | SymbolKind::Function => Namespace::Callable,
            SymbolKind::Force => Namespace::Force,
            SymbolKind::Moment => Namespace::Moment,
            SymbolKind::Model
            | SymbolKind::Body
            | SymbolKind::Observation
            | SymbolKind::Effect
            | SymbolKind::Solve => Namespace::Other,
            _ => Namespace::Value,
        };
        let range = self.range(at);
        self.scanned.declarations.push(Declaration {
            name: plain(self.text(at)),
            kind,
            is_array: self.text(at + 1) == "[",
            statement: range.clone(),
            range,
            scope,
            doc: self.doc.clone(),
            namespace,
        });
        self.scanned.weak.push(weak);
        self.scanned.names.insert(plain(self.text(at)));
        let index = self.scanned.declarations.len() - 1;
        self.word(at, Found::Declares(index));
    }

    fn statement(&mut self, tokens: Range<usize>) {
        let (at, end) = (tokens.start, tokens.end);
        if self.token(at) != Token::Name || at == end {
            return self.expression(tokens, false);
        }
        let first = self.scanned.declarations.len();
        let word = self.text(at);
        self.begins = word;
        if self.is_in("solve") && !self.is_solve_word(at) {
            return self.expression(tokens, false);
        }
        self.keyword(at);
        let quantity = matches!(
            word,
            "param" | "coefficient" | "state" | "input" | "set" | "expect" | "negligible"
        );
        match word {
            "model" => self.declare(at + 1, SymbolKind::Model),
            "param" => self.named(at + 1, end, SymbolKind::Parameter, quantity),
            "coefficient" => self.named(at + 1, end, SymbolKind::Coefficient, quantity),
            "input" => self.named(at + 1, end, SymbolKind::Input, quantity),
            "state" => self.named(at + 1, end, SymbolKind::State, quantity),
            "let" => self.named(at + 1, end, SymbolKind::Quantity, quantity),
            "marker" => self.named(at + 1, end, SymbolKind::Marker, quantity),
            "observe" => self.named(at + 1, end, SymbolKind::Observation, quantity),
            "force" | "moment"
                if matches!(self.text(at + 2), "=" | "[" | "on") || at + 2 >= end =>
            {
                let kind = if word == "force" {
                    SymbolKind::Force
                } else {
                    SymbolKind::Moment
                };
                self.load(at + 1, end, kind);
            }
            "solve" => self.declare(at + 1, SymbolKind::Solve),
            "unknown" if self.is_in("solve") => {
                self.named(at + 1, end, SymbolKind::Unknown, false);
            }
            "frame" => self.frame(at + 1, end),
            "body" | "point" => self.named(at + 1, end, SymbolKind::Body, false),
            "claim" => {
                self.keyword(at + 1);
                self.keyword(at + 2);
            }
            "effect" => {
                self.declare(at + 1, SymbolKind::Effect);
                self.labels(at + 2..end);
            }
            "table" | "function" => self.callable(at, end),
            "position" | "velocity" | "angular" if self.is_in("body") => {
                let tokens = at + 1..end;
                let defaults = { tokens.clone() }.find(|at| self.text(*at) == "=");
                self.states(at + 1..defaults.unwrap_or(end));
                self.expression(defaults.unwrap_or(end)..end, true);
            }
            "inertia" => self.inertia(at + 1, end),
            "replace" => self.replace(at + 1, end),
            "needs" => self.needs(at + 1..end),
            "reference" | "site" | "variables" | "generalises" => self.labels(at + 1..end),
            _ => self.expression(at + 1..end, quantity),
        }
        for own in &mut self.scanned.declarations[first..] {
            own.statement.start = self.tokens[at].start as usize;
        }
    }

    /// Whether a word in a block of equations begins a declaration or a constraint, and no equation.
    fn is_solve_word(&self, at: usize) -> bool {
        match self.text(at) {
            "unknown" => self.token(at + 1) == Token::Name,
            "constraint" => !matches!(
                self.text(at + 1),
                "*" | "/" | "+" | "-" | "^" | "=" | "·" | "×" | "." | "["
            ),
            _ => false,
        }
    }

    fn named(&mut self, at: usize, end: usize, kind: SymbolKind, quantity: bool) {
        // The observation may have the name of the marker.
        let is_weak = kind == SymbolKind::Observation;
        self.declare_in(at, kind, self.scope..usize::MAX, is_weak);
        self.expression(at + 1..end, quantity);
    }

    /// A force or moment, with the body on which it acts.
    fn load(&mut self, at: usize, end: usize, kind: SymbolKind) {
        self.declare(at, kind);
        let mut tokens = (at + 1..end).take_while(|at| self.text(*at) != "=");
        let Some(on) = tokens.find(|at| self.text(*at) == "on") else {
            return self.expression(at + 1..end, false);
        };
        self.expression(at + 1..on, false);
        self.keyword(on);
        self.word(on + 1, Found::Name(Namespace::Other));
        self.expression(on + 2..end, false);
    }

    /// Words that are no names of the text: models, sites, kinds of variables.
    fn labels(&mut self, tokens: Range<usize>) {
        tokens.for_each(|at| self.keyword(at));
    }

    fn frame(&mut self, at: usize, end: usize) {
        self.declare(at, SymbolKind::Frame);
        self.word(at + 2, Found::Name(Namespace::Frame));
        match self.text(at + 3) {
            "turned" => {
                self.keyword(at + 3);
                if self.text(at + 5) == "about" {
                    self.declare_in(at + 4, SymbolKind::State, self.scope..usize::MAX, true);
                    self.keyword(at + 5);
                } else {
                    let about = (at + 4..end).rfind(|&k| self.text(k) == "about");
                    let about = about.unwrap_or(end);
                    self.expression(at + 4..about, false);
                    self.keyword(about);
                }
            }
            "by" => {
                self.keyword(at + 3);
                self.keyword(at + 4);
                self.states(at + 5..end);
            }
            _ => {}
        }
    }

    /// Declares the names in brackets as states, and reads the frame behind.
    fn states(&mut self, tokens: Range<usize>) {
        let mut is_behind = false;
        for at in tokens.clone() {
            is_behind |= self.text(at) == ")";
            if is_behind {
                return self.expression(at..tokens.end, false);
            }
            if self.text(at) == "velocity" {
                self.keyword(at);
            } else {
                self.declare(at, SymbolKind::State);
            }
        }
    }

    fn callable(&mut self, at: usize, end: usize) {
        let is_table = self.text(at) == "table";
        let kind = if is_table {
            SymbolKind::Table
        } else {
            SymbolKind::Function
        };
        self.declare(at + 1, kind);
        let (from, to) = (self.range(at).start, self.range(end).end);
        let mut next = at + 2;
        let mut begins = true;
        while next < end && !matches!(self.text(next), ")" | "=") {
            if begins && self.token(next) == Token::Name {
                self.declare_in(next, SymbolKind::Argument, from..to, false);
                begins = false;
            } else if self.text(next) == ":" {
                let stop = self.end_of_type(next + 1, end);
                self.of_type(next + 1..stop);
                next = stop;
                continue;
            }
            begins |= matches!(self.text(next), "," | "(");
            next += 1;
        }
        self.expression(next..end, is_table);
    }

    fn replace(&mut self, at: usize, end: usize) {
        match self.text(at) {
            "force" | "moment" => {
                self.keyword(at);
                let is_force = self.text(at) == "force";
                let namespace = if is_force {
                    Namespace::Force
                } else {
                    Namespace::Moment
                };
                self.word(at + 1, Found::Name(namespace));
                self.expression(at + 2..end, false);
            }
            "inertia" => {
                self.keyword(at);
                self.inertia(at + 1, end);
            }
            "clock" | "observe" => {
                self.keyword(at);
                self.expression(at + 1..end, false);
            }
            _ => self.expression(at..end, false),
        }
    }

    /// Moments of inertia, with their unit behind the last bracket.
    fn inertia(&mut self, at: usize, end: usize) {
        let close = (at..end).rfind(|&at| self.text(at) == ")").unwrap_or(end);
        self.expression(at..close, false);
        self.expression(close..end, true);
    }

    fn needs(&mut self, tokens: Range<usize>) {
        let mut at = tokens.start;
        let mut begins = true;
        while at < tokens.end {
            match self.text(at) {
                "vector" if begins => self.keyword(at),
                "," => begins = true,
                ":" => {
                    let stop = self.end_of_type(at + 1, tokens.end);
                    self.of_type(at + 1..stop);
                    at = stop;
                    continue;
                }
                "or" => {
                    self.keyword(at);
                    let mut open = 0_i32;
                    let stop = (at + 1..tokens.end).find(|&next| {
                        open += i32::from(self.text(next) == "(");
                        open -= i32::from(self.text(next) == ")");
                        open == 0 && self.text(next) == ","
                    });
                    let stop = stop.unwrap_or(tokens.end);
                    self.expression(at + 1..stop, false);
                    at = stop;
                    continue;
                }
                _ if begins => {
                    self.declare_in(at, SymbolKind::Need, self.scope..usize::MAX, true);
                    begins = false;
                }
                _ => {}
            }
            at += 1;
        }
    }
}

//! Precedence-climbing parser for expressions: `^` (right-associative), then signs, products, sums.

use super::ast::{BinaryOp, Expr, ExprKind, Quantity, UnitExpr};
use super::parser::{Parser, Read, Reported};
use super::quantity::{FOLLOWING, INCH, superscript_value};
use super::token::Token;
use crate::diagnostic::{Diagnostic, Kind, Span};
use crate::unit::symbol;

/// Maximum height of an expression in nodes, which bounds the recursion of later passes.
pub(crate) const MAX_HEIGHT: u32 = 200;

const SIGN: u8 = 25;
const POWER: u8 = 31;

struct Tree {
    expr: Expr,
    height: u32,
}

fn binding(token: Token) -> Option<(BinaryOp, u8, u8)> {
    Some(match token {
        Token::Sign("+") => (BinaryOp::Add, 10, 11),
        Token::Sign("-") => (BinaryOp::Sub, 10, 11),
        Token::Sign("*") => (BinaryOp::Mul, 20, 21),
        Token::Sign("·") => (BinaryOp::Dot, 20, 21),
        Token::Sign("×") => (BinaryOp::Cross, 20, 21),
        Token::Sign("/") => (BinaryOp::Div, 20, 21),
        Token::Sign("^") => (BinaryOp::Pow, POWER, POWER - 1),
        _ => return None,
    })
}

impl Parser<'_> {
    pub fn expr(&mut self) -> Read<Expr> {
        self.tree(0).map(|t| t.expr)
    }

    fn tree(&mut self, least: u8) -> Read<Tree> {
        self.nested(|p| p.tree_inner(least))
    }

    fn tree_inner(&mut self, least: u8) -> Read<Tree> {
        let mut left = self.prefix()?;
        loop {
            if self.peek() == Token::Superscript && POWER >= least {
                left = self.superscript(left)?;
                continue;
            }
            if self.peek() == Token::Sign("**") {
                let span = self.here();
                let message = "expected an operator, found `**`";
                let fault = Diagnostic::new(Kind::Grammar, span, message);
                return self.refuse(fault.help("a power is written `^`").fix(span, "^"));
            }
            let Some((op, from, to)) = binding(self.peek()) else {
                break;
            };
            if from < least {
                break;
            }
            self.advance();
            let right = self.tree(to)?;
            let span = left.expr.span.to(right.expr.span);
            let height = left.height.max(right.height);
            let kind = ExprKind::Binary(op, Box::new(left.expr), Box::new(right.expr));
            left = self.grown(kind, span, height)?;
        }
        Ok(left)
    }

    /// Creates a node above subtrees of height `below`; reports a tree beyond [`MAX_HEIGHT`].
    fn grown(&mut self, kind: ExprKind, span: Span, below: u32) -> Read<Tree> {
        if below + 1 > MAX_HEIGHT {
            let message = format!("this expression has more than {MAX_HEIGHT} operations in a row");
            let fault = Diagnostic::new(Kind::Limit, self.behind(), message);
            return self.refuse(fault.help("give parts of it names with `let`"));
        }
        Ok(Tree {
            expr: Expr { kind, span },
            height: below + 1,
        })
    }

    fn superscript(&mut self, base: Tree) -> Read<Tree> {
        let span = self.here();
        let value = superscript_value(self.raw()).unwrap_or(f64::INFINITY);
        self.advance();
        let mut exponent = Expr::number(value.abs().to_string(), span);
        if value < 0.0 {
            exponent = Expr::new(ExprKind::Neg(Box::new(exponent)), span);
        }
        let whole = base.expr.span.to(span);
        let exponent = Box::new(exponent);
        let kind = ExprKind::Binary(BinaryOp::Pow, Box::new(base.expr), exponent);
        self.grown(kind, whole, base.height)
    }

    fn prefix(&mut self) -> Read<Tree> {
        let start = self.here();
        if self.eat(Token::Sign("-")) {
            let inner = self.tree(SIGN)?;
            let span = start.to(inner.expr.span);
            return self.grown(ExprKind::Neg(Box::new(inner.expr)), span, inner.height);
        }
        if self.eat(Token::Sign("+")) {
            return self.tree(SIGN);
        }
        let mut tree = self.primary()?;
        while self.eat(Token::Sign(".")) {
            let part = self.axis("the number of an axis or component: 1, 2 or 3")?;
            let span = tree.expr.span.to(self.behind());
            tree = self.grown(ExprKind::Part(Box::new(tree.expr), part), span, tree.height)?;
        }
        Ok(tree)
    }

    pub fn axis(&mut self, what: &str) -> Read<u8> {
        match (self.peek(), self.raw()) {
            (Token::Number, raw @ ("1" | "2" | "3")) => {
                self.advance();
                Ok(raw.as_bytes()[0] - b'0')
            }
            (Token::Name, "x" | "y" | "z") => {
                let help = "components are numbered: `.1`, `.2`, `.3`";
                self.expected_help(what, Some(help.to_owned()))
            }
            (Token::Name, function) if self.peek_at(1) == Token::Sign("(") => {
                let help = format!("a function stands before its argument: `{function}(…)`");
                self.expected_help(what, Some(help))
            }
            _ => self.expected(what),
        }
    }

    fn primary(&mut self) -> Read<Tree> {
        let start = self.here();
        match self.peek() {
            Token::Number => self.literal(),
            Token::Sign("(") => self.bracket(start),
            Token::Name if self.peek_at(1) == Token::Sign("(") => self.call(start),
            Token::Name if self.peek_at(1) == Token::Sign("[") => {
                let name = self.name("a name")?;
                let subscripts = self.nested(Self::subscripts)?;
                let span = start.to(self.behind());
                self.grown(ExprKind::Element(name.text, subscripts), span, 0)
            }
            Token::Name => {
                let name = self.name("a name")?;
                self.grown(ExprKind::Name(name.text), start, 0)
            }
            _ => self.expected("an expression"),
        }
    }

    /// Whether the name here continues the statement after a number, as in `within 1e-9`, and is not its unit. `in` is the
    /// inch unless another name follows, as in `i in F`.
    fn follows_a_number(&self) -> bool {
        match self.raw() {
            INCH => self.peek_at(1) == Token::Name,
            word => FOLLOWING.contains(&word),
        }
    }

    fn literal(&mut self) -> Read<Tree> {
        let number = self.digits("a number")?;
        let unit = match self.peek() {
            Token::Sign("[") => Some(self.square_unit()?),
            Token::Name
                if !self.begins_anew()
                    && !self.follows_a_number()
                    && self.peek_at(1) != Token::Sign("(") =>
            {
                let factor = self.unit_power()?;
                let span = factor.span;
                Some(UnitExpr {
                    factors: vec![factor],
                    span,
                })
            }
            Token::Name if self.peek_at(1) == Token::Sign("(") && !self.first_on_line() => {
                let help = format!("write `{}*{}(…)`", number.text, self.raw());
                return self.expected_help("an operator", Some(help));
            }
            _ => None,
        };
        let span = number.span.to(self.behind());
        self.grown(ExprKind::Number(Quantity { number, unit, span }), span, 0)
    }

    fn bracket(&mut self, start: Span) -> Read<Tree> {
        self.advance();
        let first = self.tree(0)?;
        if self.peek() != Token::Sign(",") {
            self.closing(start)?;
            let expr = Expr::new(first.expr.kind, start.to(self.behind()));
            return Ok(Tree { expr, ..first });
        }
        self.advance();
        let second = self.tree(0)?;
        if self.peek() == Token::Sign(")") {
            let [first, second] = [&first, &second].map(|part| self.slice(part.expr.span));
            let vector = || {
                format!(
                    "a vector has three components: `({first}, {second}, 0)`, or `({first}, 0, {second})`"
                )
            };
            let help = super::spelling::element_help(first, second).unwrap_or_else(vector);
            return self.expected_help("`,` and the third component of a vector", Some(help));
        }
        self.need(Token::Sign(","), "`,` between the components of a vector")?;
        let third = self.tree(0)?;
        self.closing(start)?;
        let triple = start.to(self.behind());
        if !self.eat_word("in") {
            if let Some(fault) = self.unit_behind(triple, [&first, &second, &third]) {
                return self.refuse(fault);
            }
            let message = "a vector in components must say in which frame they are";
            let fault = Diagnostic::new(Kind::Grammar, triple, message).help(format!(
                "write `{} in B`, with the name of a frame for `B`",
                self.slice(triple)
            ));
            return self.refuse(fault);
        }
        let frame = self.name("the name of a frame after `in`")?;
        let span = start.to(frame.span);
        let height = first.height.max(second.height).max(third.height);
        let parts = Box::new([first.expr, second.expr, third.expr]);
        self.grown(ExprKind::Components(parts, frame), span, height)
    }

    /// Error for a unit behind the brackets of a vector in components, as in `(0, 0, 50) m in N`.
    fn unit_behind(&self, triple: Span, parts: [&Tree; 3]) -> Option<Diagnostic> {
        let next = self.slice(self.here());
        let is_unit = self.peek() == Token::Sign("[")
            || self.peek() == Token::Name && symbol::find(next).is_some();
        let message = "in an expression a unit stands behind each component of a vector";
        let each = parts.map(|part| self.slice(part.expr.span));
        let shown = match (self.peek(), each) {
            (Token::Name, [a, b, c]) => format!("`({a} {next}, {b} {next}, {c} {next}) in …`"),
            (_, [a, b, c]) => format!("`({a} […], {b} […], {c} […]) in …`"),
        };
        let fault = Diagnostic::new(Kind::Grammar, triple, message);
        is_unit.then(|| fault.help(format!("write {shown}, of which 0 needs none")))
    }

    fn closing(&mut self, open: Span) -> Read<()> {
        if self.eat(Token::Sign(")")) {
            return Ok(());
        }
        let found = super::lexer::name_of(self.lexeme(), self.slice_all());
        let help = match self.peek() {
            Token::Name | Token::Number | Token::Sign("(") => {
                Some("a product is written with `*` or `·`".to_owned())
            }
            _ => None,
        };
        if !self.reported_by_lexer() {
            let message = format!("expected an operator or `)`, found {found}");
            let fault = Diagnostic::new(Kind::Grammar, self.here(), message)
                .label(open.first_bytes(1), "this bracket is open")
                .label(self.here(), "here")
                .help_if(help);
            self.report(fault);
        }
        Err(Reported)
    }

    /// Parses the rest of `sum(i in 1..8, …, EXPR)` after the bracket.
    fn sum_over(&mut self, start: Span, open: Span) -> Read<Tree> {
        let mut indices = Vec::new();
        while self.peek() == Token::Name && self.raw_at(1) == "in" {
            indices.push(self.index()?);
            self.need(Token::Sign(","), "`,` and what is summed")?;
        }
        let mut tree = self.tree(0)?;
        self.closing(open)?;
        let span = start.to(self.behind());
        while let Some(index) = indices.pop() {
            let kind = ExprKind::Sum(Box::new(index), Box::new(tree.expr));
            tree = self.grown(kind, span, tree.height)?;
        }
        Ok(tree)
    }

    /// Whether a name or an element of an array fills the parentheses.
    fn is_only_a_name(&self) -> bool {
        let behind = match self.raw_at(1) {
            "[" => (2..).find(|at| matches!(self.raw_at(*at), "]" | ")" | "")),
            _ => Some(0),
        };
        self.peek() == Token::Name && behind.is_some_and(|at| self.raw_at(at + 1) == ")")
    }

    fn call(&mut self, start: Span) -> Read<Tree> {
        let name = self.name("a function")?;
        let open = self.here();
        self.advance();
        if name.text == "der" && self.is_only_a_name() {
            let state = self.name("the name of a state")?;
            let subscripts = self.nested(Self::subscripts)?;
            let element = state.span.to(self.behind());
            self.closing(open)?;
            let span = start.to(self.behind());
            if subscripts.is_empty() {
                return self.grown(ExprKind::Derivative(state), span, 0);
            }
            let kind = ExprKind::Element(state.text, subscripts);
            let element = Expr::new(kind, element);
            return self.grown(ExprKind::Call(name, vec![element]), span, 0);
        }
        if name.text == "sum" {
            if self.peek() != Token::Name || self.raw_at(1) != "in" {
                let message = "this `sum` has no index";
                let fault = Diagnostic::new(Kind::Grammar, name.span, message);
                return self.refuse(fault.help("say over what: `sum(i in 1..8, …)`"));
            }
            return self.sum_over(start, open);
        }
        let arguments = match self.peek() {
            Token::Sign(")") => Vec::new(),
            _ => self.list(|parser| parser.tree(0))?,
        };
        self.closing(open)?;
        let height = arguments.iter().map(|argument| argument.height).max();
        let arguments = arguments.into_iter().map(|argument| argument.expr);
        self.grown(
            ExprKind::Call(name, arguments.collect()),
            start.to(self.behind()),
            height.unwrap_or(0),
        )
    }
}

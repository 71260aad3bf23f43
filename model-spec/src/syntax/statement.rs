//! Parser for the statements of a file.

use super::ast::{
    Equation, ExprKind, Frame, FrameKind, Index, Input, Item, ItemKind, Let, Limit, Load,
    LoadClass, Name, Number, Parameter, ParameterClass, Quantity, State, UnitExpr,
};
use super::parser::{Parser, Read};
use super::token::Token;
use super::words;
use crate::diagnostic::{Diagnostic, Kind};
use crate::unit::symbol;

/// Tokens of a unit behind a number, beyond which no sum is searched.
const MAX_UNIT_TOKENS: usize = 40;

impl Parser<'_> {
    pub fn statement(&mut self) -> Read<Item> {
        let doc = self.doc();
        let start = self.here();
        if self.peek() != Token::Name {
            let help =
                "equations that are not solved for one derivative stand in a block `solve { … }`";
            let is_equation = matches!(self.peek(), Token::Sign("(" | "-") | Token::Number);
            return self.expected_help("a statement", is_equation.then(|| help.to_owned()));
        }
        let word = self.raw();
        let kind = match word {
            "model" => self.named(ItemKind::Model)?,
            "include" => self.include()?,
            "reference" => self.named(ItemKind::Reference)?,
            "param" | "coefficient" => self.constant()?,
            "input" => self.input()?,
            "state" => self.state()?,
            "frame" => self.frame()?,
            "body" | "point" => self.body()?,
            "claim" => self.claim()?,
            "function" => self.function()?,
            "table" => self.table()?,
            "let" => self.binding()?,
            "force" | "moment" => self.load()?,
            "der" => self.equation()?,
            "solve" => self.solve()?,
            "marker" => self.marker()?,
            "observe" => self.observe()?,
            "clock" => {
                self.advance();
                self.clock()?
            }
            "limit" => self.limit()?,
            "check" => self.check_case()?,
            "effect" => self.effect(doc.clone())?,
            _ => return self.no_statement(word),
        };
        Ok(Item::new(kind, doc, start.to(self.behind())))
    }

    /// Reports that `word` does not begin a statement in this context. Always returns `Err`.
    pub fn no_statement<T>(&mut self, word: &str) -> Read<T> {
        let span = self.here();
        let block = words::inside(word).map(|own| own.form);
        let message = match block {
            Some(block) => format!("`{word}` stands inside `{block} {{ }}`, not here"),
            None => format!("no statement begins with `{word}`"),
        };
        let mut fault = Diagnostic::new(Kind::Grammar, span, message);
        if block.is_none() {
            let is_definition = self.peek_at(1) == Token::Sign("=");
            if is_definition {
                let start = span.before();
                let definition = format!("a quantity is named with `let {word} = …;`");
                fault = fault.help(definition).fix(start, "let ");
            } else if self.is_equation() {
                fault = fault.help(
                    "an equation that is not solved for its derivative stands in a block: `solve { LEFT = RIGHT; }`",
                );
                return self.refuse(fault);
            } else if word == "for" {
                let help = "the index stands behind a name: `let r[i] for i in 1..8 = …;`";
                fault = fault.help(help);
            }
            fault = fault.did_you_mean(word, self.suggestions(&words::STATEMENTS));
        } else if block == Some("body NAME")
            && (self.peek_at(1), self.peek_at(2)) == (Token::Name, Token::Sign("="))
        {
            let name = self.raw_at(1);
            fault = fault.help(format!(
                "a known constant is declared with `param {name} = …;`"
            ));
        }
        self.refuse(fault)
    }

    /// Whether the statement here is an equation between expressions.
    fn is_equation(&self) -> bool {
        let is_end = |at: &usize| matches!(self.peek_at(*at), Token::End | Token::Sign(";"));
        self.is_operator_at(1)
            && (1..MAX_UNIT_TOKENS)
                .take_while(|at| !is_end(at))
                .any(|at| self.peek_at(at) == Token::Sign("="))
    }

    fn named(&mut self, make: impl Fn(Name) -> ItemKind) -> Read<ItemKind> {
        let (word, name) = self.keyword_and_name()?;
        self.semicolon(&format!("this `{word}`"))?;
        Ok(make(name))
    }

    fn include(&mut self) -> Read<ItemKind> {
        self.advance();
        let span = self.here();
        let file = Name::new(self.quoted("the name of a file")?, span);
        self.semicolon("this `include`")?;
        Ok(ItemKind::Include(file))
    }

    /// Parses `param NAME = value unit in lo .. hi;` or `coefficient …`.
    pub fn constant(&mut self) -> Read<ItemKind> {
        let (word, name) = self.keyword_and_name()?;
        let class = if word == "param" {
            ParameterClass::Param
        } else {
            ParameterClass::Coefficient
        };
        let subscripts = self.subscripts()?;
        let declared_unit = match class {
            ParameterClass::Param => self.unit_behind_colon()?,
            ParameterClass::Coefficient | ParameterClass::Input => None,
        };
        let indices = self.indices()?;
        let what = format!("`=` and the default of `{}`", name.text);
        self.need(Token::Sign("="), &what)?;
        if class == ParameterClass::Param && self.at_computed() {
            let value = self.expr()?;
            let definition = format!("the definition of `{}`", name.text);
            if self.at_word("in") {
                let help =
                    "what is computed has no bounds of its own: those of what it is made of hold";
                let what = format!("`;` at the end of {definition}");
                return self.expected_help(&what, Some(help.to_owned()));
            }
            self.semicolon(&definition)?;
            let own = Let {
                is_constant: true,
                name,
                unit: declared_unit,
                value,
            };
            return self.array(subscripts, indices, Vec::new(), ItemKind::Let(own));
        }
        if let Some(unit) = declared_unit {
            let message = "the unit of a default stands behind its number";
            let fault = Diagnostic::new(Kind::Grammar, unit.span, message);
            return self.refuse(fault.help(format!("write `param {} = 1 {unit};`", name.text)));
        }
        if indices.is_empty() && self.at_list() {
            let name = &name.text;
            let help =
                format!("a list is of an array: `{word} {name}[i] for i in 1..3 = (…, …, …);`");
            return self.expected_help("a number", Some(help));
        }
        let (value, values) = self.defaults(&indices)?;
        let parameter = ItemKind::Parameter(self.parameter(class, name, value)?);
        self.array(subscripts, indices, values, parameter)
    }

    /// Parses the bounds and the end of a declaration of a scalar.
    fn parameter(&mut self, class: ParameterClass, name: Name, value: Quantity) -> Read<Parameter> {
        let bounds = if self.eat_word("in") {
            let least = self.quantity("the least value")?;
            if !self.eat(Token::Sign("..")) {
                let help = format!("write `in {least} .. 10`");
                return self
                    .expected_help("`..` between the least and the greatest value", Some(help));
            }
            Some((least, self.quantity("the greatest value")?))
        } else {
            None
        };
        self.semicolon(&format!("this `{}`", class.keyword()))?;
        Ok(Parameter {
            class,
            name,
            value,
            bounds,
        })
    }

    /// Gives the default of `name` the unit that stands before it.
    fn unit_before(
        &mut self,
        unit: Option<UnitExpr>,
        value: &mut Quantity,
        name: &Name,
    ) -> Read<()> {
        if let (Some(unit), Some(second)) = (&unit, &value.unit) {
            let help = format!("write `{}: {unit} = …;` or `= {value};`", name.text);
            let fault = Diagnostic::new(Kind::Grammar, second.span, "the unit is stated twice");
            return self.refuse(fault.help(help));
        }
        value.unit = unit.or(value.unit.take());
        Ok(())
    }

    /// Whether the default of a parameter is an expression rather than a number with its unit, or a list of numbers.
    fn at_computed(&self) -> bool {
        let signed = |at| usize::from(matches!(self.peek_at(at), Token::Sign("-" | "+")));
        let at = signed(0);
        match self.peek_at(at) {
            Token::Name => return true,
            Token::Sign("(") => {
                let first = at + 1 + signed(at + 1);
                let is_list = self.peek_at(first) == Token::Number
                    && self.peek_at(first + 1) == Token::Sign(",");
                return !is_list;
            }
            Token::Number => {}
            _ => return false,
        }
        match (self.peek_at(at + 1), self.peek_at(at + 2)) {
            (Token::Sign("*" | "·" | "×" | "+" | "-" | "^") | Token::Superscript, _) => true,
            (Token::Sign("/"), Token::Number) => self.raw_at(at + 2) != "1",
            (Token::Sign("/"), Token::Name) => symbol::find(self.raw_at(at + 2)).is_none(),
            _ => self.adds_behind(at + 1),
        }
    }

    /// Whether a list of numbers follows, in round or square brackets.
    fn at_list(&self) -> bool {
        let is_second = |at| self.peek_at(at) == Token::Sign(",");
        match self.peek() {
            Token::Sign("[") => true,
            Token::Sign("(") => is_second(2) || is_second(3),
            _ => false,
        }
    }

    /// Whether a sum follows `at` tokens ahead in the statement, as in `2 m + d`, before the bounds.
    fn adds_behind(&self, at: usize) -> bool {
        (at..at + MAX_UNIT_TOKENS)
            .take_while(|&at| !matches!(self.peek_at(at), Token::End | Token::Sign(";" | "=")))
            .take_while(|&at| self.raw_at(at) != "in")
            .any(|at| {
                let is_sum = matches!(self.peek_at(at), Token::Sign("+" | "-"));
                is_sum && !matches!(self.peek_at(at - 1), Token::Sign("^" | "("))
            })
    }

    /// Parses the default of a parameter, and the list `(a, b, …) unit` of the defaults of an array's elements.
    fn defaults(&mut self, indices: &[Index]) -> Read<(Quantity, Vec<Number>)> {
        if indices.is_empty() || self.peek() != Token::Sign("(") {
            return Ok((self.quantity("a number")?, Vec::new()));
        }
        let start = self.here();
        self.advance();
        let values = self.list(|parser| parser.number("a number"))?;
        self.need(Token::Sign(")"), "`,` or `)` after a number")?;
        let span = start.to(self.behind());
        let unit = self.optional_unit()?;
        let elements: usize = indices
            .iter()
            .map(|index| index.values.clone().count())
            .product();
        if values.len() != elements {
            let message = format!(
                "the array has {elements} elements, but here are {} numbers",
                values.len()
            );
            return self.refuse(Diagnostic::new(Kind::Value, span, message));
        }
        let first = values[0].clone();
        let value = Quantity {
            span: first.span,
            number: first,
            unit,
        };
        Ok((value, values))
    }

    /// Parses `input NAME: UNIT = value in lo .. hi;` of a scalar, `input NAME in FRAME = (…) unit;` of a vector.
    pub fn input(&mut self) -> Read<ItemKind> {
        let (_, name) = self.keyword_and_name()?;
        let unit = self.unit_behind_colon()?;
        if unit.is_some() || self.peek() == Token::Sign("=") {
            self.need(Token::Sign("="), "`=` and the default of the input")?;
            let mut value = self.quantity("a number")?;
            self.unit_before(unit, &mut value, &name)?;
            let input = self.parameter(ParameterClass::Input, name, value);
            return input.map(ItemKind::Parameter);
        }
        let frame = self.in_frame("the name of the input, with the frame of its components")?;
        self.need(Token::Sign("="), "`=` and the default components")?;
        let value = self.triple_of_numbers()?;
        let unit = self.optional_unit()?;
        self.semicolon("this `input`")?;
        Ok(ItemKind::Input(Input {
            name,
            frame,
            value,
            unit,
        }))
    }

    pub fn triple_of_numbers(&mut self) -> Read<[Number; 3]> {
        let open = "`(` and three numbers";
        self.tuple(open, "component", "components", |p| p.number("a number"))
    }

    pub fn state(&mut self) -> Read<ItemKind> {
        let (_, name) = self.keyword_and_name()?;
        let (subscripts, indices) = (self.subscripts()?, self.indices()?);
        let what = format!("`=` and the value of `{}` at the start", name.text);
        self.need(Token::Sign("="), &what)?;
        let value = self.quantity("a number")?;
        self.semicolon("this `state`")?;
        let state = ItemKind::State(State { name, value });
        self.array(subscripts, indices, Vec::new(), state)
    }

    /// Parses `frame N;`, `frame A = N turned ANGLE about AXIS;`, `frame C = N by quaternion (a, b, c, d);`.
    fn frame(&mut self) -> Read<ItemKind> {
        let (_, name) = self.keyword_and_name()?;
        if self.eat(Token::Sign(";")) {
            return Ok(ItemKind::Frame(Frame {
                name,
                kind: FrameKind::Inertial,
            }));
        }
        self.need(Token::Sign("="), "`;` or `=` after the name of the frame")?;
        let parent = self.name("the frame that this one is turned from")?;
        let kind = if self.eat_word("turned") {
            self.turned(parent)?
        } else if self.eat_word("by") {
            self.need_word("quaternion", "`by`")?;
            let open = "`(` and the four components, scalar part first";
            let state = |p: &mut Self| p.name("the name of a state");
            let states = self.tuple(open, "component", "components", state)?;
            FrameKind::Quaternion { parent, states }
        } else {
            return self.expected("`turned ANGLE about AXIS` or `by quaternion (…)`");
        };
        self.semicolon("this `frame`")?;
        Ok(ItemKind::Frame(Frame { name, kind }))
    }

    /// Parses the angle and the axis of a frame that is `turned` from `parent`.
    fn turned(&mut self, parent: Name) -> Read<FrameKind> {
        if self.peek() == Token::Sign("(") && self.peek_at(2) == Token::Sign(",") {
            let help = "a frame by a unit quaternion is written `by quaternion (q0, q1, q2, q3)`";
            return self.expected_help("the angle after `turned`", Some(help.to_owned()));
        }
        let angle = self.expr()?;
        self.need_word("about", "the angle")?;
        let axis = self.axis("the axis: 1, 2 or 3")?;
        Ok(match angle.kind {
            ExprKind::Name(text) => FrameKind::Turned {
                parent,
                angle: Name::new(&text, angle.span),
                axis,
            },
            _ => FrameKind::Fixed {
                parent,
                angle,
                axis,
            },
        })
    }

    pub fn binding(&mut self) -> Read<ItemKind> {
        let (_, name) = self.keyword_and_name()?;
        self.binding_or_array(name)
    }

    /// Parses the rest of a `let` statement after its name: `[i]: unit for i in 1..8 = …;`, all optional but the value.
    pub fn binding_or_array(&mut self, name: Name) -> Read<ItemKind> {
        let subscripts = self.subscripts()?;
        let unit = self.unit_behind_colon()?;
        let indices = self.indices()?;
        let own = self.binding_value(name, unit)?;
        self.array(subscripts, indices, Vec::new(), ItemKind::Let(own))
    }

    /// Parses the rest of a `let` statement after its name: `: unit = …;`, where `: unit` is optional.
    pub fn binding_rest(&mut self, name: Name) -> Read<Let> {
        let unit = self.unit_behind_colon()?;
        self.binding_value(name, unit)
    }

    fn binding_value(&mut self, name: Name, unit: Option<UnitExpr>) -> Read<Let> {
        let statement = format!("the definition of `{}`", name.text);
        let value = self.definition(&name.text, &statement)?;
        Ok(Let::new(name, unit, value))
    }

    pub fn load(&mut self) -> Read<ItemKind> {
        let (word, name) = self.keyword_and_name()?;
        let class = if word == "force" {
            LoadClass::Force
        } else {
            LoadClass::Moment
        };
        let subscripts = self.subscripts()?;
        let on = match self.eat_word("on") {
            true => Some(self.name("the name of a body after `on`")?),
            false => None,
        };
        let indices = self.indices()?;
        let value = self.definition(&name.text, &format!("this `{word}`"))?;
        let load = ItemKind::Load(Load {
            class,
            name,
            on,
            value,
        });
        self.array(subscripts, indices, Vec::new(), load)
    }

    pub fn equation(&mut self) -> Read<ItemKind> {
        self.advance();
        self.need(Token::Sign("("), "`(` after `der`")?;
        let state = self.name("the name of a state")?;
        let subscripts = self.subscripts()?;
        self.need(Token::Sign(")"), "`)` after the state")?;
        let indices = self.indices()?;
        let value = self.definition(&format!("der({})", state.text), "this equation")?;
        let equation = ItemKind::Equation(Equation { state, value });
        self.array(subscripts, indices, Vec::new(), equation)
    }

    /// Parses the rest of a clock statement after the keyword: `clock EXPR;`, or `replace clock = EXPR;` in an effect.
    pub fn clock(&mut self) -> Read<ItemKind> {
        let value = self.expr()?;
        self.semicolon("this `clock`")?;
        Ok(ItemKind::Clock(value))
    }

    fn limit(&mut self) -> Read<ItemKind> {
        self.advance();
        let value = self.expr()?;
        if self.peek() == Token::Sign("<") {
            let help =
                "a limit says what must stay above a bound: write `limit -x > -bound` instead";
            return self.expected_help("`>`", Some(help.to_owned()));
        }
        self.need(Token::Sign(">"), "`>` and the bound of the limit")?;
        let bound = self.quantity("a number, the bound")?;
        if self.peek() == Token::Sign(";") {
            let help = "say what happens there, as in `limit z > 0 \"it has landed\";`".to_owned();
            return self.expected_help("the reason of the limit", Some(help));
        }
        let reason = self.quoted("the reason of the limit")?;
        self.semicolon("this `limit`")?;
        Ok(ItemKind::Limit(Limit {
            value,
            bound,
            reason,
        }))
    }
}

// Grammar of the model language for tree-sitter, for colours and folding. It is wider than the language: what stands in a
// statement is a sequence of expressions and words, so that a statement it does not know is parsed too. `hyzer lsp` tells
// what is wrong.

const NAME = /[A-Za-z_µżġ\u0370-\u03FF\u1E00-\u1EFF°][A-Za-z0-9_µżġ\u0370-\u03FF\u1E00-\u1EFF\u0307\u0308]*/;

const DECLARING = [
  "model", "param", "coefficient", "input", "state", "frame", "let", "force", "moment", "marker", "observe", "body",
  "point", "effect",
];

const OTHERS = [
  "reference", "include", "claim", "solve", "constraint", "clock", "limit", "check", "set", "expect", "replace", "site",
  "variables", "source", "needs", "generalises", "negligible", "increases", "decreases", "mass", "inertia", "fixed",
  "axis", "forward", "position", "velocity", "angular", "return",
];

const commaSeparated = (rule) => seq(rule, repeat(seq(",", rule)));

module.exports = grammar({
  name: "hyzer",
  word: ($) => $.name,
  extras: ($) => [/[\s\uFEFF\u00A0]/, $.comment],
  conflicts: ($) => [[$.declaration, $._expression], [$._arguments, $.brackets]],
  rules: {
    file: ($) => repeat($._item),
    _item: ($) => choice($.declaration, $.callable, $.equation, $.statement),
    declaration: ($) =>
      seq(
        field("keyword", alias(choice(...DECLARING), $.keyword)),
        field("name", $.name),
        optional($.subscripts),
        repeat($._part),
        $._end,
      ),
    subscripts: ($) => seq("[", commaSeparated($._expression), "]"),
    callable: ($) =>
      seq(
        field("keyword", alias(choice("function", "table"), $.keyword)),
        field("name", $.name),
        field("parameters", $.parameters),
        repeat($._part),
        $._end,
      ),
    parameters: ($) => seq("(", optional(commaSeparated(seq($.name, optional($.type)))), ")"),
    equation: ($) => seq(alias("der", $.keyword), "(", $._expression, ")", repeat($._part), $._end),
    statement: ($) =>
      seq(
        field("keyword", choice(alias(choice(...OTHERS, "force", "moment"), $.keyword), $.name)),
        repeat($._part),
        $._end,
      ),
    _end: ($) => choice(";", $.block),
    block: ($) => seq("{", repeat($._item), "}", optional(";")),

    _part: ($) => choice($._expression, $.type, $.table, $.string, $.clause, "=", ">", ",", "..", "relative"),
    clause: ($) =>
      prec.right(
        seq(
          alias(
            choice(
              "in", "turned", "about", "by", "quaternion", "within", "for", "or", "on", "vector", "monotone",
              "constant", "linear",
            ),
            $.keyword,
          ),
        ),
      ),
    type: ($) =>
      prec.right(
        seq(
          ":",
          optional(alias("vector", $.keyword)),
          optional(alias($._expression, $.unit)),
          optional(seq(alias("in", $.keyword), alias($.name, $.frame))),
        ),
      ),
    table: ($) => prec(1, seq("=", "{", repeat(choice($._expression, ":", ",", ";", $.row)), "}")),
    row: ($) => seq("{", repeat(choice($._expression, ":", ",", ";")), "}"),

    _expression: ($) =>
      choice(
        $.name, $.number, $.quantity, $.call, $.element, $.part, $.unary, $.binary, $.power, $.brackets, $.vector, "?",
      ),
    quantity: ($) =>
      prec(
        9,
        seq(
          choice($.number, $.brackets),
          choice(alias($.name, $.unit), seq("[", alias($._expression, $.unit), "]")),
        ),
      ),
    call: ($) =>
      prec(10, seq(field("function", choice($.name, alias("der", $.name))), "(", optional($._arguments), ")")),
    _arguments: ($) => commaSeparated(choice($._expression, $.range)),
    range: ($) => seq($.name, alias("in", $.keyword), $.number, "..", $.number),
    element: ($) => prec(10, seq($.name, "[", commaSeparated($._expression), "]")),
    part: ($) => prec(8, seq($._expression, ".", $.number)),
    power: ($) => prec(7, seq($._expression, $.superscript)),
    brackets: ($) => seq("(", commaSeparated($._expression), ")"),
    vector: ($) => prec(11, seq($.brackets, alias("in", $.keyword), alias($.name, $.frame))),
    unary: ($) => prec(4, seq(choice("-", "−", "+", "/"), $._expression)),
    binary: ($) =>
      choice(
        prec.left(2, seq($._expression, choice("+", "-", "−"), $._expression)),
        prec.left(3, seq($._expression, choice("*", "/", "·", "⋅", "×"), $._expression)),
        prec.right(6, seq($._expression, "^", $._expression)),
      ),

    name: () => NAME,
    number: () => /[0-9]+(\.[0-9]+)?([eE][+\-−]?[0-9]+)?/,
    superscript: () => /[⁺⁻]?[⁰¹²³⁴⁵⁶⁷⁸⁹]+/,
    string: () => /"[^"\n]*"/,
    comment: ($) => choice($.documentation, $._line_comment),
    documentation: () => token(prec(1, /\/\/[\/!][^\n]*/)),
    _line_comment: () => token(/\/\/[^\n]*/),
  },
});

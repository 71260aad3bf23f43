//! Words of the language: how they are used and what they mean.

/// A word of the language.
pub struct LanguageWord {
    /// The word.
    pub word: &'static str,
    /// How it is used.
    pub form: &'static str,
    /// What that means.
    pub doc: &'static str,
}

const fn word(word: &'static str, form: &'static str, doc: &'static str) -> LanguageWord {
    LanguageWord { word, form, doc }
}

/// Words that begin a statement.
pub const STATEMENTS: [LanguageWord; 44] = [
    word("model", "model NAME;", "name of the model"),
    word(
        "include",
        "include \"FILE.hyz\";",
        "statements of another file, beside this one or below",
    ),
    word(
        "reference",
        "reference NAME;",
        "equations coded by hand with which `hyzer verify` compares the model",
    ),
    word(
        "param",
        "param NAME = VALUE UNIT in LEAST .. GREATEST;",
        "known constant of the body or the place",
    ),
    word(
        "coefficient",
        "coefficient NAME = VALUE UNIT in LEAST .. GREATEST;",
        "what flights are fitted for",
    ),
    word(
        "input",
        "input NAME in FRAME = (0, 0, 0) UNIT;",
        "given with each flight; a scalar may vary during it",
    ),
    word(
        "state",
        "state NAME = VALUE UNIT;",
        "a state with an equation `der(NAME) = …;`",
    ),
    word(
        "frame",
        "frame NAME = PARENT turned ANGLE about AXIS;",
        "frame of reference; the first is inertial, with its third axis up",
    ),
    word(
        "body",
        "body NAME { mass …; inertia …; fixed in …; position …; velocity …; }",
        "rigid body, whose equations of motion are derived",
    ),
    word(
        "point",
        "point NAME { mass …; position …; velocity …; }",
        "point mass, whose equations of motion are derived",
    ),
    word(
        "claim",
        "claim body NAME { … }",
        "the body whose motion the stated equations are claimed to be",
    ),
    word(
        "function",
        "function NAME(PARAMETER: TYPE): TYPE { let …; return …; }",
        "computed anew for each call",
    ),
    word(
        "table",
        "table NAME(ARGUMENT: UNIT): UNIT = { argument: value, … };",
        "function of one number, or of two, by its values at knots",
    ),
    word(
        "let",
        "let NAME = EXPRESSION;",
        "names a number or a vector",
    ),
    word("force", "force NAME = VECTOR;", "acts at the mass centre"),
    word(
        "moment",
        "moment NAME = VECTOR;",
        "acts about the mass centre",
    ),
    word(
        "der",
        "der(STATE) = EXPRESSION;",
        "derivative of a state by the time",
    ),
    word(
        "solve",
        "solve NAME { unknown …; LEFT = RIGHT; }",
        "equations that determine derivatives and unknowns together",
    ),
    word(
        "unknown",
        "unknown NAME: UNIT;",
        "what the equations of a block `solve` determine",
    ),
    word(
        "constraint",
        "constraint LEFT = RIGHT within DIFFERENCE;",
        "equation of the states, which a block `solve` keeps",
    ),
    word(
        "marker",
        "marker NAME in FRAME;",
        "point that is tracked, fixed in a frame",
    ),
    word(
        "observe",
        "observe NAME = VECTOR;",
        "where the marker is seen, in the inertial frame",
    ),
    word(
        "clock",
        "clock EXPRESSION;",
        "seconds of flight per second of the recording's clock",
    ),
    word(
        "limit",
        "limit EXPRESSION > NUMBER \"REASON\";",
        "where the model is valid",
    ),
    word(
        "check",
        "check \"TITLE\" { set …; expect …; }",
        "case with known answers, run by `hyzer check`",
    ),
    word(
        "effect",
        "effect NAME on MODEL { … }",
        "change to a model that can be switched on",
    ),
    word("set", "set NAME = VALUE UNIT;", "value in a case"),
    word(
        "expect",
        "expect NAME = VALUE UNIT within DIFFERENCE;",
        "what the model gives in a case",
    ),
    word(
        "replace",
        "replace NAME = EXPRESSION;",
        "new definition, in which `previous` is the one before",
    ),
    word("site", "site WORD;", "where an effect acts"),
    word(
        "variables",
        "variables WORD, WORD;",
        "on what an effect depends",
    ),
    word("source", "source \"TEXT\";", "where an effect is described"),
    word(
        "needs",
        "needs vector NAME: UNIT or NAME;",
        "quantities of the model that an effect needs",
    ),
    word(
        "generalises",
        "generalises NAME, NAME;",
        "more specific effects of which this is the general form",
    ),
    word(
        "negligible",
        "negligible NAME VALUE UNIT;",
        "size below which a departure does not matter",
    ),
    word(
        "increases",
        "increases \"SENTENCE\";",
        "what an effect does above the null value of its coefficient",
    ),
    word(
        "decreases",
        "decreases \"SENTENCE\";",
        "what an effect does below the null value of its coefficient",
    ),
    word("mass", "mass EXPRESSION;", "mass of the body"),
    word(
        "inertia",
        "inertia diag(a, b, c) in FRAME;",
        "moments of inertia about the mass centre",
    ),
    word(
        "fixed",
        "fixed in FRAME;",
        "the frame that turns with the body",
    ),
    word(
        "position",
        "position (x, y, z) in FRAME;",
        "states of the mass centre; in expressions the vector, in the inertial frame",
    ),
    word(
        "velocity",
        "velocity (u, v, w) in FRAME;",
        "states of the mass centre's velocity; in expressions the vector",
    ),
    word(
        "angular",
        "angular velocity (p, q, r) in FRAME;",
        "states of the angular velocity of a body by a quaternion",
    ),
    word("return", "return EXPRESSION;", "result of a function"),
];

/// Functions and quantities of the language.
pub const BUILT_IN: [LanguageWord; 35] = [
    word("sin", "sin(angle)", "sine"),
    word("cos", "cos(angle)", "cosine"),
    word("tan", "tan(angle)", "tangent"),
    word(
        "asin",
        "asin(x)",
        "arcsine, the argument clamped to -1 .. 1",
    ),
    word(
        "acos",
        "acos(x)",
        "arccosine, the argument clamped to -1 .. 1",
    ),
    word("atan", "atan(x)", "arctangent"),
    word("atan2", "atan2(y, x)", "angle of the point (x, y)"),
    word(
        "sqrt",
        "sqrt(x)",
        "square root; 0 where the argument is negative",
    ),
    word("exp", "exp(x)", "exponential"),
    word("log", "log(x)", "natural logarithm"),
    word("abs", "abs(x)", "absolute value"),
    word("sign", "sign(x)", "-1, 0 or 1"),
    word("step", "step(x)", "1 for arguments above 0, else 0"),
    word("tanh", "tanh(x)", "hyperbolic tangent"),
    word("min", "min(a, b)", "the smaller of two numbers"),
    word("max", "max(a, b)", "the greater of two numbers"),
    word("norm", "norm(v)", "length of a vector"),
    word("unit", "unit(v)", "unit vector along a vector"),
    word("dot", "dot(a, b)", "scalar product"),
    word("cross", "cross(a, b)", "vector product"),
    word(
        "ratio",
        "ratio(a, b, otherwise)",
        "a/b, or `otherwise` where b is 0",
    ),
    word("sum", "sum(i in 1..8, f[i])", "sum over an index"),
    word("der", "der(EXPRESSION)", "derivative by the time"),
    word(
        "partial",
        "partial(EXPRESSION, STATE)",
        "derivative by a state, all others held",
    ),
    word("diag", "diag(a, b, c)", "diagonal inertia tensor"),
    word(
        "in_frame_of",
        "in_frame_of(v, w)",
        "v with its components in the frame of w",
    ),
    word(
        "position",
        "position",
        "vector of the mass centre in the inertial frame, m",
    ),
    word(
        "velocity",
        "velocity",
        "velocity of the mass centre, in the frame that the body states, m/s",
    ),
    word(
        "angular_velocity",
        "angular_velocity",
        "angular velocity of the body, rad/s",
    ),
    word(
        "specific_force",
        "specific_force",
        "sum of all forces but the weight over the mass, m/s^2",
    ),
    word(
        "angular_acceleration",
        "angular_acceleration",
        "derivative of the angular velocity in the inertial frame, rad/s^2",
    ),
    word("pi", "pi", "3.14159…"),
    word("time", "time", "time since the release, s"),
    word(
        "previous",
        "previous",
        "in a `replace`, the definition as it was",
    ),
    word(
        "mass",
        "mass",
        "in an effect, the mass that the body states",
    ),
];

/// Words inside statements.
pub const INNER: [&str; 13] = [
    "in",
    "turned",
    "about",
    "by",
    "quaternion",
    "within",
    "relative",
    "for",
    "on",
    "or",
    "vector",
    "monotone",
    "constant",
];

/// What a word of the language means.
pub fn find(word: &str, is_keyword: bool) -> Option<&'static LanguageWord> {
    let find = |all: &'static [LanguageWord]| all.iter().find(|own| own.word == word);
    if is_keyword {
        find(&STATEMENTS)
    } else {
        find(&BUILT_IN)
    }
}

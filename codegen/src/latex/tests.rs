use super::*;

/// LaTeX of the expression with the text `expression`, evaluated in a test model that declares parameters, a
/// coefficient, an input vector, states and a vector, to which the expression can refer.
fn written(expression: &str) -> String {
    let text = format!(
        "model t;\nparam a = 1 rad;\nparam b = 2 rad;\nparam c = 3 rad;\ncoefficient C_La = 1 rad;\ninput wind in N = (1, 0, 0) rad;\n\
         frame N;\nstate alpha = 0 rad;\nstate u = 0 rad;\nder(alpha) = 0 [rad/s];\nder(u) = 0 [rad/s];\n\
         let e = (a, b, c) in N;\nlet t = {expression};\n"
    );
    let model = model_spec::load::from_text("t", &text, &[]).unwrap_or_else(|e| panic!("{e}"));
    let wanted = model
        .aux_variables
        .iter()
        .find(|l| l.name == "t")
        .expect("is there");
    super::expression(&model, &wanted.value)
}

#[test]
fn expressions_have_the_parentheses_they_need() {
    for (plain, latex) in [
        ("a + b*c", "a + b c"),
        ("(a + b)*c", "(a + b) c"),
        ("a - (b - c)", "a - (b - c)"),
        ("a - b - c", "a - b - c"),
        ("-a*b", "-a b"),
        ("a*(-b)", "a (-b)"),
        ("a - (-b)", "a - (-b)"),
        ("2*3*a", r"2 \cdot 3 a"),
        ("a*2", r"a \cdot 2"),
        ("a/b/c", r"\frac{\frac{a}{b}}{c}"),
        ("a/(b*c)", r"\frac{a}{b c}"),
        ("-a/b", r"-\frac{a}{b}"),
        ("(a/b)^2", r"\left(\frac{a}{b}\right)^2"),
        ("(a + b)^2", "(a + b)^2"),
        ("(-a)^2", "(-a)^2"),
        ("(a^2)^3", "(a^2)^3"),
        ("a^12", "a^{12}"),
        ("sqrt(a*b)", r"\sqrt{a b}"),
        ("sin(alpha)*a", r"\sin\alpha \cdot a"),
        ("a*sin(alpha)*cos(alpha)", r"a \sin\alpha \cos\alpha"),
        ("sin(2*alpha)*a", r"\sin(2 \alpha) a"),
        ("sin(alpha)^2", r"\sin^2\alpha"),
        ("C_La*alpha", r"C_{L\alpha} \alpha"),
        ("atan2(-a, b)", r"\operatorname{atan2}(-a,\, b)"),
        ("dot(e, wind)", r"\mathbf{e} \cdot \mathbf{wind}"),
        ("a*dot(e, wind)", r"a (\mathbf{e} \cdot \mathbf{wind})"),
        ("-dot(e, wind)*a", r"(-\mathbf{e} \cdot \mathbf{wind}) a"),
        ("a - dot(e, wind)", r"a - \mathbf{e} \cdot \mathbf{wind}"),
        (
            "cross(e, cross(e, wind))",
            r"\mathbf{e} \times (\mathbf{e} \times \mathbf{wind})",
        ),
        (
            "dot(e, wind)*N.3",
            r"(\mathbf{e} \cdot \mathbf{wind}) \mathbf{n}_3",
        ),
        ("cross(a*e, wind)", r"a \mathbf{e} \times \mathbf{wind}"),
        (
            "cross(e + wind, N.1)",
            r"(\mathbf{e} + \mathbf{wind}) \times \mathbf{n}_1",
        ),
        ("norm(e)^2", r"\left|\mathbf{e}\right|^2"),
        ("unit(e)", r"\operatorname{unit}(\mathbf{e})"),
        ("e.2", r"\mathbf{e} \cdot \mathbf{n}_2"),
        ("max(a, b + c)", r"\max(a,\, b + c)"),
        ("0.00001*a", r"10^{-5} a"),
    ] {
        assert_eq!(written(plain), latex, "{plain}");
    }
}

#[test]
fn definitions_by_name() {
    let disc = model_spec::load::load("disc", &[]).unwrap_or_else(|e| panic!("{e}"));
    for (name, latex) in [
        ("C_L", Some(r"C_L = C_{L0} + C_{L\alpha} \alpha")),
        ("q", Some(r"q = \frac{\rho_{\mathrm{air}} \, V^2}{2}")),
        (
            "weight",
            Some(r"\mathbf{F}_{\mathrm{weight}} = -m g_{\mathrm{here}} \, \mathbf{n}_3"),
        ),
        ("der(u)", None),
        ("nothing", None),
    ] {
        assert_eq!(definition(&disc, name).as_deref(), latex, "{name}");
    }
}

/// All equations of motion of a model as one LaTeX `align*` environment.
fn equations_of(model: &Model) -> String {
    let mut lines: Vec<(String, String)> = Vec::new();
    for quantity in &model.aux_variables {
        // Stated derivatives that other expressions use are auxiliary variables too; the equations below include them.
        if !quantity.name.starts_with("der_") {
            lines.extend(sides(model, &quantity.name));
        }
    }
    for (loads, letter) in [(&model.forces, "F"), (&model.moments, "M")] {
        for load in loads {
            lines.push((
                load_name(letter, &load.name),
                expression(model, &load.value),
            ));
        }
    }
    if let Some(body) = &model.body {
        let sum = |loads: &[Load], letter: &str| match loads {
            [] => r"\mathbf{0}".to_string(),
            _ => {
                let names: Vec<String> = loads
                    .iter()
                    .map(|load| load_name(letter, &load.name))
                    .collect();
                names.join(" + ")
            }
        };
        let mass = tree::piece(model, &body.mass).at_least(piece::Bind::Product);
        lines.push((
            format!(r"{} \dot{{\mathbf{{v}}}}", mass.text),
            sum(&model.forces, "F"),
        ));
        if body.rotation.is_some() {
            let momentum = r"\frac{\mathrm{d}}{\mathrm{d}t} (\mathbf{I} \boldsymbol{\omega})";
            lines.push((momentum.to_string(), sum(&model.moments, "M")));
        }
    }
    for equation in &model.equations {
        let state = &model.states[equation.state].name;
        let line = (rate(state), expression(model, stated(model, equation)));
        // Skips trivial equations: a state that is named as the rate of another.
        if line.0 != line.1 {
            lines.push(line);
        }
    }
    if let Some(clock) = &model.clock {
        let left = r"\frac{\mathrm{d}t}{\mathrm{d}t_{\mathrm{clock}}}".to_string();
        lines.push((left, expression(model, &clock.value)));
    }
    if let Some(observation) = &model.observation {
        let left = format!(r"\mathbf{{y}}_{{{}}}", words(&observation.name));
        lines.push((left, expression(model, &observation.value)));
    }
    let lines: Vec<String> = lines
        .into_iter()
        .map(|(left, right)| format!("  {left} &= {right}"))
        .collect();
    format!(
        "\\begin{{align*}}\n{}\n\\end{{align*}}\n",
        lines.join(" \\\\\n")
    )
}

#[test]
fn the_whole_disc() {
    for name in ["disc", "disc_appendix"] {
        let model = model_spec::load::load(name, &[]).unwrap_or_else(|e| panic!("{e}"));
        insta::assert_snapshot!(name, equations_of(&model));
    }
}

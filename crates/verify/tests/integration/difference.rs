//! What a change of a model does: rewritings are the same function, and the derivative that a mutant changes is named.

use crate::support::built_in;
use model_spec::load::{MODELS, from_text};
use model_spec::model::Model;
use model_spec::syntax::ast::{BinaryOp, Expr, ExprKind, File, Item, ItemKind, Name};
use oracle::{Point, derivatives};
use verify::difference::{Change, Difference, End, Flown, Sameness, compare, landing, operations};
use verify::mutants::mutants;
use verify::random::Random;
use verify::sample;

fn model(text: &str) -> Option<Model> {
    from_text("rewritten", text, &[]).ok()
}

/// Text of a model file in which the name `from` is replaced by `to` everywhere.
fn with_word(file: &File, from: &str, to: &str) -> String {
    let is_name = |c: char| c.is_alphanumeric() || c == '_';
    let text = file.to_string();
    let mut out = String::new();
    let mut rest = text.as_str();
    while let Some(start) = rest.find(is_name) {
        let (before, after) = rest.split_at(start);
        let end = after.find(|c| !is_name(c)).unwrap_or(after.len());
        let word = &after[..end];
        out.push_str(before);
        if word == from {
            out.push_str(to);
        } else if word.strip_prefix("in_") == Some(from) {
            out.push_str(&format!("in_{to}"));
        } else {
            out.push_str(word);
        }
        rest = &after[end..];
    }
    out + rest
}

/// Variants (description, text) of a model file, each with one name of an auxiliary variable, a frame or a load replaced
/// by another.
fn renamed(file: &File) -> Vec<(String, String)> {
    let (mut names, mut others) = (Vec::new(), Vec::new());
    for item in &file.items {
        match &item.kind {
            ItemKind::Let(l) => names.push(l.name.text.clone()),
            ItemKind::Frame(f) => names.push(f.name.text.clone()),
            ItemKind::Load(l) => names.push(l.name.text.clone()),
            ItemKind::Parameter(c) => others.push(c.name.text.clone()),
            _ => {}
        }
    }
    names.retain(|name| !others.contains(name));
    names
        .iter()
        .map(|name| {
            (
                format!("{name} renamed"),
                with_word(file, name, &format!("{name}_new")),
            )
        })
        .collect()
}

/// Variants (description, text) of a model file with reordered statements. Frames, states and headings keep their
/// positions.
fn reordered(file: &File) -> Vec<(String, String)> {
    let moves = |item: &Item| {
        matches!(
            item.kind,
            ItemKind::Let(_) | ItemKind::Load(_) | ItemKind::Parameter(_) | ItemKind::Equation(_)
        )
    };
    (1..=5)
        .map(|seed| {
            let mut random = Random::new(seed, "order");
            let mut file = file.clone();
            let places: Vec<usize> = (0..file.items.len())
                .filter(|&k| moves(&file.items[k]))
                .collect();
            for k in (1..places.len()).rev() {
                let other = (random.next() % (k as u64 + 1)) as usize;
                file.items.swap(places[k], places[other]);
            }
            (format!("reordered by {seed}"), file.to_string())
        })
        .collect()
}

fn value_of(item: &mut Item) -> Option<&mut Expr> {
    match &mut item.kind {
        ItemKind::Let(l) => Some(&mut l.value),
        ItemKind::Load(l) => Some(&mut l.value),
        ItemKind::Equation(e) => Some(&mut e.value),
        _ => None,
    }
}

/// Expressions that differ from `e` but have the same value, such as a sum with interchanged operands; empty if none is
/// known.
fn rewritings(e: &Expr) -> Vec<Expr> {
    let with = |kind| Expr { kind, span: e.span };
    let pair = |op, a: &Expr, b: &Expr| {
        with(ExprKind::Binary(
            op,
            Box::new(a.clone()),
            Box::new(b.clone()),
        ))
    };
    let neg = |a: Expr| with(ExprKind::Neg(Box::new(a)));
    match &e.kind {
        ExprKind::Binary(op @ (BinaryOp::Add | BinaryOp::Mul), a, b) => {
            let mut out = vec![pair(*op, b, a)];
            if let (BinaryOp::Mul, ExprKind::Binary(sum @ (BinaryOp::Add | BinaryOp::Sub), x, y)) =
                (*op, &a.kind)
            {
                out.push(pair(*sum, &pair(*op, x, b), &pair(*op, y, b)));
            }
            if *op == BinaryOp::Mul {
                out.push(neg(pair(*op, a, &neg((**b).clone()))));
            }
            out
        }
        ExprKind::Binary(BinaryOp::Sub, a, b) => vec![neg(pair(BinaryOp::Sub, b, a))],
        ExprKind::Binary(BinaryOp::Pow, a, n) if n.to_string() == "2" => {
            vec![pair(BinaryOp::Mul, a, a)]
        }
        ExprKind::Call(name, arguments) if name.text == "sin" => {
            let negative = ExprKind::Call(name.clone(), vec![neg(arguments[0].clone())]);
            vec![neg(with(negative))]
        }
        _ => Vec::new(),
    }
}

/// Replaces the subexpression with index `n`, in preorder, by the expression that `f` returns. Returns false if `f`
/// returns `None` or there is no such subexpression.
fn replace(e: &mut Expr, n: usize, f: &mut dyn FnMut(&Expr) -> Option<Expr>) -> bool {
    fn walk(e: &mut Expr, n: &mut usize, f: &mut dyn FnMut(&Expr) -> Option<Expr>) -> Option<bool> {
        if *n == 0 {
            let made = f(e);
            let is_made = made.is_some();
            if let Some(made) = made {
                *e = made;
            }
            return Some(is_made);
        }
        *n -= 1;
        let mut children = e.children_mut().into_iter();
        children.find_map(|child| walk(child, n, f))
    }
    let mut n = n;
    walk(e, &mut n, f).unwrap_or(false)
}

/// Variants (description, text) of a model file, each with one expression rewritten to an equivalent one.
fn factored(file: &File) -> Vec<(String, String)> {
    let mut out = Vec::new();
    for index in 0..file.items.len() {
        let mut item = file.items[index].clone();
        let Some(size) = value_of(&mut item).map(|e| e.nodes().count()) else {
            continue;
        };
        for n in 0..size {
            for way in 0..3 {
                let mut changed = file.clone();
                let made = value_of(&mut changed.items[index])
                    .is_some_and(|e| replace(e, n, &mut |e| rewritings(e).into_iter().nth(way)));
                if made {
                    out.push((format!("{} at {n}, {way}", item.kind), changed.to_string()));
                }
            }
        }
    }
    out
}

/// Variants (description, text) of a model file: with the components of a load transformed to another frame, and with
/// an auxiliary variable replaced by its definition.
fn reframed_and_inlined(file: &File) -> Vec<(String, String)> {
    let frames: Vec<String> = file
        .items
        .iter()
        .filter_map(|item| match &item.kind {
            ItemKind::Frame(f) => Some(f.name.text.clone()),
            _ => None,
        })
        .collect();
    let mut out = Vec::new();
    for (index, item) in file.items.iter().enumerate() {
        match &item.kind {
            ItemKind::Load(load) => out.extend(frames.iter().map(|frame| {
                let mut changed = file.clone();
                let name = Name {
                    text: format!("in_{frame}"),
                    span: load.value.span,
                };
                if let Some(value) = value_of(&mut changed.items[index]) {
                    value.kind = ExprKind::Call(name, vec![value.clone()]);
                }
                (
                    format!("{} in {frame}", load.name.text),
                    changed.to_string(),
                )
            })),
            ItemKind::Let(named) => {
                let mut changed = file.clone();
                for other in &mut changed.items {
                    let Some(value) = value_of(other) else {
                        continue;
                    };
                    for n in (0..value.nodes().count()).rev() {
                        replace(value, n, &mut |e| match &e.kind {
                            ExprKind::Name(name) if *name == named.name.text => {
                                Some(named.value.clone())
                            }
                            _ => None,
                        });
                    }
                }
                out.push((format!("{} put in", named.name.text), changed.to_string()));
            }
            _ => {}
        }
    }
    out
}

#[test]
fn rewritings_are_the_same_function() {
    let (mut made, mut exact) = (0, 0);
    let mut faults = Vec::new();
    for (name, _) in MODELS {
        let loaded = built_in(name);
        let original = loaded.model.as_ref().unwrap();
        let mut all = renamed(&loaded.file);
        all.extend(reordered(&loaded.file));
        all.extend(reframed_and_inlined(&loaded.file));
        // One in several, so that the test ends in seconds.
        all.extend(factored(&loaded.file).into_iter().step_by(9));
        for (what, text) in all {
            let Some(rewritten) = model(&text) else {
                continue;
            };
            if text == loaded.file.to_string() {
                continue;
            }
            made += 1;
            let difference = compare(original, &rewritten);
            let rows = &difference.rows;
            exact += usize::from(rows.iter().all(|r| r.sameness == Some(Sameness::Same)));
            if difference.is_changed() || !difference.statements.iter().all(|s| quiet(s.change)) {
                faults.push(format!("{name}: {what}\n{}", difference.text()));
            }
        }
    }
    assert!(
        faults.is_empty(),
        "{} of {made}\n{}",
        faults.len(),
        faults.join("\n")
    );
    assert!(made >= 200, "{made} rewritings");
    println!("{made} rewritings, {exact} decided exactly");
    assert_eq!(exact, made);
}

/// Whether a change of a statement is of another kind than `Changed`, which means that it computes another function.
fn quiet(change: Change) -> bool {
    !matches!(change, Change::Changed)
}

/// For each state of `a`, whether its derivative differs between two models. The derivatives are computed by the
/// reference simulator, which shares no code with the compiler. `None` if they cannot be computed.
fn changed_rows(a: &Model, b: &Model) -> Option<Vec<bool>> {
    let mut random = Random::new(5, "mutants");
    let mut changed = vec![false; a.states.len()];
    for _ in 0..8 {
        let here = sample::point(a, &mut random);
        let (x, y) = (derivatives(a, &here).ok()?, derivatives(b, &here).ok()?);
        for (changed, (x, y)) in changed.iter_mut().zip(x.iter().zip(&y)) {
            let difference = (x - y).abs();
            *changed |= difference.is_nan() || difference > 1e-7 * (x.abs() + y.abs()) + 1e-9;
        }
    }
    Some(changed)
}

#[test]
fn the_derivatives_that_a_mutant_changes_are_named_with_the_statement() {
    let (mut made, mut named) = (0, 0);
    let mut faults = Vec::new();
    for (name, _) in MODELS {
        let loaded = built_in(name);
        let original = loaded.model.as_ref().unwrap();
        for mutant in mutants(&loaded.file, &loaded.sources).iter().step_by(5) {
            let checked = model_spec::check(&mutant.file, &loaded.sources);
            let Some(other) = checked.model.filter(|_| checked.diagnostics.is_empty()) else {
                continue;
            };
            let names = |model: &Model| -> Vec<String> {
                model.states.iter().map(|s| s.name.clone()).collect()
            };
            // The truth is by position: the same states, in one order.
            if names(original) != names(&other)
                || Point::defaults(original) != Point::defaults(&other)
            {
                continue;
            }
            let Some(truth) = changed_rows(original, &other) else {
                continue;
            };
            made += 1;
            let difference = compare(original, &other);
            let wrong = truth
                .iter()
                .zip(&difference.rows)
                .any(|(truth, row)| *truth != row.is_changed());
            let place = mutant.place.as_str();
            let place = ["body", "observe", "marker", "limit"]
                .into_iter()
                .find(|class| place.starts_with(class))
                .unwrap_or(place.trim_start_matches("declaration of "));
            let blamed = |d: &Difference| {
                let changed = d.rows.iter().filter(|row| row.is_changed());
                changed
                    .flat_map(|row| &row.causes)
                    .any(|cause| cause.starts_with(place))
            };
            let silent = truth.contains(&true) && !blamed(&difference);
            if wrong || silent {
                faults.push(format!(
                    "{name}: {}: {} {truth:?}\n{}",
                    mutant.place,
                    mutant.change,
                    difference.text()
                ));
            }
            named += usize::from(truth.contains(&true));
        }
    }
    println!("{made} mutants, {named} change a derivative");
    let first: String = faults.iter().take(5).cloned().collect();
    assert!(faults.is_empty(), "{} of {made}\n{first}", faults.len());
    assert!(named >= 200, "{named} mutants");
}

#[test]
fn functions_that_are_equal_and_not_as_symbols_agree_in_numbers() {
    let text = |law: &str| {
        format!(
            "model decay; param h = 2 m; frame N; state z = 1 m; state v = 0 m/s; der(z) = v;
             der(v) = {law}*1 [m/s^2];"
        )
    };
    let (a, b) = (text("exp(z/h + 1)"), text("exp(z/h)*exp(1)"));
    let difference = compare(&model(&a).unwrap(), &model(&b).unwrap());
    assert!(!difference.is_changed(), "{}", difference.text());
    assert_eq!(difference.rows[1].sameness, Some(Sameness::Agrees));
    assert!(difference.sentence().contains("not decided exactly"));
}

fn end(flown: &Flown) -> &End {
    match flown {
        Flown::End(end) => end,
        Flown::Failed(why) => panic!("{why}"),
    }
}

#[test]
fn what_is_added_is_named_as_the_cause() {
    let disc = built_in("disc").sources[0].text.clone();
    let own = disc.clone() + "coefficient C_Y = 0 s; force side = q*A*C_Y*r*d2;";
    let (old, new) = (model(&disc).unwrap(), model(&own).unwrap());
    let difference = compare(&old, &new);
    let changed = difference.changed_rows();
    assert_eq!(
        changed,
        ["der(u)", "der(v)", "der(w)"]
            .map(|r| r)
            .into_iter()
            .filter(|r| changed.contains(r))
            .collect::<Vec<_>>()
    );
    assert!(changed.contains(&"der(v)"), "{}", difference.text());
    for row in difference.rows.iter().filter(|row| row.is_changed()) {
        assert!(
            row.causes.iter().any(|c| c == "force side added"),
            "{row:?}"
        );
    }
    let operations = operations(&old, &new);
    assert!(operations["f"].new > operations["f"].old);
    assert!(operations["f_jac_par"].new > operations["f_jac_par"].old);
    // Its default value is 0: a named release flies as before.
    let same = landing("backhand", &old, &new).unwrap();
    let (a, b) = (end(&same.old), end(&same.new));
    assert_eq!(a.reason, b.reason);
    assert!(
        ["x", "y", "z"]
            .map(|axis| a.state[axis] - b.state[axis])
            .iter()
            .all(|d| d.abs() < 1e-8)
    );

    let moved = disc.replace("C_D0 + C_Da*alpha^2", "C_D0 + 2*C_Da*alpha^2");
    let moved = model(&moved).unwrap();
    let mut difference = compare(&old, &moved);
    let by = &difference
        .rows
        .iter()
        .find(|r| r.row == "der(u)")
        .unwrap()
        .causes;
    assert!(
        by[0].contains("`2*C_Da*alpha^2` instead of `C_Da*alpha^2`"),
        "{by:?}"
    );
    let other = landing("backhand", &old, &moved).unwrap();
    let (a, b) = (end(&other.old).clone(), end(&other.new).clone());
    assert!((a.state["x"] - b.state["x"]).abs() > 1e-4, "{other:?}");
    difference.landings.push(other);
    let text = difference.text();
    let end = format!("+ {:.6} s, {}: x = {:.6}", b.time_s, b.reason, b.state["x"]);
    assert!(text.contains(&end), "{text}");
}

#[test]
fn a_release_that_one_model_cannot_fly_is_an_error_that_names_the_model() {
    let disc = model(&built_in("disc").sources[0].text).unwrap();
    let ball = model(&built_in("ball").sources[0].text).unwrap();
    let error = landing("backhand", &disc, &ball).unwrap_err().to_string();
    assert!(error.starts_with("the new model"), "{error}");
    let error = landing("backhand", &ball, &disc).unwrap_err().to_string();
    assert!(error.starts_with("the old model"), "{error}");
    let error = landing("absent.toml", &disc, &disc).unwrap_err();
    let cause = std::error::Error::source(&error).expect("a cause");
    assert!(cause.to_string().contains("absent.toml"), "{cause}");
}

#[test]
fn another_name_of_a_parameter_is_another_function() {
    let disc = built_in("disc").sources[0].text.clone();
    let renamed = model(&disc.replace("C_L0", "C_L_0")).unwrap();
    let difference = compare(&model(&disc).unwrap(), &renamed);
    let row = difference.rows.iter().find(|row| row.row == "der(u)");
    let row = row.unwrap();
    assert!(row.is_changed(), "{row:?}");
    assert!(row.causes.contains(&"C_L0 removed".into()), "{row:?}");
    assert!(row.causes.contains(&"C_L_0 added".into()), "{row:?}");
}

#[test]
fn a_stated_value_or_unit_is_said_and_is_no_other_function() {
    let ball = built_in("ball").sources[0].text.clone();
    let heavy = ball.replace("param m = 0.0027 kg", "param m = 2.8 g");
    let difference = compare(&model(&ball).unwrap(), &model(&heavy).unwrap());
    assert!(!difference.is_changed());
    let [statement] = &difference.statements[..] else {
        panic!("{}", difference.text());
    };
    assert_eq!(statement.change, Change::Restated);
    assert_eq!(statement.what, "m");
    assert!(
        statement.new.as_ref().unwrap().contains("2.8 g"),
        "{statement:?}"
    );
}

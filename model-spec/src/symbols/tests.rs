use super::{Symbols, WordKind};
use crate::read::{BODIES, EFFECTS, MODELS, REFUTED};

/// Words of a text with what they are, those of the language left out.
fn shown(text: &str) -> String {
    let symbols = Symbols::of(text);
    let words = symbols.words.iter().filter_map(|word| {
        let text = &text[word.range.clone()];
        let noun = |own: usize| symbols.declarations[own].kind.noun();
        Some(match word.kind {
            WordKind::Keyword | WordKind::BuiltIn => return None,
            WordKind::Unit => format!("{text}=unit"),
            WordKind::Declaration(own) => format!("+{text}={}", noun(own)),
            WordKind::Reference(own) => format!("{text}={}", noun(own)),
            WordKind::Unknown => format!("?{text}"),
        })
    });
    words.collect::<Vec<_>>().join(" ")
}

#[test]
fn words_are_what_they_are() {
    let cases = [
        (
            "param m = 2 kg*m; let a = m*m + 3 m;",
            "+m=parameter kg=unit m=unit +a=quantity m=parameter m=parameter m=unit",
        ),
        (
            "param d = 1 m; param A = pi*d^2/4;",
            "+d=parameter m=unit +A=parameter d=parameter",
        ),
        (
            "coefficient k = 0.3 /rad^2 in -1 .. 1; let a = 2*k;",
            "+k=coefficient rad=unit +a=quantity k=coefficient",
        ),
        (
            "state v = 1 m/s; solve rod { unknown T: N; m*der(v) = T; constraint v*T = 1 within 1 mm; T = 2; } let a = T;",
            "+v=state m=unit s=unit +rod=block of equations +T=unknown N=unit ?m v=state T=unknown v=state T=unknown mm=unit T=unknown +a=quantity T=unknown",
        ),
        (
            "solve { constraint = 2*T; unknown R: vector N in B; } frame B;",
            "?constraint ?T +R=unknown N=unit B=frame +B=frame",
        ),
        (
            "frame N; frame B = N turned φ about 1; let a = in_B(N.3)*φ̇;",
            "+N=frame +B=frame N=frame +φ=state +a=quantity B=frame N=frame φ=state",
        ),
        (
            "param i = 1 rad; frame N; frame B = N turned i about 1;",
            "+i=parameter rad=unit +N=frame +B=frame N=frame i=parameter",
        ),
        (
            "frame N; body b { position (x, y, z) in N; } let a = z;",
            "+N=frame +b=body +x=state +y=state +z=state N=frame +a=quantity z=state",
        ),
        (
            "input wind in N = (0, 0, 0) m/s; let a = wind_x*wind.2;",
            "+wind=input ?N m=unit s=unit +a=quantity wind=input wind=input",
        ),
        (
            "function f(a: vector m in N, b): N { let c = a; return c*b; } let c = f(c, 1);",
            "+f=function +a=argument m=unit ?N +b=argument N=unit +c=quantity a=argument c=quantity b=argument +c=quantity f=function c=quantity",
        ),
        (
            "let r[i] for i in 1..3 = i*2 m; let s = sum(i in 1..3, r[i]) + r_2;",
            "+r=quantity i=index +i=index i=index m=unit +s=quantity +i=index r=quantity i=index r=quantity",
        ),
        (
            "table t(V: m/s): kg = { 0: 1, 2 km/h: 3 } monotone; let a = t(b);",
            "+t=table +V=argument m=unit s=unit kg=unit km=unit h=unit +a=quantity t=table ?b",
        ),
        (
            "marker k in N; observe k = k; observe o = k;",
            "+k=marker ?N k=marker k=marker +o=observation k=marker",
        ),
        (
            "force a = b; moment a = c; effect e { replace force a = previous; needs vector V: m or c; }",
            "+a=force ?b +a=moment ?c +e=effect a=force +V=needed quantity m=unit ?c",
        ),
        (
            "let a = ((b; let c = a",
            "+a=quantity ?b +c=quantity a=quantity",
        ),
        (
            "let a = 1 in - b; let c = 1 ¿ a;",
            "+a=quantity in=unit ?b +c=quantity a=quantity",
        ),
    ];
    for (text, expected) in cases {
        assert_eq!(shown(text), expected, "{text}");
    }
}

#[test]
fn names_of_built_in_models_are_all_declared() {
    for (name, text) in [MODELS, BODIES, REFUTED].into_iter().flatten() {
        let symbols = Symbols::of(text);
        let unknown = symbols
            .words
            .iter()
            .filter(|word| word.kind == WordKind::Unknown);
        let unknown: Vec<&str> = unknown.map(|word| &text[word.range.clone()]).collect();
        assert!(unknown.is_empty(), "{name}: {unknown:?}");
    }
}

#[test]
fn words_are_in_order_and_inside_the_text() {
    for (name, text) in [MODELS, BODIES, EFFECTS].into_iter().flatten() {
        let symbols = Symbols::of(text);
        let pairs = symbols.words.iter().zip(symbols.words.iter().skip(1));
        for (word, next) in pairs {
            assert!(
                word.range.end <= next.range.start,
                "{name}: {word:?} {next:?}"
            );
        }
        for own in &symbols.declarations {
            assert!(
                text.get(own.statement.clone())
                    .is_some_and(|s| s.contains(&text[own.range.clone()]))
            );
        }
    }
}

#[test]
fn names_are_refused_that_would_mean_something_else() {
    let text = "param m = 1 kg; let a = m; function f(b) { return a*b; } frame A;";
    let symbols = Symbols::of(text);
    let refused = |name: &str| symbols.refusal(0, name).is_some();
    let cases = [
        ("mass_0", false),
        ("μ", false),
        ("A", false),
        ("a", true),
        ("b", true),
        ("pi", true),
        ("sin", true),
        ("2x", true),
        ("x y", true),
        ("", true),
        ("x;", true),
    ];
    for (name, expected) in cases {
        assert_eq!(refused(name), expected, "{name}");
    }
}

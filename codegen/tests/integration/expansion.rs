//! Models with functions, arrays and sums compute what the same models compute that are written out by hand.

use crate::support::{Random, point};
use codegen::tape_model::{At, Scratch, TapeFunction, TapeModel};
use model_spec::model::Model;
use std::fmt::Write;

/// Greatest distance of two results, in units in the last place.
const MAX_ULP: u64 = 4;

fn loaded(name: &str, text: &str) -> Model {
    model_spec::load::from_text(name, text, &[]).unwrap_or_else(|error| panic!("{text}\n{error}"))
}

/// f, its Jacobians by states and by parameters, and their sparsity, at one point.
struct Values {
    arrays: [Vec<f64>; 3],
    patterns: [Vec<(u32, u32)>; 2],
}

fn values(tape: &TapeModel, x: &[f64], p: &[f64]) -> Values {
    let prepared = &tape.prepare(p)[..];
    let at = At {
        t: 0.3,
        x,
        p,
        prepared,
    };
    let function: &TapeFunction = &tape.f_jac_par;
    let lens = function.lens();
    let mut arrays: [Vec<f64>; 3] = std::array::from_fn(|k| vec![0.0; lens[k]]);
    let [dx, j, jp] = &mut arrays;
    let scratch = &mut Scratch::default();
    function.eval(at, &[], scratch, &mut [dx, j, jp]);
    let patterns = ["j", "jp"].map(|name| function.pattern(name).to_vec());
    Values { arrays, patterns }
}

/// Distance in units in the last place of the larger of two numbers; of numbers below 1e-12, of that size.
fn ulps(a: f64, b: f64) -> u64 {
    let size = a.abs().max(b.abs()).max(1e-12);
    ((a - b).abs() / (size * f64::EPSILON)).ceil() as u64
}

/// Requires the same f, J and Jp of two texts at random points.
fn same(name: &str, one: &str, by_hand: &str) {
    let models = [one, by_hand].map(|text| loaded(name, text));
    let compiled = models.each_ref().map(codegen::compile);
    assert_eq!(
        compiled[0].layout.parameters, compiled[1].layout.parameters,
        "{name}"
    );
    assert_eq!(
        compiled[0].layout.states, compiled[1].layout.states,
        "{name}"
    );
    let tapes = compiled.each_ref().map(TapeModel::new);
    let mut random = Random(7);
    for _ in 0..20 {
        let (x, p) = point(&compiled[0], &mut random);
        let [a, b] = tapes.each_ref().map(|tape| values(tape, &x, &p));
        assert_eq!(a.patterns, b.patterns, "{name}");
        for (array, (a, b)) in a.arrays.iter().zip(&b.arrays).enumerate() {
            assert!(
                a.iter().any(|value| *value != 0.0),
                "{name}: all of {array} is 0"
            );
            for (k, (a, b)) in a.iter().zip(b).enumerate() {
                let apart = ulps(*a, *b);
                assert!(
                    apart <= MAX_ULP,
                    "{name}, {array}[{k}]: {a} and {b}, {apart} ulp\n{one}\n{by_hand}"
                );
            }
        }
    }
}

fn gallery(name: &str) -> String {
    let path = format!(
        "{}/../examples/gallery/{name}.hyz",
        env!("CARGO_MANIFEST_DIR")
    );
    std::fs::read_to_string(path).expect("a model of the gallery")
}

/// The text of a model without its functions and checks, and with each line of an array or sum replaced by `written`.
fn by_hand(text: &str, written: impl Fn(&str) -> Option<String>) -> String {
    let mut out = String::new();
    let mut is_in_function = false;
    for line in text.lines() {
        is_in_function |= line.starts_with("function");
        if is_in_function {
            is_in_function = !line.ends_with('}');
        } else if line.contains(" in 1..") {
            out += &written(line).unwrap_or_else(|| panic!("`{line}` is not written by hand"));
        } else if !line.starts_with("check") {
            out += line;
            out.push('\n');
        }
    }
    out
}

fn samara_by_hand(text: &str) -> String {
    let list = |of: &dyn Fn(usize) -> String| (1..=8).map(of).collect::<String>();
    let chords = [8, 11, 13, 14, 14, 13, 11, 7];
    by_hand(text, |line| {
        Some(if line.starts_with("param chord") {
            list(&|i| format!("param chord_{i} = {} mm;\n", chords[i - 1]))
        } else if line.starts_with("param r[") {
            list(&|i| format!("let r_{i} = ({i} - 0.5)/8*span;\n"))
        } else if line.starts_with("let place") {
            list(&|i| format!("let place_{i} = r_{i}*C.1 - sweep*C.2;\n"))
        } else if line.starts_with("let lift") {
            list(&|i| {
                format!(
                    "let v_{i} = air_velocity + angular_velocity × place_{i};\n\
                     let V_{i} = sqrt(v_{i}.2^2 + v_{i}.3^2);\n\
                     let lift_{i} = rho*chord_{i}*span/8*(C_T*ratio(v_{i}.2*v_{i}.3, norm((0, v_{i}.2, v_{i}.3) in C), 0)\
                     *((0, v_{i}.3, -v_{i}.2) in C) - (C_D0*norm((0, v_{i}.2, v_{i}.3) in C) \
                     + C_Dn*ratio(v_{i}.3^2, norm((0, v_{i}.2, v_{i}.3) in C), 0))/2*((0, v_{i}.2, v_{i}.3) in C));\n"
                )
            })
        } else if line.starts_with("force wing") {
            let terms: Vec<String> = (1..=8).map(|i| format!("lift_{i}")).collect();
            format!("force wing = {};\n", terms.join(" + "))
        } else if line.starts_with("moment wing") {
            let terms: Vec<String> = (1..=8).map(|i| format!("place_{i} × lift_{i}")).collect();
            format!("moment wing = {};\n", terms.join(" + "))
        } else {
            return None;
        })
    })
}

fn blades(of: &dyn Fn(usize, usize) -> String) -> String {
    let all = (1..=2).flat_map(|k| (1..=4).map(move |i| (k, i)));
    all.map(|(k, i)| of(k, i)).collect()
}

fn boomerang_by_hand(text: &str) -> String {
    let force = |k: usize, i: usize| {
        format!(
            "(rho/2*width*length/4*((C_L0*(v_{k}_{i}·(along_{k} × C.3))^2 - C_La*norm(v_{k}_{i})*v_{k}_{i}.3)*C.3 \
             - C_D*norm(v_{k}_{i})*v_{k}_{i}))"
        )
    };
    by_hand(text, |line| {
        Some(if line.starts_with("let along") {
            let [left, right] = [(1, "+"), (2, "-")].map(|(k, sign)| {
                format!("let along_{k} = -cos(half_angle)*C.1 {sign} sin(half_angle)*C.2;\n")
            });
            left + &right
        } else if line.starts_with("let place") {
            blades(&|k, i| {
                format!(
                    "let place_{k}_{i} = elbow*C.1 + {}*length*along_{k};\n\
                     let v_{k}_{i} = air_velocity + cross(angular_velocity, place_{k}_{i});\n",
                    (i as f64 - 0.5) / 4.0
                )
            })
        } else if line.starts_with("force blade") {
            blades(&|k, i| format!("force blade_{k}_{i} = {};\n", force(k, i)))
        } else if line.starts_with("moment blade") {
            blades(&|k, i| format!("moment blade_{k}_{i} = place_{k}_{i} × {};\n", force(k, i)))
        } else {
            return None;
        })
    })
}

fn taketombo_by_hand(text: &str) -> String {
    let pitches = [30, 22, 16, 12];
    let force = |k: usize, i: usize| {
        format!(
            "(-rho/2*(R*width/4)*(C_N*norm(a_{k}_{i})*(v_{k}_{i}·n_{k}_{i})*n_{k}_{i} + C_D*norm(a_{k}_{i})*a_{k}_{i}))"
        )
    };
    by_hand(text, |line| {
        Some(if line.starts_with("param pitch") {
            (1..=4)
                .map(|i| format!("param pitch_{i} = {} deg;\n", pitches[i - 1]))
                .collect()
        } else if line.starts_with("let side") {
            "let side_1 = C.1;\nlet side_2 = -C.1;\n".to_owned()
        } else if line.starts_with("let place") {
            blades(&|k, i| {
                format!(
                    "let place_{k}_{i} = above*C.3 + {}*R*side_{k};\n\
                     let v_{k}_{i} = air_velocity + angular_velocity × place_{k}_{i};\n\
                     let n_{k}_{i} = cos(pitch_{i})*C.3 - sin(pitch_{i})*(C.3 × side_{k});\n\
                     let a_{k}_{i} = v_{k}_{i} - (v_{k}_{i}·side_{k})*side_{k};\n",
                    (i as f64 - 0.5) / 4.0
                )
            })
        } else if line.starts_with("force blade") {
            blades(&|k, i| format!("force blade_{k}_{i} = {};\n", force(k, i)))
        } else if line.starts_with("moment blade") {
            blades(&|k, i| format!("moment blade_{k}_{i} = place_{k}_{i} × {};\n", force(k, i)))
        } else {
            return None;
        })
    })
}

#[test]
fn the_gallery_computes_what_is_written_by_hand() {
    for (name, by_hand) in [
        ("samara", samara_by_hand as fn(&str) -> String),
        ("boomerang", boomerang_by_hand),
        ("taketombo", taketombo_by_hand),
    ] {
        let text = gallery(name);
        assert!(text.lines().count() <= 60, "{name}");
        same(name, &text, &by_hand(&text));
    }
}

/// A random expression of pure numbers.
enum Tree {
    Name(String),
    Number(u32),
    Two(char, Box<Tree>, Box<Tree>),
    Of(&'static str, Box<Tree>),
    /// Call of the function with this number.
    Call(usize, Vec<Tree>),
}

fn pick(random: &mut Random, count: usize) -> usize {
    (((random.next() + 1.0) / 2.0 * count as f64) as usize).min(count - 1)
}

fn tree(random: &mut Random, names: &[&str], functions: usize, depth: usize) -> Tree {
    let inner = |random: &mut Random| Box::new(tree(random, names, functions, depth - 1));
    match pick(random, if depth == 0 { 2 } else { 7 }) {
        0 => Tree::Number(1 + pick(random, 4) as u32),
        1 => Tree::Name(names[pick(random, names.len())].to_owned()),
        2 | 3 => {
            let sign = ['+', '-', '*'][pick(random, 3)];
            Tree::Two(sign, inner(random), inner(random))
        }
        4 | 5 if functions > 0 => {
            let arguments = (0..2).map(|_| *inner(random)).collect();
            Tree::Call(pick(random, functions), arguments)
        }
        _ => Tree::Of(["sin", "cos", "tanh"][pick(random, 3)], inner(random)),
    }
}

/// `function f(a, b) { let u = …; return …; }`
struct Drawn {
    local: Tree,
    result: Tree,
}

impl Tree {
    /// The expression with calls, and with names replaced.
    fn text(&self, name: &dyn Fn(&str) -> String) -> String {
        match self {
            Tree::Name(own) => name(own),
            Tree::Number(own) => own.to_string(),
            Tree::Two(sign, a, b) => format!("({} {sign} {})", a.text(name), b.text(name)),
            Tree::Of(function, a) => format!("{function}({})", a.text(name)),
            Tree::Call(k, arguments) => {
                let arguments: Vec<String> = arguments.iter().map(|own| own.text(name)).collect();
                format!("f{k}({})", arguments.join(", "))
            }
        }
    }

    /// The expression with its functions written out, and with names replaced.
    fn by_hand(&self, functions: &[Drawn], name: &dyn Fn(&str) -> String) -> String {
        match self {
            Tree::Two(sign, a, b) => {
                format!(
                    "({} {sign} {})",
                    a.by_hand(functions, name),
                    b.by_hand(functions, name)
                )
            }
            Tree::Of(function, a) => format!("{function}({})", a.by_hand(functions, name)),
            Tree::Call(k, arguments) => {
                let own = arguments.iter().map(|own| own.by_hand(functions, name));
                let own: Vec<String> = own.collect();
                let parameter = |wanted: &str| match wanted {
                    "a" => Some(own[0].clone()),
                    "b" => Some(own[1].clone()),
                    _ => None,
                };
                let plain = |wanted: &str| parameter(wanted).unwrap_or_else(|| wanted.to_owned());
                let local = functions[*k].local.by_hand(functions, &plain);
                let inside = |wanted: &str| match wanted {
                    "u" => local.clone(),
                    _ => plain(wanted),
                };
                functions[*k].result.by_hand(functions, &inside)
            }
            _ => self.text(name),
        }
    }
}

/// Length of a text by hand, bytes, beyond which the model may have too many operations.
const MAX_HAND: usize = 10_000;

const HEAD: &str = "model drawn;\nparam m = 1 kg;\nparam k = 0.7;\nframe N;\n\
    point drawn { mass m; position (x, y, z) in N; velocity (vx, vy, vz) in N; }\n\
    let X = x/(1 m);\nlet Y = vy/(1 [m/s]);\n";

#[test]
fn random_functions_loops_and_sums_compute_what_is_written_by_hand() {
    let mut random = Random(46);
    let mut compared = 0;
    for case in 0..60 {
        let count = 1 + pick(&mut random, 3);
        let mut functions: Vec<Drawn> = Vec::new();
        for own in 0..count {
            let local = tree(&mut random, &["a", "b", "k"], own, 2);
            let result = tree(&mut random, &["a", "b", "u", "X"], own, 2);
            functions.push(Drawn { local, result });
        }
        let elements = 1 + pick(&mut random, 4);
        let element = tree(&mut random, &["X", "Y", "i", "k"], count, 2);
        let term = tree(&mut random, &["q[i]", "Y", "i"], count, 2);
        let as_is = |name: &str| name.to_owned();
        let mut text = HEAD.to_owned();
        for (k, own) in functions.iter().enumerate() {
            let (local, result) = (own.local.text(&as_is), own.result.text(&as_is));
            let _ = writeln!(
                text,
                "function f{k}(a, b) {{ let u = {local}; return {result}; }}"
            );
        }
        let range = format!("i in 1..{elements}");
        let _ = writeln!(
            text,
            "let q[i] for {range} = k + X*Y + {};",
            element.text(&as_is)
        );
        let sum = format!("sum({range}, q[i] + {})", term.text(&as_is));
        let _ = writeln!(
            text,
            "force drawn = (1 N)*({sum})*N.1 + (1 N)*q[1]*N.2 + m*(1 [m/s^2])*N.3;"
        );

        let mut hand = HEAD.to_owned();
        let mut terms = Vec::new();
        for i in 1..=elements {
            let number = |name: &str| match name {
                "i" => i.to_string(),
                "q[i]" => format!("q_{i}"),
                other => other.to_owned(),
            };
            let own = element.by_hand(&functions, &number);
            let _ = writeln!(hand, "let q_{i} = k + X*Y + {own};");
            terms.push(format!("q_{i} + {}", term.by_hand(&functions, &number)));
        }
        let sum = terms.join(" + ");
        let _ = writeln!(
            hand,
            "force drawn = (1 N)*({sum})*N.1 + (1 N)*q_1*N.2 + m*(1 [m/s^2])*N.3;"
        );
        if hand.len() < MAX_HAND {
            same(&format!("case {case}"), &text, &hand);
            compared += 1;
        }
    }
    assert!(compared >= 40, "{compared}");
}

/// Text of a wing with this number of elements.
fn wing(elements: usize) -> String {
    let text = gallery("boomerang");
    text.replace("i in 1..4", &format!("i in 1..{}", elements / 2))
        .replace("/4*length", &format!("/{}*length", elements / 2))
        .replace("length/4", &format!("length/{}", elements / 2))
}

#[test]
fn forty_blade_elements_compile_in_seconds() {
    let start = std::time::Instant::now();
    let compiled = codegen::compile(&loaded("wing", &wing(40)));
    let took = start.elapsed();
    assert_eq!(compiled.layout.states.len(), 13);
    // 0.5 s where nothing else runs; tests share the processor, and are compiled with little optimisation.
    assert!(took.as_secs_f64() < 20.0, "{took:?}");
}

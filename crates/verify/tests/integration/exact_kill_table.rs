//! Kill table of the exact check of f, J and Jp: of seeded mutants of the compiled programs, every one that changes a value
//! is refuted by this check alone.

use crate::support::{QUICK, TOP, built_in, results};
use codegen::Compiled;
use codegen::program::{Binary, Function, Fused, Op, Operand, Program, Unary};
use model_spec::load::{MODELS, from_text};
use model_spec::model::Model;
use std::time::Instant;
use verify::checks::exact_functions::check;
use verify::random::Random;
use verify::report::Verdict;
use verify::sample;

/// Minimum number of tested mutants per model that change a computed value.
const MUTANTS: usize = 400;

/// Mutation operators for compiled programs; each returns a description of the mutation, or `None` if it is not
/// applicable.
const OPERATORS: [fn(&mut Program, &mut Random) -> Option<String>; 5] =
    [operand, sign, constant, dropped_term, output];

/// Text of a test model of a gliding body in a vertical plane, with explicitly written equations, air density that
/// decreases with height, and stall.
const GLIDER: &str = "model glider;
param m = 3 g;
param S = 0.017 m^2;
param rho_0 = 1.225 kg/m^3;
param H = 8500 m;
param g = 9.81 m/s^2;
coefficient C_L = 0.6 [1] in 0 .. 3;
coefficient C_D = 0.1 [1] in 0 .. 3;
frame N;
state gamma = 0 rad;
state V = 4 m/s;
state z = 10 m;
state alpha = 0.1 rad;
limit V > 0.3 m/s \"it hangs in the air\";
let rho = rho_0*exp(-z/H);
let stall = asin(alpha/(3 rad))/(1 rad);
let pressure_force = rho*V^2/2*S;
der(V) = -pressure_force*(C_D + stall^2/10)/m - g*sin(gamma);
der(gamma) = (pressure_force*C_L*stall/(m*V) - g*cos(gamma)/V)*1 rad;
der(z) = V*sin(gamma);
der(alpha) = (atan2(sin(gamma), 2 + cos(alpha)) - alpha)*1 [1/s];
";

/// Text of a test model of a mass on a spring that can go slack, with a brake of limited force. It contains branches,
/// which the check over the prime field cannot decide.
const SLACK: &str = "model slack;
param m = 0.2 kg;
param h = 2 m;
param k = 3 N/m;
param g = 9.81 m/s^2;
coefficient c = 0.3 kg/s in 0 .. 3;
coefficient F_max = 0.7 N in 0 .. 3;
frame N;
state z = 1 m;
state v = 0.5 m/s;
der(z) = v;
der(v) = (k*max(h - z, 0.1*h) + min(c*abs(v), F_max)*sign(-v))/m - g;
";

/// Index of a random statement of a compiled program; `None` if the program has no statements.
fn any(program: &Program, random: &mut Random) -> Option<usize> {
    let count = program.statements.len() as u64;
    (count > 0).then(|| (random.next() % count) as usize)
}

/// Mutation: replaces an operand of a random statement of the compiled program by another input, constant or earlier
/// result that the program uses.
fn operand(program: &mut Program, random: &mut Random) -> Option<String> {
    let k = any(program, random)?;
    let mut known: Vec<Operand> = Vec::new();
    for statement in &program.statements {
        for operand in statement.op.operands() {
            let is_earlier = !matches!(operand, Operand::Temp(t) if t as usize >= k);
            if is_earlier && !known.contains(&operand) {
                known.push(operand);
            }
        }
    }
    let other = known[(random.next() % known.len() as u64) as usize];
    let count = program.statements[k].op.operands().len() as u64;
    let (place, mut at) = (random.next() % count, 0);
    let before = program.statements[k].op;
    program.statements[k].op.for_operands(|operand| {
        if at == place {
            *operand = other;
        }
        at += 1;
    });
    Some(format!("{k}: {before:?} reads {other:?}"))
}

/// Mutation: changes a sign in a random statement of the compiled program, such as that of a term or factor.
fn sign(program: &mut Program, random: &mut Random) -> Option<String> {
    let k = any(program, random)?;
    let before = program.statements[k].op;
    program.statements[k].op = match before {
        Op::Unary(Unary::Neg, a) => Op::Binary(Binary::Add, a, Operand::Constant(0.0)),
        Op::Unary(_, a) => Op::Unary(Unary::Neg, a),
        Op::Binary(Binary::Add, a, b) => Op::Binary(Binary::Sub, a, b),
        Op::Binary(Binary::Sub, a, b) if random.once_in(2) => Op::Binary(Binary::Sub, b, a),
        Op::Binary(Binary::Sub, a, b) => Op::Binary(Binary::Add, a, b),
        Op::Binary(Binary::Mul, a, b) => Op::Fused(Fused::NegMulAdd, a, b, Operand::Constant(0.0)),
        Op::Binary(op, a, b) => Op::Binary(op, b, a),
        Op::Fused(Fused::MulAdd, a, b, c) if random.once_in(2) => Op::Fused(Fused::MulSub, a, b, c),
        Op::Fused(Fused::MulAdd, a, b, c) => Op::Fused(Fused::NegMulAdd, a, b, c),
        Op::Fused(_, a, b, c) => Op::Fused(Fused::MulAdd, a, b, c),
        Op::IfZero(a, then, otherwise) => Op::IfZero(a, otherwise, then),
    };
    Some(format!("{k}: {before:?} as {:?}", program.statements[k].op))
}

/// Mutation: changes a constant of the compiled program in its ninth digit, by 1, or in sign.
fn constant(program: &mut Program, random: &mut Random) -> Option<String> {
    let has = |statement: &codegen::program::Statement| {
        let operands = statement.op.operands();
        operands.iter().any(|o| matches!(o, Operand::Constant(_)))
    };
    let with: Vec<usize> = (0..program.statements.len())
        .filter(|&k| has(&program.statements[k]))
        .collect();
    let count = with.len() as u64;
    let k = *with.get(random.next().checked_rem(count)? as usize)?;
    let before = program.statements[k].op;
    let how = random.next() % 3;
    program.statements[k].op.for_operands(|operand| {
        if let Operand::Constant(c) = operand {
            *c = match how {
                // A decimal number: its digits are the number that the field has.
                0 => format!("{:.8e}", *c * (1.0 + 2e-8)).parse().unwrap_or(*c),
                1 => *c + 1.0,
                _ => -*c,
            };
        }
    });
    Some(format!("{k}: {before:?} as {:?}", program.statements[k].op))
}

/// Mutation: removes a term or a factor from a random statement of the compiled program.
fn dropped_term(program: &mut Program, random: &mut Random) -> Option<String> {
    let k = any(program, random)?;
    let before = program.statements[k].op;
    let same = |a| Op::Binary(Binary::Add, a, Operand::Constant(0.0));
    program.statements[k].op = match before {
        Op::Binary(Binary::Sub, _, b) if random.once_in(2) => Op::Unary(Unary::Neg, b),
        Op::Binary(Binary::Add | Binary::Sub | Binary::Mul | Binary::Div, a, _) => same(a),
        Op::Fused(_, _, _, c) if random.once_in(2) => same(c),
        Op::Fused(Fused::NegMulAdd, a, b, _) => {
            Op::Fused(Fused::NegMulAdd, a, b, Operand::Constant(0.0))
        }
        Op::Fused(_, a, b, _) => Op::Binary(Binary::Mul, a, b),
        Op::Unary(_, a) => same(a),
        _ => return None,
    };
    Some(format!("{k}: {before:?} as {:?}", program.statements[k].op))
}

/// Mutation: replaces an output of the compiled program by another of its outputs.
fn output(program: &mut Program, random: &mut Random) -> Option<String> {
    let count = program.outputs.len() as u64;
    let (a, b) = (
        random.next().checked_rem(count)? as usize,
        random.next().checked_rem(count)? as usize,
    );
    program.outputs[a] = program.outputs[b];
    Some(format!("result {a} is result {b}"))
}

/// Numbers of mutants made by one mutation operator: those that change a value, and those that a check refutes.
#[derive(Default)]
struct Kills {
    changed: usize,
    killed: usize,
}

/// Makes pseudorandom mutants of `prepare`, `f`, `f_jac` and `f_jac_par` of a model. Returns the counts by mutation
/// operator, and descriptions of the mutants that no check refutes.
fn table(model: &Model, seed: u64) -> ([Kills; OPERATORS.len()], Vec<String>) {
    let compiled = codegen::compile(model);
    let mut random = Random::new(seed, "seeded mutants of the code");
    let points: Vec<_> = (0..4).map(|_| sample::point(model, &mut random)).collect();
    let functions: [fn(&mut Compiled) -> &mut Function; 4] = [
        |c| &mut c.prepare,
        |c| &mut c.f,
        |c| &mut c.f_jac,
        |c| &mut c.f_jac_par,
    ];
    let all = |compiled: &Compiled| -> Vec<f64> {
        [&compiled.f, &compiled.f_jac, &compiled.f_jac_par]
            .iter()
            .flat_map(|function| results(compiled, function, &points))
            .collect()
    };
    let right = all(&compiled);
    let mut kills: [Kills; OPERATORS.len()] = Default::default();
    let mut survivors: Vec<String> = Vec::new();
    let mut trial = 0;
    while kills.iter().map(|k| k.changed).sum::<usize>() < MUTANTS {
        trial += 1;
        assert!(trial < 100 * MUTANTS, "{} has too few mutants", model.name);
        let mut mutant = compiled.clone();
        let function = functions[trial % functions.len()](&mut mutant);
        let operator = trial / functions.len() % OPERATORS.len();
        let Some(change) = OPERATORS[operator](&mut function.program, &mut random) else {
            continue;
        };
        let name = function.name;
        let wrong = all(&mutant);
        let differs = |(a, b): (&f64, &f64)| {
            let difference = (a - b).abs();
            difference.is_nan() || difference > 1e-9 * (a.abs() + b.abs()) + 1e-12
        };
        if !right.iter().zip(&wrong).any(differs) {
            continue;
        }
        kills[operator].changed += 1;
        let row = check(model, &mutant, &QUICK);
        if row.verdict == Verdict::Refuted {
            kills[operator].killed += 1;
        } else {
            survivors.push(format!(
                "{name}, {change}: {:?} {}",
                row.verdict, row.detail
            ));
        }
    }
    (kills, survivors)
}

#[test]
fn every_seeded_mutant_of_every_model_that_changes_a_value_is_refuted_by_this_check_alone() {
    let own = [("top", TOP), ("glider", GLIDER), ("slack", SLACK)];
    let own = own.map(|(name, text)| (name, from_text(name, text, &[]).unwrap()));
    let built_in = MODELS
        .iter()
        .map(|(name, _)| (*name, built_in(name).model.unwrap()));
    for (name, model) in built_in.chain(own) {
        let right = check(&model, &codegen::compile(&model), &QUICK);
        let by_the_field = if name == "slack" {
            Verdict::Skipped
        } else {
            Verdict::Holds
        };
        assert_eq!(right.verdict, by_the_field, "{name}: {right:?}");
        let (kills, survivors) = table(&model, 5);
        let each = kills.iter().map(|k| format!("{}/{}", k.killed, k.changed));
        println!("{name}: {}", each.collect::<Vec<_>>().join(" "));
        assert!(
            survivors.is_empty(),
            "{name}: {} survive\n{}",
            survivors.len(),
            survivors.join("\n")
        );
        // Operands, signs, dropped terms and results of every model; constants where it has any.
        for operator in [0, 1, 3, 4] {
            assert!(kills[operator].killed >= 10, "{name}: {operator}");
        }
    }
}

#[test]
fn the_check_of_all_models_takes_less_than_ten_seconds() {
    let models: Vec<Model> = MODELS
        .iter()
        .map(|(name, _)| built_in(name).model.unwrap())
        .collect();
    let compiled: Vec<Compiled> = models.iter().map(codegen::compile).collect();
    let start = Instant::now();
    for (model, compiled) in models.iter().zip(&compiled) {
        assert_eq!(check(model, compiled, &QUICK).verdict, Verdict::Holds);
    }
    let seconds = start.elapsed().as_secs_f64();
    println!("{seconds:.3} s for {} models", models.len());
    assert!(seconds < 10.0, "{seconds} s");
}

//! Steps of an evaluation: the instructions of a program before their values have registers, in an order with long runs
//! of one operation.
//!
//! An interpreter decides once for each run what it computes, so that it is faster the fewer the runs are. A step still
//! follows those that compute its operands, and no result depends on the order of the others.

use super::Opcode;
use crate::program::{Operand, Program};
use crate::schedule::pairs::{OperandKey, sin_cos_pairs};
use std::cmp::Reverse;
use std::collections::{BTreeMap, HashMap, VecDeque};

/// Index of a value: statements first, then inputs and constants.
pub(super) type Value = usize;

/// Instruction before register allocation: its operands and results are indices of values.
#[derive(Clone, Copy, Debug)]
pub(super) struct Step {
    pub(super) opcode: Opcode,
    /// Operands of the operation; if it has fewer than three, the first is repeated.
    pub(super) operands: [Value; 3],
    pub(super) result: Value,
    /// Second result, of an instruction that computes sine and cosine of one angle. `None` for all other instructions.
    pub(super) second: Option<Value>,
}

/// Program whose instructions are reordered so that many consecutive ones have the same operation code.
pub(super) struct Steps {
    pub(super) steps: Vec<Step>,
    /// Number of statements of the program, which is also the index of the first input among the values.
    pub(super) statements: usize,
    /// Inputs and constants that the program reads, in the order of their value indices.
    pub(super) inputs: Vec<Operand>,
    pub(super) outputs: Vec<Value>,
}

impl Steps {
    /// Translates the statements of a program to steps, ordered so that many consecutive ones have the same opcode.
    pub(super) fn new(program: &Program) -> Steps {
        let mut values = Values::new(program.statements.len());
        let steps = in_program_order(program, &mut values);
        let outputs = program.outputs.iter();
        let outputs = outputs.map(|&output| values.value(output)).collect();
        let order = order_in_runs(&steps, values.statements + values.inputs.len());
        Steps {
            steps: order.into_iter().map(|step| steps[step]).collect(),
            statements: values.statements,
            inputs: values.inputs,
            outputs,
        }
    }

    /// Number of values: results of statements, inputs and constants.
    pub(super) fn values(&self) -> usize {
        self.statements + self.inputs.len()
    }
}

/// Value indices assigned so far to the inputs and constants of a program.
struct Values {
    statements: usize,
    inputs: Vec<Operand>,
    found: HashMap<OperandKey, Value>,
}

impl Values {
    fn new(statements: usize) -> Values {
        Values {
            statements,
            inputs: Vec::new(),
            found: HashMap::new(),
        }
    }

    fn value(&mut self, operand: Operand) -> Value {
        if let Operand::Temp(statement) = operand {
            return statement as usize;
        }
        *self.found.entry(operand.into()).or_insert_with(|| {
            self.inputs.push(operand);
            self.statements + self.inputs.len() - 1
        })
    }
}

fn in_program_order(program: &Program, values: &mut Values) -> Vec<Step> {
    let pairs = sin_cos_pairs(program);
    let mut steps = Vec::with_capacity(program.statements.len());
    for (k, statement) in program.statements.iter().enumerate() {
        let mut operands = [None; 3];
        for (value, operand) in operands.iter_mut().zip(statement.op.operands()) {
            if let Operand::Temp(t) = operand {
                assert!(
                    (t as usize) < k,
                    "statement {k} reads the later statement {t}"
                );
            }
            *value = Some(values.value(operand));
        }
        let first = operands[0].expect("every operation has an operand");
        let (opcode, result, second) = match pairs.get(&k) {
            None => (statement.op.into(), k, None),
            Some(&(sin, cos)) if k == sin.min(cos) => (Opcode::SinCos, sin, Some(cos)),
            // The step of the earlier statement computes this one too.
            Some(_) => continue,
        };
        steps.push(Step {
            opcode,
            operands: operands.map(|value| value.unwrap_or(first)),
            result,
            second,
        });
    }
    steps
}

/// Steps in runs of one operation code: next the code that must be followed by most changes, as long as one is ready.
fn order_in_runs(steps: &[Step], values: usize) -> Vec<usize> {
    let readers = Readers::new(steps, values);
    let mut changes = vec![0_usize; steps.len()];
    let mut awaited = vec![0_usize; steps.len()];
    for (index, step) in steps.iter().enumerate().rev() {
        for reader in readers.of(step) {
            let change = usize::from(steps[reader].opcode != step.opcode);
            changes[index] = changes[index].max(changes[reader] + change);
            awaited[reader] += 1;
        }
    }
    let mut ready: BTreeMap<Opcode, Ready> = BTreeMap::new();
    for (index, step) in steps.iter().enumerate() {
        if awaited[index] == 0 {
            let ready = ready.entry(step.opcode).or_default();
            ready.push(index, changes[index]);
        }
    }
    let mut order = Vec::with_capacity(steps.len());
    while let Some(opcode) = next(&ready) {
        while let Some(step) = ready.get_mut(&opcode).and_then(Ready::pop) {
            order.push(step);
            for reader in readers.of(&steps[step]) {
                awaited[reader] -= 1;
                if awaited[reader] == 0 {
                    let ready = ready.entry(steps[reader].opcode).or_default();
                    ready.push(reader, changes[reader]);
                }
            }
        }
    }
    order
}

/// For each value, the steps that read it, listed once per operand that reads it.
struct Readers {
    steps: Vec<usize>,
    /// For each value, the position of its first reader in the list `steps`; the last entry is the length of that list.
    starts: Vec<usize>,
}

impl Readers {
    fn new(steps: &[Step], values: usize) -> Readers {
        let mut starts = vec![0; values + 1];
        for &operand in steps.iter().flat_map(|step| &step.operands) {
            starts[operand + 1] += 1;
        }
        for value in 0..values {
            starts[value + 1] += starts[value];
        }
        let mut next = starts.clone();
        let mut readers = vec![0; 3 * steps.len()];
        for (index, step) in steps.iter().enumerate() {
            for &operand in &step.operands {
                readers[next[operand]] = index;
                next[operand] += 1;
            }
        }
        Readers {
            steps: readers,
            starts,
        }
    }

    /// Indices of the steps that read a result of the given step, once per operand that reads it.
    fn of(&self, step: &Step) -> impl Iterator<Item = usize> {
        let results = std::iter::once(step.result).chain(step.second);
        results.flat_map(|value| {
            let of_value = self.starts[value]..self.starts[value + 1];
            self.steps[of_value].iter().copied()
        })
    }
}

/// Steps with one operation code that are ready, in the order in which they became ready.
#[derive(Default)]
struct Ready {
    steps: VecDeque<usize>,
    /// Most changes of operation code that must follow one of the steps.
    changes: usize,
}

impl Ready {
    fn push(&mut self, step: usize, changes: usize) {
        self.steps.push_back(step);
        self.changes = self.changes.max(changes);
    }

    fn pop(&mut self) -> Option<usize> {
        let step = self.steps.pop_front();
        if step.is_none() {
            self.changes = 0;
        }
        step
    }
}

/// Operation code that must be followed by most changes, then that of most steps.
fn next(ready: &BTreeMap<Opcode, Ready>) -> Option<Opcode> {
    let any = ready.iter().filter(|(_, ready)| !ready.steps.is_empty());
    let next =
        any.max_by_key(|&(&opcode, ready)| (ready.changes, ready.steps.len(), Reverse(opcode)));
    next.map(|(&opcode, _)| opcode)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn runs(steps: &[Step]) -> usize {
        steps.chunk_by(|a, b| a.opcode == b.opcode).count()
    }

    #[test]
    fn steps_of_models_follow_their_operands_in_a_third_of_the_runs() {
        for body in ["disc", "golf_driver", "table_tennis_ball"] {
            let model = model_spec::load::load(body, &[]).expect("the model");
            let function = crate::compile(&model).f_jac_par;
            let mut values = Values::new(function.program.statements.len());
            let before = in_program_order(&function.program, &mut values);
            let Steps {
                steps, statements, ..
            } = Steps::new(&function.program);
            let mut known = vec![false; statements];
            for step in &steps {
                let results = step.operands.iter().filter(|&&value| value < statements);
                assert!(results.into_iter().all(|&value| known[value]), "{body}");
                known[step.result] = true;
                step.second.inspect(|&second| known[second] = true);
            }
            assert!(known.iter().all(|&known| known), "{body}");
            assert!(
                3 * runs(&steps) <= runs(&before),
                "{body}: {} runs",
                runs(&steps)
            );
        }
    }
}

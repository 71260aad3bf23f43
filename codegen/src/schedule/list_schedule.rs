//! List scheduling: statement order for a superscalar processor with few registers.

use super::contract_fma::latency;
use crate::program::{Operand, Program, Statement};
use crate::schedule::pairs::sin_cos_pairs;
use std::cmp::Reverse;
use std::collections::HashMap;

/// Issue width of the processor model: maximum number of operations started per clock cycle.
const WIDTH: u32 = 2;

/// From this many live values, statements that free registers are issued first.
const LIVE_VALUES_LIMIT: usize = 20;

pub(super) fn list_schedule(program: Program) -> Program {
    let sequence = Order::new(&program).sequence();
    permuted(program, &sequence)
}

struct Order<'a> {
    program: &'a Program,
    /// For each statement, the indices of the statements whose results it reads.
    needs: Vec<Vec<usize>>,
    users: Vec<Vec<usize>>,
    /// Latency of the longest path from each statement to a result, in clock cycles.
    height: Vec<u32>,
    /// Clock cycle in which the operands are available; `None` while unknown, and once issued.
    ready: Vec<Option<u32>>,
    /// Statements to be issued whose clock cycle is known.
    waiting: Vec<usize>,
    /// For each statement of such a pair, the sine and cosine of one angle.
    pairs: HashMap<usize, (usize, usize)>,
    end: Vec<u32>,
    /// Number of pending uses of each statement's result.
    left: Vec<usize>,
    /// Decrease in the number of live results if a statement is issued; negative for an increase.
    freed: Vec<i64>,
    /// Number of live results: those that are computed and still have pending uses.
    live: usize,
}

impl<'a> Order<'a> {
    fn new(program: &'a Program) -> Order<'a> {
        let n = program.statements.len();
        let needs: Vec<Vec<usize>> = program.statements.iter().map(temps).collect();
        let mut users = vec![Vec::new(); n];
        for (k, needs) in needs.iter().enumerate() {
            for &need in needs {
                users[need].push(k);
            }
        }
        let mut height = vec![0; n];
        for k in (0..n).rev() {
            let above = users[k].iter().map(|&user| height[user]).max();
            height[k] = latency(&program.statements[k].op) + above.unwrap_or(0);
        }
        let freed = |k: usize| {
            let last = needs[k].iter().filter(|&&need| users[need].len() == 1);
            last.count() as i64 - i64::from(!users[k].is_empty())
        };
        Order {
            pairs: sin_cos_pairs(program),
            freed: (0..n).map(freed).collect(),
            program,
            ready: needs.iter().map(|n| n.is_empty().then_some(0)).collect(),
            waiting: (0..n).filter(|&k| needs[k].is_empty()).collect(),
            left: users.iter().map(Vec::len).collect(),
            end: vec![0; n],
            live: 0,
            needs,
            users,
            height,
        }
    }

    fn sequence(mut self) -> Vec<usize> {
        let mut sequence = Vec::with_capacity(self.needs.len());
        let (mut time, mut started) = (0, 0);
        while sequence.len() < self.needs.len() {
            let Some(next) = self.next(time) else {
                let known = self.waiting.iter().filter_map(|&k| self.ready[k]);
                time = known.min().unwrap_or(time);
                started = 0;
                continue;
            };
            for k in [Some(next), self.partner(next)].into_iter().flatten() {
                self.start(k, time);
                sequence.push(k);
            }
            started += 1;
            if started == WIDTH {
                (time, started) = (time + 1, 0);
            }
        }
        sequence
    }

    fn next(&self, time: u32) -> Option<usize> {
        let waiting = self.waiting.iter();
        let waiting = waiting.filter_map(|&k| Some((k, self.ready[k]? <= time)));
        if self.live >= LIVE_VALUES_LIMIT {
            let rank = |k: usize, now| (self.freed[k], now, self.height[k], Reverse(k));
            return waiting.max_by_key(|&(k, now)| rank(k, now)).map(|(k, _)| k);
        }
        let can = waiting.filter(|&(_, now)| now).map(|(k, _)| k);
        can.max_by_key(|&k| (self.height[k], self.freed[k], Reverse(k)))
    }

    /// Statement of the same sine and cosine pair, if it can be issued.
    fn partner(&self, k: usize) -> Option<usize> {
        let &(sin, cos) = self.pairs.get(&k)?;
        let partner = if k == sin { cos } else { sin };
        self.ready[partner].map(|_| partner)
    }

    fn start(&mut self, k: usize, time: u32) {
        self.ready[k] = None;
        if let Some(at) = self.waiting.iter().position(|&other| other == k) {
            self.waiting.swap_remove(at);
        }
        self.end[k] = time + latency(&self.program.statements[k].op);
        for &need in &self.needs[k] {
            self.left[need] -= 1;
            if self.left[need] == 1 {
                self.users[need]
                    .iter()
                    .for_each(|&user| self.freed[user] += 1);
            }
            self.live -= usize::from(self.left[need] == 0);
        }
        self.live += usize::from(!self.users[k].is_empty());
        for user in self.users[k].clone() {
            let mut ends = 0;
            let known = self.needs[user].iter().all(|&need| {
                ends = ends.max(self.end[need]);
                self.end[need] > 0
            });
            if known {
                self.ready[user] = Some(ends);
                self.waiting.push(user);
            }
        }
    }
}

/// Indices of the statements whose results a statement reads, without duplicates.
fn temps(statement: &Statement) -> Vec<usize> {
    let operands = statement.op.operands().into_iter();
    let mut temps: Vec<usize> = operands.filter_map(Operand::temp).collect();
    temps.sort_unstable();
    temps.dedup();
    temps
}

/// Returns the program with its statements in the order `sequence` and its operands renumbered.
fn permuted(mut program: Program, sequence: &[usize]) -> Program {
    let mut places = vec![0; sequence.len()];
    for (place, &k) in sequence.iter().enumerate() {
        places[k] = place as u32;
    }
    let mut statements: Vec<Option<Statement>> = program.statements.into_iter().map(Some).collect();
    program.statements = sequence
        .iter()
        .filter_map(|&k| statements[k].take())
        .collect();
    program.renumber(&places);
    program
}

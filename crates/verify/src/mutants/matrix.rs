//! Mutation matrix: number of mutants by mutation operator and by the checks that kill them.

use super::status::{ALWAYS, CHECKS, MutantStatus};
use super::{Mutant, Operator};
use crate::row::{Row, plain_table};
use serde::Serialize;

/// Numbers of mutants that the checks kill, and mutants that no check kills.
#[derive(Clone, Debug, Default, Serialize)]
pub struct MutationMatrix {
    /// Names of the checks, in ascending order of effort.
    pub checks: Vec<&'static str>,
    /// Counts of mutants, one row of the matrix per mutation operator.
    pub rows: Vec<MutationRow>,
    /// Mutants that no check kills, although the reference implementation contains all terms.
    pub survivors: Vec<String>,
    /// Mutants that no check kills, for a model without a reference or with terms that it lacks.
    #[serde(rename = "unwatched")]
    pub not_covered: Vec<String>,
    /// Mutants proved equivalent to the model, with the kind of proof.
    pub equivalent: Vec<(String, &'static str)>,
}

/// Counts of the mutants made by one mutation operator.
#[derive(Clone, Debug, Default, Serialize)]
pub struct MutationRow {
    /// Name of the mutation operator, such as `sign flipped`.
    pub operator: &'static str,
    /// Number of mutants, without equivalent ones and those not covered.
    pub mutants: usize,
    /// Number of the operator's mutants that at least one check refutes.
    pub killed: usize,
    /// For each check, the number of mutants that it is the first to kill.
    pub first: Vec<usize>,
    /// For each check, the number of mutants that it kills.
    pub noticed: Vec<usize>,
}

impl MutationMatrix {
    /// Counts the mutants by operator and check.
    pub fn of(mutants: &[Mutant], statuses: &[MutantStatus]) -> Self {
        let kills = |check: usize| {
            let mut statuses = statuses.iter();
            statuses.any(|s| matches!(s, MutantStatus::Killed(by) if by.contains(&check)))
        };
        // The last checks apply only to models with claims.
        let last = (ALWAYS..CHECKS.len()).rev().find(|check| kills(*check));
        let count = last.map_or(ALWAYS, |check| check + 1);
        let mut table = Self {
            checks: CHECKS[..count].to_vec(),
            ..Self::default()
        };
        for (operator, name) in Operator::ALL {
            let mut row = MutationRow {
                operator: name,
                first: vec![0; count],
                noticed: vec![0; count],
                ..MutationRow::default()
            };
            let own = mutants.iter().zip(statuses);
            for (mutant, fate) in own.filter(|(m, _)| m.operator == operator) {
                let mutant = || format!("{}: {}", mutant.place, mutant.change);
                match fate {
                    MutantStatus::Equivalent(reason) => {
                        table.equivalent.push((mutant(), reason));
                        continue;
                    }
                    MutantStatus::NotCovered => {
                        table.not_covered.push(mutant());
                        continue;
                    }
                    MutantStatus::Survived => table.survivors.push(mutant()),
                    MutantStatus::Killed(by) => {
                        row.killed += 1;
                        row.first[by[0]] += 1;
                        by.iter().for_each(|&check| row.noticed[check] += 1);
                    }
                }
                row.mutants += 1;
            }
            table.rows.push(row);
        }
        table
    }

    /// Number of mutants, without equivalent ones and those not covered.
    pub fn mutants(&self) -> usize {
        self.rows.iter().map(|row| row.mutants).sum()
    }

    /// Total number of mutants that at least one check refutes.
    pub fn killed(&self) -> usize {
        self.rows.iter().map(|row| row.killed).sum()
    }

    /// Row of a report; it holds if no mutant survives.
    pub fn row(&self) -> Row {
        let (mutants, killed, same) = (self.mutants(), self.killed(), self.equivalent.len());
        let not_covered = match self.not_covered.len() {
            0 => String::new(),
            n => format!("; {n} not covered by the reference"),
        };
        let says = format!("{killed} of {mutants} killed; {same} more are equivalent{not_covered}");
        Row::counted("mutants", mutants, &self.survivors, "").with_detail(says)
    }

    /// Text of the matrix; cells `first/all`: killed by this check first, and killed by it.
    pub fn table(&self) -> String {
        let mut header = vec!["mutation operator", "mutants", "killed"];
        header.extend(&self.checks);
        let mut table = plain_table(&header);
        let sums = |pick: fn(&MutationRow) -> &Vec<usize>| {
            let checks = 0..self.checks.len();
            let sum = |k| self.rows.iter().map(|row| pick(row)[k]).sum();
            checks.map(sum).collect()
        };
        let all = MutationRow {
            operator: "all",
            mutants: self.mutants(),
            killed: self.killed(),
            first: sums(|row| &row.first),
            noticed: sums(|row| &row.noticed),
        };
        let rows = self.rows.iter().filter(|row| row.mutants > 0);
        for row in rows.chain([&all]) {
            let counts = [row.mutants, row.killed].map(|count| count.to_string());
            let by_check = row.first.iter().zip(&row.noticed);
            let by_check = by_check.map(|(first, all)| format!("{first}/{all}"));
            let cells = [row.operator.to_owned()].into_iter().chain(counts);
            table.add_row(cells.chain(by_check));
        }
        let mut text = format!("{table}\nEach cell: killed by this check first / killed by it.\n");
        for (mutant, reason) in &self.equivalent {
            text.push_str(&format!("equivalent: {mutant} ({reason})\n"));
        }
        for mutant in &self.not_covered {
            text.push_str(&format!("not covered by the reference: {mutant}\n"));
        }
        for mutant in &self.survivors {
            text.push_str(&format!("SURVIVED: {mutant}\n"));
        }
        text
    }
}

//! The kill table: what each kind of mistake was noticed by.

use super::judge::{CHECKS, Fate};
use super::{Mutant, Operator};
use crate::report::{Row, plain_table};
use serde::Serialize;

/// What became of the mutants of a model.
#[derive(Clone, Debug, Default, Serialize)]
pub struct KillTable {
    /// The checks, in the order in which they were asked.
    pub checks: Vec<&'static str>,
    /// One row a kind of mistake.
    pub rows: Vec<KillRow>,
    /// Mutants that nobody noticed.
    pub survivors: Vec<String>,
    /// Mutants of terms that the reference does not know, and that nothing else noticed.
    pub unwatched: Vec<String>,
    /// Mutants shown to be the same model: each with the proof.
    pub equivalent: Vec<(String, &'static str)>,
}

/// Mutants of one kind.
#[derive(Clone, Debug, Default, Serialize)]
pub struct KillRow {
    /// The kind of mistake.
    pub operator: &'static str,
    /// How many there are that change the physics.
    pub mutants: usize,
    /// How many of them were noticed.
    pub killed: usize,
    /// How many each check was the first to notice.
    pub first: Vec<usize>,
    /// How many each check noticed.
    pub noticed: Vec<usize>,
}

impl KillTable {
    /// Counts the fates of mutants.
    pub fn of(mutants: &[Mutant], fates: &[Fate]) -> Self {
        let mut table = Self {
            checks: CHECKS.to_vec(),
            ..Self::default()
        };
        for operator in Operator::ALL {
            let mut row = KillRow {
                operator: operator.name(),
                first: vec![0; CHECKS.len()],
                noticed: vec![0; CHECKS.len()],
                ..KillRow::default()
            };
            for (mutant, fate) in mutants
                .iter()
                .zip(fates)
                .filter(|(m, _)| m.operator == operator)
            {
                let name = || format!("{}: {}", mutant.place, mutant.change);
                match fate {
                    Fate::Equivalent(reason) => {
                        table.equivalent.push((name(), reason));
                        continue;
                    }
                    Fate::Unwatched => {
                        table.unwatched.push(name());
                        continue;
                    }
                    Fate::Survived => table.survivors.push(name()),
                    Fate::Killed(by) => {
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

    /// How many mutants change the physics.
    pub fn mutants(&self) -> usize {
        self.rows.iter().map(|row| row.mutants).sum()
    }

    /// How many of them were noticed.
    pub fn killed(&self) -> usize {
        self.rows.iter().map(|row| row.killed).sum()
    }

    /// One row for the report.
    pub fn row(&self) -> Row {
        let (mutants, killed, same) = (self.mutants(), self.killed(), self.equivalent.len());
        let unwatched = match self.unwatched.len() {
            0 => String::new(),
            n => format!("; {n} in terms that no reference knows, noticed by nothing else"),
        };
        let says =
            format!("{killed} of {mutants} killed; {same} more are the same model{unwatched}");
        Row::counted("mutants", mutants, &self.survivors, "").saying(says)
    }

    /// The table for people: `first/all` by each check.
    pub fn table(&self) -> String {
        let mut header = vec!["mistake", "mutants", "killed"];
        header.extend(&self.checks);
        let mut table = plain_table(&header);
        let sum = |pick: fn(&KillRow) -> &Vec<usize>, k: usize| -> usize {
            self.rows.iter().map(|row| pick(row)[k]).sum()
        };
        for row in self.rows.iter().filter(|row| row.mutants > 0) {
            let mut cells = vec![
                row.operator.to_owned(),
                row.mutants.to_string(),
                row.killed.to_string(),
            ];
            cells.extend(
                row.first
                    .iter()
                    .zip(&row.noticed)
                    .map(|(first, all)| format!("{first}/{all}")),
            );
            table.add_row(cells);
        }
        let mut cells = vec![
            String::from("all"),
            self.mutants().to_string(),
            self.killed().to_string(),
        ];
        cells.extend(
            (0..self.checks.len())
                .map(|k| format!("{}/{}", sum(|r| &r.first, k), sum(|r| &r.noticed, k))),
        );
        table.add_row(cells);
        let mut text = format!("{table}\nEach cell: killed first by this check / noticed by it.\n");
        for (mutant, reason) in &self.equivalent {
            text.push_str(&format!("equivalent: {mutant} ({reason})\n"));
        }
        for mutant in &self.unwatched {
            text.push_str(&format!("not watched by the reference: {mutant}\n"));
        }
        for mutant in &self.survivors {
            text.push_str(&format!("SURVIVED: {mutant}\n"));
        }
        text
    }
}

//! Whether the equations of a block `solve { … }` are linear and determine its unknowns.

use super::Checker;
use super::elaborate::node;
use super::solve::occurring;
use crate::diagnostic::{Diagnostic, Kind};
use crate::model::{Expr, ExprKind, Shape, ValidityLimit};

/// Bound of [`ExprKind::Determinacy`]: half of the digits of a pivot are lost to cancellation.
const LEAST_DETERMINACY: f64 = 1e-8;

impl Checker<'_> {
    /// Reports a system that is not linear, or whose equations cannot determine its unknowns.
    pub fn determined(&mut self, index: usize) {
        let system = self.model.systems[index].clone();
        let count = |e: &Expr| match e.shape {
            Shape::Scalar => 1,
            Shape::Vector(_) => 3,
        };
        let rows: usize = system.equations.iter().map(count).sum();
        let unknowns = &system.unknowns;
        let listed = || {
            let names: Vec<&str> = unknowns.iter().map(|own| &*own.name).collect();
            crate::diagnostic::listed(&names)
        };
        if rows != unknowns.len() {
            let counted = |count: usize, what: &str| {
                format!("{count} {what}{}", if count == 1 { "" } else { "s" })
            };
            let message = format!(
                "{} has {}, but {}",
                system.title,
                counted(rows, "equation"),
                counted(unknowns.len(), "unknown")
            );
            let fault = Diagnostic::new(Kind::Value, system.span, message);
            let fault = fault.note("an equation of vectors, and a vector, count as three");
            self.report(match unknowns.is_empty() {
                true => fault.help("the unknowns are derivatives such as `der(v)`, and what `unknown NAME: UNIT;` declares"),
                false => fault.note(format!("the unknowns are {}", listed())),
            });
            return;
        }
        if let Some(fault) = self.not_linear(index) {
            self.report(fault);
            return;
        }
        let (mut row_unknowns, known) = (Vec::new(), self.unknowns_of_variables(index));
        for e in &system.equations {
            let found = occurring(e, index, &known);
            row_unknowns.extend(vec![found; count(e)]);
        }
        let undetermined = unmatched(&row_unknowns, unknowns.len());
        if let Some(&first) = undetermined.first() {
            let names: Vec<&str> = undetermined.iter().map(|k| &*unknowns[*k].name).collect();
            let message = format!(
                "the equations of {} do not determine {}",
                system.title,
                crate::diagnostic::listed(&names)
            );
            let occurs = row_unknowns.iter().any(|row| row.contains(&first));
            let fault = Diagnostic::new(Kind::Value, system.span, message);
            self.report(if occurs {
                fault.note(
                    "other unknowns are in too few of the equations, or the same ones in too many",
                )
            } else {
                fault.note(format!("`{}` is in none of them", unknowns[first].name))
            });
            return;
        }
        let determinacy = node(ExprKind::Determinacy(index), Shape::Scalar, system.span);
        self.model.limits.push(ValidityLimit {
            value: determinacy,
            bound: LEAST_DETERMINACY,
            reason: format!(
                "{} does not determine {} here",
                system.title.replace('`', "\""),
                {
                    let names: Vec<&str> = unknowns.iter().map(|own| &*own.name).collect();
                    names.join(", ")
                }
            ),
            span: system.span,
        });
    }

    fn not_linear(&self, system: usize) -> Option<Diagnostic> {
        let mut degrees = Degrees {
            system,
            variables: Vec::new(),
        };
        for own in &self.model.aux_variables {
            let degree = degrees.of(&own.value).ok();
            degrees.variables.push(degree);
        }
        let equations = self.model.systems[system].equations.iter();
        let culprit = { equations }.find_map(|e| degrees.of(e).err())?;
        let text = self.text(culprit.span);
        let message = format!(
            "`{text}` is not linear in the unknowns of {}",
            self.model.systems[system].title
        );
        let fault = Diagnostic::new(Kind::Value, culprit.span, message);
        Some(fault.help(
            "unknowns are added, and multiplied and divided by what is known without the block",
        ))
    }

    /// For each auxiliary variable, the unknowns of a system on which it depends.
    pub fn unknowns_of_variables(&self, system: usize) -> Vec<Vec<usize>> {
        let mut known: Vec<Vec<usize>> = Vec::new();
        for own in &self.model.aux_variables {
            let found = occurring(&own.value, system, &known);
            known.push(found);
        }
        known
    }
}

/// Unknowns that no assignment of each to an equation of its own covers.
fn unmatched(rows: &[Vec<usize>], count: usize) -> Vec<usize> {
    fn place(
        unknown: usize,
        rows: &[Vec<usize>],
        taken: &mut [Option<usize>],
        seen: &mut [bool],
    ) -> bool {
        for row in 0..rows.len() {
            if seen[row] || !rows[row].contains(&unknown) {
                continue;
            }
            seen[row] = true;
            if taken[row].is_none_or(|other| place(other, rows, taken, seen)) {
                taken[row] = Some(unknown);
                return true;
            }
        }
        false
    }
    let mut taken = vec![None; rows.len()];
    let fails = |unknown: &usize| !place(*unknown, rows, &mut taken, &mut vec![false; rows.len()]);
    (0..count).filter(fails).collect()
}

/// Whether expressions are independent of the unknowns of a system (0) or linear in them (1).
struct Degrees {
    system: usize,
    /// `None` for an auxiliary variable that is not linear.
    variables: Vec<Option<u8>>,
}

impl Degrees {
    fn greatest<'e>(&self, parts: &'e [Expr]) -> Result<u8, &'e Expr> {
        let mut degrees = parts.iter().map(|part| self.of(part));
        degrees.try_fold(0, |greatest, degree| Ok(degree?.max(greatest)))
    }

    /// Degree of an expression, or the part of it that is not linear.
    fn of<'e>(&self, e: &'e Expr) -> Result<u8, &'e Expr> {
        use ExprKind as K;
        match &e.kind {
            K::Unknown(system, _) => Ok(u8::from(*system == self.system)),
            K::AuxVariable(i) => self.variables.get(*i).copied().flatten().ok_or(e),
            K::Add(a, b) | K::Sub(a, b) => Ok(self.of(a)?.max(self.of(b)?)),
            K::Mul(a, b) | K::Dot(a, b) | K::Cross(a, b) => match self.of(a)? + self.of(b)? {
                2 => Err(e),
                degree => Ok(degree),
            },
            K::Div(a, b) => match (self.of(a)?, self.of(b)?) {
                (degree, 0) => Ok(degree),
                _ => Err(e),
            },
            K::Neg(a) | K::Component(a, _) | K::Reexpress(a) => self.of(a),
            // What is differentiated depends on no unknown.
            K::Rate(_, _, rates) => self.greatest(rates),
            K::BodyRate(_, loads) => self.greatest(loads),
            K::Components(parts) => self.greatest(&parts[..]),
            _ => {
                for child in e.children() {
                    if self.of(child)? != 0 {
                        return Err(e);
                    }
                }
                Ok(0)
            }
        }
    }
}

//! Command `hyzer diff`: prints the effect of a change of a model.

use model_spec::load::inspect;
use verify::difference::{compare, landing, operations};

use crate::cli::Diff;
use crate::{Answer, output};

/// Runs `hyzer diff`. `Answer::No` if two models differ in a time derivative, the measurement equation or a limit.
pub(super) fn run(options: &Diff) -> anyhow::Result<Answer> {
    let with = super::names(&options.with);
    let (old, old_faults) = inspect(&options.old, &with)?.model_and_messages()?;
    let (new, new_faults) = inspect(&options.new, &with)?.model_and_messages()?;
    let landings = options.release.iter();
    let landings = landings.map(|release| landing(release, &old, &new));
    let landings = landings.collect::<Result<Vec<_>, _>>()?;
    let mut difference = compare(&old, &new);
    difference.set_unit_faults(&old_faults, &new_faults);
    difference.operations = operations(&old, &new);
    difference.landings = landings;
    output::print(if options.json {
        serde_json::to_string_pretty(&difference)? + "\n"
    } else {
        difference.text()
    })?;
    Ok(Answer::of(!difference.is_changed()))
}

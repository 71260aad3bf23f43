//! Outcome of a command of the program.

/// Outcome of a command, which determines the exit status: `Yes` (0); `No` (1), for example if a check fails; or
/// `Undecided` (3). Invalid input is an error instead, with exit status 2.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Answer {
    Yes,
    No,
    Undecided,
}

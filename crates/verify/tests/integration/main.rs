//! Models that are right hold under every check, and what is wrong, in a model, an effect or the compiled code, is refused by
//! the check that is meant to; records, reports and mutants.

mod beyond;
mod claimed;
mod compiler_on_mutants;
mod difference;
mod each_check_refuses;
mod effects;
mod every_effect;
mod every_row_can_fail;
mod exact_functions;
mod exact_kill_table;
mod gallery_mutants;
mod general_effects;
mod instruments;
mod mutants;
mod own_models;
mod record;
mod refuted;
mod report;
mod right_models;
mod rounding;
mod same_motion;
mod seeds;
mod support;
mod systems;
mod tables;
mod ties;
mod user_models;
mod written_out;
mod written_out_rust;

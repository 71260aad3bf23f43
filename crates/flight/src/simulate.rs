//! Simulation of a release: integration from the initial state to the end of the flight.

use crate::cancellation::stop_if_cancelled;
use crate::compiled_model::CompiledModel;
use crate::release::{Release, Stop};
use ode::{Event, IntegrationError, IntegrationOptions, Trajectory};

/// Simulates the flight from `release` to its end, [`Release::stop`]. The apex and the contact with the ground (the
/// height, the last of [`CompiledModel::place`], falls to 0) are the events `apex` and `ground`.
///
/// # Errors
/// [`IntegrationError`] if the integration fails, a limit of validity is reached, or the ground is not reached within
/// [`Release::MAX_DURATION`].
///
/// ```
/// use flight::release::{Release, Vocabulary, built_in, read};
/// use flight::{CompiledModel, simulate};
///
/// let model = model_spec::load::load("disc", &[])?;
/// let text = built_in("backhand").expect("a built-in release");
/// let release = read("backhand", text, |_| Ok(Vocabulary::of(&model)))?;
/// let flight = simulate(&CompiledModel::new(&model), &release, &Default::default())?;
/// assert_eq!(flight.events[0].event, "apex");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn simulate(
    model: &CompiledModel,
    release: &Release,
    options: &IntegrationOptions,
) -> Result<Trajectory, IntegrationError> {
    stop_if_cancelled();
    let bound = model.bind(model.release_parameters(release));
    let mut events = bound.limits();
    if let Some(height) = model.place()[2] {
        events.push(Event::peak_of("apex", height));
        if release.stop == Stop::Ground {
            events.push(Event::falls_to("ground", height, 0.0).terminal());
        }
    }
    let start = (0.0, &release.state().into());
    match release.stop {
        Stop::Duration(duration) => bound.integrate(start, duration, options, &mut events),
        Stop::Ground => {
            bound.integrate_to_event(start, Release::MAX_DURATION, options, &mut events)
        }
    }
}

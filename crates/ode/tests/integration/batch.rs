//! Batches of a right-hand side whose solutions are known.

use ode::{
    FlightEnd, FlightOutcome, FlightQueue, FlightSpan, IntegrationOptions, LanePoint, LaneRhs,
    LaneSizes, Method, fly_on,
};

/// Test right-hand side x' = x², whose solution becomes infinite at the time 1 / x(0). The parameter is an upper limit
/// of validity of x.
struct Square;

impl LaneRhs for Square {
    fn sizes(&self) -> LaneSizes {
        LaneSizes {
            states: 1,
            parameters: 1,
            prepared: 0,
            limits: 1,
            scratch: 0,
        }
    }
    #[inline(always)]
    fn prepare<T: lanes::Lanes>(&self, _: &[T], _: &mut [T], _: &mut [T]) {}
    #[inline(always)]
    fn derivative<T: lanes::Lanes>(&self, at: LanePoint<'_, T>, _: &mut [T], dx: &mut [T]) {
        dx[0] = at.x[0] * at.x[0];
    }
    #[inline(always)]
    fn limits<T: lanes::Lanes>(&self, at: LanePoint<'_, T>, _: &mut [T], margins: &mut [T]) {
        margins[0] = at.p[0] - at.x[0];
    }
}

/// Queue of test flights: `starts` contains the initial state and the limit of each, `ends` its outcome, final time and
/// final state.
struct Queue {
    next: usize,
    starts: Vec<(f64, f64)>,
    ends: Vec<Option<(FlightOutcome, f64, f64)>>,
}

impl FlightQueue for Queue {
    fn next(&mut self, x: &mut [f64], p: &mut [f64]) -> Option<u64> {
        let (start, limit) = *self.starts.get(self.next)?;
        (x[0], p[0]) = (start, limit);
        self.next += 1;
        Some(self.next as u64 - 1)
    }
    fn end(&mut self, end: FlightEnd<'_>) {
        self.ends[end.flight as usize] = Some((end.outcome, end.time, end.state[0]));
    }
}

fn queue(starts: Vec<(f64, f64)>) -> Queue {
    Queue {
        next: 0,
        ends: vec![None; starts.len()],
        starts,
    }
}

#[test]
fn a_flight_that_becomes_infinite_ends_alone() {
    let span = FlightSpan {
        t_end: 2.0,
        height: None,
        seeks_apex: true,
        until_ground: false,
    };
    for method in [Method::Tsit5, Method::Dop853] {
        let options = IntegrationOptions {
            method,
            ..IntegrationOptions::with_tolerance(1e-10)
        };
        // Every third one becomes infinite at the time 1, every third one meets its limit.
        let starts = (0..50).map(|k| match k % 3 {
            0 => (1.0, f64::MAX),
            1 => (0.1, 0.11),
            _ => (0.1 + 0.001 * f64::from(k), 1e9),
        });
        let mut queue = queue(starts.collect());
        fly_on(lanes::Isa::best(), &Square, &mut queue, &span, &options);
        for (k, (end, (start, _))) in queue.ends.iter().zip(&queue.starts).enumerate() {
            let (outcome, time, x) = end.expect("an end");
            match k % 3 {
                0 => {
                    assert_eq!(outcome, FlightOutcome::StepTooSmall);
                    assert!((time - 1.0).abs() < 1e-6, "{time}");
                }
                1 => {
                    assert_eq!(outcome, FlightOutcome::Limit(0));
                    // 1 / 0.1 - 1 / 0.11
                    assert!((time - (10.0 - 1.0 / 0.11)).abs() < 1e-7, "{time}");
                    assert!((x - 0.11).abs() < 1e-9, "{x}");
                }
                _ => {
                    assert_eq!((outcome, time), (FlightOutcome::Time, 2.0));
                    let exact = 1.0 / (1.0 / start - 2.0);
                    assert!((x - exact).abs() < 1e-8, "{x} {exact}");
                }
            }
        }
    }
}

#[test]
fn what_cannot_start_does_not_and_an_empty_queue_is_no_work() {
    let span = FlightSpan {
        t_end: 1.0,
        height: Some(0),
        seeks_apex: true,
        until_ground: true,
    };
    let options = IntegrationOptions::default();
    let starts = vec![
        (f64::NAN, 1.0),
        (0.5, f64::INFINITY),
        (-1.0, 9.0),
        (2.0, 1.0),
    ];
    let mut flights = queue(starts);
    fly_on(lanes::Isa::best(), &Square, &mut flights, &span, &options);
    let outcomes: Vec<_> = flights
        .ends
        .iter()
        .map(|end| end.expect("an end").0)
        .collect();
    assert_eq!(
        outcomes,
        [
            FlightOutcome::NotFinite,
            FlightOutcome::NotFinite,
            FlightOutcome::StartsBelowGround,
            FlightOutcome::Limit(0)
        ]
    );
    assert_eq!(
        fly_on(
            lanes::Isa::best(),
            &Square,
            &mut queue(Vec::new()),
            &span,
            &options
        ),
        Some(2)
    );
    for isa in lanes::Isa::ALL {
        let mut one = queue(vec![(0.5, 9.0)]);
        let span = FlightSpan {
            seeks_apex: true,
            until_ground: false,
            ..span
        };
        if fly_on(isa, &Square, &mut one, &span, &options).is_some() {
            let (outcome, _, x) = one.ends[0].expect("an end");
            assert_eq!(outcome, FlightOutcome::Time);
            assert!((x - 1.0).abs() < 1e-5, "{} {x}", isa.name());
        }
    }
}

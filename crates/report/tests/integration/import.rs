//! The page of an import, made from flights that never were.

use report::figures::Line;
use report::import::{Distance, Edge, ImportPage, ImportedFlight, ImportedTake, html};

fn flight(number: usize) -> ImportedFlight {
    let points = |value: fn(f64) -> f64| -> Vec<(f64, f64)> {
        let times = (0..200).map(|i| f64::from(i) / 100.0);
        times
            .map(|t| {
                (
                    t,
                    if (1.0..1.1).contains(&t) {
                        f64::NAN
                    } else {
                        value(t)
                    },
                )
            })
            .collect()
    };
    ImportedFlight {
        file: format!("flight{number:02}.csv"),
        samples: 120,
        release: Edge {
            time: 0.4,
            reason: "the hand <lets go>".into(),
        },
        end: Edge {
            time: 1.6,
            reason: "stopped".into(),
        },
        span: (0.4, 1.6),
        gaps: vec![(1.0, 1.1)],
        missing: vec![("rim & all".into(), 7)],
        curves: vec![
            Line::new("Height, m", points(|t| 2.0 + t - t * t)),
            Line::new("Speed, m/s", points(|_| f64::NAN)),
        ],
        distances: vec![
            Distance {
                name: "a–b".into(),
                template: 0.2,
                points: points(|t| if t > 1.3 { 0.35 } else { 0.2 }),
            },
            Distance {
                name: "a–c".into(),
                template: 0.1,
                points: points(|_| 0.1),
            },
        ],
    }
}

fn page(flights: usize) -> String {
    page_of(flights, vec![(0.0, 1.0), (0.5, f64::NAN), (1.0, 2.0)])
}

fn page_of(flights: usize, heights: Vec<(f64, f64)>) -> String {
    let take = ImportedTake {
        file: "take <1>.csv".into(),
        decisions: vec![("up".into(), "+y, by --up".into())],
        notes: vec!["a second \"m1\" is called \"m1#2\"".into()],
        heights,
        flights: (1..=flights).map(flight).collect(),
    };
    html(&ImportPage {
        dataset: "throws".into(),
        model: "disc".into(),
        takes: vec![take],
    })
}

#[test]
fn the_page_says_what_was_decided() {
    let html = page(2);
    for text in [
        "take &lt;1&gt;.csv",
        "the hand &lt;lets go&gt;",
        "+y, by --up",
        "m1#2",
        "nothing from 1.000 to 1.100 s",
        "rim &amp; all in 7",
        "2 flights from 1 recording",
        // The pair that jumps by 150 mm comes first.
        "<tr><th scope=\"row\">a–b</th><td class=\"n\">200.0</td><td class=\"n\">200.0</td><td class=\"n\">150.0</td>",
    ] {
        assert!(html.contains(text), "{text}");
    }
    assert!(html.find("\">a–b</th>") < html.find("\">a–c</th>"));
}

#[test]
fn the_page_is_whole_and_loads_nothing() {
    let html = page(3);
    let without = html.replace("xmlns=\"http://www.w3.org/2000/svg\"", "");
    for load in [
        "http:", "https:", "url(", "@import", " src=", "<script", "<link", "<img",
    ] {
        assert!(!without.contains(load), "{load}");
    }
    let mut figures = 0;
    for part in html.split("<svg ").skip(1) {
        let svg = format!(
            "<svg {}</svg>",
            part.split("</svg>").next().expect("an end")
        );
        roxmltree::Document::parse(&svg).expect("well-formed");
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
        figures += 1;
    }
    // Three flights, and the take for wide and for narrow screens.
    assert_eq!(figures, 5);
}

#[test]
fn many_flights_and_none() {
    assert!(page(70).contains("10 more flights are not drawn"));
    assert!(page(0).contains("No throw was found"));
}

#[test]
fn a_recording_is_drawn_whole_where_something_of_it_is_cut_away() {
    let is_whole = |heights: Vec<(f64, f64)>| page_of(1, heights).contains("Whole recordings");
    assert!(is_whole(vec![(0.1, 1.0), (0.5, 1.5)]));
    assert!(!is_whole(vec![(0.1, f64::NAN), (0.5, 1.5), (1.5, 1.0)]));
}

//! The table `[wind]` of files: what it states, and the faults of broken ones with their places.

use flight::release::{Vocabulary, read, read_in_wind};
use flight::wind::{GustStrength, Gusts, Profile, ReferenceWind, WindField, read_wind_file};

use super::{model, released};

const HEAD: &str = "model = \"ball\"\nduration = 1.0\n[throw]\nspeed = 9.0\nheading = 12\n";

/// Faults of a release file with the text `wind`, as location and message; lines are counted from the start of `wind`.
fn faults(wind: &str) -> Vec<((usize, usize), String)> {
    let names = |name: &str| Ok(Vocabulary::of(&model(name)));
    let text = format!("{HEAD}{wind}");
    let error = read_in_wind("r.toml", &text, &[], names).expect_err(wind);
    let lines = HEAD.lines().count();
    let faults = error.faults.into_iter().map(|fault| {
        let (line, column) = fault.location.expect("a place");
        ((line - lines, column), fault.message)
    });
    faults.collect()
}

#[test]
fn a_file_states_profile_and_gusts_and_is_written_as_it_was() {
    let wind = "[wind]\nprofile = \"power\"\nspeed = 4\nexponent = 0.25\n[wind.gusts]\nmodel = \"dryden\"\nseed = 9\n";
    let (release, model) = released(&format!("{HEAD}{wind}"));
    let expected = WindField {
        profile: Some(Profile::Power {
            at: ReferenceWind {
                speed: 4.0,
                direction: 0.0,
                height: 10.0,
            },
            exponent: 0.25,
        }),
        gusts: Some(Gusts {
            seed: 9,
            flight: 0,
            heading: 12.0,
            intensity: 1.0,
            height: 3.048,
            strength: GustStrength::LowAltitude,
        }),
    };
    assert_eq!(release.wind_field.as_ref(), Some(&expected));
    let layout = model_spec::Layout::new(&model);
    for (name, _) in expected.parameters() {
        assert!(layout.parameter(&name).is_some(), "{name}");
    }
    for wind in [
        wind.to_owned(),
        "[wind]\nprofile = \"log\"\nspeed = 1e-3\ndirection = -7.5\nreference_height = 2.0\nroughness = 1e-5\n".to_owned(),
        "[wind]\ntable = [[1.0, 1.0, 0.0, 0.0], [2.0, -2.5, 1e-9, 0.0]]\n[wind.gusts]\nmodel = \"dryden\"\nseed = 9\nflight = 3\nsd = [1.0, 2.0, 3.0]\nlength = [4.0, 5.0, 6.0]\nheading = 1.0\nintensity = 0.5\nheight = 7.0\n".to_owned(),
        "[wind]\nconstant = [1.0, 2.0, 3.0]\n[wind.gusts]\nmodel = \"dryden\"\nseed = 9\n".to_owned(),
    ] {
        let (release, _) = released(&format!("{HEAD}{wind}"));
        let field = release.wind_field.expect("a field");
        let (again, _) = released(&format!("{HEAD}{}", field.to_toml(release.wind)));
        assert_eq!((again.wind_field, again.wind), (Some(field), release.wind));
    }
}

#[test]
fn every_fault_has_its_place_and_what_was_expected() {
    for (wind, place, words) in [
        (
            "[wind]\nprofil = \"log\"",
            (2, 1),
            "did you mean \"profile\"?",
        ),
        (
            "[wind]\nprofile = \"logarithm\"",
            (2, 11),
            "expected \"log\" or \"power\"",
        ),
        ("[wind]\nprofile = \"log\"", (2, 11), "found no speed"),
        (
            "[wind]\nspeed = 3.0",
            (2, 9),
            "found speed without a profile",
        ),
        (
            "[wind]\nprofile = \"log\"\nspeed = -3.0",
            (3, 9),
            "expected a number from 0 to 100 m/s",
        ),
        (
            "[wind]\nprofile = \"log\"\nspeed = 3.0\nexponent = 0.1",
            (4, 12),
            "expected roughness",
        ),
        (
            "[wind]\nprofile = \"power\"\nspeed = 3.0\nroughness = 0.1",
            (4, 13),
            "expected exponent",
        ),
        (
            "[wind]\nprofile = \"log\"\nspeed = 3.0\nroughness = 0",
            (4, 13),
            "from 0.000001 to 10 m",
        ),
        (
            "[wind]\nprofile = \"log\"\nspeed = 3.0\nconstant = [1.0, 0.0, 0.0]",
            (4, 12),
            "a constant wind beside",
        ),
        (
            "[wind]\nprofile = \"log\"\nspeed = 3.0\ntable = [[1.0, 0.0, 0.0, 0.0], [2.0, 0.0, 0.0, 0.0]]",
            (4, 9),
            "both a profile and a table",
        ),
        (
            "[wind]\ntable = [[1.0, 0.0, 0.0, 0.0]]",
            (2, 9),
            "2 to 500 rows",
        ),
        (
            "[wind]\ntable = [[1.0, 0.0, 0.0, 0.0], [2.0, 0.0, 0.0]]",
            (2, 32),
            "four numbers",
        ),
        (
            "[wind]\ntable = [[1.0, 0.0, 0.0, 0.0], [0.5, 0.0, 0.0, 0.0]]",
            (2, 32),
            "heights that grow",
        ),
        (
            "[wind]\ntable = [[1.0, 0.0, 0.0, 0.0], [2.0, 1e9, 0.0, 0.0]]",
            (2, 38),
            "from -200 to 200 m/s",
        ),
        ("[wind]\ngusts = 3", (2, 9), "expected a table"),
        ("[wind.gusts]\nseed = 3", (1, 1), "found no model"),
        (
            "[wind.gusts]\nmodel = \"karman\"\nseed = 3",
            (2, 9),
            "expected \"dryden\"",
        ),
        ("[wind.gusts]\nmodel = \"dryden\"", (1, 1), "found no seed"),
        (
            "[wind.gusts]\nmodel = \"dryden\"\nseed = 1.5",
            (3, 8),
            "expected a whole number",
        ),
        (
            "[wind.gusts]\nmodel = \"dryden\"\nseed = 1\nsd = [1.0, 1.0, 1.0]",
            (4, 6),
            "expected both",
        ),
        (
            "[wind.gusts]\nmodel = \"dryden\"\nseed = 1\nheight = 1e6",
            (4, 10),
            "from 0.3048 to 304.8 m",
        ),
        (
            "[wind.gusts]\nmodel = \"dryden\"\nseed = 1\nsd = [1.0, 1.0, -1.0]\nlength = [1.0, 1.0, 1.0]",
            (4, 6),
            "from 0 to 50 m/s",
        ),
        (
            "[wind]\nprofile = \"log\"\nspeed = 3.0\n[parameters]\nwind_speed = 4.0",
            (5, 1),
            "follows from [wind]",
        ),
    ] {
        let found = faults(wind);
        let is_there =
            |(at, message): &((usize, usize), String)| *at == place && message.contains(words);
        assert!(found.iter().any(is_there), "{wind}\n{found:?}");
    }
}

#[test]
fn a_model_that_cannot_have_the_wind_is_refused_at_it() {
    let text = "model stone;\nparam m = 1 kg;\nframe N;\npoint stone { mass m; position (x, y, z) in N; velocity (vx, vy, vz) in N; }\nforce weight = -m*9.81 [m/s^2]*N.3;\n";
    let stone = model_spec::load::from_text("stone.hyz", text, &[]).expect("a stone");
    let release = "model = \"stone\"\nduration = 1.0\n[throw]\nspeed = 9.0\n[wind]\nprofile = \"log\"\nspeed = 3.0\n";
    let error = read_in_wind("r.toml", release, &[], |_| Ok(Vocabulary::of(&stone))).unwrap_err();
    assert_eq!(error.faults[0].location, Some((5, 1)));
    let message = &error.faults[0].message;
    assert!(
        message.contains("stone") && message.contains("air_velocity"),
        "{message}"
    );
}

#[test]
fn who_flies_constant_winds_alone_refuses_others() {
    let text = format!("{HEAD}[wind]\nprofile = \"log\"\nspeed = 3.0\n");
    let error = read("r.toml", &text, |name| Ok(Vocabulary::of(&model(name)))).unwrap_err();
    assert_eq!(error.faults[0].location, Some((6, 1)));
    assert!(
        error.faults[0]
            .message
            .contains("expected only a constant wind")
    );
}

#[test]
fn a_wind_file_is_read_by_itself() {
    let folder = std::env::temp_dir().join(format!("hyzer-winds-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    let path = folder.join("wind.toml");
    std::fs::write(&path, "[wind]\nprofile = \"log\"\nspeed = 3.0\n").expect("written");
    let (constant, field) = read_wind_file(&path).expect("a wind");
    assert!(constant == [0.0; 3] && field.is_some_and(|field| field.gusts.is_none()));
    std::fs::write(&path, "model = \"disc\"\n").expect("written");
    let error = read_wind_file(&path).unwrap_err().to_string();
    assert!(error.contains("found no [wind]"), "{error}");
    std::fs::remove_dir_all(&folder).expect("removed");
}

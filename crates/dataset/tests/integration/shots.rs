//! Tables of launch monitors as they are exported: marks of numbers, units, sides, and columns that are not read.

use std::path::Path;

use dataset::{ImportedShots, InputError, ShotOptions, SummaryQuantity, import_shots};

fn import(text: &str) -> Result<ImportedShots, InputError> {
    import_shots(
        Path::new("shots.csv"),
        text.as_bytes(),
        &ShotOptions::default(),
    )
}

/// Values of a quantity in the shots, SI and with its sign.
#[track_caller]
fn values(made: &ImportedShots, wanted: SummaryQuantity) -> Vec<Option<f64>> {
    let mut sensors = made.dataset.sensors.iter().enumerate();
    let own = sensors.find_map(|(place, sensor)| match sensor.kind {
        dataset::SensorKind::Summary(own) if own.quantity == wanted => Some((place, own.to_si())),
        _ => None,
    });
    let (place, to_si) = own.unwrap_or_else(|| panic!("{}", wanted.name()));
    let flights = made.dataset.flights.iter();
    let values = flights.map(|flight| flight.readings[0][place].map(|own| own[0] * to_si));
    values.collect()
}

#[track_caller]
fn are_near(made: &ImportedShots, quantity: SummaryQuantity, wanted: &[f64]) {
    let found = values(made, quantity);
    assert_eq!(found.len(), wanted.len());
    for (found, wanted) in found.iter().zip(wanted) {
        let found = found.unwrap_or_else(|| panic!("{}", quantity.name()));
        assert!(
            (found - wanted).abs() < 1e-9 * wanted.abs().max(1.0),
            "{}: {found} {wanted}",
            quantity.name()
        );
    }
}

const MPH: f64 = 0.44704;
const YARD: f64 = 0.9144;
const RPM: f64 = std::f64::consts::PI / 30.0;

#[test]
fn decimal_commas_and_marks_of_thousands() {
    for text in [
        "Ball Speed;Spin Rate;Carry\n[mph];[rpm];[yd]\n150,947;4367,636;233,652\n127,7;3450,65;195,82\n",
        "Ball Speed\tSpin Rate\tCarry\n[mph]\t[rpm]\t[yd]\n150,947\t4.367,636\t233,652\n127,7\t3450,65\t195,82\n",
        "Ball Speed,Spin Rate,Carry\n[mph],[rpm],[yd]\n150.947,\"4,367.636\",233.652\n127.7,\"3,450.65\",195.82\n",
    ] {
        let made = import(text).expect(text);
        are_near(&made, SummaryQuantity::Speed, &[150.947 * MPH, 127.7 * MPH]);
        are_near(
            &made,
            SummaryQuantity::Spin,
            &[4367.636 * RPM, 3450.65 * RPM],
        );
        are_near(
            &made,
            SummaryQuantity::Carry,
            &[233.652 * YARD, 195.82 * YARD],
        );
        let told = made.decisions.iter().any(|own| own.contains("is a comma"));
        assert_eq!(told, text.contains("150,947"), "{:?}", made.decisions);
    }
    let whole = "Ball Speed,Spin Rate,Carry\n[mph],[rpm],[yd]\n150,\"4,367\",233\n";
    let made = import(whole).expect(whole);
    are_near(&made, SummaryQuantity::Spin, &[4367.0 * RPM]);
}

#[test]
fn a_table_without_a_shot_tells_the_first_reason() {
    let text = "Ball Speed,Carry\n[mph],[yd]\n150,far\n150,farther\n";
    let error = import(text).expect_err("no shot").to_string();
    assert!(
        error.contains("no shot: line 3 is left out: cell 2, \"far\", expected a number"),
        "{error}"
    );
}

#[test]
fn sides_and_units_in_cells() {
    let text = "Ball Speed,Launch Direction,Spin Axis,Carry,Side\n\
        150.947 mph,1.8 R,5.8 R,233.7 yds,23.5R\n40 m/s,1.5° L,1.8 L,195.8 yds,3.0 yds L\n";
    let made = import(text).expect(text);
    let degree = std::f64::consts::PI / 180.0;
    are_near(&made, SummaryQuantity::Speed, &[150.947 * MPH, 40.0]);
    // The heading counts positive to the left.
    are_near(
        &made,
        SummaryQuantity::Heading,
        &[-1.8 * degree, 1.5 * degree],
    );
    are_near(
        &made,
        SummaryQuantity::SpinAxis,
        &[5.8 * degree, -1.8 * degree],
    );
    are_near(&made, SummaryQuantity::Carry, &[233.7 * YARD, 195.8 * YARD]);
}

#[test]
fn the_side_without_a_unit_in_every_cell() {
    let text = "Ball Speed,Carry,Side\n[mph],[yd],[yd]\n150,230,23.5R\n150,230,3.0L\n150,230,0\n150,-2 L,1\n";
    let made = import(text).expect(text);
    are_near(
        &made,
        SummaryQuantity::Side,
        &[23.5 * YARD, -3.0 * YARD, 0.0],
    );
    let left_out = made.decisions.iter().find(|own| own.contains("line 6"));
    assert!(
        left_out.is_some_and(|own| own.contains("no side")),
        "{left_out:?}"
    );
}

#[test]
fn a_row_of_units_without_brackets() {
    let text = "Club,Ball Speed,Spin Rate,Carry,Height\n,mph,rpm,yds,ft\nDriver,150,2500,230,90\n";
    let made = import(text).expect(text);
    assert_eq!(made.dataset.flights.len(), 1);
    are_near(&made, SummaryQuantity::ApexHeight, &[90.0 * 0.3048]);
}

#[test]
fn columns_of_numbers_that_are_not_read_are_named() {
    // Half of the cells are numbers.
    let text = "Shot,Date,Smash,Club Speed (mph),Carry (yd)\n1,2024-05-03,1.45,104,230\n2,2024-05-03,?,103,220\n";
    let lines = import(text).expect(text).decisions;
    for line in [
        "\"Smash\": not read; --column \"Smash=IS,UNIT\" reads it",
        "\"Club Speed (mph)\": not read; --column \"Club Speed (mph)=IS,mph\" reads it, where IS is speed or landing_speed",
    ] {
        assert!(lines.iter().any(|own| own == line), "{line}\n{lines:?}");
    }
    for (quantity, option) in [("speed", "speed,mph"), ("spin", "spin,rpm")] {
        let begins = format!("no column is the {quantity} of the release");
        let found = lines.iter().find(|own| own.starts_with(&begins));
        let option = format!("--column \"HEADER={option}\"");
        assert!(found.is_some_and(|own| own.ends_with(&option)), "{lines:?}");
    }
    assert_eq!(lines.len(), 5, "{lines:?}");
}

#[test]
fn backspin_and_sidespin_are_the_spin_and_its_axis() {
    let text = "Ball (mph),Push/Pull (deg),Backspin (rpm),Sidespin (rpm),Carry (yds)\n\
        150,1,4000,3000,230\n150,-1,4000,3000 L,230\n150,-1,4000,,230\n";
    let made = import(text).expect(text);
    let (spin, axis) = (
        values(&made, SummaryQuantity::Spin),
        values(&made, SummaryQuantity::SpinAxis),
    );
    let near = |found: Option<f64>, wanted: f64| (found.expect("a value") - wanted).abs() < 1e-9;
    assert!(near(spin[0], 5000.0 * RPM) && near(spin[1], 5000.0 * RPM));
    assert!(near(axis[0], 0.75_f64.atan()) && near(axis[1], -0.75_f64.atan()));
    assert_eq!((spin[2], axis[2]), (None, None));
    assert!(near(values(&made, SummaryQuantity::Speed)[0], 150.0 * MPH));
    assert!(near(
        values(&made, SummaryQuantity::Heading)[0],
        -std::f64::consts::PI / 180.0
    ));
    let from = "\"Total Spin\": spin, rpm, release, from \"Backspin (rpm)\" and \"Sidespin (rpm)\"";
    assert!(
        made.decisions.iter().any(|own| own == from),
        "{:?}",
        made.decisions
    );
}

#[test]
fn the_type_of_the_ball_is_no_speed() {
    let text = "Ball,Axis (deg),Ball Speed (mph),Carry (yd)\nPremium,3,150,230\n";
    let made = import(text).expect(text);
    are_near(&made, SummaryQuantity::Speed, &[150.0 * MPH]);
    are_near(
        &made,
        SummaryQuantity::SpinAxis,
        &[3.0 * std::f64::consts::PI / 180.0],
    );
}

#[test]
fn statistics_of_the_shots_are_left_out_and_named() {
    let head = "Club,Ball Speed,Carry\n[],[mph],[yd]\n";
    let text = format!(
        "{head}Driver,150,230\nDriver,152,234\nAverage,151,232\nStd. Dev.,1,2\n\
         7 Iron,110,160\n7 Iron,112,164\nAVG (2),111,162\nMax.,112,164\n"
    );
    let made = import(&text).expect("shots");
    are_near(
        &made,
        SummaryQuantity::Speed,
        &[150.0 * MPH, 152.0 * MPH, 110.0 * MPH, 112.0 * MPH],
    );
    for line in [
        "line 5 left out: \"Average\", no shot",
        "line 6 left out: \"Std. Dev.\", no shot",
        "line 9 left out: \"AVG (2)\", no shot",
        "line 10 left out: \"Max.\", no shot",
    ] {
        assert!(
            made.decisions.iter().any(|own| own == line),
            "{:?}",
            made.decisions
        );
    }
    // The label may stand in any column that is not read, and a player may have the name of a statistic.
    let second =
        "No.,Player,Ball Speed,Carry\n,,[mph],[yd]\n1,Max,150,230\n2,Max,152,234\n,Mean,151,232\n";
    let made = import(second).expect("shots");
    are_near(&made, SummaryQuantity::Speed, &[150.0 * MPH, 152.0 * MPH]);
}

#[test]
fn units_of_the_header_and_of_the_row_of_units_agree() {
    let told = |text: &str| import(text).expect_err(text).to_string();
    let row = "Ball Speed (mph),Carry (yds)\n[mph],[yd]\n150,230\n";
    are_near(
        &import(row).expect("they agree"),
        SummaryQuantity::Speed,
        &[150.0 * MPH],
    );
    let error = told(&row.replace("[mph]", "[km/h]"));
    assert!(
        error.contains(
            "found [km/h] in the row of units below \"Ball Speed (mph)\", expected one unit"
        ) && error.contains("--column \"Ball Speed (mph)=IS,UNIT\""),
        "{error}"
    );
    let spins = "Backspin (rpm),Sidespin (rpm),Carry (yds)\n[rpm],[deg/s],[yd]\n4000,300,230\n";
    assert!(
        told(spins).contains("[deg/s] in the row of units below \"Sidespin (rpm)\""),
        "{}",
        told(spins)
    );
    let options = ShotOptions {
        columns: vec![(
            "Ball Speed (mph)".into(),
            "speed".into(),
            Some("km/h".into()),
        )],
        ..ShotOptions::default()
    };
    let text = row.replace("[mph]", "[km/h]");
    let made = import_shots(Path::new("shots.csv"), text.as_bytes(), &options);
    are_near(
        &made.expect("the unit is stated"),
        SummaryQuantity::Speed,
        &[150.0 / 3.6],
    );
}

#[test]
fn a_second_column_of_a_quantity_is_said_to_be_one() {
    let text = "Ball Speed (mph),Ball Speed (km/h),Carry (yd)\n150,241,230\n";
    let lines = import(text).expect(text).decisions;
    let line = "\"Ball Speed (km/h)\": not read, as \"Ball Speed (mph)\" is the speed";
    assert!(lines.iter().any(|own| own == line), "{lines:?}");
}

//! Sensors of a dataset: read, written back, and refused where they are wrong.

use dataset::SensorKind;
use model_spec::compose::Instrument;

const HEAD: &str = "model = \"disc\"\n\n[[flights]]\nfile = \"a.csv\"\n";

fn read(manifest: &str, table: &str) -> Result<dataset::Dataset, String> {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("dataset.toml"), manifest).expect("written");
    std::fs::write(folder.path().join("a.csv"), table).expect("written");
    dataset::load(folder.path()).map_err(|error| error.to_string())
}

fn sensor(kind: &str, more: &str) -> String {
    format!("{HEAD}\n[[sensors]]\nname = \"s\"\nkind = \"{kind}\"\n{more}")
}

#[test]
fn every_kind_is_read_and_written_back() {
    let manifest = format!(
        "{HEAD}\n[[markers]]\nname = \"m1\"\nposition = [0.1, 0, 0]\n\
         \n[[sensors]]\nname = \"m2\"\nkind = \"marker\"\nposition = [0, 0.1, 0]\nsigma = 0.002\n\
         \n[[sensors]]\nname = \"tag\"\nkind = \"pose\"\nsigma = 0.003\nsigma_angle = 0.02\n\
         \n[[sensors]]\nname = \"gyro\"\nkind = \"gyroscope\"\nposition = [0.01, 0, 0]\n\
         \n[[sensors]]\nname = \"acc\"\nkind = \"accelerometer\"\n\
         \n[[sensors]]\nname = \"radar\"\nkind = \"speed\"\n"
    );
    let table = "t,radar,m1_x,m1_y,m1_z,m2_x,m2_y,m2_z,tag_x,tag_y,tag_z,tag_qw,tag_qx,tag_qy,tag_qz,gyro_x,gyro_y,gyro_z,acc_x,acc_y,acc_z\n\
                 0,12,1,2,3,1.1,2.1,3,7,8,9,1,0,0,0,0.1,0.2,50,1,2,9.8\n\
                 0.01,,1,2,3,,,,7,8,9,,,,,0.1,0.2,50,,,\n";
    let read = read(&manifest, table).expect("a dataset");
    assert_eq!((read.markers.len(), read.sigma), (2, Some(0.002)));
    let kinds: Vec<SensorKind> = read.sensors.iter().map(|sensor| sensor.kind).collect();
    let instrument = SensorKind::Instrument;
    assert_eq!(
        kinds,
        [
            SensorKind::Pose,
            instrument(Instrument::Gyroscope),
            instrument(Instrument::Accelerometer),
            instrument(Instrument::Speed)
        ]
    );
    let flight = &read.flights[0];
    assert_eq!(flight.readings[0][4], Some([12.0, 0.0, 0.0, 0.0]));
    assert_eq!(flight.readings[0][1], Some([1.0, 0.0, 0.0, 0.0]));
    assert_eq!(flight.readings[1][1], None);
    assert_eq!(flight.readings[1][3], None);
    read.validate().expect("it is written as it is read");
}

#[test]
fn what_is_stated_wrongly_is_refused() {
    let table = "t,s_x,s_y,s_z\n0,1,2,3\n";
    let cases = [
        (
            sensor("gyro", ""),
            table,
            "found kind = \"gyro\", expected one of",
        ),
        (
            sensor("speed", "sigma = 0"),
            table,
            "found sigma = 0, expected a standard deviation above 0",
        ),
        (
            sensor("gyroscope", "sigma_angle = 0.1"),
            table,
            "sigma_angle only with kind = \"pose\"",
        ),
        (
            sensor("gyroscope", "rate = 3"),
            table,
            "found the key \"rate\" in [[sensors]]",
        ),
        (
            sensor("gyroscope", ""),
            "t,s_x,s_y\n0,1,2\n",
            "found no column s_z",
        ),
        (
            sensor("gyroscope", ""),
            "t,s_x,s_y,s_w\n0,1,2,3\n",
            "found the column \"s_w\"",
        ),
        (
            sensor("pose", ""),
            "t,s_x,s_y,s_z,s_qw,s_qx,s_qy,s_qz\n0,1,2,3,1,1,0,0\n",
            "a.csv:2:9: found a quaternion of norm 1.414",
        ),
        (
            HEAD.to_owned(),
            table,
            "found no [[markers]], expected at least one marker",
        ),
        (
            format!(
                "{}\n[template]\norigin_error = [0, 0, -1]\n",
                sensor("pose", "")
            ),
            table,
            "found origin_error = [0.0, 0.0, -1.0], expected standard errors from 0 to 1 m",
        ),
        (
            format!("{}\n[template]\naxis_error = 2\n", sensor("pose", "")),
            table,
            "found axis_error = 2, expected a standard error from 0 to 0.5 rad",
        ),
    ];
    for (manifest, table, message) in cases {
        let error = read(&manifest, table).expect_err(message);
        assert!(error.contains(message), "{error}\nexpected {message}");
    }
}

#[test]
fn readings_have_the_units_of_what_is_measured() {
    use model_spec::unit::Unit;
    let of_kind = |kind: SensorKind| {
        let text = format!(
            "model m; param a = 1 {}; frame N; state x = 0 s; der(x) = a/a;",
            kind.unit()
        );
        let model = model_spec::load::from_text("m.hyz", &text, &[]);
        model.unwrap_or_else(|error| panic!("{error}")).params[0].unit
    };
    for (kind, name) in SensorKind::ALL {
        let unit = match name {
            "pose" => Unit::METRE,
            "gyroscope" => Unit::RATE,
            "accelerometer" => Unit::ACCELERATION,
            _ => Unit::SPEED,
        };
        assert_eq!(of_kind(kind), unit, "{name}");
    }
}

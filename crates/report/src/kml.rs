//! Landings on a map of the Earth, as KML.

use crate::figures::svg::escape;
use crate::sweep::Landings;

/// Semi-major axis of WGS 84, m, and the square of its eccentricity.
const WGS84: (f64, f64) = (6_378_137.0, 6.694_379_990_141e-3);

/// Greatest latitude of an origin, deg: beyond it the east is no direction to count from.
const MAX_LATITUDE: f64 = 89.0;

/// Where the inertial frame stands on the Earth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Origin {
    /// Latitude of the origin, deg.
    latitude: f64,
    /// Longitude of the origin, deg.
    longitude: f64,
    /// Direction of +x, rad clockwise from north.
    bearing: f64,
}

impl Origin {
    /// Reads `LAT,LON` or `LAT,LON,BEARING`, deg; without a bearing +x points to the east.
    ///
    /// # Errors
    /// What was expected.
    pub fn parse(text: &str) -> Result<Origin, String> {
        let numbers = text.split(',').map(|part| part.trim().parse::<f64>());
        let numbers: Result<Vec<f64>, _> = numbers.collect();
        let (latitude, longitude, bearing) = match numbers.as_deref() {
            Ok([latitude, longitude]) => (*latitude, *longitude, 90.0),
            Ok([latitude, longitude, bearing]) => (*latitude, *longitude, *bearing),
            _ => return Err("LAT,LON or LAT,LON,BEARING in deg, as in 47.3769,8.5417".to_owned()),
        };
        for (what, value, most) in [
            ("a latitude", latitude, MAX_LATITUDE),
            ("a longitude", longitude, 180.0),
            ("a bearing", bearing, 360.0),
        ] {
            if !(-most..=most).contains(&value) {
                return Err(format!("{what} from −{most} to {most} deg, not {value}"));
            }
        }
        Ok(Origin {
            latitude,
            longitude,
            bearing: bearing.to_radians(),
        })
    }

    /// Longitude and latitude, deg, of a place in the inertial frame, m, within some kilometres of the origin.
    fn coordinates(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let (sin, cos) = self.bearing.sin_cos();
        let (north, east) = (x * cos + y * sin, x * sin - y * cos);
        let (axis, eccentricity) = WGS84;
        let latitude = self.latitude.to_radians();
        let flattened = 1.0 - eccentricity * latitude.sin().powi(2);
        let meridian = axis * (1.0 - eccentricity) / flattened.powf(1.5);
        let parallel = axis / flattened.sqrt() * latitude.cos();
        [
            self.longitude + (east / parallel).to_degrees(),
            self.latitude + (north / meridian).to_degrees(),
        ]
    }

    /// Coordinates as KML has them.
    fn written(&self, place: [f64; 2]) -> String {
        let [longitude, latitude] = self.coordinates(place);
        format!("{longitude:.8},{latitude:.8},0")
    }
}

/// The landings of a sweep as KML: the origin, their mean, their ellipses and each of them.
pub fn landings(title: &str, origin: &Origin, landings: &Landings) -> String {
    let point = |name: &str, style: &str, place: [f64; 2]| {
        format!(
            "<Placemark><name>{name}</name><styleUrl>#{style}</styleUrl><Point><coordinates>{}</coordinates></Point></Placemark>\n",
            origin.written(place)
        )
    };
    let mut text = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<kml xmlns=\"http://www.opengis.net/kml/2.2\">\n<Document>\n<name>{}</name>\n{STYLES}",
        escape(title)
    );
    text += &point("origin", "pin", [0.0; 2]);
    text += &point("mean landing", "pin", landings.mean);
    for (name, ellipse) in ["half of the landings", "95 % of the landings"]
        .into_iter()
        .zip(&landings.ellipses)
    {
        let ring: Vec<String> = ellipse.iter().map(|place| origin.written(*place)).collect();
        text += &format!(
            "<Placemark><name>{name}</name><styleUrl>#ellipse</styleUrl><Polygon><outerBoundaryIs><LinearRing><coordinates>{}</coordinates></LinearRing></outerBoundaryIs></Polygon></Placemark>\n",
            ring.join(" ")
        );
    }
    text += "<Folder><name>landings</name>\n";
    for place in &landings.places {
        text += &point("", "landing", *place);
    }
    text + "</Folder>\n</Document>\n</kml>\n"
}

const STYLES: &str = "\
<Style id=\"pin\"><IconStyle><scale>1</scale></IconStyle></Style>
<Style id=\"ellipse\"><LineStyle><color>ffb27200</color><width>2</width></LineStyle><PolyStyle><fill>0</fill></PolyStyle></Style>
<Style id=\"landing\"><IconStyle><scale>0.4</scale><Icon><href>http://maps.google.com/mapfiles/kml/shapes/shaded_dot.png</href></Icon></IconStyle></Style>
";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_nautical_mile_to_the_north_is_about_a_minute() {
        let origin = Origin::parse("45, 8").unwrap();
        let [longitude, latitude] = origin.coordinates([0.0, 1_852.0]);
        assert!((60.0 * (latitude - 45.0) - 1.0).abs() < 1e-3 && longitude == 8.0);
        // A minute of longitude is as long as one of latitude times the cosine, but for the flattening.
        let [longitude, _] = origin.coordinates([1_852.0 * 0.5_f64.sqrt(), 0.0]);
        assert!((60.0 * (longitude - 8.0) - 1.0).abs() < 4e-3);
        // With +x to the north, +y is the west.
        let [longitude, latitude] = Origin::parse("45,8,0").unwrap().coordinates([10.0, 10.0]);
        assert!(latitude > 45.0 && longitude < 8.0);
    }

    #[test]
    fn a_place_that_is_none_is_refused() {
        for wrong in [
            "", "45", "45,8,0,1", "a,b", "90,0", "0,181", "nan,0", "0,inf",
        ] {
            assert!(Origin::parse(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn the_file_has_the_origin_and_all_landings() {
        let made = Landings {
            places: vec![[1.0, 2.0], [3.0, 4.0]],
            mean: [2.0, 3.0],
            ellipses: vec![vec![[1.0, 2.0], [3.0, 4.0], [1.0, 2.0]]],
        };
        let text = landings("a & b", &Origin::parse("47.5,8.5").unwrap(), &made);
        assert!(text.contains("<name>a &amp; b</name>"));
        assert_eq!(text.matches("<Point>").count(), 4);
        assert!(text.contains("8.50000000,47.50000000,0"));
    }
}

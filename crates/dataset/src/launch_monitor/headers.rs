//! Headers of launch monitors: which quantity they name, and in which unit.

use crate::summary::{SummaryQuantity as Q, SummaryUnit};

/// Headers of launch monitors, without spaces, signs and units; those of a quantity with sides, to the right or left.
const HEADERS: [(Q, &str); 17] = [
    (Q::Speed, "ballspeed speed releasespeed throwspeed"),
    (
        Q::Launch,
        "launchangle launchang vla launch verticallaunchangle",
    ),
    (
        Q::Heading,
        "launchdirection launchdir hla horizontallaunchangle azimuth sideangle pushpull",
    ),
    (Q::Nose, "noseangle nose"),
    (Q::Hyzer, "hyzerangle hyzer"),
    (Q::Spin, "spinrate totalspin spin"),
    (Q::SpinAxis, "spinaxis spintiltaxis"),
    (Q::Height, "releaseheight launchheight"),
    (Q::Wobble, "wobble wobbleangle"),
    (
        Q::Carry,
        "carryflatlength carrylength carry carrydistance carrydist",
    ),
    (
        Q::Side,
        "carryflatside carryside side offline carryoffline carrydeviation",
    ),
    (
        Q::ApexHeight,
        "maxheightheight height maxheight peakheight apex apexheight",
    ),
    (Q::ApexDistance, "maxheightdist apexdistance"),
    (Q::HangTime, "carryflattime hangtime flighttime airtime"),
    (
        Q::LandingSpeed,
        "carryflatballspeed landingspeed carryballspeed",
    ),
    (
        Q::LandingAngle,
        "carryflatlandangle landangle landingangle descentangle carrylandangle",
    ),
    (Q::FinalSpin, "landingspin finalspin"),
];

/// Quantity of a header, as it is a key of [`HEADERS`].
fn known(key: &str) -> Option<Q> {
    let is_own = |(_, all): &&(Q, &str)| all.split(' ').any(|own| own == key);
    HEADERS.iter().find(is_own).map(|(quantity, _)| *quantity)
}

/// Headers that are these quantities only if the column has a unit of theirs: `Ball` may be the type of the ball.
const WITH_UNIT: [(Q, &str); 2] = [(Q::Speed, "ball"), (Q::SpinAxis, "axis")];

/// Quantity of a column, by the key of its header and its unit.
pub(super) fn quantity(key: &str, unit: Option<SummaryUnit>) -> Option<Q> {
    let own = WITH_UNIT.iter().find(|(_, own)| *own == key);
    match (own, unit) {
        (Some((quantity, _)), Some(unit)) => {
            (unit.dimension() == quantity.dimension()).then_some(*quantity)
        }
        _ => known(key),
    }
}

/// Ends of headers that are units, as in `speedMph`.
const ENDINGS: [(&str, &str); 8] = [
    ("mph", "mph"),
    ("kmh", "km/h"),
    ("mps", "m/s"),
    ("rpm", "rpm"),
    ("yds", "yd"),
    ("yards", "yd"),
    ("feet", "ft"),
    ("degrees", "deg"),
];

/// Header without unit, as the keys of [`HEADERS`], and the unit that it names in brackets or at its end.
pub(super) fn read_header(header: &str) -> (String, Option<SummaryUnit>) {
    let mut unit = None;
    let mut bare = header.to_owned();
    if let Some((before, rest)) = header.split_once(['(', '['])
        && let Some((inside, after)) = rest.split_once([')', ']'])
        && let Some(own) = SummaryUnit::parse(inside)
    {
        (unit, bare) = (Some(own), format!("{before}{after}"));
    }
    let mut key: String = bare.chars().filter(|c| c.is_alphanumeric()).collect();
    key.make_ascii_lowercase();
    if unit.is_none() && known(&key).is_none() {
        let ending = ENDINGS.iter().find(|(end, _)| key.ends_with(end));
        if let Some((end, name)) = ending {
            key.truncate(key.len() - end.len());
            unit = SummaryUnit::parse(name);
        }
    }
    (key, unit)
}

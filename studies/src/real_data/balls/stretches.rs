//! Stretches of the recording in which every flight's lift points to the side that its stated spin implies.

use dataset::Dataset;

/// First and last file number (both included) of each part of the recording in which every lift agrees with the spin ω
/// that the data state, that is, points to the side of ω × v for the velocity v. The parts were chosen by the computed
/// cosines between lift and ω × v.
pub(super) const AGREEING: [(u32, u32); 2] = [(2, 54), (139, 213)];

/// Number formed by the digits in the file name of a flight; 0 if it has none.
pub(super) fn number(file: &str) -> u32 {
    let digits: String = file.chars().filter(char::is_ascii_digit).collect();
    digits.parse().unwrap_or(0)
}

/// Whether the number in the file name of a flight is in one of the two ranges in which every lift agrees with the spin
/// that the data state.
pub fn is_agreeing(file: &str) -> bool {
    let number = number(file);
    let mut stretches = AGREEING.iter();
    stretches.any(|(first, last)| (*first..=*last).contains(&number))
}

/// Returns the dataset restricted to those parts of the recording in which every lift agrees with the spin that the
/// data state.
pub(super) fn agreeing(flights: &Dataset) -> Dataset {
    let mut part = flights.clone();
    part.flights.retain(|flight| is_agreeing(&flight.file));
    part
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stretches_are_of_numbers() {
        assert!(is_agreeing("flight054.csv") && !is_agreeing("flight056.csv"));
        assert!(is_agreeing("flight139.csv") && !is_agreeing("flight291.csv"));
    }
}

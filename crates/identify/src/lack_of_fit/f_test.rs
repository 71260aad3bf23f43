//! Survival function of the F distribution, approximated for large degrees of freedom.

use statrs::function::erf::erfc;

/// Probability that an F variable with degrees of freedom (`dof1`, `dof2`) exceeds `value`, by Paulson's normal
/// approximation of the variable's cube root. 1 if an argument is not positive.
pub(super) fn f_survival(value: f64, (dof1, dof2): (f64, f64)) -> f64 {
    if !(dof1 > 0.0 && dof2 > 0.0 && value > 0.0) {
        return 1.0;
    }
    let (a, b) = (2.0 / (9.0 * dof1), 2.0 / (9.0 * dof2));
    let root = value.cbrt();
    let z = ((1.0 - b) * root - (1.0 - a)) / (b * root * root + a).sqrt();
    erfc(z / std::f64::consts::SQRT_2) / 2.0
}

/// Lack-of-fit statistic, with its expectation and the variance that results from the estimation of the noise; tested
/// as an F variable.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct ScaledStatistic {
    /// Test statistic: sum of squares over the estimated noise variance.
    pub value: f64,
    /// Expectation of the statistic under the null hypothesis: its degrees of freedom.
    pub degrees_of_freedom: f64,
    /// Additional variance of the statistic because the noise is estimated, beyond the variance of χ² with `degrees_of_freedom`
    /// degrees of freedom.
    pub noise_variance: f64,
}

impl ScaledStatistic {
    /// Adds `other`, a statistic with an independent estimate of the noise variance, such as from another flight.
    pub fn add(&mut self, other: &Self) {
        self.value += other.value;
        self.degrees_of_freedom += other.degrees_of_freedom;
        self.noise_variance += other.noise_variance;
    }

    /// p-value of the statistic under the null hypothesis, by the F distribution.
    pub fn p_value(&self) -> f64 {
        if self.degrees_of_freedom <= 0.0 {
            return 1.0;
        }
        let relative = self.noise_variance / (self.degrees_of_freedom * self.degrees_of_freedom);
        let dof2 = 2.0 / relative.max(1e-9);
        f_survival(
            self.value / self.degrees_of_freedom,
            (self.degrees_of_freedom, dof2),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tails_are_those_of_tables() {
        // 1 % and 5 % points of F(10, 20), F(60, 120), F(5, 1e6) = chi squared(5) / 5.
        for (value, degrees_of_freedom, expected) in [
            (3.368, (10.0, 20.0), 0.01),
            (2.348, (10.0, 20.0), 0.05),
            (1.656, (60.0, 120.0), 0.01),
            (3.017, (5.0, 1e9), 0.01),
        ] {
            let found = f_survival(value, degrees_of_freedom);
            assert!((found / expected - 1.0).abs() < 0.06, "{found} {expected}");
        }
        assert_eq!(f_survival(0.0, (3.0, 3.0)), 1.0);
    }
}

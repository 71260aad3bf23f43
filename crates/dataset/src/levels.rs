//! Levels that hold for screening and fits: what counts as noise, as the same, as far above the noise. Ratios are those of
//! residual scales, robust standard deviations of residuals, to the noise or to the scales of other flights. Simulated
//! flights with wrong models, outliers and wrong starts, whose fits must arrive, set their values.

/// Ratio up to which residuals are at the noise, and equal.
pub const AT_NOISE: f64 = 1.1;

/// Ratio up to which residuals are near the noise: a model that leaves more does not describe the flights in detail.
pub const NEAR_NOISE: f64 = 1.3;

/// Ratio up to which residuals of a single flight, or from a single step, may be noise.
pub const ROUGHLY_NOISE: f64 = 2.0;

/// Ratio above which residuals are far above the noise or unlike those of others: the model is wrong, or the minimum.
pub const FAR_ABOVE: f64 = 3.0;

/// Ratio above which a flight is none of the same body, or nothing can be said of a fit.
pub const HOPELESS: f64 = 10.0;

/// Ratio to the residuals before, at which those of another start or scale are clearly smaller.
pub const CLEARLY_SMALLER: f64 = 0.7;

/// Number of standard errors at which a difference is significant, and of standard deviations at which a value is an
/// outlier; noise exceeds it once in two million.
pub const SIGNIFICANT: f64 = 5.0;

/// Least noise of a coordinate that residuals are held against, m: rounding and integration errors contribute to them.
pub const LEAST_NOISE: f64 = 1e-5;

/// Ratio of a variance to the median of many above which a sample contains an outlier.
pub const OUTLIER_VARIANCE: f64 = SIGNIFICANT * SIGNIFICANT;

/// Number of robust standard deviations above which a value is unlike the others; smooth paths are rarely as wrong.
pub const UNLIKE: f64 = 4.0;

/// Relative standard error of a robust standard deviation of normal values, times the root of their number.
pub const ROBUST_ERROR: f64 = 1.17;

/// Relative size of what rounding leaves of a quantity that is zero; also the increase of the diagonal of a normal
/// matrix, which makes it invertible.
pub const ROUNDING: f64 = 1e-9;

/// Ratio of a time between samples, or a time span of several, to the usual one, above which samples are missing.
pub const MAX_GAP: f64 = 1.5;

/// Eigenvalue or squared pivot of a matrix with unit diagonal, or singular value relative to the greatest, below which a
/// direction depends on the others.
pub const RANK: f64 = 1e-12;

/// Number of neighbours on each side of a sample by which it is judged; two of them may be outliers.
pub const NEIGHBOURS: usize = 4;

/// Number of samples from which the noise of a series is estimated.
pub const MIN_SERIES: usize = 20;

/// Number of flights from which statements are made of the differences between flights.
pub const MIN_POPULATION: usize = 4;

/// Standard error of a direction, in typical magnitudes, above which the flights do not show it at all.
pub const CONFOUNDED: f64 = 1e3;

/// Ratio of a misfit to the least one up to which another meaning of readings is as good.
pub const AS_GOOD: f64 = 1.2;

/// Greatest delay of readings that is compared, in intervals between them.
pub const MAX_DELAY: i32 = 12;

/// Whether a ratio of sums of squares is clearly above that of noise of unknown size: by twice the gain of the
/// log-likelihood of this number of values.
pub fn is_clear(ratio: f64, count: f64) -> bool {
    ratio > NEAR_NOISE * NEAR_NOISE && count * ratio.ln() > SIGNIFICANT * SIGNIFICANT
}

//! Keys by which things that are nearly the same become neighbours when they are sorted.

/// Weights in no simple ratio: the fractional parts of the square roots of the first nine
/// primes.
const WEIGHTS: [f64; 9] = [
    0.414213562373,
    0.732050807569,
    0.236067977500,
    0.645751311065,
    0.316624790355,
    0.605551275464,
    0.123105625618,
    0.358898943541,
    0.795831523313,
];

/// A number that differs by no more than rounding between lists that do, and hardly ever
/// between others by so little.
pub fn near_key(numbers: &[f64; 9]) -> f64 {
    numbers.iter().zip(WEIGHTS).map(|(x, w)| x * w).sum()
}

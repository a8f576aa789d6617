//! Intervals that are drawn in proportion to their lengths, from lists of running sums.

/// Intervals for each entry of a guide.
const PER_ENTRY: usize = 8;

/// Where to look for a number among running sums: a search from there on reads one or two lines of
/// memory, where halving would read one at each step.
#[derive(Clone, Debug, Default)]
pub struct Guides {
    /// Sums in a list.
    length: usize,
    /// Equal parts of the range of numbers, by each of which a list's first interval is known.
    parts: usize,
    /// Those intervals, list by list, and the last interval of each that is longer than nothing.
    firsts: Vec<u32>,
    lasts: Vec<u32>,
}

impl Guides {
    /// The guides to lists of so many sums each, which do not fall within a list.
    pub fn new(sums: &[f64], length: usize) -> Self {
        let parts = length.div_ceil(PER_ENTRY);
        let mut guides = Self {
            length,
            parts,
            firsts: Vec::with_capacity(sums.len() / length * parts),
            lasts: Vec::with_capacity(sums.len() / length),
        };
        for sums in sums.chunks_exact(length) {
            let total = sums[length - 1];
            let mut first = 0;
            for part in 0..parts {
                // Lower than what any number of the part becomes by rounding.
                let least = part as f64 / parts as f64 * total * (1.0 - 4.0 * f64::EPSILON);
                while first < length && sums[first] <= least {
                    first += 1;
                }
                guides.firsts.push(first as u32);
            }
            let last = sums.partition_point(|&sum| sum < total);
            guides.lasts.push(last as u32);
        }
        guides
    }

    /// Where the search in a list starts for a number from 0 to 1.
    #[inline(always)]
    pub fn start(&self, sums: &[f64], list: usize, u: f64) -> Start {
        let target = u * sums[(list + 1) * self.length - 1];
        let part = ((u * self.parts as f64) as usize).min(self.parts - 1);
        let first = self.firsts[list * self.parts + part] as usize;
        Start { target, first }
    }

    /// The interval of a list with the number that was looked for, and the way through it: the
    /// first that ends beyond the number. Those without length are never chosen. Over all numbers
    /// the search takes about [`PER_ENTRY`] steps on average at most, whatever the lengths are.
    #[inline(always)]
    pub fn choose(&self, sums: &[f64], list: usize, start: Start) -> (usize, f64) {
        let sums = &sums[list * self.length..(list + 1) * self.length];
        let Start { target, first } = start;
        let beyond = sums[first..].iter().position(|&sum| sum > target);
        let last = self.lasts[list] as usize;
        let chosen = beyond.map_or(last, |steps| (first + steps).min(last));
        let below = if chosen == 0 { 0.0 } else { sums[chosen - 1] };
        let through = (target - below) / (sums[chosen] - below);
        (chosen, through.clamp(0.0, 1.0))
    }
}

/// A number among the sums of a list, and the first interval that it can be in.
#[derive(Clone, Copy, Debug, Default)]
pub struct Start {
    target: f64,
    first: usize,
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Lists of all kinds are searched as by halving, also at the ends of intervals and of parts.
    #[test]
    fn guides_lead_to_what_halving_finds() {
        for length in [1, 2, 7, 8, 9, 100] {
            let lists = [0, 1, 2, 3, 4].map(|kind| {
                let mut sum = 0.0;
                let lengths = (0..length).map(|i| match (kind, i) {
                    (0, _) => 1.0,
                    // One that is much longer, and many without length.
                    (1, i) if i == length / 2 => 1e6,
                    (1, _) => 1e-3,
                    (2, i) => f64::from(u8::from(i % 5 == 3 || i == 0)),
                    (3, i) => (i as f64 * 0.618_034).fract().powi(8),
                    _ => 0.0,
                });
                let sums = lengths.map(|length| {
                    sum += length;
                    sum
                });
                sums.collect::<Vec<f64>>()
            });
            let sums = lists.concat();
            let guides = Guides::new(&sums, length);
            for (list, own) in lists.iter().enumerate() {
                let total = own[length - 1];
                let ends = own.iter().map(|sum| sum / total);
                let parts = (0..=100).map(|i| f64::from(i) / 100.0);
                let numbers = ends.chain(parts).filter(|u| u.is_finite());
                for u in numbers.flat_map(|u| [u, u.next_down().max(0.0), u.next_up().min(1.0)]) {
                    let last = own.partition_point(|&sum| sum < total);
                    let expected = own.partition_point(|&sum| sum <= u * total).min(last);
                    let start = guides.start(&sums, list, u);
                    let (chosen, through) = guides.choose(&sums, list, start);
                    assert_eq!(chosen, expected, "{length} {list} {u}");
                    assert!((0.0..=1.0).contains(&through) || total == 0.0);
                }
            }
        }
    }
}

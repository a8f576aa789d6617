//! Times as people write them.

use std::time::Duration;

/// The time in a text such as `30`, `30s`, `1.5m` or `1h`: above 0 and below 10⁹ seconds;
/// otherwise what was expected.
pub fn parse_duration(text: &str) -> Result<Duration, String> {
    let (number, unit) = match text.trim_end_matches(['s', 'm', 'h']) {
        number if text.ends_with('m') => (number, 60.0),
        number if text.ends_with('h') => (number, 3600.0),
        number => (number, 1.0),
    };
    let seconds = number.parse::<f64>().map(|x| x * unit);
    match seconds {
        Ok(s) if s > 0.0 && s < 1e9 && text.len() <= number.len() + 1 => {
            Ok(Duration::from_secs_f64(s))
        }
        _ => Err("expected a time above 0, for example 30s, 5m or 1h".into()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn durations() {
        assert_eq!(parse_duration("90"), Ok(Duration::from_secs(90)));
        assert_eq!(parse_duration("1.5m"), Ok(Duration::from_secs(90)));
        assert_eq!(parse_duration("2h"), Ok(Duration::from_secs(7200)));
        for bad in ["", "s", "0", "-3", "nan", "5ms", "1e30"] {
            assert!(parse_duration(bad).is_err(), "{bad}");
        }
    }
}

//! Range checks of numbers.

use super::declaration::Param;
use super::kind_error::KindError;
use serde_json::Value;

/// Checks that the numbers among the values of `params` are in their declared ranges.
pub(crate) fn check_ranges(params: &[Param], values: &Value) -> Result<(), KindError> {
    for param in params {
        let [least, greatest] = param.range;
        let check = |value: &Value, path: String| match value.as_f64() {
            Some(number) if !(least..=greatest).contains(&number) => {
                let message = match greatest {
                    f64::INFINITY => format!("found {number}, expected a number from {least}"),
                    _ => format!("found {number}, expected a number from {least} to {greatest}"),
                };
                Err(KindError::Params { path, message })
            }
            _ => Ok(()),
        };
        match &values[param.id] {
            Value::Array(several) => (0..)
                .zip(several)
                .try_for_each(|(i, value)| check(value, format!("{}[{i}]", param.id)))?,
            value => check(value, param.id.to_owned())?,
        }
    }
    Ok(())
}

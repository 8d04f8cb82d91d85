//! What a shader costs beyond the shader around it.

use serde::Serialize;

use super::StaticCost;
use crate::CheckError;

/// The difference of two static costs. Registers and spills are not in it, as they do not add up.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct NetCost {
    /// Instructions.
    pub instructions: i64,
    /// Cycles in which one wave keeps the busiest unit from others.
    pub inverse_throughput: i64,
    /// Cycles from the first to the last instruction of one wave.
    pub latency: i64,
    /// Bytes of machine code.
    pub code_size: i64,
}

/// Subtracts the cost of a baseline, such as an empty shader with the same inputs.
///
/// A difference is negative where the baseline costs more.
///
/// # Errors
/// [`CheckError::Input`] when the two were not compiled by the same driver for the same family.
pub fn net(cost: &StaticCost, baseline: &StaticCost) -> Result<NetCost, CheckError> {
    if cost.family != baseline.family || cost.driver_version != baseline.driver_version {
        return Err(CheckError::Input(format!(
            "a cost on {} ({}) cannot be compared with one on {} ({}): compile both with the same driver for the same \
             family",
            cost.family, cost.driver_version, baseline.family, baseline.driver_version
        )));
    }
    let difference = |of: fn(&StaticCost) -> u64| {
        let signed = |cost| i64::try_from(of(cost)).unwrap_or(i64::MAX);
        signed(cost) - signed(baseline)
    };
    Ok(NetCost {
        instructions: difference(|cost| cost.instructions),
        inverse_throughput: difference(|cost| cost.inverse_throughput),
        latency: difference(|cost| cost.latency),
        code_size: difference(|cost| cost.code_size),
    })
}

//! A kernel that reads its inputs, writes its outputs, and does nothing else.

use crate::CheckError;
use crate::judge::wgsl_to_spirv;

/// The name of the kernel's entry point.
pub(super) const ENTRY: &str = "main";

/// The most inputs or outputs of a point that a kernel is written for.
const MOST_NUMBERS: usize = 1_024;

/// The kernel as SPIR-V. Each output is the sum of all inputs, which are read once.
pub(super) fn copy_kernel(workgroup_size: u32, inputs: usize, outputs: usize) -> Result<Vec<u32>, CheckError> {
    if workgroup_size == 0 {
        return Err(CheckError::Input("the workgroup size is 0: at least 1 is needed".to_owned()));
    }
    for (what, count) in [("inputs", inputs), ("outputs", outputs)] {
        if count == 0 {
            return Err(CheckError::Input(format!("a kernel to be timed has no {what}: a point needs at least one")));
        }
        if count > MOST_NUMBERS {
            let what = format!("the number of {what} of a point that is timed");
            return Err(CheckError::Limit { what, asked: count as u64, allowed: MOST_NUMBERS as u64 });
        }
    }
    let mut text = format!(
        "@group(0) @binding(0) var<storage, read> inputs: array<f32>;
@group(0) @binding(1) var<storage, read_write> outputs: array<f32>;

@compute @workgroup_size({workgroup_size})
fn {ENTRY}(@builtin(global_invocation_id) id: vec3<u32>) {{
    let point = id.x;
    if (point >= arrayLength(&outputs) / {outputs}u) {{
        return;
    }}
    var sum = inputs[point * {inputs}u];
"
    );
    for input in 1..inputs {
        text.push_str(&format!("    sum += inputs[point * {inputs}u + {input}u];\n"));
    }
    for output in 0..outputs {
        text.push_str(&format!("    outputs[point * {outputs}u + {output}u] = sum;\n"));
    }
    text.push_str("}\n");
    wgsl_to_spirv("the kernel that only reads and writes", &text)
}

//! Whether there is memory for what a scene becomes, before it is taken.

use std::fs;

/// What a triangle takes in a scene that is ready to be rendered, bytes: in its shape's mesh, in
/// the joined mesh and in the tree for rays. Measured with 10 and with 40 tessellated spheres: 271
/// and 272.
pub const OF_TRIANGLE: u64 = 272;

/// The part of it in its shape's mesh, with normals and texture coordinates: half a vertex, and a
/// face.
pub const OF_TRIANGLE_OF_SHAPE: u64 = 84;

/// What a triangle takes besides where something moves, bytes: its edges, their tree, and what
/// edges are sampled with. Measured with 10 tessellated spheres: 1,036.
pub const OF_MOVING_TRIANGLE: u64 = 1036;

/// What a triangle takes besides where it emits light, bytes: to be sampled. Measured with 3000
/// spheres of 1280 triangles: 210.
pub const OF_EMITTING_TRIANGLE: u64 = 210;

/// What a texel of an environment map takes besides its colour, bytes: to be sampled.
pub const OF_SKY_TEXEL: u64 = 16;

/// How many bytes can be taken, where the system says that: what the machine has free, what the
/// control group of the process leaves of its limit, and what `ulimit -v` leaves.
pub fn available() -> Option<u64> {
    let text = |path: &str| fs::read_to_string(path).ok();
    let of_machine = text("/proc/meminfo").and_then(|text| of_meminfo(&text));
    let number = |path| text(path)?.trim().parse::<u64>().ok();
    // A container may have less than its machine.
    let of_group = number("/sys/fs/cgroup/memory.max")
        .zip(number("/sys/fs/cgroup/memory.current"))
        .map(|(most, taken)| most.saturating_sub(taken));
    let of_process = text("/proc/self/limits")
        .zip(text("/proc/self/status"))
        .and_then(|(limits, status)| of_limits(&limits, &status));
    [of_machine, of_group, of_process]
        .into_iter()
        .flatten()
        .min()
}

/// Bytes for people, in MiB, rounded up.
pub fn mib(bytes: u64) -> u64 {
    bytes.div_ceil(1 << 20)
}

fn of_meminfo(text: &str) -> Option<u64> {
    kib_of(text, "MemAvailable:")
}

/// What is left of the largest address space.
fn of_limits(limits: &str, status: &str) -> Option<u64> {
    let mut lines = limits.lines();
    let limit = lines.find_map(|line| line.strip_prefix("Max address space"))?;
    // "unlimited" is no number.
    let most: u64 = limit.split_whitespace().next()?.parse().ok()?;
    Some(most.saturating_sub(kib_of(status, "VmSize:")?))
}

/// The number of KiB in a line of one of the kernel's tables, in bytes.
fn kib_of(text: &str, name: &str) -> Option<u64> {
    let line = text.lines().find_map(|line| line.strip_prefix(name))?;
    let kib: u64 = line.trim().strip_suffix(" kB")?.parse().ok()?;
    kib.checked_mul(1 << 10)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_linux_says() {
        let text = "MemTotal:       24604192 kB\nMemAvailable:   23265440 kB\n";
        assert_eq!(of_meminfo(text), Some(23_265_440 << 10));
        assert_eq!(of_meminfo("MemTotal: 1 kB"), None);
        let limits = "Max cpu time  unlimited  unlimited  seconds\n\
                      Max address space         8388608              unlimited            bytes\n";
        let status = "Name:\tcapwalk\nVmSize:\t    2048 kB\n";
        assert_eq!(of_limits(limits, status), Some((8 << 20) - (2 << 20)));
        assert_eq!(
            of_limits(&limits.replace("8388608", "unlimited"), status),
            None
        );
        if cfg!(target_os = "linux") {
            assert!(available().is_some_and(|free| free > 1 << 20));
        }
    }
}

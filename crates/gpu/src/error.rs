//! Why a batch has no answers, and what to do about it.

use std::time::Duration;

/// Why something could not be done on the device. Nothing is half done after any of them:
/// a batch has all its answers, or none.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GpuError {
    /// There is nothing to run on.
    #[error(
        "no GPU: {reason}. Install the driver of the GPU, or software Vulkan (on Debian and \
         Ubuntu `apt-get install mesa-vulkan-drivers`), or use the CPU"
    )]
    NoAdapter {
        /// What was looked for.
        reason: String,
    },
    /// The adapter cannot do what is needed, or would not.
    #[error("{adapter} cannot be used: {reason}. Update its driver, or use the CPU")]
    Unusable {
        /// The adapter's name.
        adapter: String,
        /// What its driver said.
        reason: String,
    },
    /// The driver gave the device up: unplugged, reset, or destroyed.
    #[error(
        "{adapter} was lost ({reason}). Open it again and upload the trees again, or use the CPU"
    )]
    DeviceLost {
        /// The adapter's name.
        adapter: String,
        /// What its driver said.
        reason: String,
    },
    /// There is no memory for the tree, or not even for the smallest batch.
    #[error(
        "{adapter} has no memory for {bytes} bytes. Close other programs that use it, or use the CPU"
    )]
    OutOfMemory {
        /// The adapter's name.
        adapter: String,
        /// What did not fit.
        bytes: u64,
    },
    /// A tree cannot be cut into parts, and this one is larger than what one buffer of
    /// the device can hold.
    #[error(
        "the tree needs a buffer of {bytes} bytes, but {adapter} allows {limit}. Use a coarser \
         mesh or the CPU"
    )]
    TreeTooLarge {
        /// The adapter's name.
        adapter: String,
        /// The largest array of the tree.
        bytes: u64,
        /// The largest buffer of the device.
        limit: u64,
    },
    /// A tree follows only the vertices of the mesh that it was built from.
    #[error(
        "the tree cannot be refitted: {reason}. Give it the mesh it was built from, with other \
         positions, or upload a new tree"
    )]
    OtherMesh {
        /// What is wrong with the mesh.
        reason: String,
    },
    /// The device did not answer in time. Its work cannot be taken back: it may go on.
    #[error(
        "{adapter} did not finish {queries} queries within {} s. Allow more (`GpuOptions::timeout`), or use \
         the CPU",
        .allowed.as_secs_f64()
    )]
    Timeout {
        /// The adapter's name.
        adapter: String,
        /// Queries of the launch.
        queries: usize,
        /// How long was waited.
        allowed: Duration,
    },
    /// The driver ended loops early and went on, so all results would be wrong. Mesa's software device
    /// does so where a kernel has much to do.
    #[error(
        "{adapter} ended loops early, in {threads} threads or more (Mesa's software device allows all loops \
         of eight threads 65,535 rounds together): use the CPU, or a GPU"
    )]
    CutShort {
        /// The adapter's name.
        adapter: String,
        /// How many threads noticed it.
        threads: u32,
    },
    /// The driver refused a kernel, a buffer, or a launch: a bug of this program or of the
    /// driver.
    #[error("{adapter} refused: {reason}. Please report this, and use the CPU meanwhile")]
    Refused {
        /// The adapter's name.
        adapter: String,
        /// What the driver said.
        reason: String,
    },
}

//! The device that everything runs on, chosen once.

use std::collections::BTreeMap;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;

use crate::compiled_kernel::CompiledKernel;
use crate::copies::Copies;
use crate::cuda_driver::CudaDriver;
use crate::driver::{Driver, Memory};
use crate::error::GpuError;
use crate::launch::{ARRAYS, Fault, Launch, locked};
use crate::precision::Precision;
use crate::wgpu_driver::WgpuDriver;

/// Queries of the first launch of a kernel, when it is not known yet how long they take.
const FIRST: usize = 1 << 12;

/// No launch on a GPU has fewer groups of threads than about run at once: on most, fewer take as long.
const GROUPS_AT_ONCE: usize = 64;

/// How many times as long as others a launch may take that a software device compiles a kernel for.
const COMPILING: u32 = 10;

/// How the device is reached.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Interface {
    /// Vulkan, Metal or DX12, through wgpu: GPUs of every vendor, and software.
    Wgpu,
    /// The driver of NVIDIA.
    Cuda,
}

/// How the device is opened and used.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct GpuOptions {
    /// Part of the name of the adapter, in any case; the fastest kind if `None`.
    pub adapter: Option<String>,
    /// How it is reached; if `None`, through wgpu, or by CUDA where wgpu finds no GPU.
    pub interface: Option<Interface>,
    /// The precision of the tests; the best that the device has if `None`.
    pub precision: Option<Precision>,
    /// No buffer is larger than this, bytes; the device's own limit if `None`. Batches are
    /// cut to fit.
    pub largest_buffer: Option<u64>,
    /// A launch should take about this long: screens of a GPU that also shows a desktop
    /// stand still meanwhile. It takes longer where 64 groups of threads do.
    pub launch: Duration,
    /// A launch that takes longer than this is an error. The first one of a kernel may take ten
    /// times as long on a software device, which compiles it then.
    pub timeout: Duration,
}

impl Default for GpuOptions {
    fn default() -> Self {
        Self {
            adapter: None,
            interface: None,
            precision: None,
            largest_buffer: None,
            launch: Duration::from_millis(50),
            timeout: Duration::from_secs(60),
        }
    }
}

/// An open device. Trees are uploaded to it (`DeviceRayTree`, `DeviceSilhouetteTree`).
#[derive(Debug)]
pub struct Gpu {
    driver: Driver,
    options: GpuOptions,
    precision: Precision,
    /// For each kernel that has run, the queries that a launch should have.
    pace: Mutex<BTreeMap<(&'static str, usize), usize>>,
    /// Nanoseconds that launches took.
    busy: AtomicU64,
    /// Larger pieces of memory are refused.
    memory: AtomicU64,
    copies: Mutex<Copies>,
}

impl Gpu {
    /// Opens the adapter that is asked for, or else the fastest kind there is: a GPU of
    /// its own before one that shares the CPU's memory before software.
    pub fn new(options: &GpuOptions) -> Result<Self, GpuError> {
        let (driver, precision) = open(options)?;
        Ok(Self {
            driver,
            precision,
            options: options.clone(),
            pace: Mutex::default(),
            busy: AtomicU64::new(0),
            memory: AtomicU64::new(u64::MAX),
            copies: Mutex::default(),
        })
    }

    /// The adapter's name.
    pub fn name(&self) -> &str {
        self.driver.name()
    }

    /// The driver and its version, as it calls itself.
    pub fn driver(&self) -> String {
        self.driver.version()
    }

    /// How it is reached.
    pub fn interface(&self) -> Interface {
        match self.driver {
            Driver::Wgpu(_) => Interface::Wgpu,
            Driver::Cuda(_) => Interface::Cuda,
        }
    }

    /// True if the adapter is a program on the CPU, so that no figure is a GPU's.
    pub fn is_software(&self) -> bool {
        self.driver.is_software()
    }

    /// The precision of the tests of triangles and edges.
    pub fn precision(&self) -> Precision {
        self.precision
    }

    /// How long kernels have run so far, by the CPU's clock: from each launch until it
    /// was known to be done, without queries and answers on their way.
    pub fn busy(&self) -> Duration {
        Duration::from_nanos(self.busy.load(Ordering::Relaxed))
    }

    /// Gives the device up, as if it were unplugged: every later call is an error.
    pub fn destroy(&self) {
        self.driver.destroy();
    }

    /// The largest buffer, bytes.
    pub fn largest_buffer(&self) -> u64 {
        let wanted = self.options.largest_buffer.unwrap_or(u64::MAX);
        self.driver.largest().min(wanted)
    }

    /// From now on there is no memory for pieces of more bytes, as on a device that is nearly full. For tests.
    #[doc(hidden)]
    pub fn pretend_memory(&self, bytes: u64) {
        self.memory.store(bytes, Ordering::Relaxed);
    }

    /// An error if the device is lost.
    pub fn check(&self) -> Result<(), GpuError> {
        self.driver.check().map_err(|fault| self.error(fault, 0))
    }

    /// A new piece of memory with undefined content.
    pub(crate) fn allocate(&self, bytes: u64) -> Result<Memory, GpuError> {
        let memory = match bytes > self.memory.load(Ordering::Relaxed) {
            true => Err(Fault::OutOfMemory),
            false => self.driver.allocate(bytes),
        };
        memory.map_err(|fault| self.error(fault, bytes))
    }

    /// Fills the first bytes of a piece.
    pub(crate) fn upload(&self, to: &Memory, bytes: &[u8]) -> Result<(), GpuError> {
        let copied = self.driver.upload(to, bytes, self.options.timeout);
        copied.map_err(|fault| self.error(fault, bytes.len() as u64))
    }

    /// Reads the first bytes of a piece.
    pub(crate) fn download(&self, from: &Memory, to: &mut [u8]) -> Result<(), GpuError> {
        let bytes = to.len() as u64;
        let read = self.driver.download(from, to, self.options.timeout);
        read.map_err(|fault| self.error(fault, bytes))
    }

    /// The CPU's copies of batches; new ones while another caller has them.
    pub(crate) fn take_copies(&self) -> Copies {
        std::mem::take(&mut *locked(&self.copies))
    }

    /// Keeps them for the next caller.
    pub(crate) fn keep_copies(&self, copies: Copies) {
        *locked(&self.copies) = copies;
    }

    /// Runs a kernel for some queries, cut into launches each of which takes about as long as
    /// the options say.
    pub(crate) fn run(
        &self,
        kernel: &CompiledKernel,
        arrays: [&Memory; ARRAYS],
        whole: Launch,
    ) -> Result<(), GpuError> {
        let groups = if self.is_software() {
            1
        } else {
            GROUPS_AT_ONCE
        };
        let least = groups * kernel.group;
        let mut rest = whole;
        while rest.first < whole.end {
            let known = locked(&self.pace).get(&kernel.key()).copied();
            let size = known.unwrap_or(FIRST);
            let compiles = known.is_none() && self.is_software();
            let times = if compiles { COMPILING } else { 1 };
            let timeout = self.options.timeout * times;
            let launch = Launch {
                end: whole.end.min(rest.first.saturating_add(size as u32)),
                ..rest
            };
            let done = self
                .driver
                .launch(kernel, self.precision, arrays, launch, timeout);
            let took = done.map_err(|fault| match fault {
                Fault::Timeout => GpuError::Timeout {
                    adapter: self.name().to_owned(),
                    queries: launch.queries(),
                    allowed: timeout,
                },
                other => self.error(other, 0),
            })?;
            self.busy
                .fetch_add(took.as_nanos() as u64, Ordering::Relaxed);
            let next = if took > self.options.launch {
                (size / 2).max(least)
            } else if 3 * took < self.options.launch && launch.queries() == size {
                (2 * size).min(kernel.most())
            } else {
                size
            };
            locked(&self.pace).insert(kernel.key(), next);
            rest.first = launch.end;
        }
        Ok(())
    }

    /// What kernels noticed in so many threads.
    pub fn loops_cut_short(&self, threads: u32) -> GpuError {
        GpuError::CutShort {
            adapter: self.name().to_owned(),
            threads,
        }
    }

    /// `bytes` is how much memory was asked for.
    fn error(&self, fault: Fault, bytes: u64) -> GpuError {
        let adapter = self.name().to_owned();
        match fault {
            Fault::OutOfMemory => GpuError::OutOfMemory { adapter, bytes },
            Fault::Lost(reason) => GpuError::DeviceLost { adapter, reason },
            Fault::Timeout => GpuError::Timeout {
                adapter,
                queries: 0,
                allowed: self.options.timeout,
            },
            Fault::Refused(reason) => GpuError::Refused { adapter, reason },
        }
    }
}

/// By the interface that is asked for; or else through wgpu, or by CUDA where that finds no
/// GPU.
fn open(options: &GpuOptions) -> Result<(Driver, Precision), GpuError> {
    let wanted = options.adapter.as_deref();
    let by_wgpu = || {
        WgpuDriver::open(wanted, options.precision)
            .map(|(driver, precision)| (Driver::Wgpu(Box::new(driver)), precision))
    };
    let by_cuda = || {
        // All of NVIDIA's have double precision.
        let precision = options.precision.unwrap_or(Precision::Double);
        CudaDriver::open(wanted).map(|driver| (Driver::Cuda(Box::new(driver)), precision))
    };
    match options.interface {
        Some(Interface::Wgpu) => by_wgpu(),
        Some(Interface::Cuda) => by_cuda(),
        None => match by_wgpu() {
            Ok(found) if !found.0.is_software() => Ok(found),
            found => by_cuda().or_else(|of_cuda| match (&found, &of_cuda) {
                // A device that is there and cannot be used is worth more words than none.
                (Err(_), GpuError::Unusable { .. }) => Err(of_cuda),
                _ => found,
            }),
        },
    }
}

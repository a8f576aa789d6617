//! NVIDIA's devices through their own driver, as on machines for computing, which often have
//! no Vulkan. The driver's library is looked for when it is asked for, so nothing of CUDA is
//! needed to build or to run elsewhere.
#![allow(unsafe_code)]

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use cudarc::driver::sys::CUresult;
use cudarc::driver::{
    CudaContext, CudaFunction, CudaModule, CudaSlice, CudaStream, DevicePtr, DriverError,
    LaunchConfig, result, sys,
};
use cudarc::nvrtc::Ptx;

use crate::compiled_kernel::{CompiledKernel, GROUP};
use crate::error::GpuError;
use crate::launch::{ARRAYS, Fault, Launch, locked};
use crate::precision::Precision;

/// The least that the kernels are compiled for: Volta, 2017.
const LEAST_CAPABILITY: (i32, i32) = (7, 0);

/// The least release of CUDA whose drivers read the kernels, as drivers count: 12.1, which
/// came with driver 530.
const LEAST_RELEASE: i32 = 12010;

/// No piece of memory is larger, bytes: kernels count words in 32 bits.
const LARGEST: u64 = 4 << 32;

/// The name that Slang gives to what a kernel is given: of each array its place and its
/// length (which nothing reads), then the place of the launch's words.
const PARAMETERS: &str = "SLANG_globalParams";

/// How long a wait asks again and again before it sleeps in between.
const SPIN: Duration = Duration::from_millis(2);

/// An open device.
#[derive(Debug)]
pub struct CudaDriver {
    context: Arc<CudaContext>,
    stream: Arc<CudaStream>,
    name: String,
    version: String,
    largest: u64,
    /// Those that were asked for, by their keys.
    kernels: Mutex<BTreeMap<(&'static str, usize), Loaded>>,
    /// The words of a launch; one launch at a time has them, and the kernel's parameters.
    launch: Mutex<CudaSlice<u32>>,
    lost: Mutex<Option<String>>,
}

/// A piece of the device's memory.
#[derive(Debug)]
pub struct CudaMemory(Mutex<CudaSlice<u8>>);

#[derive(Clone, Debug)]
struct Loaded {
    module: Arc<CudaModule>,
    function: CudaFunction,
}

impl CudaDriver {
    /// Opens the first device whose name contains `wanted`.
    pub fn open(wanted: Option<&str>) -> Result<Self, GpuError> {
        let none = |reason: &str| GpuError::NoAdapter {
            reason: reason.to_owned(),
        };
        // SAFETY: loading NVIDIA's library runs its initialisers, which ask for nothing.
        if !unsafe { sys::is_culib_present() } {
            return Err(none("there is no driver of NVIDIA"));
        }
        let refused = |error: DriverError| GpuError::Unusable {
            adapter: "NVIDIA's driver".to_owned(),
            reason: reason(error),
        };
        match result::init() {
            Err(DriverError(
                CUresult::CUDA_ERROR_NO_DEVICE
                | CUresult::CUDA_ERROR_STUB_LIBRARY
                | CUresult::CUDA_ERROR_SYSTEM_DRIVER_MISMATCH
                | CUresult::CUDA_ERROR_SYSTEM_NOT_READY,
            )) => return Err(none("NVIDIA's driver has no device")),
            outcome => outcome.map_err(refused)?,
        }
        let mut release = 0;
        // SAFETY: it writes one number to where it is told to.
        let asked = unsafe { sys::cuDriverGetVersion(&mut release) };
        asked.result().map_err(refused)?;
        if release < LEAST_RELEASE {
            return Err(GpuError::Unusable {
                adapter: "NVIDIA's driver".to_owned(),
                reason: format!(
                    "it is for CUDA {}.{}, and 12.1 (driver 530) is the least",
                    release / 1000,
                    release % 1000 / 10
                ),
            });
        }
        let count = CudaContext::device_count().map_err(refused)?;
        let mut names = Vec::new();
        for ordinal in 0..count {
            let device = result::device::get(ordinal).map_err(refused)?;
            let name = result::device::get_name(device).map_err(refused)?;
            let is_wanted =
                wanted.is_none_or(|wanted| name.to_lowercase().contains(&wanted.to_lowercase()));
            if is_wanted {
                return Self::open_device(ordinal as usize, name);
            }
            names.push(name);
        }
        Err(none(&match wanted {
            Some(wanted) if !names.is_empty() => format!(
                "no adapter's name contains \"{wanted}\"; there are {}",
                names.join(", ")
            ),
            _ => "NVIDIA's driver has no device".to_owned(),
        }))
    }

    fn open_device(ordinal: usize, name: String) -> Result<Self, GpuError> {
        let unusable = |reason: String| GpuError::Unusable {
            adapter: name.clone(),
            reason,
        };
        let refused = |error: DriverError| unusable(reason(error));
        let context = CudaContext::new(ordinal).map_err(refused)?;
        let (major, minor) = context.compute_capability().map_err(refused)?;
        if (major, minor) < LEAST_CAPABILITY {
            let (most, least) = LEAST_CAPABILITY;
            return Err(unusable(format!(
                "it has compute capability {major}.{minor}, and {most}.{least} is the least"
            )));
        }
        let stream = context.default_stream();
        let launch = stream.alloc_zeros(4).map_err(refused)?;
        Ok(Self {
            version: format!("CUDA, compute capability {major}.{minor}"),
            largest: LARGEST.min(context.total_mem().map_err(refused)? as u64),
            context,
            stream,
            name,
            kernels: Default::default(),
            launch: Mutex::new(launch),
            lost: Mutex::new(None),
        })
    }

    pub fn name(&self) -> &str {
        &self.name
    }

    pub fn version(&self) -> String {
        self.version.clone()
    }

    pub fn largest(&self) -> u64 {
        self.largest
    }

    pub fn destroy(&self) {
        locked(&self.lost).get_or_insert_with(|| "it was given up".to_owned());
    }

    pub fn check(&self) -> Result<(), Fault> {
        match &*locked(&self.lost) {
            None => Ok(()),
            Some(reason) => Err(Fault::Lost(reason.clone())),
        }
    }

    pub fn allocate(&self, bytes: u64) -> Result<CudaMemory, Fault> {
        self.check()?;
        // SAFETY: bytes have no invalid value, and unwritten ones are never interpreted.
        let slice = unsafe { self.stream.alloc(bytes as usize) };
        slice
            .map(|slice| CudaMemory(Mutex::new(slice)))
            .map_err(|error| self.fault(error))
    }

    pub fn upload(&self, to: &CudaMemory, bytes: &[u8], timeout: Duration) -> Result<(), Fault> {
        self.check()?;
        if bytes.is_empty() {
            return Ok(());
        }
        self.wait(timeout)?;
        let mut to = locked(&to.0);
        let copied = self.stream.memcpy_htod(bytes, &mut *to);
        copied.map_err(|error| self.fault(error))
    }

    pub fn launch(
        &self,
        kernel: &CompiledKernel,
        precision: Precision,
        arrays: [&CudaMemory; ARRAYS],
        launch: Launch,
        timeout: Duration,
    ) -> Result<Duration, Fault> {
        self.check()?;
        let fault = |error| self.fault(error);
        let loaded = self.loaded(kernel, precision).map_err(fault)?;
        let mut words = locked(&self.launch);
        let started = Instant::now();
        self.launch_now(kernel, &loaded, arrays, launch, &mut words)
            .map_err(fault)?;
        self.wait(timeout)?;
        Ok(started.elapsed())
    }

    fn launch_now(
        &self,
        kernel: &CompiledKernel,
        loaded: &Loaded,
        arrays: [&CudaMemory; ARRAYS],
        launch: Launch,
        words: &mut CudaSlice<u32>,
    ) -> Result<(), DriverError> {
        self.stream.memcpy_htod(&launch.words(), words)?;
        let mut parameters = [0_u64; 2 * ARRAYS + 1];
        for (parameters, memory) in parameters.chunks_exact_mut(2).zip(arrays) {
            let memory = locked(&memory.0);
            parameters.copy_from_slice(&[memory.device_ptr(&self.stream).0, memory.len() as u64]);
        }
        parameters[2 * ARRAYS] = words.device_ptr(&self.stream).0;
        let mut symbol = loaded.module.get_global(PARAMETERS, &self.stream)?;
        self.stream
            .memcpy_htod(bytemuck::cast_slice::<_, u8>(&parameters), &mut symbol)?;
        let shape = LaunchConfig {
            grid_dim: (launch.queries().div_ceil(kernel.group) as u32, 1, 1),
            block_dim: (GROUP as u32, 1, 1),
            shared_mem_bytes: 0,
        };
        // SAFETY: the kernels take no arguments but the parameters, which were set just now,
        // under the lock that `words` is from, to memory that holds all that a kernel reads
        // and writes of these queries. It is there until the launch is done: the caller keeps
        // it while it waits, and if a wait ends before, memory is given back in the order of
        // the one stream that everything here goes through.
        unsafe { self.stream.launch_builder(&loaded.function).launch(shape)? };
        Ok(())
    }

    pub fn download(
        &self,
        from: &CudaMemory,
        to: &mut [u8],
        timeout: Duration,
    ) -> Result<(), Fault> {
        self.check()?;
        self.wait(timeout)?;
        let from = locked(&from.0);
        self.stream
            .memcpy_dtoh(&from.slice(..to.len()), to)
            .and_then(|()| self.stream.synchronize())
            .map_err(|error| self.fault(error))
    }

    /// Waits until all work is done. A device that does not get that far is lost: whatever came
    /// next would wait for it.
    fn wait(&self, timeout: Duration) -> Result<(), Fault> {
        let started = Instant::now();
        let done = self.stream.record_event(None);
        let done = done.map_err(|error| self.fault(error))?;
        while !done.try_is_complete().map_err(|error| self.fault(error))? {
            let waited = started.elapsed();
            if waited > timeout {
                locked(&self.lost).get_or_insert_with(|| "it did not end a launch".to_owned());
                return Err(Fault::Timeout);
            }
            match waited < SPIN {
                true => std::thread::yield_now(),
                false => std::thread::sleep(SPIN / 20),
            }
        }
        Ok(())
    }

    /// The kernel, compiled for this device when it is first asked for.
    fn loaded(&self, kernel: &CompiledKernel, precision: Precision) -> Result<Loaded, DriverError> {
        let mut kernels = locked(&self.kernels);
        if let Some(loaded) = kernels.get(&kernel.key()) {
            return Ok(loaded.clone());
        }
        let module = self
            .context
            .load_module(Ptx::from_src(kernel.ptx_in(precision)))?;
        let function = module.load_function(kernel.name)?;
        let loaded = Loaded { module, function };
        kernels.insert(kernel.key(), loaded.clone());
        Ok(loaded)
    }

    /// What an error means. After those of a kernel, the driver answers nothing any more.
    fn fault(&self, error: DriverError) -> Fault {
        match error.0 {
            CUresult::CUDA_ERROR_OUT_OF_MEMORY => Fault::OutOfMemory,
            CUresult::CUDA_ERROR_ILLEGAL_ADDRESS
            | CUresult::CUDA_ERROR_MISALIGNED_ADDRESS
            | CUresult::CUDA_ERROR_LAUNCH_FAILED
            | CUresult::CUDA_ERROR_LAUNCH_TIMEOUT
            | CUresult::CUDA_ERROR_HARDWARE_STACK_ERROR
            | CUresult::CUDA_ERROR_ILLEGAL_INSTRUCTION
            | CUresult::CUDA_ERROR_INVALID_PC
            | CUresult::CUDA_ERROR_INVALID_ADDRESS_SPACE
            | CUresult::CUDA_ERROR_ASSERT
            | CUresult::CUDA_ERROR_NO_DEVICE
            | CUresult::CUDA_ERROR_UNKNOWN
            | CUresult::CUDA_ERROR_ECC_UNCORRECTABLE
            | CUresult::CUDA_ERROR_DEINITIALIZED
            | CUresult::CUDA_ERROR_CONTEXT_IS_DESTROYED
            | CUresult::CUDA_ERROR_DEVICE_UNAVAILABLE => {
                let reason = locked(&self.lost)
                    .get_or_insert_with(|| reason(error))
                    .clone();
                Fault::Lost(reason)
            }
            _ => Fault::Refused(reason(error)),
        }
    }
}

/// What the driver says to an error.
fn reason(error: DriverError) -> String {
    match error.error_string() {
        Ok(text) => text.to_string_lossy().into_owned(),
        Err(_) => format!("{:?}", error.0),
    }
}

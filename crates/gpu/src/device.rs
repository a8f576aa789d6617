//! The adapter that everything runs on, chosen once, and what it can do.

use std::sync::{Arc, Mutex, OnceLock};
use std::time::Duration;

use crate::error::GpuError;
use crate::kernels::{KERNELS, Kernel};
use crate::precision::Precision;

/// How the device is opened and used.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct GpuOptions {
    /// Part of the name of the adapter, in any case; the fastest kind if `None`.
    pub adapter: Option<String>,
    /// The precision of the tests; the best that the device has if `None`.
    pub precision: Option<Precision>,
    /// No buffer is larger than this, bytes; the device's own limit if `None`. Batches are
    /// cut to fit.
    pub largest_buffer: Option<u64>,
    /// A launch should take about this long: screens of a GPU that also shows a desktop
    /// stand still meanwhile.
    pub launch: Duration,
    /// A launch that takes longer than this is an error.
    pub timeout: Duration,
}

impl Default for GpuOptions {
    fn default() -> Self {
        Self {
            adapter: None,
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
    pub(crate) device: wgpu::Device,
    pub(crate) queue: wgpu::Queue,
    pub(crate) layout: wgpu::BindGroupLayout,
    pub(crate) options: GpuOptions,
    info: wgpu::AdapterInfo,
    precision: Precision,
    largest_buffer: u64,
    pipelines: [OnceLock<wgpu::ComputePipeline>; KERNELS],
    lost: Arc<Mutex<Option<String>>>,
}

impl Gpu {
    /// Opens the adapter that is asked for, or else the fastest kind there is: a GPU of
    /// its own before one that shares the processor's memory before software.
    pub fn new(options: &GpuOptions) -> Result<Self, GpuError> {
        let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
        descriptor.backends = wgpu::Backends::VULKAN | wgpu::Backends::METAL | wgpu::Backends::DX12;
        descriptor.flags = wgpu::InstanceFlags::empty();
        let instance = wgpu::Instance::new(descriptor);
        let adapter = choose(&instance, options.adapter.as_deref())?;
        let info = adapter.get_info();
        let unusable = |reason: String| GpuError::Unusable {
            adapter: info.name.clone(),
            reason,
        };
        let has_double = adapter.features().contains(wgpu::Features::SHADER_F64);
        let precision = match (options.precision, has_double) {
            (Some(Precision::Single), _) | (None, false) => Precision::Single,
            (_, true) => Precision::Double,
            (Some(Precision::Double), false) => {
                return Err(unusable("it has no double precision".to_owned()));
            }
        };
        let of_adapter = adapter.limits();
        let limits = wgpu::Limits {
            max_buffer_size: of_adapter.max_buffer_size,
            max_storage_buffer_binding_size: of_adapter.max_storage_buffer_binding_size,
            ..wgpu::Limits::downlevel_defaults()
        };
        // What queries need beyond the least that wgpu demands of any device.
        let limits = wgpu::Limits {
            max_storage_buffers_per_shader_stage: 8,
            ..limits
        };
        let request = adapter.request_device(&wgpu::DeviceDescriptor {
            label: Some("capwalk"),
            required_features: match precision {
                Precision::Single => wgpu::Features::empty(),
                Precision::Double => wgpu::Features::SHADER_F64,
            },
            required_limits: limits.clone(),
            ..Default::default()
        });
        let (device, queue) =
            pollster::block_on(request).map_err(|error| unusable(error.to_string()))?;
        let lost = Arc::new(Mutex::new(None));
        let noted = lost.clone();
        device.set_device_lost_callback(move |reason, message| {
            let text = match message.is_empty() {
                true => format!("{reason:?}").to_lowercase(),
                false => message,
            };
            if let Ok(mut lost) = noted.lock() {
                *lost = Some(text);
            }
        });
        // Errors are fetched where they arise; one that is not is still no reason to panic.
        device.on_uncaptured_error(Arc::new(|error| log::error!("GPU: {error}")));
        let own = limits
            .max_buffer_size
            .min(limits.max_storage_buffer_binding_size);
        Ok(Self {
            layout: layout(&device),
            device,
            queue,
            info,
            precision,
            largest_buffer: own.min(options.largest_buffer.unwrap_or(u64::MAX)),
            options: options.clone(),
            pipelines: Default::default(),
            lost,
        })
    }

    /// The adapter's name.
    pub fn name(&self) -> &str {
        &self.info.name
    }

    /// The driver and its version, as it calls itself.
    pub fn driver(&self) -> String {
        format!("{} {}", self.info.driver, self.info.driver_info)
    }

    /// True if the adapter is a program on the processor, so that no figure is a GPU's.
    pub fn is_software(&self) -> bool {
        self.info.device_type == wgpu::DeviceType::Cpu
    }

    /// The precision of the tests of triangles and edges.
    pub fn precision(&self) -> Precision {
        self.precision
    }

    /// Gives the device up, as if it were unplugged: every later call is an error.
    pub fn destroy(&self) {
        self.device.destroy();
        let mut lost = self
            .lost
            .lock()
            .unwrap_or_else(|poisoned| poisoned.into_inner());
        lost.get_or_insert_with(|| "it was given up".to_owned());
    }

    /// The largest buffer, bytes.
    pub(crate) fn largest_buffer(&self) -> u64 {
        self.largest_buffer
    }

    /// An error if the device is lost.
    pub(crate) fn check(&self) -> Result<(), GpuError> {
        let lost = self
            .lost
            .lock()
            .unwrap_or_else(|poisoned| poisoned.into_inner());
        match &*lost {
            None => Ok(()),
            Some(reason) => Err(GpuError::DeviceLost {
                adapter: self.name().to_owned(),
                reason: reason.clone(),
            }),
        }
    }

    /// The result of calls of wgpu; or the error that came up in them. `bytes` is how much
    /// memory they ask for.
    pub(crate) fn guarded<T>(
        &self,
        what: &str,
        bytes: u64,
        calls: impl FnOnce() -> T,
    ) -> Result<T, GpuError> {
        self.check()?;
        let memory = self.device.push_error_scope(wgpu::ErrorFilter::OutOfMemory);
        let internal = self.device.push_error_scope(wgpu::ErrorFilter::Internal);
        let validation = self.device.push_error_scope(wgpu::ErrorFilter::Validation);
        let result = calls();
        let refused = pollster::block_on(validation.pop()).or(pollster::block_on(internal.pop()));
        let memory = pollster::block_on(memory.pop());
        self.check()?;
        let adapter = self.name().to_owned();
        if memory.is_some() {
            return Err(GpuError::OutOfMemory { adapter, bytes });
        }
        match refused {
            None => Ok(result),
            Some(error) => Err(GpuError::Refused {
                adapter,
                what: what.to_owned(),
                reason: error.to_string(),
            }),
        }
    }

    /// The kernel, compiled when it is first asked for.
    pub(crate) fn pipeline(&self, kernel: Kernel) -> Result<&wgpu::ComputePipeline, GpuError> {
        let slot = &self.pipelines[kernel as usize];
        if let Some(pipeline) = slot.get() {
            return Ok(pipeline);
        }
        let compiled = self.guarded("a kernel", 0, || {
            let source = kernel.source(self.precision);
            let module = self
                .device
                .create_shader_module(wgpu::ShaderModuleDescriptor {
                    label: Some(kernel.name()),
                    source: wgpu::ShaderSource::Wgsl(source.into()),
                });
            let layout = self
                .device
                .create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
                    label: Some(kernel.name()),
                    bind_group_layouts: &[Some(&self.layout)],
                    ..Default::default()
                });
            self.device
                .create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
                    label: Some(kernel.name()),
                    layout: Some(&layout),
                    module: &module,
                    entry_point: Some(kernel.name()),
                    compilation_options: Default::default(),
                    cache: None,
                })
        })?;
        Ok(slot.get_or_init(|| compiled))
    }
}

/// The adapter whose name contains the wanted one, or the first of the fastest kind.
fn choose(instance: &wgpu::Instance, wanted: Option<&str>) -> Result<wgpu::Adapter, GpuError> {
    let adapters = pollster::block_on(instance.enumerate_adapters(wgpu::Backends::all()));
    let names: Vec<_> = adapters
        .iter()
        .map(|adapter| adapter.get_info().name)
        .collect();
    let is_wanted = |adapter: &wgpu::Adapter| {
        let name = adapter.get_info().name.to_lowercase();
        wanted.is_none_or(|wanted| name.contains(&wanted.to_lowercase()))
    };
    let rank = |adapter: &wgpu::Adapter| match adapter.get_info().device_type {
        wgpu::DeviceType::DiscreteGpu => 0,
        wgpu::DeviceType::IntegratedGpu => 1,
        wgpu::DeviceType::VirtualGpu => 2,
        wgpu::DeviceType::Other => 3,
        wgpu::DeviceType::Cpu => 4,
    };
    let chosen = adapters.into_iter().filter(is_wanted).min_by_key(rank);
    chosen.ok_or_else(|| GpuError::NoAdapter {
        reason: match (wanted, names.is_empty()) {
            (Some(wanted), false) => format!(
                "no adapter's name contains \"{wanted}\"; there are {}",
                names.join(", ")
            ),
            _ => "there is no adapter with Vulkan, Metal or DX12".to_owned(),
        },
    })
}

/// What every kernel is given: its binding's number is its place here.
fn layout(device: &wgpu::Device) -> wgpu::BindGroupLayout {
    let read = wgpu::BufferBindingType::Storage { read_only: true };
    let write = wgpu::BufferBindingType::Storage { read_only: false };
    let types = [
        read,
        read,
        read,
        read,
        read,
        read,
        write,
        write,
        wgpu::BufferBindingType::Uniform,
    ];
    let entries: Vec<_> = types
        .into_iter()
        .enumerate()
        .map(|(binding, ty)| wgpu::BindGroupLayoutEntry {
            binding: binding as u32,
            visibility: wgpu::ShaderStages::COMPUTE,
            ty: wgpu::BindingType::Buffer {
                ty,
                has_dynamic_offset: false,
                min_binding_size: None,
            },
            count: None,
        })
        .collect();
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("queries"),
        entries: &entries,
    })
}

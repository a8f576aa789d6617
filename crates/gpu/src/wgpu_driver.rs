//! Devices through wgpu: Vulkan, Metal and DX12, and Vulkan in software.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, mpsc};
use std::time::{Duration, Instant};

use crate::compiled_kernel::CompiledKernel;
use crate::error::GpuError;
use crate::launch::{ARRAYS, Fault, Launch, locked};
use crate::precision::Precision;

/// An open device.
#[derive(Debug)]
pub struct WgpuDriver {
    device: wgpu::Device,
    queue: wgpu::Queue,
    layout: wgpu::BindGroupLayout,
    info: wgpu::AdapterInfo,
    largest: u64,
    /// Those that were asked for, by the names of their kernels; each is compiled by one thread, for
    /// which the others that want it wait.
    pipelines: Mutex<BTreeMap<(&'static str, usize), OncePipeline>>,
    lost: Arc<Mutex<Option<String>>>,
    /// What the last download came through: new memory would cost more than the copy.
    back: Mutex<Option<wgpu::Buffer>>,
}

/// A kernel that is compiled by whoever locks it first.
type OncePipeline = Arc<Mutex<Option<wgpu::ComputePipeline>>>;

impl WgpuDriver {
    /// Opens the adapter whose name contains `wanted`, or else the fastest kind there is: a
    /// GPU of its own before one that shares the CPU's memory before software. With
    /// it comes the precision: the wanted one, or the best that it has.
    pub fn open(
        wanted: Option<&str>,
        precision: Option<Precision>,
    ) -> Result<(Self, Precision), GpuError> {
        let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
        descriptor.backends = wgpu::Backends::VULKAN | wgpu::Backends::METAL | wgpu::Backends::DX12;
        descriptor.flags = wgpu::InstanceFlags::empty();
        let instance = wgpu::Instance::new(descriptor);
        let adapter = choose(&instance, wanted)?;
        let info = adapter.get_info();
        let unusable = |reason: String| GpuError::Unusable {
            adapter: info.name.clone(),
            reason,
        };
        let has_double = adapter.features().contains(wgpu::Features::SHADER_F64);
        let precision = match (precision, has_double) {
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
            // What queries need beyond the least that wgpu demands of any device.
            max_storage_buffers_per_shader_stage: ARRAYS as u32,
            ..wgpu::Limits::downlevel_defaults()
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
            *locked(&noted) = Some(text);
        });
        // Errors are fetched where they arise; one that is not is still no reason to panic.
        device.on_uncaptured_error(Arc::new(|error| log::error!("GPU: {error}")));
        let driver = Self {
            layout: layout(&device),
            device,
            queue,
            info,
            largest: limits
                .max_buffer_size
                .min(limits.max_storage_buffer_binding_size),
            pipelines: Default::default(),
            lost,
            back: Mutex::new(None),
        };
        Ok((driver, precision))
    }

    pub fn name(&self) -> &str {
        &self.info.name
    }

    pub fn version(&self) -> String {
        format!("{} {}", self.info.driver, self.info.driver_info)
    }

    pub fn is_software(&self) -> bool {
        self.info.device_type == wgpu::DeviceType::Cpu
    }

    pub fn largest(&self) -> u64 {
        self.largest
    }

    pub fn destroy(&self) {
        self.device.destroy();
        locked(&self.lost).get_or_insert_with(|| "it was given up".to_owned());
    }

    pub fn check(&self) -> Result<(), Fault> {
        match &*locked(&self.lost) {
            None => Ok(()),
            Some(reason) => Err(Fault::Lost(reason.clone())),
        }
    }

    pub fn allocate(&self, bytes: u64) -> Result<wgpu::Buffer, Fault> {
        use wgpu::BufferUsages as Use;
        self.buffer(bytes, Use::STORAGE | Use::COPY_DST | Use::COPY_SRC)
    }

    fn buffer(&self, size: u64, usage: wgpu::BufferUsages) -> Result<wgpu::Buffer, Fault> {
        self.guarded(|| {
            self.device.create_buffer(&wgpu::BufferDescriptor {
                label: None,
                size,
                usage,
                mapped_at_creation: false,
            })
        })
    }

    pub fn upload(&self, to: &wgpu::Buffer, bytes: &[u8]) -> Result<(), Fault> {
        self.guarded(|| self.queue.write_buffer(to, 0, bytes))
    }

    pub fn launch(
        &self,
        kernel: &CompiledKernel,
        precision: Precision,
        arrays: [&wgpu::Buffer; ARRAYS],
        launch: Launch,
        timeout: Duration,
    ) -> Result<Duration, Fault> {
        use wgpu::BufferUsages as Use;
        let pipeline = self.pipeline(kernel, precision)?;
        let words = self.buffer(16, Use::UNIFORM | Use::COPY_DST)?;
        let started = Instant::now();
        self.guarded(|| {
            self.queue
                .write_buffer(&words, 0, bytemuck::cast_slice(&launch.words()));
            let entries: Vec<_> = arrays
                .into_iter()
                .chain([&words])
                .enumerate()
                .map(|(binding, buffer)| wgpu::BindGroupEntry {
                    binding: binding as u32,
                    resource: buffer.as_entire_binding(),
                })
                .collect();
            let group = self.device.create_bind_group(&wgpu::BindGroupDescriptor {
                label: None,
                layout: &self.layout,
                entries: &entries,
            });
            let mut encoder = self.device.create_command_encoder(&Default::default());
            {
                let mut pass = encoder.begin_compute_pass(&Default::default());
                pass.set_pipeline(&pipeline);
                pass.set_bind_group(0, &group, &[]);
                pass.dispatch_workgroups(launch.queries().div_ceil(kernel.group) as u32, 1, 1);
            }
            self.queue.submit([encoder.finish()]);
        })?;
        self.wait(timeout)?;
        Ok(started.elapsed())
    }

    pub fn download(
        &self,
        from: &wgpu::Buffer,
        to: &mut [u8],
        timeout: Duration,
    ) -> Result<(), Fault> {
        use wgpu::BufferUsages as Use;
        let bytes = to.len() as u64;
        let kept = locked(&self.back).take();
        let back = match kept.filter(|back| back.size() >= bytes) {
            Some(back) => back,
            None => self.buffer(bytes, Use::MAP_READ | Use::COPY_DST)?,
        };
        let (sender, receiver) = mpsc::channel();
        self.guarded(|| {
            let mut encoder = self.device.create_command_encoder(&Default::default());
            encoder.copy_buffer_to_buffer(from, 0, &back, 0, bytes);
            self.queue.submit([encoder.finish()]);
            back.map_async(wgpu::MapMode::Read, ..bytes, move |mapped| {
                // Nobody listens any more if the wait failed meanwhile.
                let _ = sender.send(mapped.map_err(|error| error.to_string()));
            });
        })?;
        self.wait(timeout)?;
        let mapped = receiver
            .recv()
            .unwrap_or_else(|error| Err(error.to_string()));
        mapped.map_err(|reason| self.refused(reason))?;
        let range = back
            .get_mapped_range(..bytes)
            .map_err(|error| self.refused(error.to_string()))?;
        to.copy_from_slice(&range);
        drop(range);
        back.unmap();
        *locked(&self.back) = Some(back);
        Ok(())
    }

    /// Waits until all work is done.
    fn wait(&self, timeout: Duration) -> Result<(), Fault> {
        let waited = self.device.poll(wgpu::PollType::Wait {
            submission_index: None,
            timeout: Some(timeout),
        });
        self.check()?;
        match waited {
            Ok(_) => Ok(()),
            Err(wgpu::PollError::Timeout) => Err(Fault::Timeout),
            Err(error) => Err(Fault::Refused(error.to_string())),
        }
    }

    fn refused(&self, reason: String) -> Fault {
        self.check().err().unwrap_or(Fault::Refused(reason))
    }

    /// The result of calls of wgpu; or the error that came up in them.
    fn guarded<T>(&self, calls: impl FnOnce() -> T) -> Result<T, Fault> {
        self.check()?;
        let memory = self.device.push_error_scope(wgpu::ErrorFilter::OutOfMemory);
        let internal = self.device.push_error_scope(wgpu::ErrorFilter::Internal);
        let validation = self.device.push_error_scope(wgpu::ErrorFilter::Validation);
        let result = calls();
        let refused = pollster::block_on(validation.pop()).or(pollster::block_on(internal.pop()));
        let memory = pollster::block_on(memory.pop());
        self.check()?;
        if memory.is_some() {
            return Err(Fault::OutOfMemory);
        }
        match refused {
            None => Ok(result),
            Some(error) => Err(Fault::Refused(error.to_string())),
        }
    }

    /// The kernel, compiled when it is first asked for.
    fn pipeline(
        &self,
        kernel: &CompiledKernel,
        precision: Precision,
    ) -> Result<wgpu::ComputePipeline, Fault> {
        let own = locked(&self.pipelines)
            .entry(kernel.key())
            .or_default()
            .clone();
        let mut own = locked(&own);
        if let Some(pipeline) = &*own {
            return Ok(pipeline.clone());
        }
        let compiled = self.guarded(|| {
            let source = kernel.wgsl_in(precision);
            let module = self
                .device
                .create_shader_module(wgpu::ShaderModuleDescriptor {
                    label: Some(kernel.name),
                    source: wgpu::ShaderSource::Wgsl(source.into()),
                });
            let layout = self
                .device
                .create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
                    label: Some(kernel.name),
                    bind_group_layouts: &[Some(&self.layout)],
                    ..Default::default()
                });
            self.device
                .create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
                    label: Some(kernel.name),
                    layout: Some(&layout),
                    module: &module,
                    entry_point: Some(kernel.name),
                    compilation_options: Default::default(),
                    cache: None,
                })
        })?;
        *own = Some(compiled.clone());
        Ok(compiled)
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

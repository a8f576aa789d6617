//! The kernels as `cargo xtask kernels` compiled them from `kernels/render.slang`.

use capwalk_gpu::CompiledKernel;

macro_rules! compiled {
    ($name:literal) => {
        CompiledKernel {
            name: $name,
            group: 64,
            wgsl: [
                include_str!(concat!("kernels/", $name, "_single.wgsl")),
                include_str!(concat!("kernels/", $name, "_double.wgsl")),
            ],
            ptx: [
                include_str!(concat!("kernels/", $name, "_single.ptx")),
                include_str!(concat!("kernels/", $name, "_double.ptx")),
            ],
        }
    };
}

/// Follows the camera's rays to what they hit.
pub const BEGIN_PATHS: CompiledKernel = compiled!("begin_paths");

/// Takes the paths of a list further by a segment.
pub const GO_ON: CompiledKernel = compiled!("go_on");

/// The same in scenes where all surfaces are diffuse and light comes from no map.
pub const GO_ON_DIFFUSE: CompiledKernel = compiled!("go_on_diffuse");

/// Words of a camera's ray.
pub const CAMERA_RAY: usize = 9;
/// Words of a path; the first three are its light.
pub const PATH: usize = 14;

#[cfg(test)]
mod tests {
    use capwalk_gpu::RAYS_SOURCE;

    use super::*;

    /// Whoever changes the source must compile it again, and nobody edits the result.
    #[test]
    fn compiled_kernels_are_current() {
        let mut source = include_str!("kernels/render.slang").to_owned();
        for (name, content) in [
            ("rays", RAYS_SOURCE),
            ("numbers", include_str!("kernels/numbers.slang")),
            ("surfaces", include_str!("kernels/surfaces.slang")),
            ("fresnel", include_str!("kernels/fresnel.slang")),
            ("microfacets", include_str!("kernels/microfacets.slang")),
            ("lobes", include_str!("kernels/lobes.slang")),
            (
                "environment_map",
                include_str!("kernels/environment_map.slang"),
            ),
            ("emitters", include_str!("kernels/emitters.slang")),
        ] {
            source = source.replace(&format!("#include \"{name}.slang\"\n"), content);
        }
        for kernel in [BEGIN_PATHS, GO_ON, GO_ON_DIFFUSE] {
            assert_eq!(kernel.check(&source), Ok(()));
        }
    }
}

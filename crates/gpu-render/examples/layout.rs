//! Writes what the kernels include of Rust's own constants into a folder: `cargo xtask kernels` runs it.

use std::path::PathBuf;

fn main() -> std::io::Result<()> {
    let folder = PathBuf::from(std::env::args_os().nth(1).expect("a folder"));
    std::fs::create_dir_all(&folder)?;
    std::fs::write(folder.join("arrays.slang"), capwalk_gpu::arrays_slang())?;
    std::fs::write(
        folder.join("layout.slang"),
        capwalk_gpu_render::layout_slang(),
    )
}

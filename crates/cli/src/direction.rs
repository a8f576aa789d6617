//! The direction of a derivative, from parameters and files of velocities.

use anyhow::{Context, Result};
use capwalk::{Direction, FilesRead, Prepared, Tangent, read_velocities, vertex_tangent};

use crate::args::MotionArgs;

/// The direction that the command line asks for. Its files are added to those that were read.
pub fn tangent(prepared: &Prepared, args: &MotionArgs, read: &mut FilesRead) -> Result<Tangent> {
    let scene = prepared.scene();
    let mut tangent = match &args.param {
        // Nothing else moves: what is wrong with it has its name.
        Some(expression) if args.motion.is_empty() => {
            expression.tangent(scene, prepared.registry())?.into_owned()
        }
        Some(expression) => prepared.registry().tangent(scene, expression)?,
        None => Tangent::zero(scene),
    };
    for (shape, file) in &args.motion {
        read.add(file);
        let velocities = read_velocities(file)
            .with_context(|| format!("cannot read the velocities of \"{shape}\""))?;
        let of_shape = vertex_tangent(scene, shape, velocities)
            .with_context(|| format!("cannot use the velocities in {}", file.display()))?;
        tangent.add(&of_shape);
    }
    Ok(tangent)
}

/// A name for the direction in file headers and tables.
pub fn describe(args: &MotionArgs) -> String {
    let files = args.motion.iter();
    let files = files.map(|(shape, file)| format!("{shape}={}", file.display()));
    let parameters = args.param.iter().cloned();
    parameters.chain(files).collect::<Vec<_>>().join(" + ")
}

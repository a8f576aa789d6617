//! What moves, from parameters and files of velocities.

use anyhow::{Context, Result};
use capwalk::{Motion, Prepared, read_velocities, vertex_motion};

use crate::args::MotionArgs;

/// The motion that the command line asks for.
pub fn motion(prepared: &Prepared, args: &MotionArgs) -> Result<Motion> {
    let scene = prepared.scene();
    let mut motion = match &args.param {
        Some(expression) => prepared.registry().motion(scene, expression)?,
        None => Motion::zero(scene),
    };
    for (shape, file) in &args.motion {
        let velocities = read_velocities(file)
            .with_context(|| format!("cannot read the velocities of \"{shape}\""))?;
        let of_shape = vertex_motion(scene, shape, velocities)
            .with_context(|| format!("cannot use the velocities in {}", file.display()))?;
        motion.add(&of_shape);
    }
    Ok(motion)
}

/// A name for the motion in file headers and tables.
pub fn describe(args: &MotionArgs) -> String {
    let files = args.motion.iter();
    let files = files.map(|(shape, file)| format!("{shape}={}", file.display()));
    let parameters = args.param.iter().cloned();
    parameters.chain(files).collect::<Vec<_>>().join(" + ")
}

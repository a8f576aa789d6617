//! What a scene refuses as a whole.

use capwalk_boundary::refuse::{refuse_cut_normals, refuse_motion};
use capwalk_boundary::{Boundaries, Method, Refusal};
use capwalk_render::{PreparedScene, Watch};
use capwalk_scene::memory;

/// The boundaries of a scene, or none if nothing moves; an error if there is no memory to build them
/// or the watch stops that.
pub(crate) fn boundaries<'a>(
    prepared: &'a PreparedScene,
    moves: bool,
    watch: &dyn Watch,
) -> Result<&'a Boundaries, Refusal> {
    if moves && !prepared.has_boundaries() {
        let triangles = prepared.accel().mesh.faces.len() as u64;
        refuse_beyond_memory(triangles, memory::available())?;
    }
    Ok(prepared.try_boundaries_if(moves, watch)?)
}

/// Refuses boundaries of so many triangles that there is no memory for them.
fn refuse_beyond_memory(triangles: u64, free: Option<u64>) -> Result<(), Refusal> {
    let needed = triangles.saturating_mul(memory::OF_MOVING_TRIANGLE);
    match free.filter(|&free| needed > free) {
        Some(free) => Err(Refusal::Memory {
            triangles,
            needed,
            free,
        }),
        None => Ok(()),
    }
}

/// Refuses sums of a gradient with respect to so many numbers, of which there are so many copies,
/// that there is no memory for them.
pub(crate) fn refuse_sums_beyond_memory(
    numbers: u64,
    copies: u64,
    free: Option<u64>,
) -> Result<(), Refusal> {
    let needed = numbers.saturating_mul(copies).saturating_mul(OF_NUMBER);
    match free.filter(|&free| needed > free) {
        Some(free) => Err(Refusal::GradientMemory {
            numbers,
            needed,
            free,
        }),
        None => Ok(()),
    }
}

/// Bytes of a number.
const OF_NUMBER: u64 = 8;

/// The reason why derivatives with respect to whatever moves edges are refused for a
/// scene, if they are.
pub fn refusal(prepared: &PreparedScene) -> Option<Refusal> {
    refuse_cut_normals(prepared.scene(), true, |_| false)
        .and_then(|()| refuse_motion(prepared.accel(), &Method::default()))
        .err()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// So do sums.
    #[test]
    fn gradients_that_do_not_fit_are_refused() {
        assert_eq!(
            refuse_sums_beyond_memory(1 << 20, 22, Some(1 << 30)),
            Ok(())
        );
        assert_eq!(refuse_sums_beyond_memory(u64::MAX, 22, None), Ok(()));
        let refusal = refuse_sums_beyond_memory(1 << 24, 22, Some(1 << 30)).unwrap_err();
        let text = refusal.to_string();
        assert!(text.contains("16777216 numbers"), "{text}");
        assert!(
            text.contains("2816 MiB") && text.contains("1024 MiB"),
            "{text}"
        );
    }

    /// What does not fit says what it needs and what there is.
    #[test]
    fn boundaries_that_do_not_fit_are_refused() {
        assert_eq!(refuse_beyond_memory(1 << 20, Some(2 << 30)), Ok(()));
        assert_eq!(refuse_beyond_memory(u64::MAX, None), Ok(()));
        let refusal = refuse_beyond_memory(1 << 20, Some(1 << 30)).unwrap_err();
        let text = refusal.to_string();
        assert!(text.contains("1048576 triangles"), "{text}");
        assert!(
            text.contains("1036 MiB") && text.contains("1024 MiB"),
            "{text}"
        );
    }
}

//! Boundary terms of paths on the device: edges before emitters, and paths that go on to both sides of an edge.

use capwalk_geometry::buffers::NONE;
use capwalk_gpu::GpuError;
use capwalk_render::Watch;

use crate::device_edges::DeviceEdges;
use crate::layout::fault::PARTS;
use crate::layout::launch::{DEPTH_BITS, FIRST_SUBTREES, LATER_SUBTREES};
use crate::paths::Paths;
use crate::render_kernels::{BOUNDARY, BOUNDARY_BACK};

/// Subtrees that are sampled at the vertex that the camera sees, and at later ones.
const SUBTREES: [usize; 2] = [FIRST_SUBTREES, LATER_SUBTREES];
/// No launch is at a later vertex of a path.
pub const LAST_VERTEX: u32 = (1 << DEPTH_BITS) - 1;
/// No more parts are counted.
pub const MOST_PARTS: usize = 1 << (32 - DEPTH_BITS);

impl Paths<'_> {
    /// Adds the boundary terms at the vertices, of this number, that the paths of a list are at; false
    /// if the watch stopped it.
    pub(crate) fn cross_edges(
        &self,
        edges: &DeviceEdges,
        list: &[u32],
        depth: usize,
        watch: &dyn Watch,
    ) -> Result<bool, GpuError> {
        let kernels = match self.keeps_vertices() {
            true => &BOUNDARY_BACK,
            false => &BOUNDARY,
        };
        // Each launch looks at so many leaves or samples one subtree, so that no thread works for long.
        let subtrees = SUBTREES[usize::from(depth > 0)];
        assert!(depth <= LAST_VERTEX as usize, "so long paths were refused");
        let of_part = |part: usize| depth | part << DEPTH_BITS;
        let before = |has_any, parts| if has_any { parts } else { 0 };
        let before_areas = edges.crosses.before_areas(depth);
        let mut parts = before(edges.crosses.before_environment(depth), subtrees);
        parts = parts.max(before(before_areas, 1));
        if parts > 0 {
            self.write_list(list)?;
        }
        let mut part = 0;
        while part < parts {
            if watch.should_stop() {
                return Ok(false);
            }
            self.launch(&kernels.cross_edges, list.len(), of_part(part))?;
            if part == 0 && before_areas {
                parts = parts.max(self.take_parts()?);
                assert!(parts <= MOST_PARTS, "so many leaves were refused");
            }
            part += 1;
        }
        if !edges.crosses.before_surfaces(depth) {
            return Ok(true);
        }
        for subtree in 0..subtrees {
            self.write_list(list)?;
            self.launch(&kernels.begin_sides, list.len(), of_part(subtree))?;
            let mut listed = 2 * list.len();
            let mut has_sides = false;
            // Follow the sides as paths of an image, from the next vertex on.
            for next in depth + 1.. {
                let sides = self.listed(listed)?;
                if sides.is_empty() {
                    break;
                }
                if watch.should_stop() {
                    return Ok(false);
                }
                has_sides = true;
                self.write_list(&sides)?;
                self.launch(&edges.image.go_on, sides.len(), next)?;
                listed = sides.len();
            }
            if has_sides {
                self.write_list(list)?;
                self.launch(&kernels.add_sides, list.len(), depth)?;
            }
        }
        Ok(true)
    }

    /// In how many parts the last launch wants the edges before emitters to be taken; the next one counts
    /// anew.
    fn take_parts(&self) -> Result<usize, GpuError> {
        let mut counts = self.counts()?;
        let parts = std::mem::take(&mut counts[PARTS]);
        if parts > 0 {
            self.gpu
                .write(&self.results, bytemuck::cast_slice(&counts))?;
        }
        Ok(parts as usize)
    }

    /// The paths among the first so many of the device's list that go on, in order, whichever thread
    /// was first.
    pub(crate) fn listed(&self, count: usize) -> Result<Vec<u32>, GpuError> {
        let mut list = vec![0_u32; count];
        self.gpu
            .read(&self.state, bytemuck::cast_slice_mut(&mut list))?;
        list.retain(|&path| path != NONE);
        Ok(list)
    }

    /// Gives a list to the next launch.
    pub(crate) fn write_list(&self, list: &[u32]) -> Result<(), GpuError> {
        self.gpu.write(&self.input, bytemuck::cast_slice(list))
    }
}

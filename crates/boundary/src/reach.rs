//! Whether a walk can come to a boundary that moves: most walks in a room where one thing moves cannot, and are left
//! out (method 2).

use std::f64::consts::PI;

use capwalk_geometry::{ConeQuery, EdgeSubset};
use capwalk_math::{Real, Vec3};
use capwalk_walk::WalkSettings;

use crate::field::Field;
use crate::viewpoint::Viewpoint;

/// How much farther than a walk can reach edges are asked for, for rounding.
const FARTHER: f64 = 1.0 + 1e-6;

/// The most images in mirrors that are looked at before edges count as reached.
const MOST_IMAGES: u32 = 16;

/// What moves, as far as it is known.
#[derive(Clone, Copy)]
pub struct MovingBoundaries<'a> {
    /// All edges but those that certainly do not move.
    pub edges: &'a EdgeSubset,
    /// False if no flat mirror moves.
    pub mirrors: bool,
}

impl Field<'_> {
    /// False if no walk from the direction `q` around a viewpoint comes to a boundary that moves, seen directly
    /// or in mirrors. In doubt it is true, as it is for cameras with parallel rays and fields of someone else.
    pub fn reaches<R: Real>(
        &self,
        viewpoint: &Viewpoint<R>,
        q: Vec3,
        settings: &WalkSettings,
        moving: MovingBoundaries,
    ) -> bool {
        let max_angle = settings.reach() * FARTHER;
        let is_known = self.method.traits().is_spherical && viewpoint.axes.is_none();
        if !is_known || max_angle >= 0.5 * PI {
            return true;
        }
        let query = ConeQuery {
            apex: viewpoint.position.value(),
            axis: q,
            max_angle,
            edges: viewpoint.selection,
            groups: viewpoint.group,
            in_front_of: None,
        };
        let mut search = Search {
            field: self,
            moving,
            images: 0,
        };
        search.meets(&query, viewpoint.events, None)
    }
}

/// A search for what moves.
struct Search<'a> {
    field: &'a Field<'a>,
    moving: MovingBoundaries<'a>,
    /// How many images in mirrors were looked at.
    images: u32,
}

impl Search<'_> {
    /// True if a boundary that moves is in a cone, or in its image behind one of so many mirrors in turn. The last one
    /// of them was `behind`.
    fn meets(&mut self, query: &ConeQuery, events: u32, behind: Option<usize>) -> bool {
        if (self.field.boundaries.tree()).meets(query, self.moving.edges) {
            return true;
        }
        if events == 0 {
            return false;
        }
        let Some(mirrors) = self.field.accel.mirror_planes() else {
            return true;
        };
        let (sin, cos) = query.max_angle.sin_cos();
        mirrors.planes.iter().enumerate().any(|(i, plane)| {
            // A ray does not meet the plane again that it comes from.
            if behind == Some(i) || !plane.may_be_in_cone(query.apex, query.axis, [cos, sin]) {
                return false;
            }
            // As a mirror shows it, everything moves with the mirror.
            if self.moving.mirrors || self.images == MOST_IMAGES {
                return true;
            }
            self.images += 1;
            let image = ConeQuery {
                apex: plane.mirror.point(query.apex),
                axis: plane.mirror.direction(query.axis),
                ..*query
            };
            self.meets(&image, events - 1, Some(i))
        })
    }
}

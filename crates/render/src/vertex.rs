//! A vertex of a path.

use capwalk_boundary::Leaving;
use capwalk_math::{Frame, Real, Rgb, Vec3};
use capwalk_scene::lobe::{Event, LocalBsdf, Specular};

use crate::receiver::Receiver;

/// A surface point that scatters light.
#[derive(Clone, Debug)]
pub struct Vertex<R: Real> {
    /// World-space position.
    pub position: Vec3<R>,
    /// The face that it is on, of all in the scene.
    pub face: u32,
    /// Unit normal of the face on the viewer's side.
    pub face_normal: Vec3,
    /// The shading frame.
    pub frame: Frame<R>,
    /// Unit direction to the viewer in that frame.
    pub wi: Vec3<R>,
    /// The BSDF, in that frame.
    pub bsdf: LocalBsdf<R>,
    /// True if light can come from both sides.
    pub transmits: bool,
}

impl<R: Real> Vertex<R> {
    /// A vertex with the given shading frame, seen from the unit direction `wi`.
    pub fn new(
        position: Vec3<R>,
        face: u32,
        face_normal: Vec3,
        frame: Frame<R>,
        wi: Vec3<R>,
        bsdf: LocalBsdf<R>,
    ) -> Self {
        Self {
            transmits: bsdf.transmits(),
            bsdf,
            ..Self::black(position, face, face_normal, frame, wi)
        }
    }

    /// A vertex without lobes, seen from the unit direction `wi`.
    #[inline]
    pub fn black(
        position: Vec3<R>,
        face: u32,
        face_normal: Vec3,
        frame: Frame<R>,
        wi: Vec3<R>,
    ) -> Self {
        Self {
            position,
            face,
            face_normal,
            wi: frame.to_local(wi),
            frame,
            bsdf: LocalBsdf::default(),
            transmits: false,
        }
    }

    /// Turns the normal of its frame over.
    pub fn turn_over(&mut self) {
        self.frame.n = -self.frame.n;
        self.wi.z = -self.wi.z;
    }

    /// BSDF times cosine for the unit direction of incident light, per solid angle; zero for
    /// perfectly specular events.
    #[inline]
    pub fn eval(&self, direction: Vec3<R>) -> Rgb<R> {
        self.bsdf.eval(self.wi, self.frame.to_local(direction))
    }

    /// Origin and direction of the ray after a specular event, and the fraction of light that comes
    /// from there. `incoming` is the ray that led to the vertex: what passes follows it, however
    /// the surface moves.
    pub fn specular(&self, event: Specular, incoming: [Vec3<R>; 2]) -> ([Vec3<R>; 2], Rgb<R>) {
        let (wo, throughput) = self.bsdf.specular(event, self.wi);
        let ray = match event.event {
            Event::Reflect | Event::Transmit => [self.position, self.frame.to_world(wo)],
            Event::Pass => incoming,
        };
        (ray, throughput)
    }

    /// How a ray leaves it after an event.
    pub fn leaving(&self, event: Event) -> Leaving {
        Leaving::after(event, self.face, self.face_normal)
    }

    /// The vertex without its derivative.
    pub fn value(&self) -> Vertex<f64> {
        Vertex {
            position: self.position.value(),
            face: self.face,
            face_normal: self.face_normal,
            frame: self.frame.value(),
            wi: self.wi.value(),
            bsdf: self.bsdf.value(),
            transmits: self.transmits,
        }
    }
}

impl Vertex<f64> {
    /// What of it matters to directions towards emitters.
    pub fn receiver(&self) -> Receiver {
        Receiver {
            position: self.position,
            frame: self.frame,
            transmits: self.transmits,
        }
    }

    /// Density per solid angle with which the material samples a direction.
    #[inline]
    pub fn pdf(&self, direction: Vec3) -> f64 {
        self.bsdf.pdf(self.wi, self.frame.to_local(direction))
    }
}

//! How finely the spheres of a scene are divided: fewer triangles each where they are many.

use capwalk_scene::primitive::{SPHERE_DIVISION, sphere_error, sphere_triangles};

/// The triangles that all spheres of a file share if they have more than so many: with the trees of
/// a derivative they take five gigabytes. 69 spheres have fewer.
const SHARED: u64 = 1 << 22;

/// The coarsest division, of very many spheres: 320 triangles, of which silhouettes are off by up
/// to 2 % of the radius.
const COARSEST: u32 = 4;

/// How finely spheres are divided, by their radii: so that all silhouettes are off by the same
/// length, but for those of large spheres that are finer already, which keep the finest division.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SphereDivision {
    /// The square of a sphere's division over its radius.
    squares_per_radius: f64,
}

impl SphereDivision {
    /// The finest for all.
    pub const FINEST: Self = Self {
        squares_per_radius: f64::INFINITY,
    };

    /// For all spheres of a file, given their radii.
    pub fn of(radii: &[f64]) -> Self {
        let total = |division: Self| {
            let triangles = |&radius: &f64| u64::from(sphere_triangles(division.at(radius)));
            radii.iter().map(triangles).sum::<u64>()
        };
        if total(Self::FINEST) <= SHARED {
            return Self::FINEST;
        }
        let squares_per_radius = |exponent: f64| Self {
            squares_per_radius: exponent.exp2(),
        };
        // Exponents between which the division of any radius goes from the coarsest to the finest.
        let (mut few, mut many) = (-1100.0, 1100.0);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (few + many);
            match total(squares_per_radius(middle)) <= SHARED {
                true => few = middle,
                false => many = middle,
            }
        }
        squares_per_radius(few)
    }

    /// The division of a sphere of this radius.
    pub fn at(self, radius: f64) -> u32 {
        // The finest for no radius and one that is no number, which are refused elsewhere.
        let division = (self.squares_per_radius * radius).sqrt() as u32;
        match self == Self::FINEST {
            true => SPHERE_DIVISION,
            false => division.clamp(COARSEST, SPHERE_DIVISION),
        }
    }

    /// What is to be said of it, if anything.
    pub fn warning(self, radii: &[f64]) -> Option<String> {
        let divisions = || radii.iter().map(|&radius| self.at(radius));
        let (least, most) = (divisions().min()?, divisions().max()?);
        (self != Self::FINEST).then(|| {
            format!(
                "the scene has {} spheres, which share {} triangles: they have {} to {} each, and \
                 their silhouettes are off by up to {:.2} % of the radius (0.01 % where spheres are \
                 few); give those that fill an image as meshes",
                radii.len(),
                divisions().map(|n| u64::from(sphere_triangles(n))).sum::<u64>(),
                sphere_triangles(least),
                sphere_triangles(most),
                100.0 * sphere_error(least),
            )
        })
    }
}

/// Halvings of the exponent: what is left is less than its rounding.
const HALVINGS: u32 = 60;

#[cfg(test)]
mod tests {
    use super::*;

    /// Few spheres stay as they are; of many, each is as coarse as its size allows, and all
    /// together have nearly the triangles that they may have.
    #[test]
    fn many_spheres_share_triangles() {
        assert_eq!(SphereDivision::of(&[1.0; 69]), SphereDivision::FINEST);
        assert_eq!(SphereDivision::of(&[1.0; 69]).warning(&[1.0; 69]), None);
        let mut radii = vec![0.2; 3000];
        radii.extend([1.0, 1000.0]);
        let division = SphereDivision::of(&radii);
        assert_eq!(division.at(1000.0), SPHERE_DIVISION);
        assert!(division.at(1.0) > division.at(0.2));
        let count = radii
            .iter()
            .map(|&r| u64::from(sphere_triangles(division.at(r))));
        let count: u64 = count.sum();
        assert!((SHARED / 2..=SHARED).contains(&count), "{count}");
        let warning = division.warning(&radii).expect("they are many");
        assert!(
            warning.starts_with("the scene has 3002 spheres"),
            "{warning}"
        );
        // So many that even the coarsest are more.
        let division = SphereDivision::of(&vec![1.0; 20_000]);
        assert_eq!(division.at(1.0), COARSEST);
    }
}

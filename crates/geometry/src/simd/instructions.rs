//! Which instruction set a computation runs on.

#[cfg(target_arch = "x86_64")]
use super::avx2::Avx2;
use super::scalar::Scalar;
use super::vectors::Computation;

/// An instruction set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Instructions {
    /// Plain Rust, runs everywhere.
    Scalar,
    /// AVX2 with fused multiply-add, and AVX-512 where there is that.
    #[cfg(target_arch = "x86_64")]
    Avx2(Avx2),
}

impl Instructions {
    /// The fastest that this CPU has.
    pub fn detect() -> Self {
        #[cfg(target_arch = "x86_64")]
        if let Some(avx2) = Avx2::detect() {
            return Self::Avx2(avx2);
        }
        Self::Scalar
    }

    /// All that this CPU has but the fastest.
    #[cfg(test)]
    pub fn slower() -> Vec<Self> {
        let fastest = Self::detect();
        let mut all = vec![Self::Scalar];
        #[cfg(target_arch = "x86_64")]
        if let Self::Avx2(avx2) = fastest {
            all.push(Self::Avx2(avx2.without_avx512()));
        }
        all.retain(|&instructions| instructions != fastest);
        all
    }

    /// Runs the job compiled for these instructions.
    #[inline]
    pub fn run<J: Computation>(self, job: J) -> J::Output {
        match self {
            Self::Scalar => job.run(Scalar),
            #[cfg(target_arch = "x86_64")]
            Self::Avx2(avx2) => avx2.run(job),
        }
    }
}

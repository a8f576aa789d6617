//! Memory for the pixels of a file, taken once it is known how many are wanted.

use capwalk_math::Rgb;
use capwalk_scene::Image;

/// Memory for so many things, or an error that says for which size there is none.
pub(super) fn reserve<T>([width, height]: [usize; 2]) -> Result<Vec<T>, String> {
    let mut things = Vec::new();
    let count = width.checked_mul(height);
    let reserved = count.map(|count| things.try_reserve_exact(count));
    match reserved {
        Some(Ok(())) => Ok(things),
        _ => Err(format!("there is no memory for {width} x {height} pixels")),
    }
}

/// An image of pixels that are read row by row, each from some numbers.
pub(super) fn collect_pixels<N>(
    size: [usize; 2],
    mut next: N,
    pixel: impl Fn(&mut N) -> Result<Rgb, String>,
) -> Result<Image, String> {
    let [width, height] = size;
    let mut pixels = reserve(size)?;
    for _ in 0..width * height {
        pixels.push(pixel(&mut next)?);
    }
    Ok(Image {
        width,
        height,
        pixels,
    })
}

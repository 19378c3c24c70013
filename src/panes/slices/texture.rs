//! The picture of a slice: made and sent to the graphics card when what it shows changes, and not before.

use std::sync::{Arc, Weak};

use egui::{Color32, ColorImage, Context, TextureHandle, TextureId, TextureOptions};

use super::plane::SlicePlane;
use crate::document::GreyWindow;
use crate::io::ImageSeries;

/// What a picture shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlicePicture {
    /// Which slice, and how it lies.
    pub plane: SlicePlane,
    /// Which voxel along its normal.
    pub depth: usize,
    /// Which volume.
    pub instant: usize,
    /// How bright.
    pub window: GreyWindow,
    /// Whether grey values are blended between voxels.
    pub smooth: bool,
}

/// The pictures of the slices across the three axes.
#[derive(Default)]
pub struct SliceTextures([Option<SliceTexture>; 3]);

struct SliceTexture {
    // Keeps no image alive that nobody looks at any more.
    of: Weak<ImageSeries>,
    shows: SlicePicture,
    texture: TextureHandle,
}

impl SliceTextures {
    /// The texture of a picture of a series.
    pub fn texture(
        &mut self,
        ctx: &Context,
        series: &Arc<ImageSeries>,
        picture: SlicePicture,
    ) -> Option<TextureId> {
        let kept = self.0.get_mut(picture.plane.normal)?;
        let same = |kept: &&SliceTexture| {
            std::ptr::eq(kept.of.as_ptr(), Arc::as_ptr(series)) && kept.shows == picture
        };
        if let Some(kept) = kept.as_ref().filter(same) {
            return Some(kept.texture.id());
        }
        let options = match picture.smooth {
            true => TextureOptions::LINEAR,
            false => TextureOptions::NEAREST,
        };
        let image = slice_image(series, &picture);
        // A new one each time: whoever compares what is drawn knows a texture by its number.
        let texture = ctx.load_texture("slice", image, options);
        let id = texture.id();
        *kept = Some(SliceTexture {
            of: Arc::downgrade(series),
            shows: picture,
            texture,
        });
        Some(id)
    }
}

/// The grey values of a slice, a pixel a voxel.
fn slice_image(series: &ImageSeries, picture: &SlicePicture) -> ColorImage {
    let size = series.image.frame().size();
    let plane = &picture.plane;
    let strides = [1, size[0], size[0] * size[1]];
    let values = series.image.volumes().get(picture.instant);
    let values = values.map_or(&[][..], |values| &values[..]);
    let places = |screen: super::plane::ScreenAxis| {
        let count = size[screen.axis];
        let place = move |pixel: usize| match screen.flipped {
            true => count - 1 - pixel,
            false => pixel,
        };
        (0..count).map(move |pixel| place(pixel) * strides[screen.axis])
    };
    let start = picture.depth * strides[plane.normal];
    let mut pixels = Vec::with_capacity(size[plane.right.axis] * size[plane.down.axis]);
    for row in places(plane.down) {
        for column in places(plane.right) {
            let value = values.get(start + row + column).copied();
            let grey = picture.window.grey(value.unwrap_or(f32::NAN));
            pixels.push(Color32::from_gray(grey));
        }
    }
    ColorImage::new([size[plane.right.axis], size[plane.down.axis]], pixels)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::panes::slices::tests::series_of;

    #[test]
    fn pixels_are_the_voxels_of_the_slice_as_it_lies_on_the_screen() {
        // Values tell their place: i + 10 j + 100 k.
        let series = series_of([3, 4, 2], |[i, j, k]| (i + 10 * j + 100 * k) as f32);
        let frame = *series.image.frame();
        for normal in 0..3 {
            let plane = SlicePlane::new(&frame, normal);
            let picture = SlicePicture {
                plane,
                depth: 1,
                instant: 0,
                window: GreyWindow::between(0.0, 255.0),
                smooth: false,
            };
            let image = slice_image(&series, &picture);
            let [width, height] = image.size;
            for row in 0..height {
                for column in 0..width {
                    let shares = [
                        (column as f64 + 0.5) / width as f64,
                        (row as f64 + 0.5) / height as f64,
                    ];
                    let voxel = plane.voxel(&frame, shares, 1.0);
                    let value = voxel.x + 10.0 * voxel.y + 100.0 * voxel.z;
                    let grey = image.pixels[row * width + column].r();
                    assert!((f64::from(grey) - value).abs() < 0.6, "{normal} {voxel}");
                }
            }
        }
    }
}

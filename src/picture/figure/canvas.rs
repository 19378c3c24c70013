//! Pixels in memory, with smooth edges: rectangles, polygons and lines over a rendered heart.

/// Red, green, blue and opacity per pixel, 8 bits each, opacity not multiplied in.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Canvas {
    width: u32,
    height: u32,
    pixels: Vec<u8>,
}

/// Samples per side of a pixel where an edge crosses it: 16 levels, finer than the eye sees.
const SAMPLES: u32 = 4;

impl Canvas {
    /// One colour everywhere; opacity 0 is a transparent picture.
    pub fn filled(width: u32, height: u32, colour: [f32; 3], opacity: f32) -> Self {
        let [red, green, blue] = colour.map(byte);
        let pixel = [red, green, blue, byte(opacity)];
        Self {
            width,
            height,
            pixels: pixel.repeat(width as usize * height as usize),
        }
    }

    /// Width in pixels.
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Height in pixels.
    pub fn height(&self) -> u32 {
        self.height
    }

    /// Four bytes per pixel, row by row from the top.
    pub fn pixels(&self) -> &[u8] {
        &self.pixels
    }

    /// Red, green, blue and opacity of one pixel; `None` outside.
    pub fn pixel(&self, x: u32, y: u32) -> Option<[u8; 4]> {
        let place = self.place(i64::from(x), i64::from(y))?;
        self.pixels.get(place..place + 4)?.try_into().ok()
    }

    /// Puts a picture of the same kind down with its upper left corner at (x, y), replacing what
    /// was there; what reaches beyond the canvas is cut off.
    pub fn put(&mut self, x: u32, y: u32, width: u32, pixels: &[u8]) {
        let fits = self.width.saturating_sub(x).min(width) as usize * 4;
        if fits == 0 {
            return;
        }
        for (row, source) in pixels.chunks_exact(width as usize * 4).enumerate() {
            let Some(start) = self.place(i64::from(x), i64::from(y) + row as i64) else {
                break;
            };
            self.pixels[start..start + fits].copy_from_slice(&source[..fits]);
        }
    }

    /// Lays a colour over one pixel; outside nothing happens.
    pub fn cover(&mut self, x: i64, y: i64, colour: [f32; 3], opacity: f32) {
        let Some(place) = self.place(x, y) else {
            return;
        };
        let over = opacity.clamp(0.0, 1.0);
        let under = f32::from(self.pixels[place + 3]) / 255.0 * (1.0 - over);
        let whole = over + under;
        if whole <= 0.0 {
            return;
        }
        for (channel, value) in colour.into_iter().enumerate() {
            let below = f32::from(self.pixels[place + channel]) / 255.0;
            self.pixels[place + channel] = byte((value * over + below * under) / whole);
        }
        self.pixels[place + 3] = byte(whole);
    }

    /// Fills a polygon that is convex or at least does not cross itself.
    pub fn fill(&mut self, corners: &[[f32; 2]], colour: [f32; 3], opacity: f32) {
        let Some([low, high]) = self.extent(corners) else {
            return;
        };
        for y in low[1]..high[1] {
            for x in low[0]..high[0] {
                let inside = coverage(corners, x, y);
                if inside > 0.0 {
                    self.cover(x, y, colour, opacity * inside);
                }
            }
        }
    }

    /// Fills a rectangle given by two corners.
    pub fn fill_rectangle(&mut self, low: [f32; 2], high: [f32; 2], colour: [f32; 3]) {
        let corners = [low, [high[0], low[1]], high, [low[0], high[1]]];
        self.fill(&corners, colour, 1.0);
    }

    /// A straight line of a width in pixels.
    pub fn line(&mut self, from: [f32; 2], to: [f32; 2], width: f32, colour: [f32; 3]) {
        let along = glam::Vec2::from(to) - glam::Vec2::from(from);
        let across = along.perp().normalize_or_zero() * (0.5 * width);
        let (from, to) = (glam::Vec2::from(from), glam::Vec2::from(to));
        let corners = [from + across, to + across, to - across, from - across];
        self.fill(&corners.map(Into::into), colour, 1.0);
    }

    /// The pixels that corners can touch, cut to the canvas.
    fn extent(&self, corners: &[[f32; 2]]) -> Option<[[i64; 2]; 2]> {
        let first = *corners.first()?;
        let (mut low, mut high) = (first, first);
        for corner in corners {
            for axis in 0..2 {
                low[axis] = low[axis].min(corner[axis]);
                high[axis] = high[axis].max(corner[axis]);
            }
        }
        let size = [i64::from(self.width), i64::from(self.height)];
        Some([
            [0, 1].map(|axis| (low[axis].floor() as i64).clamp(0, size[axis])),
            [0, 1].map(|axis| (high[axis].ceil() as i64).clamp(0, size[axis])),
        ])
    }

    fn place(&self, x: i64, y: i64) -> Option<usize> {
        let inside = x >= 0 && y >= 0 && x < i64::from(self.width) && y < i64::from(self.height);
        inside.then(|| (y as usize * self.width as usize + x as usize) * 4)
    }
}

/// Share of a pixel's samples that lie inside, by the number of edges to their right.
fn coverage(corners: &[[f32; 2]], x: i64, y: i64) -> f32 {
    let mut inside = 0;
    for sample in 0..SAMPLES * SAMPLES {
        let at = |index: u32| (index as f32 + 0.5) / SAMPLES as f32;
        let point = [
            x as f32 + at(sample % SAMPLES),
            y as f32 + at(sample / SAMPLES),
        ];
        let mut odd = false;
        for (i, a) in corners.iter().enumerate() {
            let b = corners[(i + 1) % corners.len()];
            if (a[1] > point[1]) != (b[1] > point[1]) {
                let crossing = a[0] + (point[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
                odd ^= point[0] < crossing;
            }
        }
        inside += u32::from(odd);
    }
    inside as f32 / (SAMPLES * SAMPLES) as f32
}

fn byte(value: f32) -> u8 {
    (value.clamp(0.0, 1.0) * 255.0).round() as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rectangle_covers_its_own_area() {
        let mut canvas = Canvas::filled(10, 10, [0.0; 3], 1.0);
        canvas.fill_rectangle([2.5, 3.0], [6.0, 5.5], [1.0; 3]);
        let lit: f32 = canvas
            .pixels()
            .chunks(4)
            .map(|p| f32::from(p[0]) / 255.0)
            .sum();
        assert!((lit - 3.5 * 2.5).abs() < 0.1, "{lit}");
        assert_eq!(canvas.pixel(3, 3), Some([255, 255, 255, 255]));
        assert_eq!(canvas.pixel(2, 3), Some([128, 128, 128, 255]));
        assert_eq!(canvas.pixel(10, 0), None);
    }

    #[test]
    fn colours_over_nothing_keep_their_colour() {
        let mut canvas = Canvas::filled(2, 1, [0.0; 3], 0.0);
        canvas.cover(0, 0, [1.0, 0.0, 0.0], 0.5);
        assert_eq!(canvas.pixel(0, 0), Some([255, 0, 0, 128]));
        assert_eq!(canvas.pixel(1, 0), Some([0, 0, 0, 0]));
    }

    #[test]
    fn pictures_are_cut_at_the_edge() {
        let mut canvas = Canvas::filled(4, 4, [0.0; 3], 1.0);
        canvas.put(3, 3, 2, &[255; 16]);
        assert_eq!(canvas.pixel(3, 3), Some([255; 4]));
        assert_eq!(canvas.pixel(2, 3), Some([0, 0, 0, 255]));
        canvas.put(7, 0, 2, &[255; 16]);
    }
}

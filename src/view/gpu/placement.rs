//! The position of a picture on the canvas: it fills the canvas or a part of it, or the canvas
//! shows one tile of a picture that is larger than the adapter can draw at once. The canvas itself
//! is at most as large as that.

/// A picture on a canvas, in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Placement {
    /// Width and height of the picture.
    pub size: (u32, u32),
    /// Left and top edge on the canvas; negative if outside.
    pub at: (i32, i32),
    /// Width and height of the canvas.
    pub canvas: (u32, u32),
}

impl Placement {
    /// Returns the placement of a picture that fills a canvas.
    pub fn whole(canvas: (u32, u32)) -> Placement {
        Placement { size: canvas, at: (0, 0), canvas }
    }

    /// Returns a part of this picture (left, top, width, height) as a picture of its own.
    pub fn part(&self, [left, top, width, height]: [u32; 4]) -> Placement {
        let at = (self.at.0 + left as i32, self.at.1 + top as i32);
        Placement { size: (width, height), at, ..*self }
    }

    /// Returns the map from clip coordinates of the picture to those of the canvas: the factors of
    /// x and y, and the offsets, which are multiplied by w.
    pub fn transform(&self) -> [f32; 4] {
        let along = |size: u32, at: i32, canvas: u32| {
            let canvas = canvas.max(1) as f32;
            (size as f32 / canvas, (2.0 * at as f32 + size as f32) / canvas - 1.0)
        };
        let (x, right) = along(self.size.0, self.at.0, self.canvas.0);
        let (y, down) = along(self.size.1, self.at.1, self.canvas.1);
        [x, y, right, -down]
    }

    /// Returns the part of the canvas that the picture covers: left, top, width, height, if any.
    pub fn shown(&self) -> Option<[u32; 4]> {
        let along = |size: u32, at: i32, canvas: u32| {
            let from = i64::from(at).max(0);
            let to = (i64::from(at) + i64::from(size)).min(i64::from(canvas));
            (to > from).then_some([from as u32, (to - from) as u32])
        };
        let [left, width] = along(self.size.0, self.at.0, self.canvas.0)?;
        let [top, height] = along(self.size.1, self.at.1, self.canvas.1)?;
        Some([left, top, width, height])
    }
}

/// Returns the largest size of the same proportions with no side over `limit`, and none under 1.
pub fn clamp_size(width: u32, height: u32, limit: u32) -> (u32, u32) {
    let longer = width.max(height);
    if longer <= limit {
        return (width.max(1), height.max(1));
    }
    let scale = |side: u32| (u64::from(side) * u64::from(limit) / u64::from(longer)).max(1) as u32;
    (scale(width), scale(height))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the canvas position of a point of the picture, in pixels from its upper left corner.
    fn on_canvas(placement: &Placement, [x, y]: [f32; 2]) -> [f32; 2] {
        let (width, height) = (placement.size.0 as f32, placement.size.1 as f32);
        let clip = [2.0 * x / width - 1.0, 1.0 - 2.0 * y / height];
        let [sx, sy, ox, oy] = placement.transform();
        let (width, height) = (placement.canvas.0 as f32, placement.canvas.1 as f32);
        [0.5 * (clip[0] * sx + ox + 1.0) * width, 0.5 * (1.0 - clip[1] * sy - oy) * height]
    }

    #[test]
    fn tiles_show_every_pixel_of_a_picture_where_it_is() {
        let (size, tile) = ((1000, 700), (256, 300));
        for (left, top) in [(0, 0), (256, 300), (768, 600)] {
            let placement = Placement { size, at: (-left, -top), canvas: tile };
            for point in [[0.0, 0.0], [999.0, 700.0], [300.0, 310.0]] {
                let [x, y] = on_canvas(&placement, point);
                assert!((x - (point[0] - left as f32)).abs() < 1e-2, "{x}");
                assert!((y - (point[1] - top as f32)).abs() < 1e-2, "{y}");
            }
        }
        let last = Placement { size, at: (-768, -600), canvas: tile };
        assert_eq!(last.shown(), Some([0, 0, 232, 100]));
    }

    #[test]
    fn parts_of_a_picture_are_cut_by_the_canvas() {
        let tile = Placement { size: (1000, 700), at: (-256, 0), canvas: (256, 256) };
        let [left, right] = [[0, 0, 500, 700], [500, 0, 500, 700]].map(|part| tile.part(part));
        assert_eq!(left.shown(), Some([0, 0, 244, 256]));
        assert_eq!(right.shown(), Some([244, 0, 12, 256]));
        assert_eq!(right.part([300, 0, 200, 700]).shown(), None);
        let [x, _] = on_canvas(&right, [3.0, 0.0]);
        assert!((x - 247.0).abs() < 1e-2);
    }

    #[test]
    fn a_whole_picture_keeps_its_clip_coordinates() {
        let whole = Placement::whole((1440, 900));
        assert_eq!(whole.transform(), [1.0, 1.0, 0.0, 0.0]);
        assert_eq!(whole.shown(), Some([0, 0, 1440, 900]));
    }

    #[test]
    fn a_canvas_over_the_limit_keeps_its_proportions() {
        assert_eq!(clamp_size(1440, 900, 8192), (1440, 900));
        assert_eq!(clamp_size(10240, 5760, 8192), (8192, 4608));
        assert_eq!(clamp_size(0, 5, 8192), (1, 5));
        assert_eq!(clamp_size(100_000, 1, 2048), (2048, 1));
    }
}

//! Places for the labels of a plot's points, so that none covers another label or a point.

/// A rectangle in pixels, y downwards.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rectangle {
    /// The corner at the top left.
    pub low: (i32, i32),
    /// The corner at the bottom right.
    pub high: (i32, i32),
}

impl Rectangle {
    /// The square around a point.
    pub fn around((x, y): (i32, i32), radius: i32) -> Self {
        Self { low: (x - radius, y - radius), high: (x + radius, y + radius) }
    }

    fn overlaps(&self, other: &Self) -> bool {
        self.low.0 < other.high.0 && other.low.0 < self.high.0 && self.low.1 < other.high.1 && other.low.1 < self.high.1
    }

    fn contains(&self, other: &Self) -> bool {
        self.low.0 <= other.low.0
            && self.low.1 <= other.low.1
            && self.high.0 >= other.high.0
            && self.high.1 >= other.high.1
    }
}

/// How far a label may stand from its point in pixels: beside it, or further off with a line that leads to it.
pub const NEAR: i32 = 10;
pub const FAR: i32 = 100;

/// How far labels stand from their points, the nearest first, and in which directions.
const DISTANCES: [i32; 8] = [6, 10, 14, 22, 34, 50, 70, 95];
const DIRECTIONS: [(f64, f64); 12] = [
    (1.0, 0.0),
    (0.8, -0.6),
    (0.8, 0.6),
    (-1.0, 0.0),
    (-0.8, -0.6),
    (-0.8, 0.6),
    (0.0, -1.0),
    (0.0, 1.0),
    (0.4, -0.9),
    (-0.4, -0.9),
    (0.4, 0.9),
    (-0.4, 0.9),
];
/// From this distance on a line leads from the label to its point.
const LED: i32 = 20;

/// The place of a label.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// What the label covers.
    pub label: Rectangle,
    /// Where a line to the point ends, if the label stands far from it.
    pub lead: Option<(i32, i32)>,
}

/// The labels of a plot.
pub struct Labels {
    bounds: Rectangle,
    points: Vec<Rectangle>,
    lines: Vec<Rectangle>,
    placed: Vec<Rectangle>,
}

impl Labels {
    /// No labels yet within some bounds: none shall cover the points, nor the lines if there is a place beside them.
    pub fn new(bounds: Rectangle, points: Vec<Rectangle>, lines: Vec<Rectangle>) -> Self {
        Self { bounds, points, lines, placed: Vec::new() }
    }

    /// Places a label of this size beside a point, at most this far off; nothing where all is full.
    pub fn place(&mut self, point: (i32, i32), size: (i32, i32), reach: i32) -> Option<Place> {
        let (distance, label) = self.free(point, size, reach, true).or_else(|| self.free(point, size, reach, false))?;
        self.placed.push(label);
        let middle = i32::midpoint(label.low.1, label.high.1);
        let nearest = (point.0.clamp(label.low.0, label.high.0), point.1.clamp(label.low.1, label.high.1));
        let end = if nearest.0 == label.low.0 || nearest.0 == label.high.0 { (nearest.0, middle) } else { nearest };
        Some(Place { label, lead: (distance >= LED).then_some(end) })
    }

    fn free(
        &self,
        point: (i32, i32),
        (width, height): (i32, i32),
        reach: i32,
        beside_lines: bool,
    ) -> Option<(i32, Rectangle)> {
        let lines: &[Rectangle] = if beside_lines { &self.lines } else { &[] };
        let distances = DISTANCES.into_iter().filter(|distance| *distance <= reach);
        let places = distances.flat_map(|distance| DIRECTIONS.map(|direction| (distance, direction)));
        let mut labels = places.map(|(distance, (x, y))| {
            // The label's nearest corner, or the middle of its nearest edge, lies in the direction.
            let start = |part: f64, length: i32| {
                let shift = (part * f64::from(distance)).round() as i32;
                match part {
                    part if part > 0.5 => shift,
                    part if part < -0.5 => shift - length,
                    _ => shift - length / 2,
                }
            };
            let low = (point.0 + start(x, width), point.1 + start(y, height));
            (distance, Rectangle { low, high: (low.0 + width, low.1 + height) })
        });
        labels.find(|(_, label)| {
            let mut taken = self.points.iter().chain(&self.placed).chain(lines);
            self.bounds.contains(label) && !taken.any(|other| other.overlaps(label))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::{FAR, Labels, Rectangle};

    #[test]
    fn labels_cover_neither_points_nor_each_other() {
        let bounds = Rectangle { low: (0, 0), high: (400, 300) };
        let points: Vec<(i32, i32)> = (0..12).map(|index| (150 + 9 * index, 140 + 3 * (index % 4))).collect();
        let marks: Vec<Rectangle> = points.iter().map(|&point| Rectangle::around(point, 4)).collect();
        let mut labels = Labels::new(bounds, marks.clone(), Vec::new());
        let placed: Vec<Rectangle> =
            points.iter().filter_map(|&point| labels.place(point, (70, 12), FAR)).map(|place| place.label).collect();
        assert!(placed.len() >= 10, "{} of 12 have a place", placed.len());
        for (index, label) in placed.iter().enumerate() {
            assert!(bounds.contains(label));
            assert!(!marks.iter().chain(&placed[..index]).any(|other| other.overlaps(label)), "{label:?}");
        }
    }

    #[test]
    fn a_label_finds_no_place_where_all_is_full() {
        let bounds = Rectangle { low: (0, 0), high: (40, 40) };
        let mut labels = Labels::new(bounds, Vec::new(), Vec::new());
        assert_eq!(labels.place((20, 20), (60, 10), FAR), None);
    }
}

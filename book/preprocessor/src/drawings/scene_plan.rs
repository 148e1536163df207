//! Where everything is in the still life: seen from above, and from the side.

use super::{Panel, Point, number, scale};
use glam::{Vec2, Vec3};
use plane_hit::Shape;
use ray_casting::scene::still_life_camera;
use shadows::scene::lit_still_life;

/// Pixels per unit of length.
const UNIT: f64 = 34.0;
/// The margin around the plotted area: left, right, top and bottom.
const MARGIN: [f64; 4] = [34.0, 16.0, 26.0, 40.0];

/// One of the two views of the scene.
struct Plan {
    /// The ends of what it shows of the axis to the right, and of the axis upwards.
    ends: [[f64; 2]; 2],
    /// These two coordinates of a point.
    axes: fn(Vec3) -> [f32; 2],
    names: [&'static str; 2],
    /// The points of the image plane through which the edges of the view go.
    edges: [Vec2; 2],
    caption: &'static str,
}

pub fn panels() -> Vec<Panel> {
    // The pictures are 4 to 3.
    let [right, up] = [Vec2::new(4.0 / 3.0, 0.0), Vec2::Y];
    let above = Plan {
        ends: [[-6.2, 6.2], [-7.6, 4.4]],
        axes: |point| [point.x, point.z],
        names: ["x", "z"],
        edges: [-right, right],
        caption: "The still life from above: x to the right, z away from the eye",
    };
    let aside = Plan {
        ends: [[-7.6, 4.8], [-0.4, 7.6]],
        axes: |point| [point.z, point.y],
        names: ["z", "y"],
        edges: [-up, up],
        caption: "The same from the right-hand side: z to the right, y up",
    };
    vec![above.panel(), aside.panel()]
}

impl Plan {
    fn panel(&self) -> Panel {
        let scene = lit_still_life([(); 6]);
        let camera = still_life_camera();
        let [size_x, size_y] = self.ends.map(|[from, to]| UNIT * (to - from));
        let [left, right, top, bottom] = MARGIN;
        let columns = [left, left + size_x];
        let rows = [top + size_y, top];
        let (x, y) = (scale(self.ends[0], columns), scale(self.ends[1], rows));
        let at = |point: Vec3| {
            let [to_right, upwards] = (self.axes)(point);
            [x(to_right.into()), y(upwards.into())]
        };
        let mut panel = Panel::new([size_x + left + right, size_y + top + bottom]);
        self.grid(&mut panel, x, y, columns, rows);

        // As far as the panel goes, however far that is.
        for edge in self.edges {
            let (start, end) = (at(camera.eye), at(camera.ray(edge).at(1.0)));
            panel.line("ray dashed", clip(start, end, columns, rows));
        }
        let mut words = Vec::new();
        let mut named = Vec::new();
        for object in &scene.objects {
            match object.shape {
                Shape::Sphere(sphere) => {
                    let radius = f64::from(sphere.radius);
                    panel.circle("solid", at(sphere.centre), UNIT * radius);
                    words.push(format!(
                        "{} at {} with a radius of {}",
                        object.name,
                        place(sphere.centre),
                        number(radius, 2)
                    ));
                    named.push((object.name, at(sphere.centre)));
                }
                // From the side the floor is a line; from above it is the paper.
                Shape::Plane(plane) if (self.axes)(plane.normal) == [0.0, 1.0] => {
                    let height = at(plane.point)[1];
                    panel.line("ink", columns.map(|x| [x, height]));
                }
                Shape::Plane(_) => (),
            }
        }
        for light in &scene.lights {
            let centre = at(light.position);
            panel.circle("dot ray", centre, 6.0);
            label(
                &mut panel,
                "ray",
                centre,
                "light",
                &place(light.position),
                columns,
            );
            words.push(format!("a light at {}", place(light.position)));
        }
        let eye = at(camera.eye);
        panel.circle("dot", eye, 5.0);
        // From the side, it stands above the upper edge of the view.
        let raised = if self.names[1] == "y" { 30.0 } else { 0.0 };
        let above = [eye[0], eye[1] - raised];
        label(&mut panel, "", above, "eye", &place(camera.eye), columns);
        words.push(format!("the eye at {}", place(camera.eye)));
        self.name(&mut panel, &named);
        panel.caption = format!(
            "{}. The dashed lines are the edges of the picture.",
            self.caption
        );
        panel.description = format!("{}: {}.", self.caption, words.join(", "));
        panel
    }

    /// The axes with a line for each unit of length.
    fn grid(
        &self,
        panel: &mut Panel,
        x: impl Fn(f64) -> f64,
        y: impl Fn(f64) -> f64,
        columns: [f64; 2],
        rows: [f64; 2],
    ) {
        let units = |[from, to]: [f64; 2]| from.ceil() as i32..=to.floor() as i32;
        for unit in units(self.ends[0]) {
            let x = x(unit.into());
            panel.line("faint", rows.map(|y| [x, y]));
            panel.text(
                "small",
                "middle",
                [x, rows[0] + 16.0],
                &number(unit.into(), 0),
            );
        }
        for unit in units(self.ends[1]) {
            let y = y(unit.into());
            panel.line("faint", columns.map(|x| [x, y]));
            panel.text(
                "small",
                "end",
                [columns[0] - 6.0, y + 4.0],
                &number(unit.into(), 0),
            );
        }
        panel.text(
            "",
            "end",
            [columns[1] + 12.0, rows[0] + 35.0],
            &format!("{} →", self.names[0]),
        );
        panel.text(
            "",
            "middle",
            [columns[0] - 8.0, rows[1] - 8.0],
            &format!("↑ {}", self.names[1]),
        );
    }

    /// The balls' names: within them from above, and above them where they hide each other.
    fn name(&self, panel: &mut Panel, balls: &[(&str, Point)]) {
        let mut balls = balls.to_vec();
        balls.sort_by(|(_, a), (_, b)| a[0].total_cmp(&b[0]));
        let is_above = self.names[1] == "z";
        let middle = balls.iter().map(|(_, [x, _])| x).sum::<f64>() / balls.len() as f64;
        for (i, (name, [x, y])) in balls.iter().enumerate() {
            if is_above {
                panel.text("small", "middle", [*x, y + 4.0], name);
            } else {
                let column = middle + 44.0 * (i as f64 - (balls.len() - 1) as f64 / 2.0);
                let row = MARGIN[2] + UNIT * (self.ends[1][1] - 2.55);
                panel.line("faint", [[column, row + 6.0], [*x, *y]]);
                panel.circle("dot", [*x, *y], 2.0);
                panel.text("small", "middle", [column, row], name);
            }
        }
    }
}

/// Writes a name and a place beside a point, on the side where there is room.
fn label(
    panel: &mut Panel,
    class: &str,
    [x, y]: Point,
    name: &str,
    place: &str,
    columns: [f64; 2],
) {
    let is_right = x > (columns[0] + columns[1]) / 2.0 + 1.0;
    let (anchor, x) = if is_right {
        ("end", x - 12.0)
    } else {
        ("start", x + 12.0)
    };
    panel.text(class, anchor, [x, y - 3.0], name);
    panel.text(&format!("small {class}"), anchor, [x, y + 13.0], place);
}

fn place(point: Vec3) -> String {
    let coordinates = point.to_array().map(|x| number(x.into(), 2));
    format!("({})", coordinates.join(", "))
}

/// Returns the ends of the half-line from `start` through `end`, as far as it is within the
/// columns and rows. `start` is.
fn clip(start: Point, end: Point, columns: [f64; 2], rows: [f64; 2]) -> [Point; 2] {
    let mut farthest = f64::INFINITY;
    for (axis, ends) in [columns, rows].into_iter().enumerate() {
        let step = end[axis] - start[axis];
        for end in ends {
            let t = (end - start[axis]) / step;
            if t > 0.0 && t < farthest {
                farthest = t;
            }
        }
    }
    let last = [0, 1].map(|axis| start[axis] + farthest * (end[axis] - start[axis]));
    [start, last]
}

#[cfg(test)]
mod the_plan {
    use super::*;

    #[test]
    fn says_where_everything_is() {
        for panel in panels() {
            let description = &panel.description;
            let scene = lit_still_life([(); 6]);
            for object in &scene.objects {
                if let Shape::Sphere(_) = object.shape {
                    assert!(description.contains(object.name), "{description}");
                }
            }
            assert_eq!(
                description.matches("a light at").count(),
                scene.lights.len()
            );
            assert!(
                description.contains("the eye at (0, 2, −7)"),
                "{description}"
            );
            assert_eq!(panel.shapes.matches("class=\"solid\"").count(), 5);
        }
    }

    /// Down to the right, it meets the lower edge at 3 before the right one at 10.
    #[test]
    fn ends_where_its_panel_does() {
        let line = clip([1.0, 1.0], [2.0, 2.0], [0.0, 10.0], [3.0, 0.0]);
        assert_eq!(line, [[1.0, 1.0], [3.0, 3.0]]);
        let line = clip([1.0, 1.0], [0.5, 1.0], [0.0, 10.0], [3.0, 0.0]);
        assert_eq!(line, [[1.0, 1.0], [0.0, 1.0]]);
    }
}

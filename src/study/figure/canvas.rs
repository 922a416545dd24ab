//! The sheet that a figure is drawn on.

use std::fmt::Write;

/// Pixels of the sheet, and of the edges of the plot within it.
const WIDTH: f64 = 760.0;
const HEIGHT: f64 = 500.0;
pub const LEFT: f64 = 72.0;
pub const RIGHT: f64 = 736.0;
pub const TOP: f64 = 92.0;
pub const BOTTOM: f64 = 392.0;
/// Letters of the small text, about.
const LETTER: f64 = 6.4;

/// Colours that stay apart for readers who confuse red and green (after Okabe and Ito), on light and on dark ground. The
/// first three are those of figure 2 of BeTr-GEESE, in its order: green, blue, yellow.
const COLOURS: [(&str, &str); 6] = [
    ("#00795a", "#2fd39f"),
    ("#0072b2", "#56b4e9"),
    ("#946c00", "#f0c04a"),
    ("#b84a00", "#ff9a6d"),
    ("#a3527f", "#e79fc8"),
    ("#59636e", "#b4bcc6"),
];

/// An SVG in the making.
pub struct Canvas {
    body: String,
    title: String,
}

impl Canvas {
    /// A sheet with a title above and a line of small print below.
    pub fn new(title: &str, foot: &str) -> Self {
        const MOST: usize = 62;
        let mut canvas = Self { body: String::new(), title: title.to_owned() };
        // The whole title stays in the file, as its name.
        let fits = title.chars().count() <= MOST;
        let shown = if fits { title.to_owned() } else { title.chars().take(MOST).chain(['\u{2026}']).collect() };
        canvas.text([LEFT, 28.0], "title", &shown);
        canvas.text([LEFT, HEIGHT - 12.0], "small", foot);
        canvas
    }

    /// A text; `class` gives size and anchor.
    pub fn text(&mut self, [x, y]: [f64; 2], class: &str, text: &str) {
        let text = escaped(text);
        self.put(&format!("<text class=\"{class}\" x=\"{x:.1}\" y=\"{y:.1}\">{text}</text>"));
    }

    /// A text that runs upward, centred on a place.
    pub fn upward_text(&mut self, [x, y]: [f64; 2], text: &str) {
        let text = escaped(text);
        self.put(&format!("<text class=\"middle\" transform=\"translate({x:.1} {y:.1}) rotate(-90)\">{text}</text>"));
    }

    /// A text centred below a place, broken into lines of at most so many pixels; returns how many lines.
    pub fn wrapped(&mut self, [x, y]: [f64; 2], width: f64, text: &str) -> usize {
        const MOST_LINES: usize = 4;
        // A word that would reach far into the next place is broken anywhere; fonts may be wider than `LETTER` says.
        let fits = ((width * 0.85 / LETTER) as usize).max(1);
        let words = text.split(' ').flat_map(|word| {
            let letters: Vec<char> = word.chars().collect();
            let is_long = letters.len() as f64 * LETTER > width * 1.5;
            let part = if is_long { fits } else { letters.len().max(1) };
            letters.chunks(part).map(|part| part.iter().collect::<String>()).collect::<Vec<_>>()
        });
        let mut lines: Vec<String> = Vec::new();
        for word in words {
            match lines.last_mut() {
                Some(line) if (line.chars().count() + 1 + word.chars().count()) as f64 * LETTER <= width => {
                    line.push(' ');
                    line.push_str(&word);
                }
                _ => lines.push(word),
            }
        }
        for (place, line) in lines.iter().take(MOST_LINES).enumerate() {
            self.text([x, y + 14.0 * place as f64], "middle", line);
        }
        lines.len().min(MOST_LINES)
    }

    /// A straight line.
    pub fn line(&mut self, from: [f64; 2], to: [f64; 2], class: &str) {
        let ([a, b], [c, d]) = (from, to);
        self.put(&format!("<line class=\"{class}\" x1=\"{a:.1}\" y1=\"{b:.1}\" x2=\"{c:.1}\" y2=\"{d:.1}\"/>"));
    }

    /// A rectangle between two corners.
    pub fn rectangle(&mut self, from: [f64; 2], to: [f64; 2], class: &str) {
        let (x, y) = (from[0].min(to[0]), from[1].min(to[1]));
        let (width, height) = ((from[0] - to[0]).abs(), (from[1] - to[1]).abs());
        self.put(&format!(
            "<rect class=\"{class}\" x=\"{x:.1}\" y=\"{y:.1}\" width=\"{width:.1}\" height=\"{height:.1}\"/>"
        ));
    }

    /// A dot.
    pub fn dot(&mut self, [x, y]: [f64; 2], radius: f64, class: &str) {
        self.put(&format!("<circle class=\"{class}\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{radius}\"/>"));
    }

    /// A line through points; `closed` makes it an area.
    pub fn path(&mut self, points: &[[f64; 2]], closed: bool, class: &str) {
        let mut path = String::new();
        for (place, [x, y]) in points.iter().enumerate() {
            // Writing to a String cannot fail.
            let _ = write!(path, "{}{x:.1} {y:.1}", if place == 0 { "M" } else { "L" });
        }
        let end = if closed { "Z" } else { "" };
        self.put(&format!("<path class=\"{class}\" d=\"{path}{end}\"/>"));
    }

    /// The words of the colours, and what the marks mean.
    pub fn legend(&mut self, groups: &[String], marks: &str) {
        let mut x = LEFT;
        for (group, word) in groups.iter().enumerate().filter(|(_, word)| !word.is_empty()) {
            let width = word.chars().count() as f64 * LETTER + 34.0;
            self.dot([x + 6.0, 50.0], 5.0, &format!("fill c{}", colour(group)));
            self.text([x + 16.0, 54.0], "", word);
            x += width;
        }
        self.text([LEFT, 74.0], "small", marks);
    }

    /// The text of the file.
    pub fn finish(self) -> String {
        let (mut light, mut dark) = (String::new(), String::new());
        for (place, (on_light, on_dark)) in COLOURS.iter().enumerate() {
            let _ = write!(light, ".c{place}{{--c:{on_light}}}");
            let _ = write!(dark, ".c{place}{{--c:{on_dark}}}");
        }
        let style = format!(
            "text{{font:12px system-ui,sans-serif;fill:#1c2127}}.title{{font-size:16px;font-weight:600}}\
             .small{{font-size:11px;fill:#59636e}}.middle{{text-anchor:middle}}.end{{text-anchor:end}}\
             .ground{{fill:#fafaf7}}.axis{{stroke:#1c2127}}.rule{{stroke:#1c2127;opacity:.12}}\
             .fill{{fill:var(--c)}}.point{{fill:var(--c);opacity:.5}}.band{{fill:var(--c);opacity:.18}}\
             .box{{fill:var(--c);fill-opacity:.14;stroke:var(--c)}}.mark{{stroke:var(--c);fill:none;stroke-width:2}}\
             .thin{{stroke:var(--c);fill:none}}{light}\
             @media(prefers-color-scheme:dark){{text{{fill:#e8eaed}}.small{{fill:#9aa4af}}.ground{{fill:#14171c}}\
             .axis,.rule{{stroke:#e8eaed}}{dark}}}"
        );
        let Self { body, title } = self;
        let title = escaped(&title);
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" width=\"{WIDTH}\" \
             height=\"{HEIGHT}\" role=\"img\" aria-label=\"{title}\"><title>{title}</title><style>{style}</style>\
             <rect class=\"ground\" width=\"{WIDTH}\" height=\"{HEIGHT}\"/>{body}</svg>\n"
        )
    }

    fn put(&mut self, element: &str) {
        self.body.push_str(element);
    }
}

/// The colour of a group; they come again when there are many.
pub fn colour(group: usize) -> usize {
    group % COLOURS.len()
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

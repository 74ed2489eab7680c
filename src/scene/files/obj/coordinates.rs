//! Reads the numbers of vertices and normals by `tobj`, from the file's own lines.

use std::{
    borrow::Cow,
    fmt::Write,
    io::{self, BufRead, Read},
};

/// The vertices and normals of a piece.
#[derive(Default)]
pub(super) struct Vertices {
    pub positions: Vec<[f64; 3]>,
    /// The colour of every vertex, NaN where it has none; empty if no vertex has one.
    pub colours: Vec<[f64; 3]>,
    pub normals: Vec<[f64; 3]>,
}

/// Lines of vertices and normals for `tobj`.
#[derive(Default)]
pub(super) struct NumberLines<'a>(Vec<Run<'a>>);

/// Lines of which all vertices have a colour, or none has.
#[derive(Default)]
struct Run<'a> {
    lines: Vec<Cow<'a, [u8]>>,
    vertices: usize,
    normals: usize,
    is_coloured: bool,
}

impl<'a> NumberLines<'a> {
    /// Adds whole lines of so many vertices.
    pub fn vertices(&mut self, lines: Cow<'a, [u8]>, count: usize, is_coloured: bool) {
        let is_other = |last: &Run| last.vertices > 0 && last.is_coloured != is_coloured;
        if self.0.last().is_some_and(is_other) {
            self.0.push(Run::default());
        }
        let run = self.last();
        run.is_coloured = is_coloured;
        run.vertices += count;
        run.lines.push(lines);
    }

    /// Adds whole lines of so many normals.
    pub fn normals(&mut self, lines: Cow<'a, [u8]>, count: usize) {
        let run = self.last();
        run.normals += count;
        run.lines.push(lines);
    }

    fn last(&mut self) -> &mut Run<'a> {
        if self.0.is_empty() {
            self.0.push(Run::default());
        }
        let last = self.0.len() - 1;
        &mut self.0[last]
    }

    /// Their numbers; `None` where `tobj` refuses a line.
    pub fn read(self) -> Option<Vertices> {
        let has_colours = self.0.iter().any(|run| run.vertices > 0 && run.is_coloured);
        let mut all = Vertices::default();
        for run in self.0 {
            let (vertices, normals) = (run.vertices, run.normals);
            let mesh = run.read()?;
            let [positions, colours, directions] =
                [&mesh.positions, &mesh.vertex_color, &mesh.normals]
                    .map(|numbers| numbers.as_chunks::<3>().0);
            if positions.len() < vertices || directions.len() != normals {
                return None;
            }
            all.positions.extend(&positions[..vertices]);
            all.normals.extend(directions);
            match colours.get(..vertices) {
                _ if !has_colours => {}
                Some(colours) => all.colours.extend(colours),
                None => all.colours.resize(all.positions.len(), [f64::NAN; 3]),
            }
        }
        Some(all)
    }
}

impl Run<'_> {
    /// `tobj` gives what faces use, in the order of their use. So one face more names all vertices, and one all
    /// normals, at a last vertex of its own.
    fn read(mut self) -> Option<tobj::Mesh> {
        let last = self.vertices + 1;
        let mut faces = String::from("v 0 0 0");
        if self.is_coloured {
            faces.push_str(" 0 0 0");
        }
        faces.push_str("\nf");
        // Writing to a string cannot fail.
        for vertex in 1..=last {
            let _ = write!(faces, " {vertex}");
        }
        if self.normals > 0 {
            faces.push_str("\nf");
        }
        for normal in 1..=self.normals {
            let _ = write!(faces, " {last}//{normal}");
        }
        faces.push('\n');
        self.lines.push(faces.into_bytes().into());
        let mut text = Chained {
            texts: &self.lines,
            at: 0,
        };
        let no_materials = |_: &_| Err(tobj::LoadError::GenericFailure);
        let read = tobj::load_obj_buf(&mut text, &tobj::LoadOptions::default(), no_materials);
        let (models, _) = read.ok()?;
        Some(models.into_iter().next()?.mesh)
    }
}

/// Texts, read one after the other.
struct Chained<'a> {
    texts: &'a [Cow<'a, [u8]>],
    /// How much of the first one is read.
    at: usize,
}

impl BufRead for Chained<'_> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        while let Some((first, others)) = self.texts.split_first()
            && self.at == first.len()
        {
            (self.texts, self.at) = (others, 0);
        }
        Ok(self.texts.first().map_or(&[], |first| &first[self.at..]))
    }

    fn consume(&mut self, bytes: usize) {
        self.at += bytes;
    }
}

impl Read for Chained<'_> {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        let read = self.fill_buf()?.read(into)?;
        self.consume(read);
        Ok(read)
    }
}

/// Lines of plain vertices or normals at the start of a text.
pub(super) struct PlainLines {
    pub bytes: usize,
    pub count: usize,
    /// How many numbers each of them has.
    pub words: usize,
}

/// The lines at the start of a text that begin with a keyword and have the same count of plain numbers, one of
/// `counts`; `None` if the first line is no such one. Each of them has an end.
pub(super) fn plain_lines(text: &[u8], keyword: &[u8], counts: &[usize]) -> Option<PlainLines> {
    let mut lines = PlainLines {
        bytes: 0,
        count: 0,
        words: 0,
    };
    while let Some(values) = text[lines.bytes..].strip_prefix(keyword)
        && let Some((bytes, words)) = plain_line(values)
        && counts.contains(&words)
        && (lines.words == words || lines.count == 0)
    {
        lines.bytes += keyword.len() + bytes;
        lines.count += 1;
        lines.words = words;
    }
    (lines.count > 0).then_some(lines)
}

/// The length of a line with its end, and how many words it has, if they have nothing but what numbers are written
/// with.
fn plain_line(text: &[u8]) -> Option<(usize, usize)> {
    let (mut words, mut in_word) = (0, false);
    for (at, byte) in text.iter().enumerate() {
        match byte {
            b'0'..=b'9' | b'.' | b'-' | b'+' | b'e' | b'E' => {
                words += usize::from(!in_word);
                in_word = true;
            }
            b' ' | b'\t' => in_word = false,
            b'\n' => return Some((at + 1, words)),
            b'\r' if text.get(at + 1) == Some(&b'\n') => return Some((at + 2, words)),
            _ => return None,
        }
    }
    None
}

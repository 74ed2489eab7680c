//! The help texts of `pick`: what picks guarantee, and what the fields of its output lines mean. Lines have at most 80
//! columns. [`crate::pick`] has the details.

/// What a pick is.
pub(super) const CONTRACT: &str = "\
What a pick is:
  A pick is what exact arithmetic says for the numbers that are stored. The
  camera stores the eye, the axes R (right), U (up) and F (forward), half the
  picture's height h (in perspective at depth 1), near, far and the size W x H.
  Each object stores the 12 numbers of its matrix M; each mesh its vertices, f32
  about an f64 origin, which lie at M (origin + vertex). --stored prints them.
  Numbers larger than 2^110 (about 1.3e33) are refused; of an OBJ file the faces
  that use one are left out. Those smaller than 2^-110 are stored as 0.
  With a = (h / H) ((2 X - W) R + (H - 2 Y) U) the ray of a position X,Y is
    eye + t (F + a)      in perspective
    eye + a + t F        with --ortho
  F + a is not made a unit vector, so t is depth along F.
  A hit counts where near <= t < far; with --cull only if it is a front one;
  with --section only if its point p has n . p + c >= 0, decided exactly.
  The pick is the hit with the least t on the visible objects. Of hits with
  equal t, it is the one on the first object, then on the first triangle.
  --all-hits lists all hits in this order.

What a hit is, in the object's own space:
  Edges, corners and rims belong to their shape.
  triangle  its corners run counter-clockwise, seen from outside. A ray in its
            plane misses. One without area is never hit.
  square    side 1 about 0,0,0 in the plane z = 0, facing +z. A ray in its
            plane misses.
  cube      side 1 about 0,0,0, solid: the ray enters (front) and leaves (back).
            Where both are one point, that is one hit: the entry. Where it
            enters, or leaves, by several faces at once, the one across the
            lowest axis is named.
  sphere    radius 1/2 about 0,0,0: the ray enters (front) and leaves (back). A
            ray that only touches it hits it once, and not from the front.
  Front and back stay what they are there under a matrix that mirrors. A matrix
  without an inverse in the range of numbers is refused.";

/// What the fields of a pick's line mean.
pub(super) const FIELDS: &str = "\
Fields of \"hit\", null where the picture shows the background; with --all-hits
of each of \"hits\":
  object, id       name, and number from 1
  triangle         of the object, from 0; null for sphere, cube and square
  material         the triangle's, as its OBJ file calls it; null where the file
                   names none
  colour           the surface's at the point, as #rrggbb, without light
  front            whether the surface is seen from outside
  t, depth         where on the ray: depth along F, from the eye; rounded once,
                   but never up to far
  distance         from the eye to the point
  ndc              the point in normalised device coordinates, z by --depth
  point_world, normal_world, point_object, normal_object
                   the point and the surface's outward unit normal, in the world
                   and in the object's own space
  barycentric      weights of the triangle's corners; null for other shapes
  edge_px          pixels from the position to the nearest edge of the triangle
                   or face, of a sphere to its outline, as far as these lie at
                   or behind the near plane and --section keeps them; null
                   where nothing does
  gap              exact difference in t to the next hit, rounded once: 0 on an
                   edge that two triangles share; null where there is no next
  exact            whether exact arithmetic decided what is hit up to here, or
                   which of two hits is nearer, because f64 could not
  file, line, face, vertices, corners
                   of a mesh: its OBJ file, read again; the line that its face
                   stands in and its number among the f lines, both from 1; the
                   corners of that polygon, each with vertex (its number), line,
                   written (its coordinates there) and stored (what they were
                   rounded to, where that is not the nearest f64); and which of
                   these the triangle's corners are, by place from 0, in the
                   order of barycentric. null where there is no file
  file_error       why the file cannot be used: it has changed, or is gone

Beside \"hit\" or \"hits\":
  in_one_place     the surfaces that drawing cannot tell apart here: the nearest
                   and those behind it by less than drawing's error in depth;
                   count, and named: the first 8, each with object, id, triangle
                   and front. null where the nearest lies by itself. Two faces
                   of a mesh that touch here, to within drawing's error (about
                   1/256 pixel), count as one unless they overlap: at an edge or
                   a corner of both, and where a corner of one lies exactly on
                   an edge of the other. So do the near and the far side of one
                   cube or sphere";

/// What the lines of `--snap` hold.
pub(super) const SNAPS: &str = "\
The lines of --snap R, one for each --at, with px:
  snap             null where nothing is near and the background shows; else to
                   (vertex, edge or face), object, id, triangle, point_world, px
                   (where that is) and away_px (from the position); line, face
                   and vertices: the vertex, the ends of the edge or the corners
                   of the face in the file; file_error, why that does not say;
                   length, of the edge; area, of the face that it is on
  distance         from the position before
  object_area      of the object; null for an ellipsoid
  file_error       where snap is null: why edges that are near did not count
  Vertices are measured as the file writes them, an object's area as its mesh
  is stored. The nearest visible vertex is taken, else the nearest visible point
  of an edge, else the pick; edges that only split a polygon into triangles do
  not count, nor do any of a file that does not say which those are. Of several
  that are exactly as near, the one with the least depth is taken, then the
  first object, then the first triangle. The area of a face is the sum over its
  triangles in the mesh: the face's own area, if it is flat and does not cross
  itself.";

/// What the line of `--stored` holds.
pub(super) const NUMBERS: &str = "\
The line of --stored, {\"stored\":{\"camera\",\"meshes\",\"objects\"}}:
  camera           eye, right (R), up (U), forward (F), half_height (h),
                   orthographic, near, far, size [W,H], cull, section (normal n
                   and offset c, or null)
  meshes           each once: origin; positions, relative to it; triangles, by
                   the places of their corners in positions, from 0
  objects          id, name, shape, visible; matrix, the upper three rows, as in
                   scene files; mesh, its place in meshes from 0, and triangles
                   [start,end) in that mesh; null for other shapes
Read as f64, each number is the stored one to the bit.";

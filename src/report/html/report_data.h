/*
 * report_data.h - the data inside a report (--report), version 1: what the C side writes and the viewer in src/web
 * reads.
 *
 * THE PAGE (src/web/README.md has its outline). Its parts, by their id:
 *   plain            a <main>: verdict, findings, picture, files as plain HTML. The viewer hides it once it has
 *                    started.
 *   fivecheck-head   <script type="text/plain">: the JSON object below, packed like a blob.
 *   blob-N           <script type="text/plain">: bytes as text (report/format/seven_bit.h). For a mesh they are
 *                    its code, for all others a zlib stream (RFC 1950: DecompressionStream("deflate")). N counts from
 *                    0. The JSON refers to a blob by its number N.
 *   fivecheck-viewer <script type="text/plain">: the viewer's one script, packed as a blob; boot.js inflates and runs
 *                    it.
 * The content security policy is `default-src 'none'` with the SHA-256 of the one <style>, of boot.js and of the
 * viewer: no style attributes in HTML text, no eval, no workers, no requests. Styles that scripts set through
 * element.style are allowed.
 *
 * UNITS. mm, degrees, seconds, machine coordinates. Positions in the JSON are numbers with up to 12 digits. Text is
 * valid UTF-8 and may contain anything that a stranger can write: insert it by textContent.
 *
 * THE JSON OBJECT (keys that do not apply are null or absent where that is said)
 *   report        1, this version. A viewer rejects unknown versions.
 *   fivecheck     version of the program, "0.1.0"
 *   program       name of the NC program as it was given
 *   verdict       {word, sentence, cautions: [text], doubts: [text], failing: bool, waived, left_out}
 *                 doubts: those of the cautions that doubt an assumption of the verdict (report/verdict.h);
 *                 word: "clear" "passed" "found" "accepted" "incomplete"; failing: does it fail the
 *                 run; waived, left_out: numbers of findings that a waiver, or --fail-on, excuses
 *   errors        [{file, line, column, text}]: why the check is incomplete
 *   files         [{kind, file, sha256}]: the files that were read; sha256 null: unknown
 *   options       {method, step, tolerance, clearance, all, dialect, ...} as in the header of --format=ndjson
 *   shard         null, or {part, parts, of}: only a part was checked
 *   machine       {name, file, axes: [axis], links: [name], spindle: {link, location: [3], direction: [3]},
 *                 workholding}
 *     axis        {name, title|null, type: "linear"|"rotary", parent, direction: [3], location: [3], limit_min|null,
 *                 limit_max|null, rate_max (per minute), home}. Axes are in the order of the machine file: a carrying
 *                 axis before the carried one.
 *     links       link 0 is "base"; link i + 1 is what axes[i] carries; `parent` is a link.
 *                 pose(0) = identity; pose(i + 1) = pose(parent) * motion(axes[i], value), where the motion is a
 *                 translation by value * direction, or a right-handed rotation by value about `direction` through
 *                 `location`. A vertex v of a body on link k is at pose(k) * v: meshes are in machine coordinates with
 *                 all axes at 0.
 *     spindle     its gauge point, and the direction from there to the tip of a tool; workholding: the link that
 *                 carries the work
 *   read_out      names of the axes in the order in which a control shows them (X Y Z A B C U V W)
 *   bodies        [{name, role, link, tool, mesh}] in the order of the machine file, then fixtures and parts, then
 *                 tools
 *     role        "machine" "fixture" "part" "stock" "holder" "shank" "cutter"
 *     tool        number of the tool that the body belongs to: it is shown only while that tool is in the spindle; 0:
 *                 always shown
 *     mesh        {blob, vertices, triangles, origin: [3], step: [3]}; null: the body has no triangles here; of a
 *                 turned body, as most tools are, {facets, profile: [r, z, r, z ...], x: [3], y: [3], z: [3], origin:
 *                 [3]}: see TURNED
 *   accuracy      mm: no drawn vertex is farther than this from the one in the STL file. Say "drawn to 0.02 mm; proved
 *                 on the STL's numbers".
 *   stock         null: there is none; else {body, when: "finding"|"end"|"start", excess}. bodies[body].mesh, null if
 *                 nothing is drawn, is the stock that remains at the first finding, or where the check ends. It
 *                 encloses the remaining material; material deeper than `excess` (mm) below its surface is certainly
 *                 there. "start": no cutter has been in the blank by then, and the blank is drawn.
 *   tools         [{number, name|null, length}]: of the setup
 *   offsets       [{name, axes: {X: ...}}]: the setup's work offsets
 *   pairs         [{a, b, status, clearance, reason}]: a, b: indices of bodies; status: "checked" "rigid" "adjacent"
 *                 "out of reach" "waived" "cutting"
 *   findings      [finding]: as in --format=ndjson (kind file line column move fraction a b axes time point clearance
 *                 block, and callers, accepted, reason, expires, axis, bound, target, excess ... where they apply) and
 *                 besides:
 *     bodies      [a, b]: indices of bodies; null for a limit
 *     tool        number of the tool in the spindle
 *     triangles   [[9 numbers of a triangle of a], [of b]], machine coordinates at the finding's pose. They touch, or
 *                 are the nearest. null for a limit, and with the stock.
 *     block_number  number of the block among those that were carried out, from 1, as in the path
 *                 At a finding's time the axes are exactly those of the finding, not those of the path.
 *   findings_left_out  the number of further findings (the first FINDINGS_MAX are here)
 *   statistics    [[name, text]]: for people
 *   sensitivity   of --sensitivity, as in NDJSON: [{quantity, direction, result, turn, kind ...}]; empty: not requested
 *   path          see PATH; null: the program moves nothing, or nothing was recorded
 *   clearance     see CLEARANCE; null: not measured
 *   planes        see PLANES; null: none
 *   code          see CODE
 *
 * TABLES. A table blob, inflated, is columns of whole numbers. First a head of 9 bytes for each column: u8 planes p,
 * f64 first (little endian). Then, column by column, p planes of rows - 1 bytes. For row r from 1 on, z = sum over k <
 * p of plane[k][r - 1] * 256^k is a zigzag code: d2 = z / 2 if z is even, else -(z + 1) / 2. d2 is a second difference:
 * with delta[0] = 0, delta[r] = delta[r - 1] + d2[r], value[r] = value[r - 1] + delta[r], value[0] = first. Numbers
 * stay below 2^53; z may exceed 2^32, so add planes as floating numbers, not with <<. The meaning of a value is
 * value * scale (its table's `scale`).
 *
 * A TABLE of a whole program comes at two levels:
 *   {columns: [name], scale: [number], rows, coarse: {blob, rows}, chunks: [{blob, first, rows, from, to}], complete}
 * rows: of the whole program. coarse: the whole program in at most COARSE_ROWS rows. chunks: the finest level in order
 * of time, as far as the size of the report permits, nearest to the findings first: rows `first` to `first + rows - 1`
 * of the program, times from..to (s). complete: the chunks hold all rows; coarse is null if they do and are few. Show
 * the chunk if there is one, else the coarse level.
 *
 * PATH. A table; a row is an instant. Between two rows all axes are linear in time. The first row is where the program
 * starts. Columns: time (scale 1e-5 s), block, line, file, tool, class, modes, feed (0.1 mm/min), then one column for
 * each axis in the order of machine.axes, by its name (scale 0.01 mm or 0.001 degrees). block: the number of the NC
 * block that ends or passes here, counted from 1; blocks that move nothing have no row. line: of that block in
 * files[file]. tool: in the spindle on the way to this row. class: of the motion that ends here: 0 rest (a dwell or a
 * tool change), 1 rapid, 2 feed, 3 feed with the spindle at rest, 4 a rapid whose path between both rows is unknown
 * (rapid="any"). modes: index in path.modes of the modes on the way to this row, -1: not kept. feed: the programmed
 * one; 0: a rapid, a feed of rotary axes alone, or a time (G93). In the coarse level rows are left out; every row
 * that is there is a row of the path. Besides the table's keys:
 *   files       [name]: of the program and its subprograms
 *   modes       [{work_offset: name|null, work: {X: ...}, shift: {X: ...}, length, tcp: bool, turned: bool, spindle}]:
 *               the active work offset (null: machine coordinates are commanded), its values, the shift by G52 and G92,
 *               the active tool length (mm), tool centre point control; turned: the program has rotated, mirrored or
 *               scaled its coordinates; spindle: revolutions per minute, below 0 with M4; 0: it does not turn, or its
 *               speed is unknown. With neither tcp nor turned an axis is at position - work - shift (Z: - length) in
 *               work coordinates
 *   end         time of the last row
 *   checked     time up to which the program was checked: the end of the block of the first finding, or `end`. The
 *               part after it was read but not checked.
 *
 * CLEARANCE. A table; a row is a block, in the coarse level one or several. Columns: time (scale 1e-5 s: where the
 * block ends), least (scale 0.001 mm), most, pair (index in `pairs`, -1: none was measured). Throughout the interval
 * from the row before to this one all bodies that must be kept apart are at least `least` apart (a proven bound,
 * rounded down; `most` is the largest of the bounds that were merged, so least = most for a single block). The bound is
 * within 0.3 mm of the smallest distance, or at least 60 % of it, as far as this is possible with about the effort of
 * the check; elsewhere at least a tenth of it; with --clearance-report 85 %. Values at the cap mean "the cap or more".
 * In the block of a finding `least` is at most the distance in the finding, 0 if bodies meet; otherwise no clearance is
 * measured between a cutter and the part, which need not be kept apart. Besides the table's keys:
 *   cap         mm
 *   start       s: where the first interval begins
 *   bound       mm: of all blocks, the cap or less
 *   smallest    {least, pair, file, line, time}: the block with the smallest clearance that was measured, and its end;
 *               with least > bound there are blocks whose clearance was not measured, but proved to be `bound` or
 *               more. null: none is smaller than the cap
 *
 * PLANES. {columns, scale, blob, rows}: a table of one level. Columns: time (1e-5 s), pair, x, y, z (0.01 mm), nx, ny,
 * nz (1e-6), distance (0.001 mm). From this row's time to the next row's, or to a finding: of this pair two triangles
 * are nearest at `time`; the plane through (x, y, z) with the unit normal (nx, ny, nz), which points from body a to
 * body b, lies half-way between them. Both are given in coordinates of the link of body a at its zero pose: multiply by
 * pose(link of a). distance: of both triangles at that time. pair -1: nothing is near (farther than the cap).
 *
 * CODE. {mode: "all" | "windows" | "none", files: [{name, sha256|null, lines, windows: [{first, lines, blob}]}]}.
 * lines: of the whole file; -1: not known. A window's blob, inflated, is UTF-8 text of `lines` lines from line `first`
 * on (from 1), separated by \n. files are in the order of path.files, which names callers, too.
 *
 * TURNED. A turned body has for each corner (r, z) of its profile, from the top down and in whole numbers of 0.001 mm,
 * a ring of `facets` vertices: number k at r cos(a), r sin(a), z with a = 2 pi k / facets; v of these is drawn at
 * origin + v.x x + v.y y + v.z z. Between a ring and the next one, for each k: triangles (upper k, lower k, lower k +
 * 1), (upper k, lower k + 1, upper k + 1); a fan about the centre of the first ring, (centre, k, k + 1), and one about
 * that of the last, (centre, k + 1, k).
 *
 * MESHES. A mesh blob is the output of a range coder (report/format/range_coder.h: bits and numbers, each under a
 * model) and not deflated. It says in which order triangles are met on a walk and where new vertices are, on a grid:
 * the coordinate is origin + step * q, q from 0 to 65535. Corners are counter-clockwise from outside. z(x) is a zigzag
 * code: 2 x, or -2 x - 1 below 0. `seen` counts vertices.
 *   Until there are as many triangles as the head says: BEGIN, then, while there are gates, take the last one that was
 *   added; if its edge is open, look BEYOND it.
 *   BEGIN, for corner k = 0, 1, 2: a bit under begins[k]. 1: a new VERTEX, k, whose near vertices are the corner before
 *   (for k = 0 the newest vertex, at first the point 0 0 0) and for k = 2 corner 0, too. 0: the vertex seen - 1 - n, n
 *   a number under back_at_start. TAKE the corners. TAKE a, b, c: a triangle. Each of its edges a-b, b-c, c-a (from u
 *   to v) that is open is no longer open; of one that is not, the edge from v to u becomes open, after[v] = u,
 *   before[u] = v. Gates are added: (b, a, c), (a, c, b), (c, b, a): an edge, and the vertex opposite it. BEYOND the
 *   gate (a, b, o): x = before[a], usable if it is not b and the edge x-a is open; y = after[b], usable if it is not a
 *   and b-y is open. Ask in this order, until a bit is 1: 1 a new vertex? 2 x, if usable? 3 y, if usable? 0 nothing? If
 *   none is, it is 4, an older vertex. The models: beyond[answer asked for][x usable][y usable][history]; history, 0 at
 *   first, becomes (5 history + answer) mod 125. 0: the edge is no longer open. Else TAKE a, b and: 1 a new VERTEX,
 *   corner 2, near b, a, o; 2 x; 3 y; 4 the vertex seen - 1 - n, n a number under back. VERTEX k with near vertices n0,
 *   n1, n2 (one, two or all of them). Steps are q - n0. A memory of 2^14 places, empty at first, is looked at where the
 *   two steps before lead: h(dx, dy, dz) = 73856093 dx ^ 19349663 dy ^ 83492791 dz; place = ((31 h(last) + h(last but
 *   one)) * 0x9e3779b1 mod 2^32) >> 18; h is 0 before there are steps. A place holds a step and a run (0: empty). A bit
 *   under again[run]: 1: it is this step, run = min(run + 1, 7). 0: run = 1 and for each coordinate k = 0, 1, 2 of the
 *   point: for i = 0, 1, 2, as far as there is a near vertex i and none before it has the same coordinate: a bit under
 *   equal[corner][k][e][i], 1: it is that vertex' coordinate. If no bit was 1: guess = n0, or with three near vertices
 *   n0 + n1 - n2; a bit under known[k][e], V[k] being the list of values, in order, that this k has got as follows. 1:
 *   the value V[k][r + d], r = how many of them are less than guess, z(d) a number under rank[corner]. 0: guess + d,
 *   z(d) a number under residual[corner], which V[k] gets. e, 0 at first, becomes (2 e + (some bit was 1)) mod 4. In
 *   the end the place holds this step.
 */
#ifndef FIVECHECK_REPORT_HTML_REPORT_DATA_H
#define FIVECHECK_REPORT_HTML_REPORT_DATA_H

enum { REPORT_DATA_VERSION = 1, COARSE_ROWS = 4096, CHUNK_ROWS = 4096, SHORT_CHUNKS = 4, FINDINGS_MAX = 500 };

#endif

# lib.sh - functions of the program tests: they make small bodies, machines and setups.
# shellcheck shell=sh

# box NAME X0 Y0 Z0 X1 Y1 Z1 - writes NAME.stl: a closed box between two corners, twelve triangles facing outward
box() {
	awk -v name="$1" -v c0="$2 $3 $4" -v c1="$5 $6 $7" '
	function corner(bits) {
		return sprintf("%s %s %s", bits % 2 ? hi[1] : lo[1], int(bits / 2) % 2 ? hi[2] : lo[2],
			       int(bits / 4) ? hi[3] : lo[3])
	}
	BEGIN {
		split(c0, lo, " ")
		split(c1, hi, " ")
		# Corner bits: 1 for X, 2 for Y, 4 for Z; six faces, counter-clockwise from outside.
		count = split("0 2 3 1  4 5 7 6  0 1 5 4  2 6 7 3  0 4 6 2  1 3 7 5", f, " ")
		print "solid " name
		for (i = 1; i <= count; i += 4) {
			for (half = 0; half < 2; half++) {
				print "facet normal 0 0 0\nouter loop"
				print "vertex " corner(f[i])
				print "vertex " corner(f[i + 1 + half])
				print "vertex " corner(f[i + 2 + half])
				print "endloop\nendfacet"
			}
		}
		print "endsolid " name
	}' >"$1.stl"
}

# tetrahedron NAME X Y Z ... - writes NAME.stl from four corners, the first three clockwise as the fourth sees them
tetrahedron() {
	echo "$@" | awk '{
		print "solid " $1
		count = split("0 1 2  0 3 1  1 3 2  2 3 0", f, " ")
		for (i = 1; i <= count; i += 3) {
			print "facet normal 0 0 0\nouter loop"
			for (k = 0; k < 3; k++)
				print "vertex " $(2 + 3 * f[i + k]) " " $(3 + 3 * f[i + k]) " " $(4 + 3 * f[i + k])
			print "endloop\nendfacet"
		}
		print "endsolid " $1
	}' >"$1.stl"
}

# sphere NAME RADIUS N - writes NAME.stl: about the origin, N rings of 2 N facets, its corners on the sphere
sphere() {
	awk -v name="$1" -v radius="$2" -v n="$3" '
	function corner(i, j, t, f) {
		if (i % n == 0)
			return sprintf("vertex 0 0 %.9g\n", i ? -radius : radius)
		t = pi * i / n
		f = pi * (j % (2 * n)) / n
		return sprintf("vertex %.9g %.9g %.9g\n", radius * sin(t) * cos(f), radius * sin(t) * sin(f),
			       radius * cos(t))
	}
	function facet(a, b, c) {
		printf "facet normal 0 0 0\nouter loop\n%s%s%sendloop\nendfacet\n", a, b, c
	}
	BEGIN {
		pi = atan2(0, -1)
		print "solid " name
		for (i = 0; i < n; i++) {
			for (j = 0; j < 2 * n; j++) {
				if (i < n - 1)
					facet(corner(i, j), corner(i + 1, j), corner(i + 1, j + 1))
				if (i > 0)
					facet(corner(i, j), corner(i + 1, j + 1), corner(i, j + 1))
			}
		}
		print "endsolid " name
	}' >"$1.stl"
}

# machine FILE - wraps standard input, the content of <base> and what follows it, into a machine file.
# A line that is just "--" ends the base.
machine() {
	{
		echo '<machine version="1" name="test machine" units="mm">'
		echo '<base>'
		awk '$0 == "--" { print "</base>"; ended = 1; next } { print } END { if (!ended) print "</base>" }'
		echo '</machine>'
	} >"$1"
}

# setup FILE - wraps standard input into a setup file
setup() {
	{
		echo '<setup version="1" units="mm">'
		cat
		echo '</setup>'
	} >"$1"
}

# small_machine - m.xml: X carries Z, which carries the head (its face at z=100 when Z=0) with the
# spindle; the table (top at z=0) turns about C, which is at the origin. X +-200, Z -150..50.
small_machine() {
	box head -20 -20 100 20 20 200
	box table -50 -50 -20 50 50 0
	machine m.xml <<'XML'
  <axis name="X" type="linear" direction="1 0 0" limit_min="-200" limit_max="200" rate_max="6000">
    <axis name="Z" type="linear" direction="0 0 1" limit_min="-150" limit_max="50" rate_max="6000">
      <body name="head" mesh="head.stl"/>
      <spindle location="0 0 100" direction="0 0 -1"/>
    </axis>
  </axis>
  <axis name="C" type="rotary" direction="0 0 -1" location="0 0 0" rate_max="3600">
    <body name="table" mesh="table.stl"/>
    <workholding location="0 0 0"/>
  </axis>
XML
}

# stock_mill - m.xml: X, Y and Z without bodies, +-300; at X0 Y0 Z-100 the gauge point is at the workholding
stock_mill() {
	machine m.xml <<'XML'
  <axis name="X" type="linear" direction="1 0 0" limit_min="-300" limit_max="300" rate_max="6000">
    <axis name="Y" type="linear" direction="0 1 0" limit_min="-300" limit_max="300" rate_max="6000">
      <axis name="Z" type="linear" direction="0 0 1" limit_min="-300" limit_max="300" home="100" rate_max="6000">
        <spindle location="0 0 100" direction="0 0 -1"/>
      </axis>
    </axis>
  </axis>
  <workholding location="0 0 0"/>
XML
}

# drawn_mill FILE - a mill with a body on every link: X +-200 with the slide carries Z -130..100 with the head, whose face is
# at z=200 when Z=0; Y +-200 carries the table, its top at z=60, 2 mm above the bed, which is 20 mm below the slide
drawn_mill() {
	box bed -100 -100 0 100 100 50
	box table -100 -100 52 100 20 60
	box slide -100 30 70 100 60 400
	box head -20 -20 200 20 25 300
	machine "$1" <<'XML'
  <body name="bed" mesh="bed.stl"/>
  <axis name="X" type="linear" direction="1 0 0" limit_min="-200" limit_max="200" rate_max="6000">
    <body name="slide" mesh="slide.stl"/>
    <axis name="Z" type="linear" direction="0 0 1" limit_min="-130" limit_max="100" rate_max="6000">
      <body name="head" mesh="head.stl"/>
      <spindle location="0 0 200" direction="0 0 -1"/>
    </axis>
  </axis>
  <axis name="Y" type="linear" direction="0 -1 0" limit_min="-200" limit_max="200" rate_max="6000">
    <body name="table" mesh="table.stl"/>
    <workholding location="0 0 60"/>
  </axis>
XML
}

# program FILE - standard input, as it is
program() {
	cat >"$1"
}

# fivecheck ARGUMENT... - the program under test
fivecheck() {
	"$FIVECHECK" "$@"
}

# status COMMAND... - runs it and prints its exit status after its output
status() {
	"$@"
	echo "status $?"
}

# findings ARGUMENT... - runs the program and prints a row a finding: kind line a b fraction(5 digits)
# distance(4 digits)
findings() {
	"$FIVECHECK" -q -f ndjson "$@" | awk '
	function value(key,    rest) {
		if (!match($0, "\"" key "\": *"))
			return "-"
		rest = substr($0, RSTART + RLENGTH)
		if (match(rest, /^"[^"]*"/))
			return substr(rest, 2, RLENGTH - 2)
		match(rest, /^[^,}]*/)
		return substr(rest, 1, RLENGTH)
	}
	/^{"kind":"(header|program|summary)"/ { next }
	{ printf "%s %s %s/%s %.5f %.4f\n", value("kind"), value("line"), value("a"), value("b"), value("fraction"),
	         value("clearance") }'
}

# rectangle NAME HALF_X HALF_Y HALF_Z [X Y Z] - a box about a middle point
rectangle() {
	# shellcheck disable=SC2046 # six words are wanted
	box "$1" $(awk -v h="$2 $3 $4" -v m="${5:-0} ${6:-0} ${7:-0}" 'BEGIN {
		split(h, s, " "); split(m, c, " ")
		printf "%.9g %.9g %.9g %.9g %.9g %.9g", c[1] - s[1], c[2] - s[2], c[3] - s[3],
		       c[1] + s[1], c[2] + s[2], c[3] + s[3]
	}')
}

# skip REASON - ends the test, because this computer lacks something; the runner repeats the reason
skip() {
	echo "$*" >>"$SKIP_REASONS"
	exit 77
}

# leave_out REASON - the test continues without a part that prints nothing
leave_out() {
	echo "$*" >>"$SKIP_REASONS"
}

# need TOOL - skips the test if this program is missing
need() {
	command -v "$1" >/dev/null || skip "there is no $1"
}

# soon COMMAND... - in at most 20 s of processor time; ends a command that waits for ever, also on a busy computer
soon() (
	ulimit -t 20
	exec timeout 1000 "$@"
)

"""report_data.py - reads a report as src/report/html/report_data.h describes it, on its own, and holds it against other outputs."""
import base64
import hashlib
import html.parser
import json
import math
import struct
import sys
import zlib

from packed_text import Mesh, seven_bit


class Page(html.parser.HTMLParser):
    """The elements of a page with their text; scripts and styles by id or kind."""

    def __init__(self, text):
        super().__init__()
        self.tags, self.scripts, self.policy, self.style, self.text, self.open = {}, {}, None, "", "", None
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.tags.setdefault(tag, []).append(attributes)
        if attributes.get("http-equiv") == "Content-Security-Policy":
            self.policy = attributes["content"]
        self.open = attributes.get("id", "boot") if tag == "script" else tag
        if tag == "script":
            self.scripts[self.open] = ""

    def handle_endtag(self, tag):
        self.open = None

    def handle_data(self, data):
        if self.open in self.scripts:
            self.scripts[self.open] += data
        elif self.open == "style":
            self.style += data
        else:
            self.text += data


class Report:
    def __init__(self, path):
        with open(path, encoding="utf-8") as file:
            self.source = file.read()
        self.page = Page(self.source)
        self.head = json.loads(zlib.decompress(seven_bit(self.page.scripts["fivecheck-head"])))
        assert self.head["report"] == 1

    def blob(self, number):
        return zlib.decompress(seven_bit(self.page.scripts[f"blob-{number}"]))

    def table(self, number, rows, scale):
        data, columns = self.blob(number), len(scale)
        heads = [struct.unpack_from("<Bd", data, 9 * c) for c in range(columns)]
        at, values = 9 * columns, []
        for (planes, first), unit in zip(heads, scale):
            codes = [sum(data[at + k * (rows - 1) + r] << 8 * k for k in range(planes)) for r in range(rows - 1)]
            at += planes * (rows - 1)
            column, delta = [first], 0
            for z in codes:
                delta += -(z + 1) // 2 if z & 1 else z // 2
                column.append(column[-1] + delta)
            values.append([v * unit for v in column])
        assert at == len(data)
        return values

    def columns(self, name, level):
        """Columns by name of a level's table: {"blob", "rows"}."""
        table = self.head[name]
        return dict(zip(table["columns"], self.table(level["blob"], level["rows"], table["scale"])))

    def chunks(self, name):
        """All chunks of a table, joined."""
        joined = {}
        for chunk in self.head[name]["chunks"]:
            for key, column in self.columns(name, chunk).items():
                joined.setdefault(key, []).extend(column)
        return joined

    def mesh(self, mesh):
        if "profile" in mesh:
            return turned(mesh)
        read = Mesh(seven_bit(self.page.scripts[f"blob-{mesh['blob']}"]), mesh["triangles"])
        assert len(read.points) == mesh["vertices"] and len(read.corners) == 3 * mesh["triangles"]
        return [tuple(mesh["origin"][k] + mesh["step"][k] * p[k] for k in range(3)) for p in read.points], read.corners


def turned(mesh):
    """The vertices and corners of a body that is told by its outline."""
    n, numbers = mesh["facets"], [0.001 * v for v in mesh["profile"]]
    rings = list(zip(numbers[::2], numbers[1::2]))
    local = [(r * math.cos(2 * math.pi * k / n), r * math.sin(2 * math.pi * k / n), z) for r, z in rings for k in range(n)]
    local += [(0, 0, rings[0][1]), (0, 0, rings[-1][1])]
    last = n * (len(rings) - 1)
    corners = []
    for k in range(n):
        after = (k + 1) % n
        corners += [len(local) - 2, k, after, len(local) - 1, last + after, last + k]
        for at in range(0, last, n):
            corners += [at + k, at + n + k, at + n + after, at + k, at + n + after, at + after]
    return [tuple(mesh["origin"][i] + u * mesh["x"][i] + v * mesh["y"][i] + w * mesh["z"][i] for i in range(3)) for u, v, w in local], corners


def rotate(p, location, u, angle):
    c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    d = [p[k] - location[k] for k in range(3)]
    cross = [u[1] * d[2] - u[2] * d[1], u[2] * d[0] - u[0] * d[2], u[0] * d[1] - u[1] * d[0]]
    along = sum(u[k] * d[k] for k in range(3)) * (1 - c)
    return [location[k] + c * d[k] + s * cross[k] + along * u[k] for k in range(3)]


def place(machine, link, axes, p):
    while link:
        axis = machine["axes"][link - 1]
        value = axes[axis["name"]]
        if axis["type"] == "rotary":
            p = rotate(p, axis["location"], axis["direction"], value)
        else:
            p = [p[k] + value * axis["direction"][k] for k in range(3)]
        link = axis["parent"]
    return p


def hash_of(text):
    return "'sha256-" + base64.b64encode(hashlib.sha256(text.encode()).digest()).decode() + "'"


def check_policy(report):
    policy = report.page.policy
    assert policy.startswith("default-src 'none'"), policy
    assert hash_of(report.page.style) in policy
    assert hash_of(report.page.scripts["boot"]) in policy
    viewer = zlib.decompress(seven_bit(report.page.scripts["fivecheck-viewer"])).decode()
    assert hash_of(viewer) in policy
    assert "unsafe" not in policy
    for tag, all_of in report.page.tags.items():
        assert tag not in ("img", "iframe", "object", "link", "base", "form"), tag
        for attributes in all_of:
            assert not any(name.startswith("on") or name in ("style", "srcset") for name in attributes), attributes
    print("policy holds")


def check_findings(report, ndjson):
    with open(ndjson, encoding="utf-8") as file:
        lines = [json.loads(line) for line in file]
    wanted = [line for line in lines if line["kind"] not in ("header", "program", "summary")]
    assert len(wanted) == len(report.head["findings"])
    for line, finding in zip(wanted, report.head["findings"]):
        assert {key: finding[key] for key in line} == line
    print(f"{len(wanted)} findings are those of ndjson")


def check_path(report, dump):
    """Every row of --dump-path stands in the path; between rows of the path nothing else happens."""
    path = report.chunks("path")
    with open(dump, encoding="utf-8") as file:
        names = file.readline().split()
        rows = [dict(zip(names, map(float, line.split()))) for line in file]
    at = {round(t, 5): i for i, t in enumerate(path["time"])}
    axes = [axis["name"] for axis in report.head["machine"]["axes"]]
    scales = dict(zip(report.head["path"]["columns"], report.head["path"]["scale"]))
    count = 0
    for row in rows:
        if row["time"] > report.head["path"]["end"] + 1e-9:
            break
        i = at.get(round(row["time"], 5))
        if i is None:
            i = min(range(len(path["time"])), key=lambda k: abs(path["time"][k] - row["time"]))
        assert abs(path["time"][i] - row["time"]) < 1.01e-5, row
        assert path["line"][i] == row["line"] and path["tool"][i] == row["tool"], (row, i)
        for name in axes:
            assert abs(path[name][i] - row[name]) <= 0.51 * scales[name], (row, i, name)
        count += 1
    assert count and report.head["path"]["rows"] == len(path["time"])
    print("the path is that of --dump-path")


def check_pose(report, stl):
    """Vertices of all bodies at the first finding, against the STL file of --pose."""
    head, finding = report.head, report.head["findings"][0]
    drawn = []
    for body in head["bodies"]:
        if body["mesh"] and body["tool"] in (0, finding["tool"]):
            vertices, corners = report.mesh(body["mesh"])
            moved = [place(head["machine"], body["link"], finding["axes"], v) for v in vertices]
            drawn += [sorted(moved[c] for c in corners[i:i + 3]) for i in range(0, len(corners), 3)]
    with open(stl, "rb") as file:
        data = file.read()
    count = struct.unpack_from("<I", data, 80)[0]
    wanted = []
    for i in range(count):
        numbers = struct.unpack_from("<9f", data, 84 + 50 * i + 12)
        wanted.append(sorted(list(numbers[k:k + 3]) for k in (0, 3, 6)))
    bound, worst = head["accuracy"] + 1e-4, 0
    cells = {}
    for triangle in drawn:
        for p in triangle:
            cells.setdefault(tuple(math.floor(c / 0.25) for c in p), []).append(p)
    for triangle in wanted:
        for p in triangle:
            cell = [math.floor(c / 0.25) for c in p]
            near = [q for dx in (-1, 0, 1) for dy in (-1, 0, 1) for dz in (-1, 0, 1)
                    for q in cells.get((cell[0] + dx, cell[1] + dy, cell[2] + dz), [])]
            worst = max(worst, min((math.dist(p, q) for q in near), default=math.inf))
    assert worst <= bound, (worst, bound)
    assert len(drawn) <= count
    print("bodies stand as in --pose")


def check_contact(report):
    """The triangles of the first finding are triangles of its bodies, and the contact is on both."""
    head, finding = report.head, report.head["findings"][0]
    for body, triangle in zip(finding["bodies"], finding["triangles"]):
        vertices, _ = report.mesh(head["bodies"][body]["mesh"])
        moved = [place(head["machine"], head["bodies"][body]["link"], finding["axes"], v) for v in vertices]
        for k in (0, 3, 6):
            assert min(math.dist(triangle[k:k + 3], q) for q in moved) <= head["accuracy"] + 1e-4
        low = [min(triangle[k::3]) for k in range(3)]
        high = [max(triangle[k::3]) for k in range(3)]
        assert all(low[k] - 0.01 - finding["clearance"] <= finding["point"][k] <= high[k] + 0.01 + finding["clearance"] for k in range(3))
    print("the triangles of the contact are the bodies' own")


def least_of_table(table):
    """The least clearance of each block that moves, in their order."""
    least = {}
    with open(table, encoding="utf-8") as file:
        file.readline()
        for line in file:
            fields = line.rstrip("\n").split(",")
            block, value = int(fields[3]), float(fields[6])
            least[block] = min(least.get(block, math.inf), value)
    return [least[block] for block in sorted(least)]


def promised(distance):
    """As much is at least proved in a short program."""
    return min(0.6 * distance, max(distance - 0.3, 0.25 * distance))


def check_clearance(report, table, sharp=False):
    """The least clearance of each block, against --clearance-report, whose cap is the same, and which is 85 % of the truth."""
    moving = least_of_table(table)
    values = report.chunks("clearance")
    level = report.head["clearance"]["coarse"]
    coarse = report.columns("clearance", level) if level else values
    assert len(values["least"]) == len(moving), (len(values["least"]), len(moving))
    for mine, wanted in zip(values["least"], moving):
        assert mine <= (wanted if sharp else wanted / 0.85) + 1e-9, (mine, wanted)
        assert mine > (wanted if sharp else promised(wanted)) - 0.0021, (mine, wanted)
    assert min(coarse["least"]) == min(values["least"])
    print("clearances are those of --clearance-report" if sharp else "clearances are as sharp as promised")


def check_long_clearance(report, table):
    """Of a long program: nothing below what is proved of it all, and one block in eight as sharp as in a short one."""
    moving = least_of_table(table)
    values = report.chunks("clearance")["least"]
    least = min(moving)
    assert len(values) == len(moving), (len(values), len(moving))
    for number, (mine, wanted) in enumerate(zip(values, moving), 1):
        assert mine <= wanted / 0.85 + 1e-9, (number, mine, wanted)
        assert mine > 0.6 * min(wanted, least) - 0.0021, (number, mine, wanted)
        assert number % 8 or mine > promised(wanted) - 0.0021, (number, mine, wanted)
    assert sum(mine < promised(wanted) - 0.0021 for mine, wanted in zip(values, moving)) > len(moving) / 4
    print("the curve of a long program is a lower bound")


def check_sharp(report, table):
    check_clearance(report, table, sharp=True)


def check_smallest(report, table):
    """The block that is named as the nearest one has the least clearance of --clearance-report, between the same bodies."""
    clearance, bodies = report.head["clearance"], report.head["bodies"]
    named, pair = clearance["smallest"], report.head["pairs"][clearance["smallest"]["pair"]]
    with open(table, encoding="utf-8") as file:
        rows = [line.rstrip("\n").split(",") for line in file][1:]
    least = min(float(row[6]) for row in rows)
    place = [named["file"], str(named["line"]), *(bodies[body]["name"] for body in (pair["a"], pair["b"]))]
    assert any(row[1:3] + row[4:6] == place and float(row[6]) < least + 0.001 for row in rows), (place, least)
    assert least - 0.002 < named["least"] <= least + 1e-4 and clearance["bound"] == named["least"], (named, least)
    assert any(abs(time - named["time"]) < 1e-5 for time in report.chunks("clearance")["time"])
    print(f"the nearest block is in {named['file']}")


def check_code(report, name):
    with open(name, encoding="utf-8", errors="replace") as file:
        lines = file.read().split("\n")
    entry = [f for f in report.head["code"]["files"] if f["name"] == name][0]
    for window in entry["windows"]:
        text = report.blob(window["blob"]).decode().split("\n")
        assert len(text) == window["lines"]
        assert text == lines[window["first"] - 1:window["first"] - 1 + window["lines"]]
    print(f"code: {report.head['code']['mode']}, {sum(w['lines'] for w in entry['windows'])} of {entry['lines']} lines")


def check_curve(report):
    """The curve of clearance is not above a finding."""
    values = report.chunks("clearance")
    for finding in report.head["findings"]:
        row = next(i for i, time in enumerate(values["time"]) if time >= finding["time"] - 1e-5)
        assert values["least"][row] <= finding["clearance"] + 1e-9, (finding["kind"], values["least"][row])
        print(f"{finding['kind']}: the curve is at {values['least'][row]:.3f} mm")


def check_planes(report):
    """A plane lies beside its two triangles' midpoint: half of `distance` from either body along its normal."""
    planes = report.head["planes"]
    columns = dict(zip(planes["columns"], report.table(planes["blob"], planes["rows"], planes["scale"])))
    assert columns["time"] == sorted(columns["time"])
    for i in range(planes["rows"]):
        assert abs(math.hypot(columns["nx"][i], columns["ny"][i], columns["nz"][i]) - 1) < 1e-5
        assert columns["distance"][i] > 0
    print("planes are in order")


CHECKS = {"policy": check_policy, "findings": check_findings, "path": check_path, "pose": check_pose, "contact": check_contact,
          "clearance": check_clearance, "long-clearance": check_long_clearance, "sharp": check_sharp, "code": check_code,
          "planes": check_planes, "curve": check_curve, "smallest": check_smallest}


def main():
    report = Report(sys.argv[1])
    for word in sys.argv[2:]:
        name, _, argument = word.partition("=")
        if name == "text":
            assert argument in report.page.text, argument
            print("said in plain HTML")
        elif argument:
            CHECKS[name](report, argument)
        else:
            CHECKS[name](report)


if __name__ == "__main__":
    main()

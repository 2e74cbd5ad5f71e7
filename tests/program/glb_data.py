"""glb_data.py GLB STL [NAME...] - holds the last instant of a glTF file's animation against the STL file of --pose; the nodes have the names."""
import json
import math
import struct
import sys


def read(path):
    with open(path, "rb") as file:
        data = file.read()
    magic, version, length = struct.unpack_from("<4sII", data)
    assert (magic, version, length) == (b"glTF", 2, len(data))
    size, kind = struct.unpack_from("<I4s", data, 12)
    assert kind == b"JSON" and size % 4 == 0
    document = json.loads(data[20:20 + size])
    length, kind = struct.unpack_from("<I4s", data, 20 + size)
    assert kind == b"BIN\0" and 28 + size + length == len(data)
    return document, data[28 + size:]


def accessor(document, binary, number):
    it = document["accessors"][number]
    view = document["bufferViews"][it["bufferView"]]
    width = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}[it["type"]]
    letter = {5126: "f", 5125: "I"}[it["componentType"]]
    flat = struct.unpack_from(f"<{width * it['count']}{letter}", binary, view["byteOffset"])
    rows = [flat[i:i + width] for i in range(0, len(flat), width)]
    if "min" in it:
        assert math.dist(it["min"], [min(r[k] for r in rows) for k in range(width)]) < 1e-6
        assert math.dist(it["max"], [max(r[k] for r in rows) for k in range(width)]) < 1e-6
    return rows


def turn(q, p):
    x, y, z, w = q
    t = [2 * (y * p[2] - z * p[1]), 2 * (z * p[0] - x * p[2]), 2 * (x * p[1] - y * p[0])]
    return [p[0] + w * t[0] + y * t[2] - z * t[1], p[1] + w * t[1] + z * t[0] - x * t[2], p[2] + w * t[2] + x * t[1] - y * t[0]]


def apply(node, p):
    s, q, t = node.get("scale", [1, 1, 1]), node.get("rotation", [0, 0, 0, 1]), node.get("translation", [0, 0, 0])
    p = turn(q, [p[k] * s[k] for k in range(3)])
    return [p[k] + t[k] for k in range(3)]


def main():
    document, binary = read(sys.argv[1])
    nodes = document["nodes"]
    parents = {child: i for i, node in enumerate(nodes) for child in node.get("children", [])}
    for animation in document.get("animations", []):
        for channel in animation["channels"]:
            sampler = animation["samplers"][channel["sampler"]]
            times = [row[0] for row in accessor(document, binary, sampler["input"])]
            values = accessor(document, binary, sampler["output"])
            assert len(times) == len(values) and times == sorted(set(times)) and times[0] == 0
            rest = nodes[channel["target"]["node"]][channel["target"]["path"]]
            assert math.dist(rest, values[-1]) < 1e-4, "the nodes stand as at the end"
            nodes[channel["target"]["node"]][channel["target"]["path"]] = list(values[-1])
    drawn, count = {}, 0
    for i, node in enumerate(nodes):
        if "mesh" not in node:
            continue
        for primitive in document["meshes"][node["mesh"]]["primitives"]:
            points = accessor(document, binary, primitive["attributes"]["POSITION"])
            corners = [row[0] for row in accessor(document, binary, primitive["indices"])]
            assert len(corners) % 3 == 0 and max(corners) < len(points)
            count += len(corners) // 3
            for p in points:
                at, p = i, list(p)
                while True:
                    p = apply(nodes[at], p)
                    if at not in parents:
                        break
                    at = parents[at]
                p = [1000 * p[0], -1000 * p[2], 1000 * p[1]]
                drawn.setdefault(tuple(math.floor(c / 0.25) for c in p), []).append(p)
    with open(sys.argv[2], "rb") as file:
        stl = file.read()
    total, worst = struct.unpack_from("<I", stl, 80)[0], 0
    for i in range(total):
        numbers = struct.unpack_from("<9f", stl, 84 + 50 * i + 12)
        for k in (0, 3, 6):
            p = numbers[k:k + 3]
            cell = [math.floor(c / 0.25) for c in p]
            near = [q for dx in (-1, 0, 1) for dy in (-1, 0, 1) for dz in (-1, 0, 1)
                    for q in drawn.get((cell[0] + dx, cell[1] + dy, cell[2] + dz), [])]
            worst = max(worst, min((math.dist(p, q) for q in near), default=math.inf))
    assert worst < 2e-3, worst
    assert count <= total
    names = [node["name"] for node in nodes]
    for name in sys.argv[3:]:
        assert name in names, (name, names)
    print("bodies stand as in --pose")


if __name__ == "__main__":
    main()

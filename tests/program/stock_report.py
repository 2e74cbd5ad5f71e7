"""stock_report.py HTML GLB NAME TOP FLOOR - holds the stock of a report and of a scene against a block of 80 x 60 mm with a slot."""
import math
import sys

import glb_data
from report_data import Report

WIDTH = 12


def volume(points, corners):
    total = 0
    for i in range(0, len(corners), 3):
        a, b, c = (points[corners[i + k]] for k in range(3))
        total += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6
    return total


def hold(points, corners, excess, top, floor):
    """The mesh has the block's box, all of what is left, little more at faces that were cut, and no corner in what was cut."""
    low, high = ([f(p[k] for p in points) for k in range(3)] for f in (min, max))
    points = [(p[0] - (low[0] + high[0]) / 2, p[1] - (low[1] + high[1]) / 2, p[2] - low[2]) for p in points]
    assert math.dist((high[0] - low[0], high[1] - low[1]), (80, 60)) < 0.1, (low, high)
    assert top - 0.1 < high[2] - low[2] < top + excess + 0.1, (low, high)
    left, cut = 80 * (60 * top - WIDTH * (top - floor)), 80 * (60 * (top < 40) + WIDTH + 2 * (top - floor))
    assert left * 0.999 < volume(points, corners) < left * 1.001 + excess * cut, (volume(points, corners), left)
    for p in points:
        assert not (abs(p[1]) < WIDTH / 2 - excess and p[2] > floor + excess + 0.1), p


def cylinder(points, corners, top):
    """A cylinder of 80 mm, with its own facets."""
    wanted = math.pi * 40 * 40 * top
    assert 0.98 * wanted < volume(points, corners) < 1.001 * wanted, volume(points, corners)
    assert len(corners) < 3000, len(corners)


def main():
    top, floor = float(sys.argv[4]), float(sys.argv[5])
    report = Report(sys.argv[1])
    stock = report.head["stock"]
    body = report.head["bodies"][stock["body"]]
    assert body["name"] == sys.argv[3] and body["role"] == "stock"
    document, binary = glb_data.read(sys.argv[2])
    mesh = next(mesh for mesh in document["meshes"] if mesh["name"] == sys.argv[3])["primitives"][0]
    scene = glb_data.accessor(document, binary, mesh["attributes"]["POSITION"])
    indices = [row[0] for row in glb_data.accessor(document, binary, mesh["indices"])]
    for points, corners in (report.mesh(body["mesh"]), (scene, indices)):
        if stock["when"] == "start":
            cylinder(points, corners, top)
        else:
            hold(points, corners, stock["excess"], top, floor)
    sentence = " ".join(report.page.text[report.page.text.index("The stock is drawn"):].split())
    print(f"{stock['when']}, within {stock['excess']:.1f} mm. {sentence}")


if __name__ == "__main__":
    main()

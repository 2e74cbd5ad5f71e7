#!/usr/bin/env python3
"""catalog_truth.py FILE SETUP.xml - compares an imported tool with the catalogue file that it was made from.

FILE is XML or a table of DIN 4000, or a product of ISO 13399 (.p21). Both are read anew. The cutter, the whole length,
and the thickness at 200 heights must be those of the catalogue; between the neck and the shank the setup may be as
thick as the thicker of cutter and shank.
"""

import csv
import re
import sys
import xml.etree.ElementTree as ET


def din(codes):
    def size(*names):
        values = [float(codes[n].replace(",", ".")) for n in names if codes.get(n)]
        return next((v for v in values if v > 0), None)

    drill = codes["NSM"] == "DIN4000-81"
    return {
        "DC": size("A11" if drill else "A1"),
        "OAL": size("B5"),
        "APMX": size("B6", "B4") if drill else size("B2", "B6"),
        "RE": size("A1") / 2 if not drill and codes["BLD"] == "6" else None if drill else size("G1", "G4"),
        "CHW": None if drill else size("G2"),
        "SIG": size("E1") if drill else None,
        "DN": None if drill else size("A5"),
        "LU": size("B9"),
        "DMM": size("C3"),
        "LS": size("C4"),
    }


def read_xml(path):
    tool = ET.parse(path).getroot().find("Tool")
    codes = {}
    for item in tool.iter():
        if item.tag in ("Property-Data", "Category-Data"):
            codes.setdefault(item.findtext("PropertyName"), (item.findtext("Value") or "").strip())
    return din(codes)


def read_table(path):
    return din(next(csv.DictReader(open(path, encoding="utf-8-sig"), delimiter=";")))


def read_p21(path):
    text = open(path, encoding="utf-8-sig").read()
    names = {
        "cutting diameter": "DC", "overall length": "OAL", "depth of cut maximum": "APMX", "corner radius": "RE",
        "neck diameter": "DN", "usable length": "LU", "connection diameter machine side": "DMM", "DCONMS": "DMM",
        "shank length": "LS", "point angle": "SIG", "corner chamfer width": "CHW",
    }
    units = dict(re.findall(r"(#\d+)\s*=\s*UNIT\s*\('([^']*)'\)", text))
    values = {}
    for name, unit, value in re.findall(r"NUMERICAL_VALUE\s*\('([^']*)',[^,]*,\s*([^,]*?)\s*,\s*'([^']*)'\)", text):
        scale = 25.4 if units.get(unit) in ("in", "inch") else 1
        values[names.get(name, name)] = scale * float(value)
    if "SIG" in values:
        values["APMX"] = values.get("LCF") or values.get("length chip flute")
        values.pop("RE", None)
    return {key: values.get(key) for key in ("DC", "OAL", "APMX", "RE", "CHW", "SIG", "DN", "LU", "DMM", "LS")}


def thickness(pieces, height):
    """The diameter at a height above the tip; pieces go from the top down."""
    top = sum(float(s.get("length")) for s in pieces)
    for section in pieces:
        low = top - float(section.get("length"))
        if height > low:
            first = float(section.get("diameter"))
            last = float(section.get("diameter_end", first))
            return first + (last - first) * (top - height) / (top - low)
        top = low
    raise ValueError("above the tool")


def near(a, b):
    return abs(a - b) < 1e-6


def compare(known, tool):
    cutter = tool.find("cutter")
    sections = [s for name in ("holder", "shank", "cutter") for s in tool.findall(name + "/section")]
    tip = cutter.get("tip", "flat")
    ball = known["RE"] is not None and abs(known["RE"] - known["DC"] / 2) < 0.011
    wanted = "cone" if known["SIG"] else "ball" if ball else "bull" if known["RE"] else "flat"
    assert tip == wanted, (tip, wanted)
    assert tip != "bull" or near(float(cutter.get("corner")), known["RE"])
    assert tip != "cone" or near(float(cutter.get("angle")), known["SIG"])
    assert near(sum(float(s.get("length")) for s in sections), known["OAL"])
    assert near(sum(float(s.get("length")) for s in cutter), known["APMX"])
    assert near(float(tool.get("length")), known["OAL"])
    for i in range(200):
        height = known["OAL"] * (i + 0.5) / 200
        found = thickness(sections, height)
        if height < known["APMX"]:
            expected = known["DC"]
            if known["CHW"] and height < known["CHW"]:
                expected -= 2 * (known["CHW"] - height)
        elif known["DN"] and known["LU"] and height < known["LU"]:
            expected = known["DN"]
        elif known["LS"] and height > max(known["OAL"] - known["LS"], known["APMX"]):
            expected = known["DMM"]
        else:
            expected = max(known["DC"], known["DMM"])
        assert near(found, expected), (height, found, expected)


def main():
    path, setup = sys.argv[1:]
    head = open(path, encoding="utf-8-sig").read(12)
    read = read_p21 if head.startswith("ISO-10303") else read_xml if head.startswith("<") else read_table
    tools = ET.parse(setup).getroot().findall("tool")
    assert len(tools) == 1
    compare(read(path), tools[0])
    print("the same")


main()

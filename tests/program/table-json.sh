# --check-machine and --list-pairs as JSON contain the same as their text.
need python3
small_machine
box part -10 -10 0 10 10 30
setup s.xml <<'XML'
  <part name="cube &amp; co &#228;" mesh="part.stl" location="0 0 5"/>
  <tool number="1" name="end mill" length="50">
    <holder><section length="20" diameter="30"/></holder>
    <cutter tip="flat"><section length="30" diameter="10"/></cutter>
  </tool>
XML
for what in --list-pairs --check-machine; do
	"$FIVECHECK" $what --format=json=out$what.json -s s.xml m.xml
	"$FIVECHECK" $what -f json -s s.xml m.xml | cmp - out$what.json
	"$FIVECHECK" $what -f text=out$what.text -s s.xml m.xml
done
python3 - <<'PY'
import json
rows = [line.rstrip("\n").split("\t") for line in open("out--list-pairs.text", encoding="utf-8")]
document = json.load(open("out--list-pairs.json", encoding="utf-8"))
assert document["kind"] == "pairs" and document["format"] == 1 and document["machine"] == "m.xml", document
assert rows[0] == ["a", "b", "status", "clearance", "reason"]
assert [{**p, "clearance": "%.12g" % p["clearance"]} for p in document["pairs"]] == [dict(zip(rows[0], r)) for r in rows[1:]]
print(len(document["pairs"]), "pairs,", document["pairs"][1]["b"].encode())

text = open("out--check-machine.text", encoding="utf-8").read()
machine = json.load(open("out--check-machine.json", encoding="utf-8"))
assert machine["kind"] == "machine" and machine["name"] == "test machine", machine
for axis in machine["axes"]:
    assert "%s+10: %s\n" % (axis["name"], axis["positive"]) in text
    print(axis["name"], axis["type"], axis["on"], axis["direction"], axis["location"], axis["limit_min"], axis["limit_max"],
          axis["rate_max"], axis["home"], axis["wrap"], axis["title"], axis["checked"])
for body in machine["bodies"]:
    bounds = ", ".join("%s %.3f to %.3f" % (c, low + 0, high + 0)
                       for c, low, high in zip("XYZ", body["least"], body["greatest"]))
    assert "%s %s: %d triangles, " % (body["role"], body["name"], body["triangles"]) + bounds in text, body
    print(body["role"], body["on"], body["tool"], body["mesh"])
print(machine["controller"], machine["spindle"], machine["workholding"])
oddities = text.split("\noddities\n")[1].splitlines()
assert ["  " + o["text"] for o in machine["oddities"]] == oddities, (machine["oddities"], oddities)
print([o["kind"] for o in machine["oddities"]])
PY
for words in '--list-pairs -f ndjson' '--check-machine -f json -f text' '--list-pairs -f json=a -o b' '-f json a.nc' \
	'--dump-path -f json a.nc'; do
	# shellcheck disable=SC2086 # words, on purpose
	status fivecheck $words m.xml
done

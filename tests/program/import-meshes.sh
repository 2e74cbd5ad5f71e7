# Meshes of other formats become STL in mm, each part one file; what is broken is refused.
need python3
[ -x "$(dirname "$FIVECHECK")/fivecheck-mesh" ] || skip "there is no fivecheck-mesh: it needs libassimp-dev"
# libassimp leaks what it read of a broken 3MF, which a sanitizer would call a fault of fivecheck-mesh.
ASAN_OPTIONS="${ASAN_OPTIONS:+$ASAN_OPTIONS:}detect_leaks=0"
export ASAN_OPTIONS
python3 - <<'PY'
import json, struct
corners = [(0, 0, 0), (40, 0, 0), (0, 30, 0), (0, 0, 20)]
faces = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]
with open("two.obj", "w") as f:
    for name, shift, first in (("plate", 0, 1), ("door", 100, 5)):
        f.write("o %s\n" % name)
        f.writelines("v %g %g %g\n" % (c[0] + shift, c[1], c[2]) for c in corners)
        f.writelines("f %d %d %d\n" % tuple(i + first for i in t) for t in faces)
with open("one.ply", "w") as f:
    f.write("ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
            "element face 4\nproperty list uchar int vertex_indices\nend_header\n")
    f.writelines("%g %g %g\n" % c for c in corners)
    f.writelines("3 %d %d %d\n" % t for t in faces)
points = b"".join(struct.pack("<3f", *[x / 1000 for x in c]) for c in corners)
indices = b"".join(struct.pack("<3H", *t) for t in faces)
data = points + indices
doc = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
       "nodes": [{"name": "ram", "mesh": 0, "translation": [1, 2, 3]}],
       "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
       "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [.04, .03, .02]},
                     {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}],
       "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 24}],
       "buffers": [{"byteLength": 72}]}
def glb(path, doc):
    text = json.dumps(doc).encode()
    text += b" " * (-len(text) % 4)
    with open(path, "wb") as f:
        f.write(b"glTF" + struct.pack("<II", 2, 12 + 8 + len(text) + 8 + len(data)))
        f.write(struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(data), 0x004E4942) + data)
glb("one.glb", doc)
doc["buffers"][0]["uri"] = "one.bin"
open("one.bin", "wb").write(data)
json.dump(doc, open("one.gltf", "w"))
doc["buffers"][0]["uri"] = "../one.bin"
json.dump(doc, open("out.gltf", "w"))
doc["buffers"][0]["uri"] = "/etc/passwd"
json.dump(doc, open("etc.gltf", "w"))
PY
bounds() { # STL...
	for file; do
		python3 - "$file" <<-'PY'
		import struct, sys
		data = open(sys.argv[1], "rb").read()
		count = struct.unpack_from("<I", data, 80)[0]
		corners = [struct.unpack_from("<3f", data, 84 + 50 * t + 12 + 12 * k) for t in range(count) for k in range(3)]
		volume = sum((a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6
		             for a, b, c in zip(corners[0::3], corners[1::3], corners[2::3]))
		print(sys.argv[1], count, " ".join("%.3f..%.3f" % (min(c[i] for c in corners), max(c[i] for c in corners)) for i in range(3)), "volume %.0f" % volume)
		PY
	done
}
fivecheck import -o obj two.obj
bounds obj/stl/*.stl
fivecheck import -o inch --units inch two.obj 2>/dev/null
bounds inch/stl/plate.stl
fivecheck import -o ply one.ply
bounds ply/stl/*.stl
echo "glTF: metres, and Y upwards"
fivecheck import -o glb one.glb
bounds glb/stl/*.stl
fivecheck import -o gltf one.gltf
cmp glb/stl/ram.stl gltf/stl/ram.stl
echo "nothing beside the file is read but what stands in its folder:"
mkdir sub
mv out.gltf etc.gltf sub
fivecheck import -o bad sub/out.gltf 2>&1 | cut -c 1-60
fivecheck import -o bad sub/etc.gltf 2>&1 | cut -c 1-60
echo "broken files:"
bad() {
	"$FIVECHECK" import -o bad "$1" 2>&1 | cut -c 1-60
	[ ! -e bad ] || { echo "a folder was written"; rm -r bad; }
}
head -c 200 one.glb >cut.glb
bad cut.glb
head -c 200 one.ply >cut.ply
bad cut.ply
python3 - <<'PY'
import struct
head = b"ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n" \
       b"element face 4\nproperty list uchar int vertex_indices\nend_header\n"
corners = [(0, 0, 0), (40, 0, 0), (0, 30, 0), (0, 0, 20)]
data = b"".join(struct.pack("<3f", *c) for c in corners)
data += b"".join(struct.pack("<B3i", 3, *t) for t in ((0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)))
open("binary.ply", "wb").write(head + data)
open("cut.ply", "wb").write(head + data[:-1])
PY
bad cut.ply
fivecheck import -o binary binary.ply 2>/dev/null
cmp binary/stl/mesh.stl ply/stl/mesh.stl
sed 's/^40 0 0/nan 0 0/' one.ply >nan.ply
bad nan.ply
sed 's/^40 0 0/1e30 0 0/' one.ply >far.ply
bad far.ply
sed 's/^3 0 1 3/3 0 1 9/' one.ply >index.ply
bad index.ply
: >empty.obj
bad empty.obj
printf 'PK\003\004broken' >broken.3mf
bad broken.3mf
"$FIVECHECK" import -o bad --units mm broken.3mf 2>&1 | cut -c 1-60
echo "a machine whose bodies are PLY:"
cat >m.urdf <<'XML'
<robot name="m"><link name="base"/><link name="ram"><visual><geometry><mesh filename="one.ply" scale="0.001 0.001 0.001"/></geometry></visual></link>
<joint name="z" type="prismatic"><parent link="base"/><child link="ram"/><axis xyz="0 0 1"/><limit lower="-1" upper="0"/></joint></robot>
XML
fivecheck import -o m m.urdf 2>/dev/null
bounds m/stl/ram.stl

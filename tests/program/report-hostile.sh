# Names, comments and programs that try to become part of the page or of the picture.
need python3
small_machine
mv head.stl 'h<&".stl'
sed -i -e 's|<body name="head" mesh="head.stl"/>|<body name="\&lt;/script>\&lt;img src=x onerror=alert(1)>" mesh="h\&lt;\&amp;\&quot;.stl"/>|' \
	-e 's|name="test machine"|name="]]>\&lt;/style>\&lt;script>alert(2)\&lt;/script>\&lt;!--"|' m.xml
printf ';</script><script>alert(3)</script><!-- \377 \001\nG1 Z-120 F600 (<svg onload=alert 4>)\n' >'<b> &quot; ".nc'
fivecheck -q --report=h.html --picture=h.svg -f ndjson=h.ndjson m.xml '<b> &quot; ".nc'
python3 "$(dirname "$LIB")/report_data.py" h.html policy findings=h.ndjson 'text=</script><img src=x onerror=alert(1)>' \
	'text=<b> &quot; ".nc' 'code=<b> &quot; ".nc'
grep -c '<img' h.html
grep -o '<script[^>]*>' h.html | grep -v 'id="blob-' | sort | uniq -c | sed 's/^ *//'
python3 - <<'PY'
import xml.etree.ElementTree as tree
for name in ("h.svg",):
    tags = {element.tag.split("}")[1] for element in tree.parse(name).iter()}
    print(sorted(tags))
PY

# --explain, SARIF's rules and the manual page have the same text for every word.
names=$("$FIVECHECK" --explain xxxx 2>&1 | sed 's/.* nor one of //' | tr ',' '\n' | sed 's/^ //')
fivecheck --explain clearance
status fivecheck --explain colision
status fivecheck --explain COLLISION
status fivecheck --explain
status fivecheck --explain clear --explain found
status fivecheck --explain clear m.xml
status fivecheck --explain clear --all
status fivecheck --explain clear --list-pairs

# The text without headline, in one line.
said() {
	"$FIVECHECK" --explain "$1" | tail -n +3 | tr -s '\n' ' ' | sed 's/ $//'
}
sed -n '/^\.Ss Words of the reports/,/^\.El/p' "$(dirname "$LIB")/../../man/fivecheck.1" |
	awk '/^\.It Cm / { if (line) print line; line = substr($0, 8) ":"; next } line && !/^\./ { line = line " " $0 } END { print line }' |
	sort >manual
echo "$names" | while read -r name; do
	echo "$name: $(said "$name")"
done | sort >program
diff manual program

need python3
small_machine
program a.nc <<'NC'
G1 Z-120 F6000
M2
NC
"$FIVECHECK" -f sarif=a.sarif m.xml a.nc 2>/dev/null
python3 - <<'PY' >rules
import json
run = json.load(open("a.sarif"))["runs"][0]
for rule in run["tool"]["driver"]["rules"]:
    print(rule["id"] + ":", rule["shortDescription"]["text"], rule["help"]["text"])
    assert rule["help"]["text"].startswith(rule["fullDescription"]["text"])
for result in run["results"]:
    print(result["ruleId"], result.get("properties", {}).get("caution"))
PY
grep -F -x -c -f program rules
grep ': ' rules | grep -F -x -v -f program
grep -v ': ' rules

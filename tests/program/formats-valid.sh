# Independent validators read the documents. SARIF_SCHEMA names the published JSON schema of SARIF
# 2.1.0 if there is a copy (OASIS publishes sarif-schema-2.1.0.json); missing validators are skipped.
small_machine
printf 'G0 X10\n\tG1 Z-120 F6000 (\303\244 & <b> \001 \377 ]]>)\r\n' >'a b,c:d%.nc'
printf 'G0 X300\nG0 X-300\nG0 X300\nG0 Z400\n' >limits.nc
echo 'G0 X10' >good.nc
echo 'G0 B90' >bad.nc
: >empty.list
cat >waivers.xml <<'XML'
<waivers version="1">
<waiver program="limits.nc" kind="limit" axis="X" block="G0 X300" axes="X200Z0C0" reason="the &lt;stop> &#228;" expires="9999-12-31"/>
</waivers>
XML
status fivecheck -a -f sarif=out.sarif -f junit=out.xml -f ndjson=out.json --waivers waivers.xml m.xml 'a b,c:d%.nc' good.nc \
	bad.nc nowhere.nc limits.nc 2>/dev/null
status fivecheck -q -o /dev/null --waivers waivers.xml --record out.record m.xml 'a b,c:d%.nc' good.nc bad.nc limits.nc 2>/dev/null
status fivecheck -f sarif=clear.sarif -f junit=clear.xml -f ndjson=clear.json --record clear.record --shard 1/2 \
	--max-blocks 7 m.xml good.nc 2>/dev/null
printf 'o<far> sub\nG0 X300\no<far> endsub\no<far> call\nM2\n' >call.nc
status fivecheck --parse-only -f sarif=call.sarif -f ndjson=call.json m.xml call.nc 2>/dev/null
fivecheck -f ndjson=turns.json --sensitivity 1,0,1000,0 m.xml good.nc 2>/dev/null

if command -v xmllint >/dev/null; then
	xmllint --noout out.xml clear.xml
	if [ "$(xmllint --xpath 'concat(count(//testcase), count(//failure), count(//error), //testsuite/@tests,
		//testsuite/@failures, //testsuite/@errors)' out.xml)" != 522522 ]; then
		echo "the counts differ"
	fi
	schema="$(dirname "$LIB")/junit.xsd"
	xmllint --noout --schema "$schema" out.xml clear.xml 2>xml.log || cat xml.log
	# What cannot fail proves nothing.
	sed 's/type="collision"/type="crash"/' out.xml >wrong.xml
	xmllint --noout --schema "$schema" wrong.xml 2>/dev/null && echo "the schema of JUnit accepts anything"
else
	leave_out "there is no xmllint (libxml2-utils)"
fi
if ! python3 -c 'import jsonschema' 2>/dev/null; then
	leave_out "there is no python3-jsonschema"
else
	[ -e "${SARIF_SCHEMA:-}" ] || leave_out "SARIF_SCHEMA does not name the published schema: only the narrower one of this folder"
	for schema in "$(dirname "$LIB")/sarif.schema.json" ${SARIF_SCHEMA:+"$SARIF_SCHEMA"}; do
		python3 - "$schema" out.sarif clear.sarif call.sarif <<'PY'
import json, sys, jsonschema
schema = json.load(open(sys.argv[1]))
kind = jsonschema.validators.validator_for(schema)
for name in sys.argv[2:]:
    document = json.load(open(name, encoding='utf-8'))
    for fault in kind(schema).iter_errors(document):
        print(name, list(fault.path), fault.message)
# What cannot fail proves nothing.
document['runs'][0]['results'] = [{'ruleId': 7}]
if kind(schema).is_valid(document):
    print('the schema accepts anything')
PY
	done
fi

# NDJSON and the record against their installed schemas.
if python3 -c 'import jsonschema' 2>/dev/null; then
	python3 - "$(dirname "$LIB")/../../src/report" <<'PY'
import copy, json, sys, jsonschema
def validator(name):
    schema = json.load(open(sys.argv[1] + '/' + name))
    kind = jsonschema.validators.validator_for(schema)
    kind.check_schema(schema)
    return kind(schema)
lines = [json.loads(line) for name in ('out.json', 'clear.json', 'turns.json', 'call.json') for line in open(name, encoding='utf-8')]
ndjson, record = validator('ndjson.schema.json'), validator('record.schema.json')
records = [json.load(open(name, encoding='utf-8')) for name in ('out.record', 'clear.record')]
for schema, documents in (ndjson, lines), (record, records):
    for document in documents:
        for fault in schema.iter_errors(document):
            print(document, fault.message)
        # Every key is needed, and no other is known; what cannot fail proves nothing.
        for key in document:
            wrong = {k: v for k, v in document.items() if k != key}
            if schema.is_valid(wrong) and key not in ('accepted', 'sensitivity', 'callers'):
                print(document, 'is valid without', key)
        if schema.is_valid({**document, 'more': 1}):
            print('the schema accepts anything')
if not any('sensitivity' in line for line in lines):
    print('no sensitivity was looked at')
if not any('callers' in line for line in lines):
    print('no callers were looked at')
kinds = {line['kind'] for line in lines}
if kinds != {'header', 'collision', 'limit', 'program', 'summary'}:
    print('not everything was looked at:', kinds)
PY
fi

# SARIF as another JSON library reads it: the rules by their number, locations that are URIs, columns in UTF-16 units.
cat >expected <<'ROWS'
collision collision head (Z) meets table (C)|a%20b%2Cc%3Ad%25.nc|2|1|34
incomplete incomplete the machine has no B axis|bad.nc|1|4|7
incomplete incomplete cannot open: No such file or directory|nowhere.nc|null|null|null
ROWS
if command -v jq >/dev/null; then
	jq -r '.runs[0] as $run | $run.results[] | select(.ruleId != "limit" and .ruleId != "caution") | "\(.ruleId) \(
		$run.tool.driver.rules[.ruleIndex].id) \(.message.text)|\(.locations[0].physicalLocation |
		"\(.artifactLocation.uri)|\(.region.startLine)|\(.region.startColumn)|\(.region.endColumn)")"' \
		out.sarif |
		diff expected -
	jq -e '.runs[0].invocations[0] | .exitCode == 2 and (.executionSuccessful | not)' out.sarif >/dev/null ||
		echo wrong end
else
	leave_out "there is no jq"
fi

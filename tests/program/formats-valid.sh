# Validators that know nothing of fivecheck read its documents. SARIF_SCHEMA names the published JSON schema of SARIF
# 2.1.0 and JUNIT_SCHEMA an XML schema of JUnit's reports, where there are such; what is not there is skipped.
skip() {
	echo "formats-valid: skipped: $*" >&2
}
small_machine
printf 'G0 X10\n\tG1 Z-120 F6000 (\303\244 & <b> \001 \377 ]]>)\r\n' >'a b,c:d%.nc'
printf 'G0 X300\nG0 X-300\nG0 X300\nG0 Z400\n' >limits.nc
echo 'G0 X10' >good.nc
echo 'G0 B90' >bad.nc
: >empty.list
status fivecheck -a -f sarif=out.sarif -f junit=out.xml m.xml 'a b,c:d%.nc' good.nc bad.nc nowhere.nc \
	limits.nc 2>/dev/null
status fivecheck -f sarif=clear.sarif -f junit=clear.xml m.xml good.nc 2>/dev/null

if command -v xmllint >/dev/null; then
	xmllint --noout out.xml clear.xml
	if [ "$(xmllint --xpath 'concat(count(//testcase), count(//failure), count(//error), //testsuite/@tests,
		//testsuite/@failures, //testsuite/@errors)' out.xml)" != 522522 ]; then
		echo "the counts differ"
	fi
	[ -z "${JUNIT_SCHEMA:-}" ] || xmllint --noout --schema "$JUNIT_SCHEMA" out.xml clear.xml 2>xml.log ||
		cat xml.log
else
	skip "there is no xmllint (libxml2-utils)"
fi
if ! python3 -c 'import jsonschema' 2>/dev/null; then
	skip "there is no python3-jsonschema"
elif [ ! -e "${SARIF_SCHEMA:-}" ]; then
	skip "SARIF_SCHEMA does not name the schema of SARIF 2.1.0"
else
	python3 - "$SARIF_SCHEMA" out.sarif clear.sarif <<'PY'
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
fi

# SARIF as another JSON library reads it: the rules by their number, locations that are URIs, columns in UTF-16 units.
cat >expected <<'ROWS'
collision collision head (Z) meets table (C)|a%20b%2Cc%3Ad%25.nc|2|1|34
incomplete incomplete the machine has no B axis|bad.nc|1|null|null
incomplete incomplete cannot open nowhere.nc: No such file or directory|nowhere.nc|null|null|null
ROWS
if command -v jq >/dev/null; then
	jq -r '.runs[0] as $run | $run.results[] | select(.ruleId != "limit") | "\(.ruleId) \(
		$run.tool.driver.rules[.ruleIndex].id) \(.message.text)|\(.locations[0].physicalLocation |
		"\(.artifactLocation.uri)|\(.region.startLine)|\(.region.startColumn)|\(.region.endColumn)")"' \
		out.sarif |
		diff expected -
	jq -e '.runs[0].invocations[0] | .exitCode == 2 and (.executionSuccessful | not)' out.sarif >/dev/null ||
		echo wrong end
else
	skip "there is no jq"
fi

# The commands of the GitHub workflow and the GitLab job of examples/ci, extracted and run.
small_machine
mv m.xml machine.xml
setup setup.xml <<'XML'
XML
echo 'G0 X10' >a.nc
printf 'G1 Z-120 F6000\n' >b.nc
for job in github-workflow gitlab-ci; do
	file="$(dirname "$LIB")/../../examples/ci/$job.yml"
	command=$(sed -n 's/^[ -]*\(fivecheck -.*\)/\1/p' "$file")
	echo "$job:"
	ls ./*.nc | sed 's,^./,,' >programs
	status eval "$command"
done
test -s fivecheck.sarif && test -s fivecheck.xml
if python3 -c 'import yaml' 2>/dev/null; then
	python3 - "$(dirname "$LIB")/../../examples/ci" <<'PY'
import sys, yaml
github = yaml.safe_load(open(sys.argv[1] + '/github-workflow.yml'))
gitlab = yaml.safe_load(open(sys.argv[1] + '/gitlab-ci.yml'))
assert any('fivecheck -j' in step.get('run', '') for step in github['jobs']['check']['steps'])
assert gitlab['fivecheck']['artifacts']['reports']['junit'] == 'fivecheck.xml'
# A changed subprogram or mesh also causes a check.
assert {'**/*.nc', '**/*.ngc', '**/*.xml', '**/*.stl'} <= set(gitlab['fivecheck']['rules'][0]['changes'])
PY
else
	leave_out "there is no python3-yaml: the syntax is not looked at"
fi

# The pre-commit hook of examples/ci, in a separate repository.
need git
export HOME="$PWD" GIT_CONFIG_NOSYSTEM=1 GIT_AUTHOR_NAME=a GIT_AUTHOR_EMAIL=a@b
export GIT_COMMITTER_NAME=a GIT_COMMITTER_EMAIL=a@b
small_machine
mv m.xml machine.xml
git init -q .
cp "$(dirname "$LIB")/../../examples/ci/pre-commit" .git/hooks/pre-commit
echo 'G0 X10' >a.nc
git add .
status git commit -q -m clear
# The hook checks the staged version of a file, not the one in the work tree.
printf 'G1 Z-120 F6000\n' >a.nc
git add a.nc
echo 'G0 X10' >a.nc
status git commit -q -m collides
git add a.nc
echo 'notes' >notes.txt
git add notes.txt
status git commit -q -m notes
# Programs in folders are checked too.
mkdir 'side one'
printf 'G1 Z-120 F6000\n' >'side one/c.nc'
git add 'side one'
status git commit -q -m folder
git rm -q --cached 'side one/c.nc'
git rm -q --cached a.nc
status git commit -q -m 'no programs'
# All configured suffixes.
printf 'G1 Z-120 F6000\n' >d.tap
git add d.tap
status env PROGRAMS='*.nc *.tap' git commit -q -m suffix
git log --format=%s

# The pre-commit hook of examples/ci, in a repository of its own.
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
# What is staged counts, not what stands beside it.
printf 'G1 Z-120 F6000\n' >a.nc
git add a.nc
echo 'G0 X10' >a.nc
status git commit -q -m collides
git add a.nc
echo 'notes' >notes.txt
git add notes.txt
status git commit -q -m notes
# Nor may what stands in a folder slip through.
mkdir 'side one'
printf 'G1 Z-120 F6000\n' >'side one/c.nc'
git add 'side one'
status git commit -q -m folder
git rm -q --cached 'side one/c.nc'
git rm -q --cached a.nc
status git commit -q -m 'no programs'
# Every suffix that it is told.
printf 'G1 Z-120 F6000\n' >d.tap
git add d.tap
status env PROGRAMS='*.nc *.tap' git commit -q -m suffix
git log --format=%s

# The completions come from the tables of options; a shell that reads them knows every option that --help lists.
options() { # of a command, or of the check
	"$FIVECHECK" "$@" --help | sed -n 's/^  \(-., \|    \)--\([a-z-]*\).*/--\2/p'
}
commands=$("$FIVECHECK" --help | sed -n 's/^       fivecheck \([a-z][a-z]*\) .*/\1/p')
need bash
for shell in bash zsh fish; do
	fivecheck completion $shell >completion.$shell
done
cat >ask.bash <<'BASH'
. ./completion.bash
COMP_WORDS=("$@")
COMP_CWORD=$(($# - 1))
_fivecheck
[ ${#COMPREPLY[@]} = 0 ] || printf '%s\n' "${COMPREPLY[@]}"
BASH
ask() {
	bash ask.bash fivecheck "$@"
}
for command in '' $commands; do
	# shellcheck disable=SC2086 # no word if there is no command
	options $command >wanted
	# shellcheck disable=SC2086
	ask $command -- | cmp - wanted
done
ask ini
ask --method '' | xargs
ask --method = cert
ask -f = s
ask m.xml --fail-on c | xargs
ask --explain co | xargs
ask init --units '' | xargs
ask init head | xargs
ask completion '' | xargs
mkdir 'a folder'
: >'a file.nc'
ask m.xml a
ask --include a
ask --tolerance a
if command -v fish >/dev/null; then
	fish_ask() {
		HOME=$PWD fish --no-config -c "source completion.fish; complete -C '$1'" | cut -f 1
	}
	for command in '' $commands; do
		# shellcheck disable=SC2086
		options $command | sort >wanted
		fish_ask "fivecheck $command --" | grep '^--' | sort | cmp - wanted
	done
	[ "$(fish_ask 'fivecheck --method=cert')" = --method=certified ] || echo "fish: no value"
	[ "$(fish_ask 'fivecheck init table')" = table-table ] || echo "fish: no family"
else
	leave_out "there is no fish"
fi
# zsh completes on a terminal only; _arguments, in its place here, gets one word an option.
if command -v zsh >/dev/null; then
	cat >ask.zsh <<'ZSH'
_arguments() { print -l -- "$@" }
_describe() { }
words=(fivecheck "$@")
CURRENT=$(($# + 1))
source ./completion.zsh
ZSH
	for command in '' $commands; do
		# shellcheck disable=SC2086
		options $command >wanted
		# shellcheck disable=SC2086
		zsh -f ask.zsh $command x -- | sed -n 's/^[*]\(--[a-z-]*\).*/\1/p' | cmp - wanted
	done
else
	leave_out "there is no zsh"
fi
status fivecheck completion
status fivecheck completion tcsh
fivecheck completion --help | head -n 1

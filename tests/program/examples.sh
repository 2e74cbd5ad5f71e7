# The committed examples: clear ones are clear, the others collide in the middle of the intended block.
root=$(dirname "$LIB")/../..
for machine in ac-trunnion cb-head b-head-c-table; do
	for program in clear collision; do
		status fivecheck -q -s "$root/examples/$machine/setup.xml" "$root/machines/$machine/machine.xml" - \
			<"$root/examples/$machine/$program.nc" | grep -E 'error|clear|block  |status'
	done
done
# A block that is cut: in the right order, with a deep slot too early, with a rapid through material.
for program in clear holder rapid; do
	status fivecheck -q -s "$root/examples/stock/setup.xml" "$root/machines/ac-trunnion/machine.xml" - \
		<"$root/examples/stock/$program.nc" | grep -E 'error|clear|block  |status'
done
paper=$root/machines/ac-trunnion/machine.xml
# The block of the paper has Z twice; the corrected block is clear.
status fivecheck -q "$paper" - <"$root/examples/paper-block.nc" 2>&1 | grep -E 'error|status'
status fivecheck --duplicates last "$paper" - <"$root/examples/paper-block.nc" 2>&1 | grep -E 'warning|clear|status'
status fivecheck -q "$paper" - <"$root/examples/paper-block-corrected.nc" | grep -E 'clear|status'
# Of the ten pairs of the paper's links, Z-A and Z-C are left, and Y-C: here the table can reach the bridge.
fivecheck --list-pairs "$paper" |
	grep -E '^(bridge|carriage|head|cradle|table)	(bridge|carriage|head|cradle|table)	' | cut -f 1-3
# The first verdict of a new user has only one caution: neighbours are excused.
for machine in ac-trunnion cb-head b-head-c-table; do
	fivecheck -q -s "$root/examples/$machine/setup.xml" "$root/machines/$machine/machine.xml" "$root/examples/$machine/clear.nc" 2>&1 |
		sed 's/^.*clear.nc: //'
done

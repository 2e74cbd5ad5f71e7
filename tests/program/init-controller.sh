# Attributes of the control are given to init, verified by the reader of machine files, and used by the check.
make() {
	"$FIVECHECK" init table-table --rotary=A,C --limits=X=-300:300,Y=-250:250,Z=-400:0,A=-120:30,C=none --location=A=0,0,120 \
		--location=C=0,0,120 --spindle=0,0,520 "$@" 2>stderr >made.xml
	status=$?
	grep error: stderr
	sed -n '/<controller/,/<base/p' made.xml
	return "$status"
}
status make --controller=path_tolerance=0.02 --controller=tcp_zero=offset
status make --dialect=fanuc --controller=least_input=0.001 --controller=power_on_units=mm --tool-change=Z=0,A=-90.5
status make --dialect=klartext --rapid=linear --tool-change=none --controller=path_tolerance=0.01
status make --units=inch --controller=path_tolerance=0.001 --tool-change=X=1 --tool-change=Y=2
for wrong in path_tolerance=0 path_tolerence=1 least_input=0.001 path_tolerance=x preset=16i 'a b=c' =1 dialect=fanuc x= \
	'tcp_zero="/><x a="'; do
	status make "--controller=$wrong"
done
status make --controller=rapid=any
status make --controller=path_tolerance=0.02 --controller=path_tolerance=0.03
for wrong in Z=1 B=0 Q=1 x; do
	status make --tool-change=$wrong
done
status make --tool-change=Z=0 --tool-change=none
status make --tool-change=none --tool-change=Z=0

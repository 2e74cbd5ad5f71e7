# Bodies that overlap at the start of the program; the printed <pair> line can be copied to waive the pair.
small_machine
box post 10 10 0 30 30 150
sed -e '/<body name="table"/a <body name="post &amp; &quot;co&quot;" mesh="post.stl"/>' m.xml >odd.xml
echo 'G0 X10' >a.nc
status fivecheck -q odd.xml a.nc | tee report
waiver=$(sed -n 's/^    to waive \(.*\) reason=""\/>/\1 reason="drawn so"\/>/p' report)
sed "s|</machine>|<pairs>$(echo "$waiver" | sed 's/&/\\&/g')</pairs></machine>|" odd.xml >waived.xml
status fivecheck -q waived.xml a.nc

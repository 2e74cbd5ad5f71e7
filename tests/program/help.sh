fivecheck --help
# --help needs no other argument and ignores all others.
fivecheck --list-pairs --help nowhere.xml | head -n 1
fivecheck -h | head -n 1
fivecheck -V | sed 's, .*, VERSION,'

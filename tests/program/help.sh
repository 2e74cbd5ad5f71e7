fivecheck --help
# Nothing else is needed, and nothing else is looked at.
fivecheck --list-pairs --help nowhere.xml | head -n 1
fivecheck -h | head -n 1
fivecheck -V | sed 's, .*, VERSION,'

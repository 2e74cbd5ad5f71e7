fivecheck --version

# Mistakes planted in the shipped machines and setups: what is said to each, and that the unchanged ones stay silent.
need python3
python3 "$(dirname "$LIB")/../doubt/mistakes.py" "$FIVECHECK"

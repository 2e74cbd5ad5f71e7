# Mistakes planted in the shipped machines and setups: the messages for each, and none for the unchanged ones.
need python3
python3 "$(dirname "$LIB")/../doubt/mistakes.py" "$FIVECHECK"

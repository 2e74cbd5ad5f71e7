# One random job, written for five controls, makes one path of the axes.
need python3
PYTHONDONTWRITEBYTECODE=1 python3 "$(dirname "$LIB")/../dialects/one_path.py" --fivecheck "$FIVECHECK" --seed 1 --cases 24

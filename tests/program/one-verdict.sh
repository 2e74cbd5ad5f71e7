# The short form of make campaign-verdict: the same verdict and first finding, to the byte, with all options.
need python3
PYTHONDONTWRITEBYTECODE=1 python3 "$(dirname "$LIB")/../verdict/one_verdict.py" --fivecheck "$FIVECHECK" --seed 1 --cases 3 --ways 4 \
	--blocks 20 --keep .
# A level that no processor has.
FIVECHECK_SIMD=mmx status fivecheck nowhere.xml nowhere.nc

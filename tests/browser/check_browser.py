"""Looks at reports in a real Chromium: make check-browser. Pictures are kept in the folder that --keep names.

usage: check_browser.py --fivecheck PROGRAM --viewer viewer.js --keep FOLDER [TEST...]
"""
import argparse
import os
import sys
import tempfile
import traceback

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from bench import TESTS, Bench  # noqa: E402
from driver import Browser, find_browser  # noqa: E402
import seen_tests  # noqa: E402, F401
import used_tests  # noqa: E402, F401


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--fivecheck", required=True)
    parser.add_argument("--viewer", required=True)
    parser.add_argument("--keep", required=True)
    parser.add_argument("tests", nargs="*")
    arguments = parser.parse_args()
    if not find_browser():
        sys.exit("check_browser: there is no Chromium")
    os.makedirs(arguments.keep, exist_ok=True)
    chosen = [t for t in TESTS if not arguments.tests or t.__name__ in arguments.tests]
    failed = 0
    with tempfile.TemporaryDirectory() as work, Browser() as browser:
        bench = Bench(arguments, work, browser)
        for function in chosen:
            try:
                function(bench)
                print(f"{function.__name__} passed", flush=True)
            except Exception:  # one test's failure must not hide the others
                traceback.print_exc()
                print(f"FAILED: {function.__name__}", flush=True)
                failed += 1
    print(f"browser tests: {len(chosen) - failed} passed, {failed} failed; pictures are in {arguments.keep}")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()

"""Looks at reports in a real Chromium or Firefox: make check-browser, check-firefox. Pictures are kept in the folder that --keep names.

usage: check_browser.py [--firefox] --fivecheck PROGRAM --viewer viewer.js --keep FOLDER [TEST...]
"""
import argparse
import contextlib
import functools
import os
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from bench import TESTS, Bench, browser_of, carry_out  # noqa: E402
import seen_tests  # noqa: E402, F401
import used_tests  # noqa: E402, F401


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--firefox", action="store_true")
    parser.add_argument("--fivecheck", required=True)
    parser.add_argument("--viewer", required=True)
    parser.add_argument("--keep", required=True)
    parser.add_argument("tests", nargs="*")
    arguments = parser.parse_args()
    os.makedirs(arguments.keep, exist_ok=True)
    with tempfile.TemporaryDirectory() as work, browser_of(arguments)() as browser:
        failed = carry_out(TESTS, functools.partial(contextlib.nullcontext, Bench(arguments, work, browser)), arguments.tests)
    print(f"browser tests: {failed} failed; pictures are in {arguments.keep}")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()

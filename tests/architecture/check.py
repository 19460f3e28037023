"""Checks a source tree against the rules: check.py ROOT. Exit status 1 and one line each for what breaks them."""

import sys

from rules import violations

found = violations(sys.argv[1])
print("\n".join(found) if found else "The tree keeps the rules of ARCHITECTURE.md.")
sys.exit(1 if found else 0)

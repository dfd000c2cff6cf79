"""Fails if a source file has more lines than one can keep in mind (CONTRIBUTING.md)."""

import sys

from source_files import lines_of, source_files

MOST_LINES = 500


def main():
    lengths = [(name, len(lines_of(name))) for name in source_files()]
    long_files = [f"{name}: {count} lines, {MOST_LINES} at most: divide it"
                  for name, count in lengths if count > MOST_LINES]
    longest = max(count for _, count in lengths)
    print("\n".join(long_files) or f"{len(lengths)} files, the longest of {longest} lines")
    return 1 if long_files else 0


if __name__ == "__main__":
    sys.exit(main())

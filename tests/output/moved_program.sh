#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# moved_program.sh PROGRAM SCRIPTS: copies both into an empty place as they are installed, moves that, and lets the
# program draw a picture.
set -euo pipefail
/usr/bin/python3 -c 'import matplotlib' 2> /dev/null || exit 77 # skipped
unset RICOCHET_SCRIPT_DIR
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir -p "$folder/first/bin" "$folder/first/share/ricochet"
cp "$1" "$folder/first/bin/ricochet"
cp -r "$2" "$folder/first/share/ricochet/scripts"
mv "$folder/first" "$folder/second"
cd "$folder"
second/bin/ricochet bench search --points 100 --repeats 1 --plot picture.png > text 2>&1 || { cat text; exit 1; }
cat text
test -s picture.png

# Without its scripts it names the place where they belong, and not those of the source.
rm -r second/share
rm picture.png
second/bin/ricochet bench search --points 100 --repeats 1 --plot picture.png > text 2>&1
cat text
test ! -e picture.png
grep -q "second/share/ricochet/scripts/plot_search.py does not exist" text

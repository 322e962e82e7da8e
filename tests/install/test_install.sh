#!/usr/bin/env bash
# Installs a build, builds somebody else's program upon it, moves it, and runs it from the new place:
#   test_install.sh BUILD SOURCE SCRATCH
set -euo pipefail
build=$1 source=$2 scratch=$3
unset PYTHONDONTWRITEBYTECODE RICOCHET_SCRIPT_DIR
fail() {
  echo "FAILED: $*" >&2
  exit 1
}
rm -rf "$scratch"
mkdir -p "$scratch"

cmake --install "$build" --prefix "$scratch/first" >"$scratch/install.log"

cmake -S "$source/tests/install/consumer" -B "$scratch/consumer" -G Ninja -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_PREFIX_PATH="$scratch/first" >"$scratch/configure.log" 2>&1 || { cat "$scratch/configure.log"; exit 1; }
cmake --build "$scratch/consumer"
said=$("$scratch/consumer/consumer" "$scratch/first/share/ricochet/prm/quickstart.prm")
echo "$said"
# 198 x 96 x 24 mm at 1.5 mm: 132 x 64 x 16 points.
[[ $said == *" 135168 points, "* ]] || fail "the consumer said: $said"

mv "$scratch/first" "$scratch/moved"
moved=$scratch/moved
version=$("$moved/bin/ricochet" --version)
[[ $version == "$("$build/ricochet" --version)" ]] || fail "version $version"
"$moved/bin/ricochet" run "$moved/share/ricochet/prm/quickstart.prm" --output "$scratch/results" --quiet \
  --set "Plate 1/Grid spacing=3 mm" --set "Time/Final time=2 us"
grep -qF "\"version\": \"$version\"" "$scratch/results/summary.json" || fail "no version in summary.json"
if /usr/bin/python3 -c 'import matplotlib, h5py' 2>/dev/null; then
  [[ -s $scratch/results/section.png ]] || fail "no picture"
  # Python leaves what it compiled beside the scripts that ran.
  [[ -d $moved/share/ricochet/scripts/__pycache__ ]] || fail "the pictures are not by the installed scripts"
fi
echo "$version runs from $moved"

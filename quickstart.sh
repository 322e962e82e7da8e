#!/usr/bin/env bash
# From a fresh Debian 12 to a first result:
#   ./quickstart.sh        installs what is missing, builds, runs prm/quickstart.prm on all cores
#   ./quickstart.sh test   the same set-up, then the tests
# Further arguments go to cmake: ./quickstart.sh test -D RICOCHET_WARNINGS_AS_ERRORS=ON
set -euo pipefail
cd "$(dirname "$0")"

packages=(cmake g++ ninja-build libdeal.ii-dev libopenmpi-dev openmpi-bin libhdf5-openmpi-dev libeigen3-dev
  libnanoflann-dev nlohmann-json3-dev libcli11-dev libgtest-dev python3-matplotlib python3-h5py python3-plotly)
what=${1:-run}
(($# == 0)) || shift
case $what in
  run | test) ;;
  *)
    echo "usage: $0 [run | test] [argument of cmake]..." >&2
    exit 2
    ;;
esac

missing=()
for package in "${packages[@]}"; do
  dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q '^install ok installed$' || missing+=("$package")
done
if ((${#missing[@]})); then
  echo "== installing ${missing[*]}"
  as_root=()
  if ((EUID != 0)); then
    command -v sudo >/dev/null || {
      echo "Not root and no sudo here. As root, run: apt-get install ${missing[*]}" >&2
      exit 1
    }
    as_root=(sudo)
  fi
  "${as_root[@]}" apt-get update -q
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${missing[@]}"
fi

echo "== building (release) into build/"
tests=OFF
[[ $what == test ]] && tests=ON
cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release -DRICOCHET_TESTS=$tests "$@" >build.log 2>&1 || {
  cat build.log >&2
  exit 1
}
cmake --build build

cores=$(nproc)
# Open MPI refuses to run as root unless told twice; inside a container there is often no other user.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
if [[ $what == test ]]; then
  echo "== testing on $cores cores"
  ctest --test-dir build --output-on-failure --label-exclude long --parallel "$cores"
  exit
fi

# Hardware threads are no cores, and a container may have fewer than its machine. More than 16 ranks gain nothing on so
# small a plate.
real_cores=$(lscpu --parse=Core,Socket | grep -v '^#' | sort -u | wc -l)
ranks=$((real_cores < cores ? real_cores : cores))
ranks=$((ranks < 1 ? 1 : ranks < 16 ? ranks : 16))
echo "== running prm/quickstart.prm on $ranks cores"
mpirun --oversubscribe --bind-to none -np "$ranks" build/ricochet run prm/quickstart.prm --force

#!/usr/bin/env bash
# Shows that the Debian package installs and runs on a bare Debian 12; as root, with debootstrap:
#   bare_debian.sh ricochet_0.1.0_amd64.deb ROOT
# ROOT is made if it is not there, about 3 GB; nothing is left running in it.
set -euo pipefail
package=$(realpath "$1") root=$2
[[ -x $root/bin/sh ]] || debootstrap --variant=minbase bookworm "$root" http://deb.debian.org/debian
cp "$package" "$root/tmp/ricochet.deb"
chroot "$root" sh -euc '
  export DEBIAN_FRONTEND=noninteractive OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
  ! command -v g++ cmake                     # really bare
  apt-get update -q
  apt-get install -q -y --no-install-recommends /tmp/ricochet.deb
  cd /tmp
  ricochet --version
  ricochet run /usr/share/ricochet/prm/quickstart.prm --output alone --force \
    --set "Plate 1/Grid spacing=3 mm" --set "Time/Final time=20 us" --set "Output/Pictures=false"
  mpirun --oversubscribe -np 2 --mca btl self,tcp ricochet run /usr/share/ricochet/prm/quickstart.prm --output two --force \
    --set "Plate 1/Grid spacing=3 mm" --set "Time/Final time=20 us" --set "Output/Pictures=false"
  cmp alone/history.csv two/history.csv
  apt-get install -q -y --no-install-recommends python3-matplotlib python3-h5py
  ricochet run /usr/share/ricochet/prm/quickstart.prm --output drawn --force \
    --set "Plate 1/Grid spacing=3 mm" --set "Time/Final time=20 us"
  test -s drawn/section.png && echo "drawn"
'

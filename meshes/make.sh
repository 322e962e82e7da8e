#!/usr/bin/env bash
# Writes the meshes of this folder and prints the table of its README. From the top of the project:
#   meshes/make.sh FOLDER
set -euo pipefail
folder=${1:?"usage: meshes/make.sh FOLDER"}
mkdir -p "$folder"
echo "| file | cells | nodes | smallest scaled Jacobian | volume error | smallest edge | stable step in steel |"
echo "|---|---|---|---|---|---|---|"
#    name      diameter   length   nose      mass
while read -r name d length nose mass; do
  for refinement in 1 2 3; do
    file=$folder/${name}_$refinement.msh
    build/ricochet mesh prm/projectile/finite_elements.prm --write "$file" \
      --set "Projectile/Diameter=$d mm" --set "Projectile/Length=$length mm" --set "Projectile/Nose length=$nose mm" \
      --set "Projectile/Mass=$mass g" --set "Projectile/Refinement=$refinement" |
      awk -v f="$(basename "$file")" '
        /^mesh/     { cells = $2; nodes = $4 }
        /^scaled/   { quality = $4 }
        /^volume/   { error = $4 " %" }
        /^smallest/ { edge = $3 " mm" }
        /^stable/   { step = $3 " µs" }
        END { sub(",", "", quality); print "| `" f "` | " cells " | " nodes " | " quality " | " error " | " edge " | " step " |" }'
  done
done <<'BODIES'
core_030 6.17 27.6 10.23 5.25
full_030 7.62 35.3 12.64 10.6
core_050 10.87 47.5 18.03 25.9
full_050 12.7 58.7 21.06 48.9
BODIES

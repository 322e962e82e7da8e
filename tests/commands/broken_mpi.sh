#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# broken_mpi.sh PROGRAM PRM: where MPI cannot start, what only writes a text does so, and what needs MPI says in one
# sentence that it cannot start.
set -euo pipefail
program=$1 prm=$2
# No component of this name, no place for its files: two of the ways in which Open MPI does not start.
broken=("OMPI_MCA_pml=nonexistent" "OMPI_MCA_orte_tmpdir_base=/proc/none")

fail() {
  printf '%s\n' "$@" >&2
  exit 1
}

for setting in "${broken[@]}"; do
  while read -r expected arguments; do
    read -ra words <<<"$arguments"
    text=$(env "$setting" "$program" "${words[@]}" 2>&1) || fail "$setting: $arguments ends with $?" "$text"
    [[ $text == *"$expected"* ]] || fail "$setting: $arguments does not say $expected" "$text"
  done <<'CASES'
. --version
template --help
--coupling check --help
subsection template
Projectile template --json
time columns
history columns --json
CASES

  # A wrong command line needs no MPI to be told either.
  status=0
  text=$(env "$setting" "$program" fly 2>&1) || status=$?
  [[ $status == 2 ]] || fail "$setting: a wrong command ends with $status" "$text"

  status=0
  text=$(env "$setting" "$program" check "$prm" 2>&1) || status=$?
  [[ $status != 0 ]] || fail "$setting does not hinder MPI" "$text"
  [[ $text == "ricochet: MPI cannot start"* ]] || fail "$setting: check does not say that MPI cannot start" "$text"
  (($(wc -l <<<"$text") <= 2)) || fail "$setting: check says too much" "$text"
done

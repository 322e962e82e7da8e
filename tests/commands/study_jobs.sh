#!/usr/bin/env bash
# Cases side by side give the table of cases in turn, failures are told at the end, and Ctrl-C ends all:
#   study_jobs.sh PROGRAM QUICKSTART.prm
set -uo pipefail
program=$1 scene=$(realpath "$2")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 1
fail() {
  echo "FAILED: $*" >&2
  exit 1
}
write_study() { # final time
  cat >study.prm <<END
subsection Study
  set Scenes = $(realpath --relative-to=. "$scene")
  set Axis 1 = Impact/Speed: 500 m/s | 600 m/s | 700 m/s
  set Settings = Plate 1/Grid spacing: 3 mm; Time/Final time: $1; Output/Pictures: false; Output/Report: false
  set Columns = outcome, exit_speed_m_s, path_mm
  set Pictures = false
  set Report = false
  set Output directory = results
end
END
}

write_study "3 us"
"$program" study study.prm >one.txt || fail "in turn"
mv results in_turn
"$program" study study.prm --jobs 2 >two.txt || fail "side by side"
cmp in_turn/study.csv results/study.csv || fail "the tables differ"
# All lines of a case have its number; what comes before the table has nothing else.
sed '/^$/,$d' two.txt | grep -qv '^\[[123]/3\] ' && fail "lines without a number: $(cat two.txt)"
[[ $(grep -c '^\[[123]/3\] ok$' two.txt) == 3 ]] || fail "not three are ok: $(cat two.txt)"

rm -r results/quickstart__speed_600_m_s
echo "in the way" >results/quickstart__speed_600_m_s
"$program" study study.prm --jobs 2 --resume --quiet >failed.txt 2>errors.txt
[[ $? == 4 ]] || fail "a failed case does not tell: $(cat failed.txt errors.txt)"
[[ $(grep -c '^\[[13]/3\].*finished before$' failed.txt) == 2 ]] || fail "it does not resume: $(cat failed.txt)"
grep -A1 "^Failed:" errors.txt | grep -q "speed_600_m_s" || fail "no list of what failed: $(cat errors.txt)"

rm -rf results
write_study "600 us"
"$program" study study.prm --jobs 2 >stopped.txt 2>errors.txt &
study=$!
for _ in $(seq 400); do # until two of them step
  [[ $(grep -c '^\[[12]/3\]   0 %' stopped.txt) == 2 ]] && break
  sleep 0.05
done
kill -INT $study
wait $study
[[ $? == 130 ]] || fail "Ctrl-C did not end it: $(cat stopped.txt errors.txt)"
[[ $(sed -n '/Missing:/,$p' errors.txt | grep -c speed_) == 3 ]] || fail "missing are: $(cat errors.txt)"
ls results/*/summary.json | grep -q 700 && fail "it went on after Ctrl-C"
exit 0

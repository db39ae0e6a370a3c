#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Four parts give the same bytes as one: of a walk and of a measurement, run by GNU parallel or by Slurm.
# Arguments: spherewalk-cli, what `demo` left, the folder packaging/slurm, parallel or slurm. Status 77: skipped.
set -eu
cli=$1
demo=$2
slurm=$3
by=$4
if [ "$by" = parallel ] && ! command -v parallel >/dev/null; then
  echo "GNU parallel is not installed."
  exit 77
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
printf 'image_width: 160\nimage_height: 120\ncamera_matrix: {data: [120, 0, 79.5, 0, 120, 59.5, 0, 0, 1]}\n' >camera.yaml

# The subcommand and its arguments, in four parts, put together at the end.
in_parts() {
  if [ "$by" = slurm ]; then
    SPHEREWALK_CLI="$cli" SPHEREWALK_CPUS=1 "$slurm/submit" 4 "$@"
    for _ in $(seq 600); do
      [ -n "$(squeue -h)" ] || break
      sleep 0.5
    done
    cat slurm-*.out
    [ -z "$(squeue -h)" ] && rm slurm-*.out
  else
    parallel --will-cite -j 4 --halt now,fail=1 "$cli" "$@" --threads 1 --shard '{}/4' ::: 1 2 3 4
    "$cli" "$@"
  fi
}

walk="walk $demo/dataset --camera $demo/robot.yaml --path $demo/path.tum --format nerfstudio --out"
# shellcheck disable=SC2086 # words, split on purpose
"$cli" $walk "$folder/one"
# shellcheck disable=SC2086
in_parts $walk "$folder/four"
ls four/parts | grep -c -- -of-4 | grep -qx 4
diff -r --exclude=times.csv --exclude=parts one four
[ -s four/index.csv ] && [ -s four/transforms.json ]

measure="measure $demo/dataset --camera $folder/camera.yaml --views 8 --sampling-views 2 --cache"
# shellcheck disable=SC2086
"$cli" $measure "$folder/cache-one" --report "$folder/report-one" >/dev/null
# shellcheck disable=SC2086
in_parts $measure "$folder/cache-four" --report "$folder/report-four"
diff -r cache-one/results cache-four/results
[ "$(ls cache-four/results | wc -l)" -ge 8 ]
for file in report-1.jpg report-2.jpg; do
  cmp report-one/$file report-four/$file
done
echo "Four parts gave the same as one, by $by."

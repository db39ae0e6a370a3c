#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The script of packaging/examples drives a practice camera through a small survey.
# Arguments: spherewalk-cli, the script.
set -eu
cli=$1
script=$2
folder=$(mktemp -d)
camera=
trap 'if [ -n "$camera" ]; then kill "$camera"; fi; rm -rf "$folder"' EXIT

: > "$folder/camera" # which is read before the camera has begun
"$cli" practice-camera --port 0 --width 1024 --time-scale 0.02 2>> "$folder/camera" &
camera=$!
address=
for _ in $(seq 100); do
    address=$(sed -n 's|.*listens at http://\([0-9.:]*\);.*|\1|p' "$folder/camera")
    if [ -n "$address" ]; then
        break
    fi
    sleep 0.1
done
"$cli" new "$folder/s.spherewalk" --rect 0,0,5,4 --ceiling 2.6 --step 0.9
"${python:-python3}" "$script" "$folder/s.spherewalk" --cli "$cli" --camera "$address" --practice --time-scale 0.02
"$cli" status "$folder/s.spherewalk" --json | grep -q '"next":null'

#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Films of a run: what ffmpeg is given, by programs in its place, and what it makes where it is
# installed; else skipped (77). Arguments: PROGRAM SCENES FOLDER.
source "$(dirname "$0")/app_common.sh"
view=${program%/*}/fabric-view
export ASAN_OPTIONS=detect_leaks=0 # Mesa keeps memory of its own until the end
export TSAN_OPTIONS=ignore_noninstrumented_modules=1 # and has threads of its own
expect 0 "" "$program" run patch --steps 4 --frames 3 -o run --progress none
expect 0 "" "$view" render run --width 64 --height 48
md5sum run/frames/*.png >before.md5

# instead LINE: a program in ffmpeg's place.
instead() {
  mkdir -p fake
  printf '#!/bin/sh\n%s\n' "$1" >fake/ffmpeg
  chmod +x fake/ffmpeg
}
film() { PATH="$PWD/fake:$PATH" "$view" film run --width 65 --height 48 "$@"; }

# Given are all pictures, their size, how many a second (three in 0.08 s) and where to.
instead 'echo "$@" >said; for to; do :; done; cat >"$to"'
expect 0 "3 frames in run/cloth.mp4" film
holds "all pictures" test "$(stat -c %s run/cloth.mp4)" = $((3 * 64 * 48 * 3))
holds "their size" grep -q -- "-video_size 64x48 -framerate 25 " said
holds "beside first" grep -q -- "-f mp4 run/cloth.mp4.partial\$" said
holds "no picture is kept or changed" md5sum --quiet -c before.md5
expect 0 "in elsewhere.mp4" film -o elsewhere.mp4

# What fails leaves the older film, and nothing else.
cp run/cloth.mp4 old.mp4
instead 'echo "no such codec" >&2; exit 3'
expect 1 "no such codec" film
expect 1 "ffmpeg failed with status 3" film
instead 'for to; do :; done; head -c 1000 >"$to"; kill -9 $$'
expect 1 "ffmpeg was ended by signal 9" film
holds "the older film" cmp old.mp4 run/cloth.mp4
holds "nothing half-written" test ! -e run/cloth.mp4.partial
mkdir -p empty
PATH=$PWD/empty expect 1 "ffmpeg, which makes MP4 films, cannot be started: No such file or directory; 'fabric-view render run' draws run/frames/NNNN.png" \
  "$view" film run
expect 1 "no/where.mp4: cannot be written" film -o no/where.mp4
expect 2 "--width is '8'" "$view" film run --width 8
expect 2 "which folder?" "$view" film
expect 2 "one folder at a time, not 'b' as well" "$view" film run b
expect 1 "nowhere/scene.yaml: cannot be read" "$view" film nowhere
cp -r run torn
head -c 100 run/frames/0002.state >torn/frames/0002.state
rm torn/cloth.mp4
instead 'for to; do :; done; cat >"$to"'
expect 1 "0002.state" env PATH="$PWD/fake:$PATH" "$view" film torn
holds "no film of some of the frames" test ! -e torn/cloth.mp4 -a ! -e torn/cloth.mp4.partial

finish() { [ "$failures" -eq 0 ] || exit 1; }
if ! command -v ffmpeg >/dev/null; then
  finish
  echo "skipped: ffmpeg is not installed"
  exit 77
fi
expect 0 "3 frames" "$view" film run --width 64 --height 48
holds "a film" test "$(head -c 8 run/cloth.mp4 | tail -c 4)" = ftyp
! command -v ffprobe >/dev/null ||
  holds "its pictures" test "$(ffprobe -v error -select_streams v -count_frames -show_entries \
    stream=nb_read_frames,width,height -of csv=p=0 run/cloth.mp4)" = 64,48,3
finish
echo "all hold"

#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# The commands of a document, as they stand there: each must do what it says, one that begins with
# '!' must fail. And the manual page and the completion, which lie beside it, know the options of
# some commands. Arguments: PROGRAM SCENES FOLDER DOCUMENT.
source "$(dirname "$0")/app_common.sh"
export ASAN_OPTIONS=detect_leaks=0 # Mesa keeps memory of its own until the end
mkdir bin
ln -s "$program" bin/fabric
ln -s "${program%/*}/fabric-view" bin
PATH=$PWD/bin:$PATH
count=0
while read -r line; do
  count=$((count + 1))
  bash -c "$line" >said 2>&1 || { holds "$line" false; cat said; }
done < <(awk '/^```/ { inside = !inside; next } inside' "$4")
holds "the document has commands" test "$count" -gt 3
# What the document says that is said.
while read -r text; do
  holds "said: $text" grep -qF -- "$text" said
done < <(sed -n 's/^says `\(.*\)`, and changes nothing\.$/\1/p' "$4")
documents=$(dirname "$4")
for option in $({
  for command in run export mesh; do "$program" $command --help; done
  for command in render film gltf export plot; do "${program%/*}/fabric-view" $command --help; done
} | sed -n 's/^  \(-[-a-z]*\) .*/\1/p' | grep -v '^--help$' | sort -u); do
  holds "the manual page has $option" grep -qF -- "${option//-/\\-}" "$documents/man/fabric.1"
  holds "the completion has $option" grep -qE -- "(^|[' ])$option([' ]|\$)" "$documents/completions/fabric"
done
finish

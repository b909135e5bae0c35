#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# The pages of --redcc-html in a browser: none is wider than its window, and the console stays empty.
. "$(dirname "$0")/library.sh"
command -v chromium >/dev/null || { echo "SKIPPED: needs chromium"; exit 77; }

begin "widths"
long=$(printf 'a_long_name_%.0s' $(seq 30))
printf 'void f(void) {\n    for (;;)\n        %s = %s;\n}\n' "$long" "$long" >x.c
printf '{"directory":"%s","redcc":"1","file":"x.c","loops":[{"line":2,"column":5,"function":"%s","verdict":"refused","reason":{"id":"R104","slug":"update-value-used","message":"%s","line":3,"column":1},"arrays":[],"guards":[]}]}\n' \
  "$PWD" "$long" "$long" >build.jsonl
"$REDCC_CC_PROGRAM" --redcc-html pages build.jsonl || fail "$case_name"
for page in index.html 1-x.c.html; do
  for width in 360 800 1280; do
    cat >measure.html <<END
<iframe id="f" src="pages/$page" style="width:${width}px;height:600px;border:0"></iframe>
<script>f.onload=()=>document.body.dataset.width=f.contentDocument.documentElement.scrollWidth</script>
END
    chromium --headless --no-sandbox --disable-gpu --allow-file-access-from-files --enable-logging=stderr \
      --user-data-dir="$work/profile" --virtual-time-budget=2000 --dump-dom "file://$PWD/measure.html" >dom 2>log
    shown=$(grep -o 'data-width="[0-9]*"' dom | grep -o '[0-9]*')
    [ "${shown:-9999}" -le "$width" ] || fail "$page: ${shown:-unknown} pixels in a window of $width"
    expect_no_match log 'CONSOLE'
  done
done
finish

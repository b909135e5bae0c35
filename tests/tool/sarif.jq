# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# What the SARIF 2.1.0 schema (OASIS) asks of the objects that redcc writes: required properties,
# types, words, and no properties but the schema's, which closes each object. Gives the list of what
# is wrong. The schema itself is not kept here.
def only($names): (keys - $names) as $more | if $more == [] then empty else "unknown \($more)" end;
def needs($names): ($names - keys) as $less | if $less == [] then empty else "missing \($less)" end;
def text: if type == "string" then empty else "no text: \(.)" end;
def one_of($words): . as $word | if $words | index([$word]) then empty else "no such word: \($word)" end;
def number_from_1: if type == "number" and . >= 1 and . == floor then empty else "no number from 1: \(.)" end;
def uri: if type == "string" and test("^[A-Za-z0-9._~:/?#@!$&'()*+,;=%-]*$") then empty else "no URI: \(.)" end;
def message: only(["text", "markdown", "id", "arguments", "properties"]), needs(["text"]), (.text | text);
def region: only(["startLine", "startColumn", "endLine", "endColumn"]), needs(["startLine"]), (.[] | number_from_1);
def location:
  only(["id", "physicalLocation", "logicalLocations", "message", "annotations", "relationships", "properties"]),
  (.physicalLocation | only(["address", "artifactLocation", "region", "contextRegion", "properties"]),
    needs(["artifactLocation"]),
    (.artifactLocation | only(["uri", "uriBaseId", "index", "description", "properties"]), (.uri | uri)),
    (select(.region) | .region | region)),
  (select(.message) | .message | message);
def rule:
  only(["id", "name", "shortDescription", "fullDescription", "help", "helpUri", "properties"]),
  needs(["id"]), (.id | text), (.name | text),
  (select(.shortDescription) | .shortDescription | message),
  (select(.help) | .help | message),
  (select(.helpUri) | .helpUri | uri);
def result($rules):
  only(["ruleId", "ruleIndex", "kind", "level", "message", "locations", "relatedLocations", "properties"]),
  needs(["message"]), (select(.message) | .message | message), (.ruleId | one_of($rules)),
  (.kind | one_of(["notApplicable", "pass", "fail", "review", "open", "informational"])),
  (.level | one_of(["none", "note", "warning", "error"])),
  (if .kind != "fail" and .level != "none" then "a level with a kind that is not fail" else empty end),
  (.locations[]? | location), (.relatedLocations // [] | .[] | location);
[only(["$schema", "version", "runs", "inlineExternalProperties", "properties"]),
 needs(["version", "runs"]), (.version | one_of(["2.1.0"])), (select(.["$schema"]) | .["$schema"] | uri),
 (.runs[]? | only(["tool", "results", "artifacts", "invocations", "columnKind", "properties"]), needs(["tool"]),
  (.tool | only(["driver", "extensions", "properties"]), needs(["driver"]),
   (.driver | only(["name", "version", "informationUri", "rules", "properties"]), needs(["name"]), (.name | text),
    ((.rules // []) | if length == (map(.id) | unique | length) then empty else "a rule twice" end),
    (.rules[]? | rule))),
  ((.tool.driver.rules // [] | map(.id)) as $rules | .results[] | result($rules)))]

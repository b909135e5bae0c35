# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# What is wrong with a value by a JSON schema that uses no more than these keywords: type, enum,
# required, properties, additionalProperties, items. `schema` is the schema; gives a list.
def kind: if type == "number" and . == floor then "integer" else type end;
def wrong($s; $at):
  (kind as $kind | if $s.type and ([$s.type] | flatten | index([$kind]) == null) then "\($at): \($kind)" else empty end),
  (if $s.enum and (. as $value | $s.enum | index([$value]) == null) then "\($at): \(.)" else empty end),
  (if type == "object" then
     (($s.required // []) - keys | .[] | "\($at): no \(.)"),
     (if $s.additionalProperties == false then keys - ($s.properties | keys) | .[] | "\($at): unknown \(.)" else empty end),
     (to_entries[] | .key as $key | select($s.properties[$key]) | .value | wrong($s.properties[$key]; "\($at).\($key)"))
   elif type == "array" and $s.items then .[] | wrong($s.items; "\($at)[]")
   else empty end);
[wrong($schema[0]; "")]

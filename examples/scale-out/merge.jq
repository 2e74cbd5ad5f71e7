# merge.jq - joins the NDJSON results of all shards of a run into those of one run; see merge.

def fail(why): ("merge: " + why + "\n") | halt_error(2);
def is_finding: .kind != "header" and .kind != "program" and .kind != "summary";

# The lines of each file, which must be a whole run.
def parts:
  reduce (inputs | [input_filename, .]) as [$name, $line] ({}; .[$name] += [$line])
  | to_entries
  | map(
      .key as $name
      | {name: $name, header: .value[0], summary: .value[-1], lines: .value[1:-1]}
      | if .header.kind != "header" or .header.format != 1 then fail("\($name) is no result of fivecheck -f ndjson")
        elif .summary.kind != "summary" then fail("\($name) has no summary: its run was cut short")
        elif any(.lines[]; .kind == "header" or .kind == "summary") then fail("\($name) holds more than one run")
        elif ([.lines[] | select(.kind == "program")] | length) != .header.programs
        then fail("\($name) does not tell of all its programs")
        else . end);

# Every shard once, and all asked the same.
def checked($files):
  (.[0].header.shard // {part: 1, parts: 1, of: "programs"}) as $shard
  | if length != $files then fail("\($files - length) of \($files) files are empty") else . end
  | map(.shard = (.header.shard // {part: 1, parts: 1, of: "programs"}))
  | sort_by(.shard.part)
  | if any(.[]; .shard.parts != $shard.parts or .shard.of != $shard.of)
    then fail("these are not shards of one run")
    elif map(.shard.part) != [range(1; $shard.parts + 1)]
    then fail("of \($shard.parts) shards there are the following: \(map(.shard.part | tostring) | join(" "))")
    elif (map(.header | del(.shard, .programs)) | unique | length) != 1
    then fail("the shards were not asked the same: their headers differ")
    else . end;

# [[findings..., program], ...]
def by_program: reduce .[] as $line ([[]]; .[-1] += [$line] | if $line.kind == "program" then . + [[]] else . end) | .[:-1];

# A list was dealt out program by program.
def dealt:
  map(.lines | by_program) as $hands
  | [range(0; $hands | map(length) | max // 0) as $i | $hands[] | .[$i] // empty] | add // [];

# Each once, in the order in which they come; unique would sort them.
def distinct: reduce .[] as $item ([]; if any(.[]; . == $item) then . else . + [$item] end);

# Each shard checked its own blocks of one program.
def sum_up($method; $all):
  map(.verdict) as $verdicts
  | (map(.checked) | add) as $checked
  | (map(.blocks) | max) as $blocks
  | if any($verdicts[]; . == "incomplete" or (. == "found" and ($all | not))) or $checked == $blocks then .
    else fail("the shards checked \($checked) blocks of \($blocks)") end
  | .[0]
    + {verdict: (["incomplete", "found", "accepted"] - (["incomplete", "found", "accepted"] - $verdicts)
                 | .[0] // (if $method == "certified" then "clear" else "passed" end)),
       $blocks, $checked,
       cautions: (map(.cautions[] | select(startswith("shard ") | not)) | distinct),
       errors: (map(.errors[]) | distinct)};
# Without --all a run ends at the first finding that fails; each shard has gone on to its own.
def up_to_first: (map(has("accepted") | not) | index(true)) as $i | if $i == null then . else .[:$i + 1] end;

def joined:
  .[0].header as $header
  | map(.lines[]) as $lines
  | if ([$lines[] | select(.kind == "program") | .file] | unique | length) != 1
    then fail("the shards are of different programs") else . end
  # Where a block ends when the next begins, the end comes first.
  | ([$lines[] | select(is_finding)] | sort_by(.time, -.fraction) | if $header.all then . else up_to_first end) as $found
  | $found + [[$lines[] | select(.kind == "program")] | sum_up($header.method; $header.all)
              | .findings = ($found | length)];

[parts | checked($files)][0] as $parts
| ($parts[0].shard.of == "blocks") as $blocks
| ($parts | if $blocks then joined else dealt end) as $lines
| [$lines[] | select(.kind == "program")] as $programs
| ($parts[0].header | .shard = null | .programs = ($programs | length)),
  $lines[],
  {kind: "summary", status: ($parts | map(.summary.status) | max), programs: ($programs | length),
   passed: ([$programs[] | select(.verdict == "clear" or .verdict == "passed")] | length),
   incomplete: ([$programs[] | select(.verdict == "incomplete")] | length),
   blocks: ($programs | map(.blocks) | add // 0), findings: ($programs | map(.findings) | add // 0)}

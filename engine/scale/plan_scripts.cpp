// SPDX-License-Identifier: Apache-2.0
#include "engine/scale/plan_scripts.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <utility>

#include "engine/error.h"
#include "engine/scale/plan.h"
#include "engine/scale/plan_products.h"

namespace ilot {
namespace {

constexpr std::array<const char*, 5> kKinds{"make", "slurm", "snakemake", "dask", "k8s"};

// In all scripts @PLAN@ is the folder, @N@ the number of areas, @I@ that of inputs, @M@ the memory of a task in MiB.
// Lines that begin with @C@ are for plans whose clouds can be labelled, those with @R@ for the others; @U@ for parts in
// an object store, where empty files in PLAN/parts say which are there, @L@ for the others. What ended with neither 0,
// 3 (done) nor 1, 2 (bad input), 130 (stopped by a user) is tried again: the machine was at fault, or a signal ended
// it.
constexpr const char* kMake = R"(# make -j 8 -f THIS OUT=out
@C@# make -j 8 -f THIS OUT=out clouds: labelled clouds too
ILOT ?= ilot
OUT ?= out
PLAN := @PLAN@
$(OUT)/run.json: $(patsubst %,$(PLAN)/parts/%,$(shell seq 1 @N@))
@R@	$(ILOT) merge $(PLAN) -o $(OUT) || test $$? -eq 3
@C@	$(ILOT) merge $(PLAN) -o $(OUT) --labels || test $$? -eq 3
@C@clouds: $(patsubst %,label-%,$(shell seq 1 @I@))
@C@label-%: $(OUT)/run.json
@C@	for try in 1 2 3; do $(ILOT) task $(PLAN) label $* -o $(OUT) --threads 1 -q; code=$$?; \
@C@	  case $$code in 0|1|2|3|130) exit $$code;; *) sleep 1;; esac; done; exit $$code
$(PLAN)/parts/%: $(PLAN)/plan.json
	for try in 1 2 3; do $(ILOT) task $(PLAN) $* --threads 1 -q; code=$$?; \
@L@	  case $$code in 0|3) exit 0;; 1|2|130) exit $$code;; *) sleep 1;; esac; done; exit $$code
@U@	  case $$code in 0|3) touch $@; exit 0;; 1|2|130) exit $$code;; *) sleep 1;; esac; done; exit $$code
)";

constexpr const char* kSlurm = R"(#!/bin/sh
# job=$(sbatch --parsable --array=1-@N@ THIS) && sbatch --dependency=afterok:$job --wrap 'ilot merge @PLAN@ -o out'
@C@# Clouds: merge with --labels, then sbatch --array=1-@I@ --export=ALL,LABEL_TO=out --dependency=afterok:MERGE THIS
# More areas than the cluster's MaxArraySize: submit ranges of numbers, with OFFSET=1000 for those from 1001 on.
#SBATCH --job-name=ilot --cpus-per-task=1 --mem=@M@M --requeue
@R@"${ILOT:-ilot}" task @PLAN@ $((SLURM_ARRAY_TASK_ID + ${OFFSET:-0})) --threads 1 --memory @M@M -q
@C@"${ILOT:-ilot}" task @PLAN@ ${LABEL_TO:+label} $((SLURM_ARRAY_TASK_ID + ${OFFSET:-0})) \
@C@  ${LABEL_TO:+-o "$LABEL_TO"} --threads 1 --memory @M@M -q
code=$?
case $code in
  0|3) exit 0;;
  1|2|130) exit $code;;
esac
[ "${SLURM_RESTART_COUNT:-0}" -lt 3 ] && scontrol requeue "${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID"
exit $code
)";

constexpr const char* kSnakemake = R"(# snakemake --cores 8 --retries 3 --snakefile THIS --config out=out
@C@# snakemake clouds --cores ...: labelled clouds too
PLAN, OUT, ILOT = "@PLAN@", config.get("out", "out"), config.get("ilot", "ilot")
rule merge:
    input: expand(PLAN + "/parts/{n}", n=range(1, @N@ + 1))
    output: OUT + "/run.json"
@R@    shell: "{ILOT} merge {PLAN} -o {OUT} || test $? -eq 3"
@C@    shell: "{ILOT} merge {PLAN} -o {OUT} --labels || test $? -eq 3"
@C@rule clouds:
@C@    input: expand(OUT + ".labelled/{n}", n=range(1, @I@ + 1))
@C@rule label:
@C@    input: ancient(OUT + "/run.json")
@C@    output: touch(OUT + ".labelled/{n}")
@C@    shell: "{ILOT} task {PLAN} label {wildcards.n} -o {OUT} --threads 1 -q"
rule task:
    output: PLAN + "/parts/{n}"
@L@    shell: "{ILOT} task {PLAN} {wildcards.n} --threads 1 -q || test $? -eq 3"
@U@    shell: "({ILOT} task {PLAN} {wildcards.n} --threads 1 -q || test $? -eq 3) && touch {output}"
)";

constexpr const char* kDask = R"(#!/usr/bin/env python3
# /usr/bin/python3 THIS tcp://SCHEDULER:8786 OUT: the workers see the same folders. Do not name this file dask.py.
@C@# With a third word, clouds, the labelled clouds are written too.
import os, subprocess, sys
from distributed import Client, as_completed
PLAN, ILOT = "@PLAN@", os.environ.get("ILOT", "ilot")
def task(*words):
    return words, subprocess.run([ILOT, "task", PLAN, *words, "--threads", "1", "-q"]).returncode
def run_all(tasks):
    tries, work = {}, as_completed([client.submit(task, *words, pure=False, retries=3) for words in tasks])
    for words, code in (future.result() for future in work):
        tries[words] = tries.get(words, 0) + 1
        if code not in (0, 1, 2, 3, 130) and tries[words] < 4:
            work.add(client.submit(task, *words, pure=False, retries=3))
        elif code not in (0, 3):
            raise SystemExit(f"task {' '.join(words)}: exit {code}")
client, out = Client(sys.argv[1]), sys.argv[2]
run_all([(str(n),) for n in range(1, @N@ + 1)])
@R@raise SystemExit(subprocess.run([ILOT, "merge", PLAN, "-o", out]).returncode)
@C@clouds = sys.argv[3:] == ["clouds"]
@C@merged = subprocess.run([ILOT, "merge", PLAN, "-o", out, *["--labels"][:clouds]]).returncode
@C@if clouds and merged in (0, 3):
@C@    run_all([("label", str(n), "-o", os.path.abspath(out)) for n in range(1, @I@ + 1)])
@C@raise SystemExit(merged)
)";

constexpr const char* kKubernetes =
    R"(# kubectl apply -f THIS; then ilot merge @PLAN@ -o out where the volume is mounted
apiVersion: batch/v1
kind: Job
metadata: {name: ilot-tasks}
spec:
  completionMode: Indexed
  completions: @N@
  parallelism: 8
  backoffLimit: 1000
  podFailurePolicy:
    rules: [{action: FailJob, onExitCodes: {containerName: task, operator: In, values: [1, 2]}}]
  template:
    spec:
      restartPolicy: Never
      containers:
        - name: task
          image: ilot
          command: [sh, -c, "ilot task @PLAN@ $((JOB_COMPLETION_INDEX + 1)) --threads 1 --memory @M@M -q; c=$?; [ $c -eq 3 ] && c=0; exit $c"]
          resources: {requests: {cpu: 1, memory: @M@Mi}}
          volumeMounts: [{name: work, mountPath: @PLAN@}]
      volumes: [{name: work, persistentVolumeClaim: {claimName: ilot}}]
)";

void replace_all(std::string& text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
}

// Keeps the lines that belong to the plan, without their marks.
std::string lines_for(const std::string& text, const Plan& plan) {
  const bool labels = carries_points(plan), remote = !plan.parts.empty();
  const std::array<std::pair<const char*, bool>, 4> marks{
      {{"@C@", labels}, {"@R@", !labels}, {"@U@", remote}, {"@L@", !remote}}};
  std::string kept;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const auto mark = std::ranges::find_if(marks, [&](const auto& m) { return line.starts_with(m.first); });
    if (mark == marks.end())
      kept += line + "\n";
    else if (mark->second)
      kept += line.substr(std::string(mark->first).size()) + "\n";
  }
  return kept;
}

const char* template_of(const std::string& kind) {
  constexpr std::array kTexts{kMake, kSlurm, kSnakemake, kDask, kKubernetes};
  const auto at = std::find(kKinds.begin(), kKinds.end(), kind);
  if (at != kKinds.end()) return kTexts[static_cast<std::size_t>(at - kKinds.begin())];
  throw Error("--as " + kind + ": there is no such engine; there are: make, slurm, snakemake, dask, k8s",
              ExitCode::usage);
}

}  // namespace

std::span<const char* const> script_kinds() {
  return kKinds;
}

std::string plan_script(const std::filesystem::path& folder, const std::string& kind) {
  const char* lines = template_of(kind);
  const Plan plan = read_plan(folder);
  std::string text = lines_for(lines, plan);
  const std::string path = std::filesystem::absolute(folder).lexically_normal().string();
  const auto plain = [](unsigned char c) {
    return std::isalnum(c) != 0 || std::string("/._+-").find(static_cast<char>(c)) != std::string::npos;
  };
  if (!std::all_of(path.begin(), path.end(), plain))
    throw Error(
        path + ": a script needs a folder whose name has only letters, digits and / . _ + -; make the plan there",
        ExitCode::usage);
  constexpr std::uint64_t kUsualMemory = 512;  // MiB; Choice: tasks of one thread have room for large buildings
  std::uint64_t memory = kUsualMemory;
  for (const PlanArea& area : plan.areas) memory = std::max(memory, (area.memory_bytes >> 20) + 1);
  replace_all(text, "@PLAN@", path.size() > 1 && path.back() == '/' ? path.substr(0, path.size() - 1) : path);
  replace_all(text, "@N@", std::to_string(plan.areas.size()));
  replace_all(text, "@I@", std::to_string(plan.inputs.size()));
  replace_all(text, "@M@", std::to_string(memory));
  return text;
}

}  // namespace ilot

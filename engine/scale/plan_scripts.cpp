// SPDX-License-Identifier: Apache-2.0
#include "engine/scale/plan_scripts.h"

#include <algorithm>
#include <array>

#include "engine/error.h"
#include "engine/scale/plan.h"

namespace ilot {
namespace {

constexpr std::array<const char*, 5> kKinds{"make", "slurm", "snakemake", "dask", "k8s"};

// In all scripts @PLAN@ is the folder, @N@ the number of areas, @M@ the memory of a task in MiB.
constexpr const char* kMake = R"(# make -j 8 -f THIS OUT=out
ILOT ?= ilot
OUT ?= out
PLAN := @PLAN@
$(OUT)/run.json: $(patsubst %,$(PLAN)/parts/%,$(shell seq 1 @N@))
	$(ILOT) merge $(PLAN) -o $(OUT) || test $$? -eq 3
$(PLAN)/parts/%: $(PLAN)/plan.json
	for try in 1 2 3; do $(ILOT) task $(PLAN) $* --threads 1 -q; code=$$?; \
	  case $$code in 0|3) exit 0;; 75) sleep 1;; *) exit $$code;; esac; done; exit 75
)";

constexpr const char* kSlurm = R"(#!/bin/sh
# job=$(sbatch --parsable --array=1-@N@ THIS) && sbatch --dependency=afterok:$job --wrap 'ilot merge @PLAN@ -o out'
# More areas than the cluster's MaxArraySize: submit ranges of numbers, with OFFSET=1000 for those from 1001 on.
#SBATCH --job-name=ilot --cpus-per-task=1 --mem=@M@M --requeue
"${ILOT:-ilot}" task @PLAN@ $((SLURM_ARRAY_TASK_ID + ${OFFSET:-0})) --threads 1 --memory @M@M -q
code=$?
[ $code -eq 75 ] && [ "${SLURM_RESTART_COUNT:-0}" -lt 3 ] && scontrol requeue "${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID"
[ $code -eq 3 ] && exit 0
exit $code
)";

constexpr const char* kSnakemake = R"(# snakemake --cores 8 --retries 3 --snakefile THIS --config out=out
PLAN, OUT, ILOT = "@PLAN@", config.get("out", "out"), config.get("ilot", "ilot")
rule merge:
    input: expand(PLAN + "/parts/{n}", n=range(1, @N@ + 1))
    output: OUT + "/run.json"
    shell: "{ILOT} merge {PLAN} -o {OUT} || test $? -eq 3"
rule task:
    output: PLAN + "/parts/{n}"
    shell: "{ILOT} task {PLAN} {wildcards.n} --threads 1 -q || test $? -eq 3"
)";

constexpr const char* kDask = R"(#!/usr/bin/env python3
# /usr/bin/python3 THIS tcp://SCHEDULER:8786 OUT: the workers see the same folders. Do not name this file dask.py.
import os, subprocess, sys
from distributed import Client, as_completed
PLAN, ILOT = "@PLAN@", os.environ.get("ILOT", "ilot")
def task(n):
    return n, subprocess.run([ILOT, "task", PLAN, str(n), "--threads", "1", "-q"]).returncode
client, tries = Client(sys.argv[1]), {}
work = as_completed(client.map(task, range(1, @N@ + 1), pure=False, retries=3))
for n, code in (future.result() for future in work):
    tries[n] = tries.get(n, 0) + 1
    if code == 75 and tries[n] < 4:
        work.add(client.submit(task, n, pure=False, retries=3))
    elif code not in (0, 3):
        raise SystemExit(f"task {n}: exit {code}")
raise SystemExit(subprocess.run([ILOT, "merge", PLAN, "-o", sys.argv[2]]).returncode)
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
  std::string text = template_of(kind);
  const Plan plan = read_plan(folder);
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
  replace_all(text, "@M@", std::to_string(memory));
  return text;
}

}  // namespace ilot

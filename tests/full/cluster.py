#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Dask (scheduler and two workers on the loopback), Snakemake and Slurm run a plan of roofs, one of planes with labelled clouds
and one of facades; each result is that of one run. Slurm is its real daemons on the loopback where they can run (as root);
else its array script runs without them, with SLURM_ARRAY_TASK_ID set, and that is said. Debian: python3-distributed,
snakemake, slurm-wlm, munge."""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

import slurm_loopback

EXE = os.environ["ILOT_EXE"]
PORT = "18789"


def run(*command, code=(0,), **options):
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True, timeout=600, **options)
    if done.returncode not in code:
        sys.exit(f"{' '.join(map(str, command))}: exit {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


def hash_of(out):
    return json.loads((out / "run.json").read_text())["result_hash"]


def script(plan, kind, path):
    shutil.rmtree(plan / "parts")  # with what killed tasks left
    (plan / "parts").mkdir()
    path.write_text(run(EXE, "plan", plan, "--as", kind))
    return path


def with_dask(folder, plan, areas, clouds):
    program = script(plan, "dask", folder / "run_plan.py")
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL, "cwd": folder}
    both = [subprocess.Popen(["dask-scheduler", "--host", "127.0.0.1", "--port", PORT, "--no-dashboard"], **quiet)]
    try:
        time.sleep(3)
        both.append(subprocess.Popen(["dask-worker", f"tcp://127.0.0.1:{PORT}", "--nworkers", "2", "--nthreads", "1",
                                      "--no-dashboard"], **quiet))
        run("/usr/bin/python3", program, f"tcp://127.0.0.1:{PORT}", folder / "dask", *(["clouds"] if clouds else []),
            cwd=folder)
    finally:
        for process in reversed(both):
            process.terminate()
            process.wait()
    return folder / "dask"


def with_snakemake(folder, plan, areas, clouds):
    program = script(plan, "snakemake", folder / "Snakefile")
    run("snakemake", *(["clouds"] if clouds else []), "--cores", "2", "--retries", "3", "--snakefile", program, "--config", f"out={folder}/snakemake",
        f"ilot={EXE}", cwd=folder)
    return folder / "snakemake"


def with_slurm_script(folder, plan, areas, clouds):
    program = script(plan, "slurm", folder / "plan.sh")
    for number in range(1, areas + 1):
        run("sh", program, env={**os.environ, "SLURM_ARRAY_TASK_ID": str(number)})
    run(EXE, "merge", plan, "-o", folder / "slurm", *(["--labels"] if clouds else []))
    for number in range(1, clouds + 1):
        run("sh", program, env={**os.environ, "SLURM_ARRAY_TASK_ID": str(number), "LABEL_TO": str(folder / "slurm")})
    return folder / "slurm"


def with_slurm(folder, plan, areas, clouds):
    program = script(plan, "slurm", folder / "plan.sh")
    out = folder / "slurm-daemons"
    with slurm_loopback.cluster(folder / "cluster") as environment:
        output = ["--output", folder / "job-%j.log"]
        tasks = slurm_loopback.submit(environment, *output, f"--array=1-{areas}", program)
        merge = f"'{EXE}' merge '{plan}' -o '{out}' {'--labels' if clouds else ''}"
        merged = slurm_loopback.submit(environment, *output, f"--dependency=afterok:{tasks}", "--wrap", merge)
        if clouds:
            slurm_loopback.submit({**environment, "LABEL_TO": str(out)}, *output, f"--array=1-{clouds}",
                                  f"--dependency=afterok:{merged}", program)
        slurm_loopback.wait_for_jobs(environment)
    return out


def compare(cloud, folder, product, clouds):
    """`clouds` is the number of labelled clouds to write."""
    folder = folder / product
    folder.mkdir()
    run(EXE, "run", cloud, "-o", folder / "one", "--products", product, "--no-report", *([] if clouds else ["--no-clouds"]))
    plan = folder / "plan"
    run(EXE, "plan", cloud, "-o", plan, "--products", product, "--area-size", "100")
    areas = len(json.loads((plan / "plan.json").read_text())["areas"])
    no_daemons = slurm_loopback.reason_against()
    if no_daemons:
        print(f"Slurm without daemons: {no_daemons}")
    for work in (with_dask, with_snakemake, with_slurm_script, *([] if no_daemons else [with_slurm])):
        same = hash_of(work(folder, plan, areas, clouds)) == hash_of(folder / "one")
        print(f"{product}, {work.__name__}: {areas} areas, {'the bytes of one run' if same else 'ANOTHER RESULT'}", flush=True)
        if not same:
            sys.exit(1)


def main():
    missing = [name for name in ("dask-scheduler", "dask-worker", "snakemake") if not shutil.which(name)]
    if missing:
        print(f"not installed: {', '.join(missing)}")
        sys.exit(77)
    os.environ["ILOT"] = EXE
    with tempfile.TemporaryDirectory(prefix="ilot-cluster-") as name:
        folder = pathlib.Path(name)
        run(EXE, "scan", "district", "-o", folder / "d.laz", "--points", "200000", "-q")
        compare(folder / "d.laz", folder, "roofs", 0)
        compare(folder / "d.laz", folder, "planes", 1)
        run(EXE, "scan", "row-wild", "--seed", "4242", "-o", folder / "row.laz", "--points", "100000", "-q")
        compare(folder / "row.laz", folder, "facades", 1)


if __name__ == "__main__":
    main()

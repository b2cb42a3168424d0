# SPDX-License-Identifier: Apache-2.0
"""A cluster of this machine alone: slurmctld and one slurmd on the loopback, with munge (Debian: slurm-wlm, munge; as root)."""
import contextlib
import datetime
import os
import pathlib
import shutil
import subprocess
import time

DAEMONS = ("munged", "slurmctld", "slurmd")
MUNGE_SOCKET = pathlib.Path("/run/munge/munge.socket.2")
CONFIGURATION = """ClusterName=loopback
SlurmctldHost={host}(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SlurmctldPort=16817
SlurmdPort=16818
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
SelectType=select/cons_tres
ReturnToService=2
NodeName={host} NodeAddr=127.0.0.1 CPUs=2 RealMemory=2000 State=UNKNOWN
PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP
"""


def reason_against():
    """Why there is no cluster here; empty where there is one."""
    path = os.environ.get("PATH", "") + ":/usr/sbin"
    missing = [name for name in DAEMONS if not shutil.which(name, path=path)]
    if missing:
        return f"not installed: {', '.join(missing)}"
    return "" if os.geteuid() == 0 else "its daemons run as root"


def wait_until(done, seconds, what):
    end = time.monotonic() + seconds
    while not done():
        if time.monotonic() > end:
            raise RuntimeError(f"slurm: {what} took longer than {seconds} s")
        time.sleep(0.2)


def start_munge():
    """Returns the daemon, or None where one runs already."""
    if MUNGE_SOCKET.exists() and subprocess.run("munge -n | unmunge", shell=True, capture_output=True).returncode == 0:
        return None
    MUNGE_SOCKET.parent.mkdir(exist_ok=True)
    shutil.chown(MUNGE_SOCKET.parent, "munge")
    daemon = subprocess.Popen(["/usr/sbin/munged", "--foreground"], user="munge", stderr=subprocess.DEVNULL)
    wait_until(MUNGE_SOCKET.exists, 10, "munge")
    return daemon


@contextlib.contextmanager
def cluster(folder):
    """Gives the environment in which sbatch and squeue know the cluster."""
    folder.mkdir()
    host = os.uname().nodename.split(".")[0]
    configuration = folder / "slurm.conf"
    configuration.write_text(CONFIGURATION.format(host=host, folder=folder))
    for name in ("state", "spool"):
        (folder / name).mkdir()
    environment = {**os.environ, "SLURM_CONF": str(configuration)}
    quiet = {"env": environment, "stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    daemons = [start_munge()]
    try:
        daemons.append(subprocess.Popen(["/usr/sbin/slurmctld", "-D", "-f", configuration], **quiet))
        daemons.append(subprocess.Popen(["/usr/sbin/slurmd", "-D", "-f", configuration], **quiet))
        idle = ["sinfo", "-h", "-o", "%t"]
        wait_until(lambda: subprocess.run(idle, env=environment, capture_output=True, text=True).stdout.strip() == "idle", 60,
                   "its start")
        yield environment
    finally:
        for daemon in reversed([d for d in daemons if d]):
            daemon.terminate()
            daemon.wait()


def submit(environment, *arguments):
    done = subprocess.run(["sbatch", "--parsable", *map(str, arguments)], env=environment, capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(done.stderr)
    return done.stdout.strip()


def wait_for_jobs(environment, seconds=600):
    """Jobs that were requeued start after some seconds here; a cluster lets them wait for two minutes."""
    quiet = {"env": environment, "capture_output": True, "text": True}

    def done():
        waiting = subprocess.run(["squeue", "-h", "-r", "-o", "%i %S"], **quiet).stdout.split("\n")[:-1]
        for job, start in (line.split() for line in waiting):
            soon = (datetime.datetime.now() + datetime.timedelta(seconds=10)).isoformat()
            if start > soon and start[0].isdigit():  # at once its node would refuse it: what was killed is known there still
                subprocess.run(["scontrol", "update", f"JobId={job}", "StartTime=now+5"], **quiet)
        return not waiting

    wait_until(done, seconds, "the jobs")

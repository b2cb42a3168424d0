# SPDX-License-Identifier: Apache-2.0
"""Calls of the program ilot: its place, its progress as JSON lines, its end on request, its faults."""
import json
import os
import shutil
import signal
import subprocess
import tempfile
import time

from processing.core.ProcessingConfig import ProcessingConfig
from qgis.core import QgsProcessingException

EXECUTABLE = "ILOT_EXECUTABLE"  # of the setting, and of the variable of the environment that goes before it
INCOMPLETE, INTERRUPTED = 3, 130
SECONDS_BETWEEN_LOOKS = 0.1


def executable():
    """The path of the program. Raises QgsProcessingException where there is none."""
    for place in (os.environ.get(EXECUTABLE), ProcessingConfig.getSetting(EXECUTABLE), "ilot"):
        found = place and shutil.which(place)
        if found:
            return found
    raise QgsProcessingException("The program ilot was not found. Install it, or name it in Settings > Options > Processing > "
                                 "Providers > ilot.")


def output_of(*arguments):
    """What a short call prints."""
    done = subprocess.run([executable(), *map(str, arguments)], capture_output=True, text=True, stdin=subprocess.DEVNULL)
    if done.returncode != 0:
        raise QgsProcessingException(done.stderr.strip() or f"ilot ended with {done.returncode}")
    return done.stdout


class Stages:
    """Shows events of a run. The share is that of the stage: the program does not say how long later ones take."""

    def __init__(self, feedback):
        self.feedback, self.total = feedback, 0

    def show(self, event):
        if event["event"] == "stage_start":
            self.total = event.get("total", 0)
            self.feedback.setProgressText(event["stage"])
            self.feedback.setProgress(0)
        elif event["event"] == "stage_done":
            self.feedback.setProgress(100)
        elif event["event"] == "unit_done" and event.get("total"):
            self.feedback.setProgress(100 * event.get("done", 0) / event["total"])


def _show_lines(text, rest, show):
    """Shows each whole line; returns what follows the last."""
    *lines, rest = (rest + text).split("\n")
    for line in lines:
        if line.strip():
            show(line)
    return rest


def run(arguments, feedback, events=False):
    """Runs the program until it ends or the user cancels: then it stops as on Ctrl-C, and a run can be resumed. Returns the
    exit code, 0 or 3 (something was skipped). Raises QgsProcessingException with the program's sentence for others."""
    command = [executable(), *map(str, arguments)]
    with tempfile.TemporaryDirectory() as room:
        log = os.path.join(room, "events")
        said = os.path.join(room, "said")
        if events:
            command += ["--log-json", log]
        feedback.pushCommandInfo(" ".join(command))
        with open(said, "w", encoding="utf-8") as out, open(said, encoding="utf-8", errors="replace") as reader:
            process = subprocess.Popen(command, stdout=out, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL)
            code, lines = _follow(process, reader, log, feedback)
    if code in (0, INCOMPLETE):
        return code
    if code == INTERRUPTED or feedback.isCanceled():
        raise QgsProcessingException("Stopped. What was done is kept; the same call with \"resume\" goes on.")
    raise QgsProcessingException(lines[-1] if lines else f"ilot ended with {code}")


def _follow(process, reader, log, feedback):
    """Shows lines and events as they come. Returns the exit code and the lines."""
    stages, lines, rest, event_rest, events = Stages(feedback), [], "", "", None

    def show(line):
        lines.append(line)
        feedback.pushInfo(line)

    while True:
        ended = process.poll() is not None
        rest = _show_lines(reader.read(), rest, show)
        if events is None and os.path.exists(log):
            events = open(log, encoding="utf-8")
        if events is not None:
            event_rest = _show_lines(events.read(), event_rest, lambda line: stages.show(json.loads(line)))
        if ended:
            break
        if feedback.isCanceled():
            process.send_signal(signal.SIGINT)
            process.wait()
        time.sleep(SECONDS_BETWEEN_LOOKS)
    if events is not None:
        events.close()
    _show_lines("\n", rest, show)
    return process.returncode, lines

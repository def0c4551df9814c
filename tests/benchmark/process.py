"""A command as a process of its own, with its seconds and its memory."""
import dataclasses
import signal
import subprocess
import sys
import tempfile

TIMED_OUT = 124  # what `timeout` ends with


@dataclasses.dataclass
class Run:
    seconds: float
    megabytes: float  # most that was resident at once, 10^6 bytes
    output: str  # with what went to standard error
    fault: str  # "" if all went well


def say(text):
    print(text, file=sys.stderr, flush=True)


def run(command, limit):
    """Time is told by GNU time: a child of Python itself is never seen to take less memory than
    Python did when it started it."""
    with tempfile.NamedTemporaryFile("r") as told:
        done = subprocess.run(
            ["/usr/bin/time", "--format=%e %M", f"--output={told.name}", "timeout", str(limit), *map(str, command)],
            text=True, capture_output=True, check=False)
        seconds, kilobytes = told.read().splitlines()[-1].split()
    return Run(float(seconds), int(kilobytes) * 1024 / 1e6, done.stdout + done.stderr, fault_of(done, limit))


def fault_of(done, limit):
    if done.returncode == 0:
        return ""
    if done.returncode == TIMED_OUT:
        return f"not done after {limit} s"
    if done.returncode > 128:
        return signal.strsignal(done.returncode - 128) or f"signal {done.returncode - 128}"
    lines = done.stderr.strip().splitlines()
    return lines[-1] if lines else f"exit code {done.returncode}"

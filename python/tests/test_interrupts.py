"""Ctrl-C ends every call soon, and other threads of Python run meanwhile."""

import contextlib
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest
from processes import environment
from public import CALLS, WITHOUT, WITHOUT_OF_RETARGET, of_table

import dq8
import dq8.retarget
from dq8._signatures import SIGNATURES

ALL = {**{name: of_table(name, parameters) for name, (parameters, _) in SIGNATURES.items()}, **CALLS}
# Of those that share their work out.
SHARED = ["mean", "mean of few", "dib_windows", "Mechanism.reach", "Mechanism.track", "Mechanism.sequence", "Mechanism.solutions", "Mechanism.jacobian", "skin", "deskew"]

# Calls by number, three times each: a line when it begins; then, when it was interrupted, for how long another thread of Python
# stood still at most. Calls that take less than the wait for the signal are called again.
CHILD = """
import _thread, signal, sys, threading, time
import numpy as np, dq8
from test_interrupts import in_line
# What a shell starts in the background ignores interrupts, and so do its children.
signal.signal(signal.SIGINT, signal.default_int_handler)
# Python throws away what is raised while it finalizes an object, as it does many in SciPy's constructors: interrupt again then.
sys.unraisablehook = lambda thrown: threading.Timer(0.001, _thread.interrupt_main).start()
sys.setswitchinterval(0.001)
turned = np.stack([dq8.from_twist([0.1 * i, 0, 0, 1, 2, i]) for i in range(8)])[3]
arm = dq8.Mechanism([-1, 0], "revolute", [0, 0, 1], dq8.from_translation([1.0, 0, 0]))
chain = dq8.Mechanism([-1] + list(range(2_000)), ["revolute"] + ["fixed"] * 2_000, [0, 0, 1], dq8.from_translation([1e-3, 0, 0]))
stood, ends = [0.0], False
def run():
    last, kept = time.monotonic(), in_line("self")
    while not ends:
        time.sleep(0.002)
        now, keeps = time.monotonic(), in_line("self")
        stood[0] = max(stood[0], now - last - sum(keeps[thread] - kept.get(thread, 0.0) for thread in keeps))
        last, kept = now, keeps
threading.Thread(target=run, daemon=True).start()
for line in sys.stdin:
    setup, call = line.rstrip("\\n").split("\\t")
    names = {"np": np, "dq8": dq8, "turned": turned, "arm": arm, "chain": chain}
    try:
        exec(setup, names)
    except Exception as error:
        sys.exit(f"{setup}: {error!r}")
    call = compile(call, "call", "exec")
    for _ in range(3):
        try:
            time.sleep(0.01)
            stood[0] = 0.0
            print("begins", flush=True)
            while True:
                exec(call, names)
        except KeyboardInterrupt:
            # The other thread says how long it waited when it runs again.
            time.sleep(0.02)
            print(stood[0], flush=True)
    del names
"""

# Seconds, the promise of the README; each call that does not look for signals, or keeps the interpreter, takes longer as a whole.
SOON = 0.2


def in_line(process: object) -> dict[str, float]:
    """Seconds for which each thread of a process was ready to run, and others had the cores: Linux counts them."""
    seconds = {}
    for thread in Path("/proc").glob(f"{process}/task/*"):
        # A thread may end meanwhile, and Linux may be built without these counts.
        with contextlib.suppress(OSError):
            seconds[thread.name] = int((thread / "schedstat").read_text().split()[1]) / 1e9
    return seconds


class Child:
    """A process that calls what it is told."""

    def __init__(self, threads: str) -> None:
        command, own = [sys.executable, "-c", CHILD], environment(DQ8_NUM_THREADS=threads)
        self.process = subprocess.Popen(command, env=own, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, bufsize=1)

    def waits(self, setup: str, call: str) -> list[tuple[float, float]]:
        """From the signal to the exception, and how long another thread stood still, three times."""
        late = threading.Timer(120, self.process.kill)
        late.start()
        try:
            self.process.stdin.write(f"{setup}\t{call}\n")
            return [self.wait() for _ in range(3)]
        finally:
            late.cancel()

    def wait(self) -> tuple[float, float]:
        """Both without the time that other processes took from this one."""
        assert self.process.stdout.readline() == "begins\n"
        time.sleep(0.1)
        sent, before = time.monotonic(), in_line(self.process.pid)
        self.process.send_signal(signal.SIGINT)
        stood = float(self.process.stdout.readline())
        waited, after = time.monotonic() - sent, in_line(self.process.pid)
        # Threads that compute side by side wait side by side.
        return waited - max((after[thread] - before.get(thread, 0.0) for thread in after), default=0.0), stood


@pytest.fixture(scope="module")
def children():
    """By the number of threads: one process for all calls, which a call that is wrong ends."""
    made: dict[str, Child] = {}

    def child(threads: str) -> Child:
        if threads not in made or made[threads].process.poll() is not None:
            made[threads] = Child(threads)
        return made[threads]

    yield child
    for child in made.values():
        child.process.kill()
        child.process.wait()


def check(child: Child, name: str) -> None:
    waits = child.waits(*ALL[name])
    # What Linux does not count, such as a host that gives the cores away, may keep it waiting, but not always.
    assert min(wait for wait, _ in waits) < SOON, waits
    assert min(stood for _, stood in waits) < SOON, waits


@pytest.mark.parametrize("name", ALL)
def test_an_interrupt_ends_a_long_call_soon_and_other_threads_run(name, children):
    check(children("1"), name)


@pytest.mark.parametrize("name", SHARED)
def test_an_interrupt_ends_a_call_of_two_threads(name, children):
    check(children("2"), name)


def test_everything_public_is_called():
    called = {name.replace(",", " ").split(" ")[0].split(".")[0] for name in ALL} | set(WITHOUT)
    assert set(dq8.__all__) <= called
    called = {name.split(" ")[0].split(".")[1] for name in ALL if name.startswith("retarget.")} | set(WITHOUT_OF_RETARGET)
    assert set(dq8.retarget.__all__) == called


def test_what_a_handler_raises_is_raised():
    code = """
import signal, numpy as np, dq8
class Stop(Exception): pass
def stop(*_): raise Stop
signal.signal(signal.SIGALRM, stop)
motions, out = np.tile(dq8.identity(), (20_000, 8, 1)), np.full((20_000, 8), 7.0)
signal.setitimer(signal.ITIMER_REAL, 0.2)
try:
    dq8.mean(motions, tolerance=-1.0, max_iterations=5_000, out=out)
except Stop:
    # What was computed until then is written, the rest is as it was.
    assert (out[-1] == 7.0).all()
    dq8.mean(motions[:10], out=out[:10])
    print("stopped")
"""
    done = subprocess.run([sys.executable, "-c", code], env=environment(), capture_output=True, text=True, timeout=60)
    assert done.stdout == "stopped\n", done.stderr

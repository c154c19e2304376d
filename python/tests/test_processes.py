"""Threads, forks and the environment."""

import sys
import threading

import numpy as np
from processes import run

import dq8


def test_importing_does_not_import_scipy():
    done = run("import sys, dq8; assert 'scipy' not in sys.modules")
    assert done.returncode == 0, done.stderr


def test_the_environment_sets_the_threads():
    done = run("import dq8; print(dq8.get_num_threads())", DQ8_NUM_THREADS="2")
    assert done.stdout.strip() == "2"
    done = run("import dq8", DQ8_NUM_THREADS="many")
    assert "DQ8_NUM_THREADS" in done.stderr
    assert done.returncode != 0


def test_a_forked_child_computes():
    code = """
import os, numpy as np, dq8
dq8.set_num_threads(2)
a = dq8.identity(50_000)
dq8.mul(a, a)
child = os.fork()
if child == 0:
    assert dq8.get_num_threads() == 1
    dq8.mul(a, a)
    dq8.set_num_threads(2)
    dq8.mul(a, a)
    os._exit(0)
assert os.waitpid(child, 0)[1] == 0
"""
    done = run(code)
    assert done.returncode == 0, done.stderr


def test_other_threads_run_meanwhile(random_motions):
    a = random_motions(300_000)
    out, counts = np.empty_like(a), []
    done = threading.Event()

    def compute():
        for _ in range(20):
            dq8.sclerp(a, a[0], 0.5, out=out)
        done.set()

    computing = threading.Thread(target=compute)
    switch = sys.getswitchinterval()
    # So rarely does the interpreter switch of itself that only a released lock lets others run.
    sys.setswitchinterval(100)
    try:
        computing.start()
        while not done.is_set():
            counts.append(1)
            done.wait(0.0005)
    finally:
        sys.setswitchinterval(switch)
        computing.join()
    assert len(counts) >= 20


def test_an_array_is_not_read_while_another_thread_writes_it(random_motions):
    a = random_motions(300_000)
    failures, wrong = [], []
    done = threading.Event()
    expected = dq8.conjugate(a)

    def write():
        for _ in range(20):
            try:
                dq8.conjugate(a, out=a)
                dq8.conjugate(a, out=a)
            except ValueError as error:
                failures.append(error)
        done.set()

    writing = threading.Thread(target=write)
    before = a.copy()
    writing.start()
    while not done.is_set():
        try:
            result = dq8.conjugate(a)
        except ValueError as error:
            failures.append(error)
        else:
            wrong.append(not (np.array_equal(result, expected) or np.array_equal(result, before)))
    writing.join()
    assert not any(wrong)

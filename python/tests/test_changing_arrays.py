"""Arrays that change during a call: each in a process of its own, which must not end by a signal."""

import pytest
from processes import run

# Every call, with arguments at the beginning of memory that goes on: what is beyond must be neither read nor written.
BEGIN = """
import threading, time
import numpy as np
import dq8
from calls import CALLS, arguments_of

BEYOND = 12345.0

def within(array):
    memory = np.full(4 * array.size + 64, BEYOND)
    memory[: array.size] = array.ravel()
    return memory, memory[: array.size].reshape(array.shape)

def each_call():
    for name, (function, _) in CALLS.items():
        yield name, function, arguments_of(name, np.random.default_rng(1))
"""


def ends(code: str) -> None:
    done = run(BEGIN + code)
    assert done.returncode == 0, f"{done.returncode}\n{done.stdout}\n{done.stderr}"


@pytest.mark.parametrize("dtype", ["f4", "i1"])
@pytest.mark.parametrize("when", ["flags", "dtype", "shape", "swapaxes", "__getitem__", "__array_finalize__", "__array_function__"])
def test_an_out_that_changes_its_dtype_is_not_written_beyond_its_end(dtype, when):
    ends(f"""
class Out(np.ndarray):
    armed = False
    def change(self):
        if Out.armed and type(self) is Out:
            np.ndarray.dtype.__set__(self, np.dtype({dtype!r}))

if {when!r} in ("flags", "dtype", "shape"):
    def get(self):
        self.change()
        return getattr(np.ndarray, {when!r}).__get__(self)
    setattr(Out, {when!r}, property(get))
else:
    def method(self, *arguments, **options):
        self.change()
        inherited = getattr(super(Out, self), {when!r}, None)
        return inherited and inherited(*arguments, **options)
    setattr(Out, {when!r}, method)

for name, function, arguments in each_call():
    expected = function(*arguments)
    memory, room = within(np.zeros(expected.shape))
    out = np.ndarray.__new__(Out, expected.shape, np.float64, memory)
    Out.armed = True
    try:
        function(*arguments, out=out)
    except (TypeError, ValueError):
        pass
    Out.armed = False
    assert (memory[room.size:] == BEYOND).all(), name
    if (room != 0).any():
        np.testing.assert_array_equal(room, expected, name)
""")


CHANGES = {
    "dtype": "array.dtype = 'f4'",
    "bytes": "array.dtype = 'i1'",
    "resize": "array.resize((0,), refcheck=False)",
    "state": "array.__setstate__((1, (1,), np.dtype('f8'), False, bytes(8)))",
    "shape": "array.shape = (array.size,)",
    "read-only": "array.flags.writeable = False",
}


@pytest.mark.parametrize("owns", [True, False], ids=["own memory", "part of memory"])
@pytest.mark.parametrize("change", CHANGES)
def test_an_argument_that_changes_the_others_has_nothing_read_beyond_their_end(change, owns):
    ends(f"""
class At:
    def __init__(self, value, others):
        self.value, self.others = value, others
    def __array__(self, dtype=None, copy=None):
        for array in self.others:
            try:
                {CHANGES[change]}
            except (ValueError, AttributeError):
                pass
        return self.value

for name, function, arguments in each_call():
    for changing in range(len(arguments)):
        given = [a.copy() if {owns} else within(a)[1] for a in arguments]
        out = np.zeros(function(*arguments).shape)
        others = [array for index, array in enumerate(given) if index != changing] + [out]
        given[changing] = At(given[changing], others)
        try:
            result = np.asarray(function(*given, out=out))
        except (TypeError, ValueError):
            continue
        assert not (np.abs(result.ravel().astype(float)) == BEYOND).any(), name
""")


@pytest.mark.parametrize("call", ["dq8.log(a)", "dq8.log(b, out=out)", "dq8.mean(a, tolerance=-1.0, max_iterations=4)"])
@pytest.mark.parametrize(
    "change",
    [
        "array.dtype = 'f4'; time.sleep(0.002); array.dtype = 'f8'",
        "array.dtype = 'i8'; time.sleep(0.002); array.dtype = 'f8'",
        "array.resize(0, refcheck=False); time.sleep(0.002); array.resize(shape, refcheck=False)",
        "array.shape = (-1,); time.sleep(0.002); array.shape = shape",
    ],
    ids=["dtype", "same size", "resize", "shape"],
)
def test_a_thread_that_changes_an_array_ends_no_process(change, call):
    ends(f"""
a = np.tile(dq8.identity(), (100_000, 1)).copy()
b, out = a.copy(), np.zeros((100_000, 6))
array = out if "out" in {call!r} else a
shape, end = array.shape, time.monotonic() + 1.5

def change():
    while time.monotonic() < end:
        try:
            {change}
        except ValueError:
            pass
        time.sleep(0.001)

changing = threading.Thread(target=change)
changing.start()
while time.monotonic() < end:
    try:
        {call}
    except (TypeError, ValueError):
        time.sleep(0)
changing.join()
""")

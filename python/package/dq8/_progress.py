"""How much of a long call is done."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterator

from . import _core


@contextlib.contextmanager
def progress(callback: Callable[[float], object]) -> Iterator[None]:
    """Tell `callback` how much of each call in the main thread is done: a pure number from 0 to 1, about twenty times a second.

    Calls of less than a twentieth of a second do not tell. What the callback raises ends the call. Each call, and each loop of a
    call that takes several, begins at 0 again. A block within another tells its own callback alone;
    where no exception ends the block, the callback is told 1 at last.

    Examples
    --------
    >>> import dq8
    >>> with dq8.progress(lambda part: print(f"{part:.0%}")):
    ...     moved = dq8.mul(dq8.identity(100), dq8.identity())
    100%

    A bar of tqdm::

        with tqdm.tqdm(total=100) as bar, dq8.progress(lambda part: bar.update(round(100 * part) - bar.n)):
            arm.reach(targets, values, "tool")
    """
    before = _core.tell_progress(callback)
    try:
        yield
    finally:
        _core.tell_progress(before)
    callback(1.0)


def tell(part: float) -> None:
    """Tells the callback that `progress` has set which part of a loop in Python is done."""
    callback = _core.tell_progress(None)
    _core.tell_progress(callback)
    if callback is not None:
        callback(part)

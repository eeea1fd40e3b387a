"""A torch data set of live streams. Importing this module needs torch."""
from __future__ import annotations

import itertools
import os
from collections.abc import Callable, Iterable, Iterator
from functools import partial
from typing import Any

from torch.utils.data import IterableDataset, get_worker_info

from saccade.client import connect
from saccade.events import Events
from saccade.protocol.session import Address
from saccade.settings import Settings
from saccade.windowing import windows


def as_tensors(events: Events, settings: Settings) -> Any:
    """The columns as tensors: Events.to_torch()."""
    return events.to_torch()


class StreamDataset(IterableDataset):  # type: ignore[misc]  # torch may be absent where types are checked
    """Opens a stream for each request, one after the other, and gives its windows as samples.

    With workers, each has its own connection, and takes every n-th request: give as many requests in parallel as the
    server has CPUs to spare. A stream is closed when its windows are used up, and when the iterator is.

    requests: the settings of the streams, such as a list, or an object whose __iter__() samples them, without end if it
        likes. Each worker iterates over all of it, so it must give every worker the same.
    transform: makes a sample of a window and the settings of its stream, from which a label may come.
    duration_us, count: the windows, see saccade.windows(); without them a sample is a packet of up to 5 ms.
    address, secret_key, server_key: as for saccade.connect(), perhaps several servers; keys as files.
    Iteration raises what connect(), open() and streams raise.
    """

    def __init__(self, requests: Iterable[Settings], *, transform: Callable[[Events, Settings], Any] = as_tensors,
                 duration_us: int | None = None, count: int | None = None, address: Address | None = None,
                 secret_key: str | os.PathLike[str] | None = None,
                 server_key: str | os.PathLike[str] | None = None) -> None:
        super().__init__()
        self._requests, self._transform = requests, transform
        self._duration_us, self._count = duration_us, count
        self._connect = partial(connect, address, secret_key=secret_key, server_key=server_key)

    def __iter__(self) -> Iterator[Any]:
        worker = get_worker_info()
        first, step = (worker.id, worker.num_workers) if worker else (0, 1)
        with self._connect() as client:
            for settings in itertools.islice(self._requests, first, None, step):
                with client.open(**settings) as stream:
                    for events in self._cut(stream):
                        yield self._transform(events, settings)

    def _cut(self, stream: Iterable[Events]) -> Iterable[Events]:
        if self._duration_us is None and self._count is None:
            return stream
        return windows(stream, duration_us=self._duration_us, count=self._count)

"""Torch data sets: of live streams, and of a data set on disk. Importing this module needs torch."""
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
from saccade.stored.dataset import Dataset
from saccade.stored.order import Order
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


class StoredDataset(IterableDataset):  # type: ignore[misc]
    """The items of a saccade.Dataset in an order. Of a DataLoader's workers each takes a part of it, one behind the other.

    So a file is opened by one worker, while with sampler=order every worker opens it. Call order.set_epoch() before
    each pass. state_dict() is that of a worker, for loaders that ask each one, such as torchdata's StatefulDataLoader.
    """

    def __init__(self, data: Dataset, order: Order) -> None:
        super().__init__()
        self._data, self._order = data, order
        self._part, self._state = order, dict[str, Any]()

    def __len__(self) -> int:
        return len(self._order)

    def __iter__(self) -> Iterator[Any]:
        worker = get_worker_info()
        self._part = self._order.part(worker.id, worker.num_workers) if worker else self._order
        if self._state:
            self._part.load_state_dict(self._state)
            self._state = {}
        return map(self._data.__getitem__, self._part)

    def state_dict(self) -> dict[str, Any]:
        """What load_state_dict() takes, in the same worker of as many, to go on behind the last item."""
        return self._part.state_dict()

    def load_state_dict(self, state: dict[str, Any]) -> None:
        """The next pass goes on there. Then, it raises ValueError for a state of another data set or worker."""
        self._state = state

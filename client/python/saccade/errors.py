"""The exceptions of the package. All of them are SaccadeError.

Each can be made of its text alone. Libraries that carry exceptions from process to process, such as torch, need that.
"""
from __future__ import annotations

from saccade.printable import printable
from saccade.v1 import control_pb2


class SaccadeError(Exception):
    """Base of all exceptions of this package. Their texts have no control characters."""

    def __init__(self, text: str = "") -> None:
        super().__init__(printable(text))


class NoAnswer(SaccadeError, TimeoutError):
    """The server did not answer in time. `endpoint` is the address that was asked."""

    def __init__(self, text: str, endpoint: str = "") -> None:
        super().__init__(text)
        self.endpoint = endpoint


class Refused(SaccadeError):
    """The server refused a request.

    code: name of the status in control.proto, such as "CODE_NOT_FOUND"; "CODE_99" of one that is not there.
    field: path of the faulty field, such as "sensors[1].threshold"; empty if no field is at fault.
    message: the fault, and the values that are valid.
    limit: name of the exceeded limit of the server; empty if none.
    retry_after_s: seconds after which to try again; 0 if this would not help.
    """

    def __init__(self, text: str, *, code: str = "", field: str = "", message: str = "", limit: str = "",
                 retry_after_s: float = 0.0) -> None:
        super().__init__(text)
        self.code, self.field, self.message = code, field, message
        self.limit, self.retry_after_s = limit, retry_after_s


class InvalidArgument(Refused, ValueError):
    """The request cannot work; `field` names the fault."""


class NotFound(Refused, LookupError):
    """The server has no such scene, trajectory or stream."""


class Unavailable(Refused):
    """The scene cannot be opened there, a table is missing, or the server is stopping."""


class PermissionDenied(Refused, PermissionError):
    """The token is not that of the stream."""


class LimitExceeded(Refused):
    """The request exceeds a limit of the server: see `limit` and `retry_after_s`."""


class Unimplemented(Refused, NotImplementedError):
    """The server does not know the call, or the version of the protocol."""


_BY_CODE = {
    control_pb2.CODE_INVALID_ARGUMENT: InvalidArgument,
    control_pb2.CODE_NOT_FOUND: NotFound,
    control_pb2.CODE_UNAVAILABLE: Unavailable,
    control_pb2.CODE_PERMISSION_DENIED: PermissionDenied,
    control_pb2.CODE_RESOURCE_EXHAUSTED: LimitExceeded,
    control_pb2.CODE_UNIMPLEMENTED: Unimplemented,
}


def refusal(status: control_pb2.Status) -> Refused:
    """The exception for the status of a refused request."""
    text = status.message or f"refused with status {status.code}, without a reason"
    if status.field:
        text = f"{status.field}: {text}"
    hint = f" (try again in {status.retry_after_s:g} s)" if status.retry_after_s > 0 else ""
    return _BY_CODE.get(status.code, Refused)(text + hint, code=_name_of(status.code), field=status.field,
                                              message=status.message, limit=status.limit,
                                              retry_after_s=status.retry_after_s)


def _name_of(code: int) -> str:
    names: dict[int, str] = {number: name for name, number in control_pb2.Code.items()}
    return names.get(code, f"CODE_{code}")


class StreamFault(SaccadeError):
    """The stream cannot go on."""


class PacketFault(StreamFault):
    """A packet fails its checks and must not be used."""


class StreamRefused(StreamFault):
    """The server sent an error on the data socket.

    names_stream: False if only this connection is at fault, and the stream itself may be sound.
    """

    def __init__(self, text: str, names_stream: bool = True) -> None:
        super().__init__(text)
        self.names_stream = names_stream


class FormatError(SaccadeError, ValueError):
    """A file does not hold events in the format that its extension names."""

"""Streams of simulated events as numpy arrays, from a server `saccaded`, and readers of files of events.

    import saccade

    with saccade.connect() as client:
        with client.open(scene="cornell-box", motion="right", size=(160, 120), duration_s=0.1) as stream:
            for events in stream:
                print(events.t0, len(events), events.p.sum())
"""
from saccade.camera import Camera
from saccade.client import Client, Stream, connect
from saccade.errors import (FormatError, InvalidArgument, LimitExceeded, NoAnswer, NotFound, PacketFault,
                            PermissionDenied, Refused, SaccadeError, StreamFault, StreamRefused, Unavailable,
                            Unimplemented)
from saccade.events import Events, concatenate
from saccade.protocol.columns import Snapshot
from saccade.protocol.retry import RetryPolicy
from saccade.protocol.sequence import Losses
from saccade.protocol.stream_state import Picture
from saccade.readers import open_file, read
from saccade.readers.calibration import read_calibration
from saccade.readers.truth import read_id_names, read_truth
from saccade.recording import Recording
from saccade.settings import SensorSettings, Settings
from saccade.stored.dataset import Dataset, Window
from saccade.stored.order import Order
from saccade.stored.sequence import Sequence
from saccade.truth import IdNames, Truth, TruthArrays
from saccade.windowing import windows

__version__ = "0.1.0"

__all__ = [
    "Camera", "Client", "Dataset", "Events", "FormatError", "IdNames", "InvalidArgument", "LimitExceeded", "Losses",
    "NoAnswer", "NotFound", "Order", "PacketFault", "PermissionDenied", "Picture", "Recording", "Refused",
    "RetryPolicy", "SaccadeError", "SensorSettings", "Sequence", "Settings", "Snapshot", "Stream", "StreamFault",
    "StreamRefused", "Truth", "TruthArrays", "Unavailable", "Unimplemented", "Window", "concatenate", "connect",
    "open_file", "read", "read_calibration", "read_id_names", "read_truth", "windows",
]

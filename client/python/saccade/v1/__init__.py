"""The messages of the protocol: control_pb2, events_pb2 and those they import, made from proto/saccade/v1 when the package is built."""

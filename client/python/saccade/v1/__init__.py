"""The messages of the protocol: control_pb2 and events_pb2, made from proto/saccade/v1 when the package is built."""

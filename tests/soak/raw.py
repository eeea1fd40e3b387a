"""ZMTP 3.0 without keys, by hand [rfc.zeromq.org/spec/23]: for peers that do what libzmq would not."""
import socket, struct

GREETING = b"\xff" + b"\0" * 8 + b"\x7f\x03\0NULL" + b"\0" * 48


def connect(endpoint):
    host, port = endpoint.split("//")[1].rsplit(":", 1)
    return socket.create_connection((host, int(port)), timeout=3)


def property_(name, value):
    return bytes([len(name)]) + name + struct.pack(">I", len(value)) + value


def frame(flags, body):
    return (bytes([flags, len(body)]) if len(body) < 256 else bytes([flags | 2]) + struct.pack(">Q", len(body))) + body


def part(body, more):
    return frame(int(more), body)


def ready(properties=b"", kind=b"DEALER"):
    return frame(4, b"\x05READY" + property_(b"Socket-Type", kind) + properties)


def shake_hands(endpoint, kind=b"DEALER", properties=b""):
    end = connect(endpoint)
    end.sendall(GREETING)
    end.recv(64, socket.MSG_WAITALL)  # libzmq refuses who says more before it has said as much
    end.sendall(ready(properties, kind))
    return end

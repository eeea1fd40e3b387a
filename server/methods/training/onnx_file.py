"""Writes the network as an ONNX file, https://github.com/onnx/onnx/blob/main/onnx/onnx.proto. Numbers of fields are
of that file. The messages are few, so that no library is needed."""
import numpy as np

from network import FEATURES, GUIDES, PLANES, SPACINGS, TAPS

FLOAT, INT64 = 1, 7                 # TensorProto.DataType
INT, INTS = 2, 7                    # AttributeProto.AttributeType
IR_VERSION, OPERATORS = 7, 13


def varint(n):
    out = b""
    while n > 127:
        out, n = out + bytes([n & 127 | 128]), n >> 7
    return out + bytes([n])


def field(number, value):
    """A field of a message: a whole number >= 0, a text, or bytes of a message."""
    if isinstance(value, int):
        return varint(number << 3) + varint(value)
    data = value.encode() if isinstance(value, str) else value
    return varint(number << 3 | 2) + varint(len(data)) + data


def tensor(name, values):
    kind = INT64 if values.dtype == np.int64 else FLOAT
    return b"".join(field(1, d) for d in values.shape) + field(2, kind) + field(8, name) + field(9, values.tobytes())


def attribute(name, value):
    if isinstance(value, int):
        return field(1, name) + field(3, value) + field(20, INT)
    return field(1, name) + b"".join(field(8, v) for v in value) + field(20, INTS)


def picture(name, channels):
    """ValueInfoProto of a tensor (1, channels, height, width)."""
    sizes = [field(1, 1), field(1, channels), field(2, "height"), field(2, "width")]
    shape = b"".join(field(1, size) for size in sizes)
    return field(1, name) + field(2, field(1, field(1, FLOAT) + field(2, shape)))


class Graph:
    def __init__(self):
        self.nodes, self.tensors, self.count = [], [], 0

    def constant(self, values):
        self.count += 1
        self.tensors.append(tensor(f"c{self.count}", np.ascontiguousarray(values)))
        return f"c{self.count}"

    def ints(self, *values):
        return self.constant(np.array(values, np.int64))

    def add(self, operator, *inputs, output=None, **attributes):
        self.count += 1
        output = output or f"t{self.count}"
        node = b"".join(field(1, name) for name in inputs) + field(2, output) + field(4, operator)
        self.nodes.append(node + b"".join(field(5, attribute(k, v)) for k, v in attributes.items()))
        return output

    def channels(self, name, first, end):
        return self.add("Slice", name, self.ints(first), self.ints(end), self.ints(1))

    def conv(self, name, w, b):
        pad = w.shape[-1] // 2
        return self.add("Conv", name, self.constant(w), self.constant(b), pads=[pad] * 4)

    def taps(self, name, channels, spacing):
        """(channels, 9, height, width): each channel as the nine taps see it, and 0 outside."""
        one_hot = np.zeros((channels, len(TAPS), 1, 3, 3), np.float32)
        for number, (y, x) in enumerate(TAPS):
            one_hot[:, number, 0, y + 1, x + 1] = 1
        moved = self.add("Conv", name, self.constant(one_hot.reshape(-1, 1, 3, 3)), group=channels,
                         dilations=[spacing] * 2, pads=[spacing] * 4)
        return self.add("Reshape", moved, self.ints(channels, len(TAPS), 0, 0))

    def affinity(self, light, features, inside, spacing):
        """network.affinity()."""
        q = self.taps(features, FEATURES + 1, spacing)
        f = self.add("Reshape", self.channels(features, 0, FEATURES), self.ints(FEATURES, 1, 0, 0))
        apart = self.add("Sub", f, self.add("Slice", q, self.ints(0), self.ints(FEATURES), self.ints(0)))
        distance = self.add("ReduceSum", self.add("Mul", apart, apart), self.ints(0), keepdims=1)
        c = self.add("Slice", q, self.ints(FEATURES), self.ints(FEATURES + 1), self.ints(0))
        w = self.add("Mul", self.add("Exp", self.add("Sub", c, distance)), self.taps(inside, 1, spacing))
        total = self.add("ReduceSum", self.add("Mul", w, self.taps(light, 1, spacing)), self.ints(1), keepdims=1)
        return self.add("Div", total, self.add("ReduceSum", w, self.ints(1), keepdims=1))

    def model(self):
        graph = b"".join(field(1, node) for node in self.nodes) + field(2, "saccade")
        graph += b"".join(field(5, values) for values in self.tensors)
        graph += field(11, picture("planes", PLANES)) + field(12, picture("light", 1))
        return field(1, IR_VERSION) + field(2, "saccade") + field(7, graph) + field(8, field(2, OPERATORS))


def model(p):
    """The bytes of an .onnx file that computes network.denoise() of one picture."""
    graph = Graph()
    light, inside = graph.channels("planes", 0, 1), graph.channels("planes", 1, 2)
    a = graph.channels("planes", 1, 1 + GUIDES)
    a = graph.add("Relu", graph.conv(a, p["w1"], p["b1"]))
    a = graph.add("Relu", graph.conv(a, p["w2"], p["b2"]))
    features = graph.conv(a, p["w3"], p["b3"])
    for level, spacing in enumerate(SPACINGS):
        part = graph.channels(features, level * (FEATURES + 1), (level + 1) * (FEATURES + 1))
        light = graph.affinity(light, part, inside, spacing)
    graph.add("Identity", light, output="light")
    return graph.model()

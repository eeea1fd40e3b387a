"""Clients that stay for a moment, each with manners of its own. They return what they have received."""
import random, time

from saccade.v1 import control_pb2 as c
from stream_client import CREDIT, Refused, Stream, Tally


def request(delivery, seed, duration_s=0.2, scene="cornell-box", **timing):
    return c.OpenStream(scene=scene, trajectory=dict(name="right"), view=dict(width=48, height=32), seed=seed,
                        timing=dict(frame_rate_hz=200, duration_s=duration_s, **timing), delivery=delivery,
                        sensors=[dict(threshold=0.1), dict(threshold=0.3)], codec=random.choice([1, 2]))


def polite(link, seed):
    stream = Stream(link, request(c.DELIVERY_LOSSLESS, seed, scene=random.choice(["cornell-box", "textured-cornell-box"])))
    stream.give(CREDIT)
    stream.receive_until(lambda: False)
    stream.close()
    return stream.tally


def vanishing(link, seed):
    stream = Stream(link, request(c.DELIVERY_LOSSLESS, seed, duration_s=0))
    stream.give(CREDIT)
    stream.receive_until(lambda: stream.tally.packets >= 5)
    stream.vanish()
    return stream.tally


def never_attached(link, seed):
    link.call(zmq_context(), open_stream=request(c.DELIVERY_LIVE, seed))
    return Tally()


def miserly(link, seed):
    """Takes a live stream whose packets have been dropped meanwhile."""
    stream = Stream(link, request(c.DELIVERY_LIVE, seed, duration_s=1, clock=c.CLOCK_PACED))
    stream.give(1)
    stream.receive_until(lambda: stream.tally.packets >= 1)
    while stream.info().frames_done < 100: time.sleep(0.1)
    stream.give(CREDIT)
    stream.receive_until(lambda: False)
    stream.close()
    return stream.tally


def listener(link, seed):
    stream = Stream(link, request(c.DELIVERY_BROADCAST, seed, duration_s=1, clock=c.CLOCK_PACED))
    stream.receive_until(lambda: False)
    stream.close()
    return stream.tally


def wrong(link, seed):
    """Asks for what there is not, attaches where it may not, and sends nonsense."""
    bad = request(c.DELIVERY_LIVE, seed)
    bad.sensors[0].threshold = -1
    try:
        link.call(zmq_context(), open_stream=bad)
        raise AssertionError("a threshold of -1 was accepted")
    except Refused:
        pass
    stream = Stream(link, request(c.DELIVERY_LIVE, seed))
    stream.say(attach=dict(stream_id=stream.opened.stream_id, token="0" * 32))
    stream.socket.send(b"\xff nonsense")
    try:
        for _ in range(3): stream.receive()
    except Refused:
        pass
    stream.close()
    return Tally()


def zmq_context():
    import zmq
    return zmq.Context.instance()


KINDS = [polite, vanishing, never_attached, miserly, listener, wrong]

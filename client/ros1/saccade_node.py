#!/usr/bin/env python3
"""A node of ROS 1 that publishes a stream of saccaded as dvs_msgs/EventArray, and its camera as CameraInfo:

    python3 saccade_node.py _scene:=cornell-box _motion:=right
"""
import os
import struct
import sys
import warnings

import genpy.dynamic
import numpy as np
import rospy
import saccade
from sensor_msgs.msg import CameraInfo

import stream_source
from stream_source import NS_PER_S, NS_PER_US

# The package dvs_msgs need not be installed: its type is made from its definition.
DEFINITION = f"""\
Header header
uint32 height
uint32 width
Event[] events
{"=" * 80}
MSG: std_msgs/Header
uint32 seq
time stamp
string frame_id
{"=" * 80}
MSG: dvs_msgs/Event
uint16 x
uint16 y
time ts
bool polarity
"""
TYPE = "dvs_msgs/EventArray"
EVENT = np.dtype([("x", "<u2"), ("y", "<u2"), ("sec", "<u4"), ("nsec", "<u4"), ("polarity", "u1")])  # 13 bytes


class EventArray(genpy.dynamic.generate_dynamic(TYPE, DEFINITION)[TYPE]):
    """The message with its events as an array of EVENT: an object for each event would be slow."""

    packed = np.empty(0, EVENT)

    def serialize(self, buff):
        super().serialize(buff)  # ends with the number of events, which is 0
        buff.seek(-4, os.SEEK_CUR)
        buff.write(struct.pack("<I", self.packed.size))
        buff.write(self.packed.tobytes())


def pack(events, begin_ns):
    times = begin_ns + events.t * NS_PER_US
    packed = np.empty(len(events), EVENT)
    packed["x"], packed["y"], packed["polarity"] = events.x, events.y, events.p
    packed["sec"], packed["nsec"] = times // NS_PER_S, times % NS_PER_S
    return packed


def event_array(events, begin_ns, frame_id):
    message = EventArray()
    message.width, message.height = events.size
    message.packed = pack(events, begin_ns)
    message.header.stamp = rospy.Time(*map(int, message.packed[-1][["sec", "nsec"]]))  # as bags of `saccade` have it
    message.header.frame_id = frame_id
    return message


def camera_info(stream, frame_id):
    info = CameraInfo(distortion_model="plumb_bob", D=[0.0] * 5, K=stream_source.intrinsics(stream))
    info.width, info.height = stream.size
    info.R = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]
    info.P = stream_source.projection(info.K)
    info.header.frame_id = frame_id
    return info


def publisher(topic, message_class, latch=False):
    """One without a queue: it waits for slow subscribers, while a queue would drop messages in silence."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", SyntaxWarning)  # rospy asks for a queue
        return rospy.Publisher(topic, message_class, latch=latch)


def run():
    parameters = {name: rospy.get_param("~" + name, default) for name, default in stream_source.PARAMETERS.items()}
    array_publisher = publisher("dvs/events", EventArray)
    info_publisher = publisher("dvs/camera_info", CameraInfo, latch=True)
    if parameters["wait_for_subscriber"]:
        stream_source.wait_for_subscriber(array_publisher.get_num_connections, rospy.is_shutdown)
    with stream_source.open_stream(parameters) as stream:
        info_publisher.publish(camera_info(stream, parameters["frame_id"]))
        losses = stream_source.LossWatch(stream, rospy.logwarn)
        begin_ns = 0 if parameters["stream_time"] else rospy.Time.now().to_nsec()
        for events in stream:
            if rospy.is_shutdown():
                return
            losses.check()
            if len(events):
                array_publisher.publish(event_array(events, begin_ns, parameters["frame_id"]))


def main():
    rospy.init_node("saccade")
    try:
        run()
    except saccade.SaccadeError as fault:
        rospy.logfatal(str(fault))
        sys.exit(1)


if __name__ == "__main__":
    main()

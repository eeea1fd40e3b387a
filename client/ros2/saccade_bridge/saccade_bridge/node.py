"""A node of ROS 2 that publishes a stream of saccaded as event_camera_msgs/EventPacket, and its camera as CameraInfo.

    ros2 run saccade_bridge node --ros-args -p scene:=cornell-box -p motion:=right
"""
import array
import sys

import rclpy
import saccade
from event_camera_msgs.msg import EventPacket
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from sensor_msgs.msg import CameraInfo

from saccade_bridge import evt3, stream_source
from saccade_bridge.stream_source import NS_PER_S, NS_PER_US

QUEUE = 1000  # messages, of up to 5 ms each; EventPacket.seq shows what a slow subscriber has lost


class Bridge(Node):
    """Topics ~/events and ~/camera_info. The name of the node is event_camera, as drivers of cameras have it."""

    def __init__(self):
        super().__init__("event_camera")
        for name, default in stream_source.PARAMETERS.items():
            self.declare_parameter(name, default)
        self.parameters = {name: self.get_parameter(name).value for name in stream_source.PARAMETERS}
        self.packets = self.create_publisher(EventPacket, "~/events", QUEUE)
        self.infos = self.create_publisher(CameraInfo, "~/camera_info", QUEUE)
        self.seq = 0

    def run(self):
        """Returns at the end of the stream, or when ROS shuts down."""
        if self.parameters["wait_for_subscriber"]:
            stream_source.wait_for_subscriber(self.packets.get_subscription_count, self.stopped)
        with stream_source.open_stream(self.parameters) as stream:
            losses = stream_source.LossWatch(stream, self.get_logger().warning)
            begin_ns = 0 if self.parameters["stream_time"] else self.get_clock().now().nanoseconds
            for events in stream:
                if self.stopped():
                    return
                losses.check()
                self.publish(events, stream, begin_ns)

    def stopped(self):
        """Also answers other nodes that ask for parameters."""
        if rclpy.ok():
            rclpy.spin_once(self, timeout_sec=0)
        return not rclpy.ok()

    def publish(self, events, stream, begin_ns):
        """Publishes empty packets too: they tell the time, which wraps every 16.8 s."""
        first_us = int(events.t[0]) if len(events) else events.t0
        packet = EventPacket(encoding="evt3", seq=self.seq)
        packet.width, packet.height = stream.size
        packet.events = array.array("B", evt3.encode(events))
        info = camera_info(stream)
        for message in (packet, info):
            message.header.frame_id = self.parameters["frame_id"]
            message.header.stamp.sec, message.header.stamp.nanosec = divmod(begin_ns + first_us * NS_PER_US, NS_PER_S)
        self.seq += 1
        self.packets.publish(packet)
        self.infos.publish(info)


def camera_info(stream):
    matrix = stream_source.intrinsics(stream)
    info = CameraInfo(distortion_model="plumb_bob", d=[0.0] * 5, k=matrix)
    info.width, info.height = stream.size
    info.r = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]
    info.p = stream_source.projection(matrix)
    return info


def main():
    rclpy.init()
    bridge = Bridge()
    try:
        bridge.run()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    except saccade.SaccadeError as fault:
        bridge.get_logger().fatal(str(fault))
        sys.exit(1)
    finally:
        bridge.destroy_node()
        rclpy.try_shutdown()

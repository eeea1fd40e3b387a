"""A closed loop of the size of CartPole: a cart is pushed about, and its camera has to stay below a lamp.

    python3 closed_loop.py [STEPS]

The camera looks straight up. The controller knows only its events. Each step sends one pose, and gets the events of
one frame. The server is that of $SACCADE_SERVER, or the one on this machine.
"""
from __future__ import annotations

import random
import sys
import time

import numpy as np

import saccade

WIDTH, HEIGHT, FOV_DEG, RATE_HZ = 64, 48, 40.0, 100
LAMP_X, LAMP_Z, FLOOR, HEIGHT_OF_LAMP = 2.78, 2.8, 1.0, 4.48  # scene units
UP = (-np.sqrt(0.5), 0.0, 0.0, np.sqrt(0.5))  # quaternion of a camera that looks along +y
UNITS_PER_PIXEL = HEIGHT_OF_LAMP * np.tan(np.radians(FOV_DEG / 2)) / (WIDTH / 2)
HALF_LAMP = 0.65 / UNITS_PER_PIXEL  # pixels from its middle to its left and right edges
ENOUGH = 10  # events; fewer are noise


class Cart:
    """Moves along x, without friction."""

    def __init__(self) -> None:
        self.x, self.speed, self._rng = 0.3, 0.0, random.Random(1)

    def move(self, push: float) -> tuple[float, ...]:
        """Takes a push of the controller and one of the world, and gives the camera's pose a frame later."""
        self.speed += (push + self._rng.gauss(0, 4)) / RATE_HZ
        self.x += self.speed / RATE_HZ
        return (LAMP_X + self.x, FLOOR, LAMP_Z, *UP)


class Controller:
    """The left and the right edge of the lamp make the events. Without motion there is nothing to see."""

    def __init__(self) -> None:
        self._x, self._speed = 0.0, 0.0

    def push(self, events: saccade.Events) -> float:
        if len(events) >= ENOUGH:
            from_middle = events.x - (WIDTH / 2 - 0.5 - self._x / UNITS_PER_PIXEL)  # of the lamp, as it was before
            moved = -np.median(from_middle - np.sign(from_middle) * HALF_LAMP) * UNITS_PER_PIXEL
            self._speed += 0.3 * (moved * RATE_HZ - self._speed)
            self._x += moved
        else:
            self._speed = 0.0
        return -40 * self._x - 8 * self._speed


def main() -> None:
    steps = int((sys.argv[1:] or ["300"])[0])
    cart, controller, push = Cart(), Controller(), 0.0
    latency, distance = [], []
    with saccade.connect() as client:
        with client.open(scene="cornell-box", motion="still", clock="lockstep", size=(WIDTH, HEIGHT), fov_x_deg=FOV_DEG,
                         rate_hz=RATE_HZ, threshold=0.5) as stream:
            stream.step(cart.move(0.0))  # from the scene's own view to the lamp
            for _ in range(steps):
                pose = cart.move(push)
                began = time.perf_counter()
                (events,) = stream.step(pose)
                latency.append((time.perf_counter() - began) * 1e3)
                push = controller.push(events)
                distance.append(abs(cart.x))
            cpu = stream.info().frame_cpu_ms
    mean, late, frame = np.mean(latency), np.percentile(latency, 99), 1e3 / RATE_HZ
    print(f"{steps} steps; {np.mean(distance[steps // 3:]):.3f} scene units from the lamp, at most {max(distance):.3f}")
    print(f"from a pose to its events: mean {mean:.1f} ms, p99 {late:.1f} ms; a frame takes {cpu:.1f} ms of CPU")
    print(f"beyond the CPU time: mean {(mean - cpu) / frame:.2f}, p99 {(late - cpu) / frame:.2f} of a frame's {frame:g} ms")


if __name__ == "__main__":
    main()

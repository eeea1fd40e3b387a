"""colcon builds this package. It also needs the Python package saccade, from ../../python."""
from setuptools import setup

NAME = "saccade_bridge"

setup(
    name=NAME,
    version="0.1.0",
    description="Publishes streams of the event-camera simulator Saccade.",
    license="MIT",
    packages=[NAME],
    data_files=[("share/ament_index/resource_index/packages", [f"resource/{NAME}"]),
                (f"share/{NAME}", ["package.xml"])],
    install_requires=["setuptools", "saccade"],
    entry_points={"console_scripts": [f"node = {NAME}.node:main"]},
)

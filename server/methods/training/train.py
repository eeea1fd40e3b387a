#!/usr/bin/python3
"""Trains the network of the method `learned`, and writes it as an ONNX file. ../RIVALS.md tells how to make the data.

Each folder has dumps of `saccade-eval frames`: truth, of a reference, and noisy*, of `pt` with --features.
It needs python3-numpy and python3-openimageio.
"""
import argparse
import pathlib

import dumps
import learning
import onnx_file


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", type=pathlib.Path)
    parser.add_argument("-o", "--output", required=True, help="file.onnx")
    parser.add_argument("--steps", type=int, default=5000)
    parser.add_argument("--batch", type=int, default=2, help="crops of 64x64 pixels per step")
    parser.add_argument("--seed", type=int, default=0)
    options = parser.parse_args()
    data = [frame for folder in options.folders for frame in dumps.frames(folder)]
    if not data:
        parser.error("no truth/Iprev_*.exr with noisy* is in these folders")
    p = learning.train(data, options.steps, options.batch, options.seed)
    pathlib.Path(options.output).write_bytes(onnx_file.model(p))


if __name__ == "__main__":
    main()

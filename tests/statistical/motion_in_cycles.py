#!/usr/bin/python3
"""Compares a change of the picture of a moving glTF file by Saccade and by Blender's Cycles.

    tests/statistical/motion_in_cycles.py MODEL.gltf FOLDER [--build build/dev] [--size 96x72] [--spp 1024]
        [--rate 96] [--frame 24] [--block 4] [--camera X,Y,Z,TX,TY,TZ,FOV_Y_DEG] [--diffuse] [--plain] [--bounces 4]

It renders the frames before and after a change, at a frame rate, twice in Cycles. The change has the figures of
`saccade-eval compare`: the noise-free error against both pairs of pictures, and the share that arrives, of pixels and of
means over blocks. Saccade's are those of its reference, and of methods with 2 paths. FOLDER/change.png
shows all, red where it grows bright. With --plain no surface has a texture: Cycles has no MIP maps, which blur small details. It needs the Debian packages blender, python3-numpy and python3-openimageio.
"""
import argparse
import json
import pathlib
import subprocess
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parent))  # Blender looks elsewhere
from gltf_in_cycles import copy_model, inside_blender, open_in_blender, render_in_blender, run_blender

METHODS = "irradiance_cache", "event_svgf", "svgf"


def leave_out_textures(scene):
    model = json.loads(scene.read_text())
    for material in model.get("materials", []):
        for part in material, material.get("pbrMetallicRoughness", {}):
            for key in [k for k in part if k.endswith("Texture")]:
                del part[key]
    scene.write_text(json.dumps(model))


def let_all_move_but_the_camera():
    """Blender plays the first animation of a file alone."""
    import bpy

    for item in bpy.data.objects:
        for track in item.animation_data.nla_tracks if item.animation_data else []:
            track.mute = False
    camera = bpy.context.scene.camera
    bpy.context.scene.frame_set(0)
    place = camera.matrix_world.copy()
    camera.animation_data_clear()
    camera.matrix_world = place


def render_change(scene, folder, frame, rate, width, height, spp, bounces, diffuse):
    open_in_blender(scene, (width, height), spp, bounces, diffuse)
    let_all_move_but_the_camera()
    for half in 0, 1:
        for at in 0, 1:
            render_in_blender(f"{folder}/cycles_{half}_{at}.exr", (frame - 1 + at) / rate, seed=half)


def luminance(path):
    import OpenImageIO

    pixels = OpenImageIO.ImageBuf(str(path)).get_pixels()
    return pixels[:, :, :3] @ [0.2126, 0.7152, 0.0722] if pixels.shape[2] >= 3 else pixels[:, :, 0]


def block_means(image, side):
    h, w = (n // side * side for n in image.shape)
    return image[:h, :w].reshape(h // side, side, w // side, side).mean((1, 3))


def figures(x, a, b):
    """The noise-free error of a change, and the share of the true one that arrives."""
    truth = (a * b).mean()
    return max(0, ((x - a) * (x - b)).mean() / truth) ** 0.5, (x * (a + b)).mean() / 2 / truth


def draw(changes, path):
    import numpy
    import OpenImageIO

    row = numpy.concatenate(changes, axis=1)
    s = numpy.clip(row / numpy.quantile(abs(row), 0.99), -1, 1)
    colors = numpy.stack([(1 + s) / 2, (1 - abs(s)) / 2, (1 - s) / 2], axis=2).repeat(3, 0).repeat(3, 1)
    picture = OpenImageIO.ImageBuf(OpenImageIO.ImageSpec(colors.shape[1], colors.shape[0], 3, "uint8"))
    picture.set_pixels(OpenImageIO.ROI(), numpy.ascontiguousarray(colors, dtype=numpy.float32))
    picture.write(str(path))


def change_of(evaluate, scene, folder, a, first, *options):
    """What `saccade-eval frames` writes of the last frame, from frame `first` on."""
    subprocess.run([evaluate, "frames", scene, "--motion", "still", "--jitter", "--rate", str(a.rate), "--bounces", str(a.bounces),
                    "--size", "x".join(map(str, a.size)), "--frames", f"{first}:{a.frame}", "--dump", folder, *options],
                   check=True, stdout=subprocess.DEVNULL)
    return luminance(folder / f"dI_{a.frame:05}.exr")


def main():
    if arguments := inside_blender():
        scene, folder, frame, rate, *numbers = arguments
        return render_change(scene, folder, int(frame), float(rate), *map(int, numbers))
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("model", type=pathlib.Path)
    p.add_argument("folder", type=pathlib.Path)
    p.add_argument("--build", type=pathlib.Path, default="build/dev")
    p.add_argument("--size", type=lambda s: [int(n) for n in s.split("x")], default=[96, 72])
    p.add_argument("--spp", type=int, default=1024)
    p.add_argument("--rate", type=float, default=96.0)
    p.add_argument("--frame", type=int, default=24)
    p.add_argument("--bounces", type=int, default=4)
    p.add_argument("--block", type=int, default=4)
    p.add_argument("--camera", type=lambda s: [float(n) for n in s.split(",")])
    p.add_argument("--diffuse", action="store_true")
    p.add_argument("--plain", action="store_true")
    a = p.parse_args()
    scene = copy_model(a.model, a.folder / "scene", a.size, a.camera, a.diffuse)
    if a.plain:
        leave_out_textures(scene)
    run_blender(__file__, scene.resolve(), a.folder.resolve(), a.frame, a.rate, *a.size, a.spp, a.bounces, int(a.diffuse))
    cycles = [luminance(a.folder / f"cycles_{half}_1.exr") - luminance(a.folder / f"cycles_{half}_0.exr") for half in (0, 1)]
    evaluate = a.build / "bin/saccade-eval"
    ours = {"reference": change_of(evaluate, scene, a.folder / "reference", a, a.frame, "--reference", str(a.spp))}
    for method in METHODS:
        ours[method] = change_of(evaluate, scene, a.folder / method, a, 1, "--method", method)
    print(f"{'':18}error, share of pixels    of {a.block}x{a.block} blocks")
    for name, change in ours.items():
        of_blocks = figures(*(block_means(image, a.block) for image in (change, *cycles)))
        print("{:18}{:.3f} {:.3f}               {:.3f} {:.3f}".format(name, *figures(change, *cycles), *of_blocks))
    draw([(cycles[0] + cycles[1]) / 2, *ours.values()], a.folder / "change.png")


if __name__ == "__main__":
    main()

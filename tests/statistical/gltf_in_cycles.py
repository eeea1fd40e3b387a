#!/usr/bin/env python3
"""Compares pictures of a glTF file by Saccade and by Blender's Cycles, as means over blocks.

    tests/statistical/gltf_in_cycles.py MODEL.gltf FOLDER [--build build/dev] [--size 320x240] [--spp 256] [--bounces 4]
        [--camera X,Y,Z,TX,TY,TZ,FOV_Y_DEG] [--blocks 16] [--diffuse]

It writes FOLDER/scene (a copy, with the camera), FOLDER/cycles.exr and FOLDER/ours.exr, and prints what
`saccade-eval compare-renders` says. With --diffuse no surface has an interface, which both programs couple to its
base in ways of their own. A file without light stands under an even sky of radiance 1 in both programs, which the
copy names. It needs the Debian package blender.
"""
import argparse
import json
import math
import pathlib
import shutil
import subprocess
import sys


def camera_node(numbers):
    """A glTF camera at a point that looks at another, with y up."""
    eye, target, fov = numbers[:3], numbers[3:6], numbers[6]
    back = [e - t for e, t in zip(eye, target)]
    unit = lambda v: [x / math.sqrt(sum(y * y for y in v)) for x in v]
    cross = lambda a, b: [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    z = unit(back)
    x = unit(cross([0, 1, 0], z))
    matrix = [*x, 0, *cross(z, x), 0, *z, 0, *eye, 1]
    return matrix, math.radians(fov)


def is_lit(scene):
    return "KHR_lights_punctual" in scene.get("extensionsUsed", []) or any(
        max(material.get("emissiveFactor", [0])) > 0 for material in scene.get("materials", []))


def set_even_sky(scene):
    scene["scenes"][scene.get("scene", 0)].setdefault("extensions", {})["SACCADE_sky"] = {"radiance": [1, 1, 1]}
    scene.setdefault("extensionsUsed", []).append("SACCADE_sky")


def copy_model(model, folder, size, camera, diffuse):
    shutil.copytree(model.parent, folder, copy_function=shutil.copyfile, dirs_exist_ok=True)
    scene = json.loads(model.read_text())
    for material in scene.get("materials", []) if diffuse else []:
        material.setdefault("extensions", {})["KHR_materials_specular"] = {"specularFactor": 0}
    if camera:
        matrix, yfov = camera_node(camera)
        cameras, nodes = scene.setdefault("cameras", []), scene["nodes"]
        cameras.append({"type": "perspective",
                        "perspective": {"yfov": yfov, "znear": 0.01, "aspectRatio": size[0] / size[1]}})
        nodes.append({"camera": len(cameras) - 1, "matrix": matrix, "name": "from here"})
        scene["scenes"][scene.get("scene", 0)]["nodes"].append(len(nodes) - 1)
    if not is_lit(scene):
        set_even_sky(scene)
    path = folder / "scene.gltf"
    path.write_text(json.dumps(scene))
    return path


def leave_out_interfaces():
    """Blender 3.4 does not read a factor of 0."""
    import bpy

    for material in bpy.data.materials:
        for node in material.node_tree.nodes if material.use_nodes else []:
            if node.type == "BSDF_PRINCIPLED":
                node.inputs["Specular"].default_value = 0


def open_in_blender(scene, size, spp, bounces, diffuse):
    """Leaves Blender ready to render a glTF file."""
    import bpy
    import numpy

    numpy.bool = bool  # Blender 3.4 of Debian 12 takes NumPy's former name
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=scene)
    if diffuse:
        leave_out_interfaces()
    it = bpy.context.scene
    it.camera = next(o for o in bpy.data.objects if o.type == "CAMERA")
    lit = any(o.type == "LIGHT" for o in bpy.data.objects) or any(
        n.inputs["Emission Strength"].default_value > 0
        and (n.inputs["Emission"].is_linked or max(n.inputs["Emission"].default_value[:3]) > 0)
        for m in bpy.data.materials if m.use_nodes for n in m.node_tree.nodes if n.type == "BSDF_PRINCIPLED")
    it.world = bpy.data.worlds.new("sky")
    it.world.use_nodes = True
    it.world.node_tree.nodes["Background"].inputs["Color"].default_value = (0, 0, 0, 1) if lit else (1, 1, 1, 1)
    prepare_cycles(size, spp, bounces)


def prepare_cycles(size, spp, bounces):
    """Sets paths without tricks, that are spread evenly over each pixel."""
    import bpy

    it = bpy.context.scene
    it.render.engine = "CYCLES"
    cycles = it.cycles
    cycles.samples, cycles.use_denoising, cycles.use_adaptive_sampling = spp, False, False
    cycles.pixel_filter_type = "BOX"
    cycles.max_bounces = cycles.diffuse_bounces = cycles.glossy_bounces = bounces
    cycles.sample_clamp_indirect = cycles.sample_clamp_direct = cycles.blur_glossy = 0
    it.render.resolution_x, it.render.resolution_y, it.render.resolution_percentage = *size, 100
    it.view_settings.view_transform = "Standard"
    it.render.image_settings.file_format, it.render.image_settings.color_depth = "OPEN_EXR", "32"


def render_in_blender(picture, seconds, seed=0):
    import bpy

    it = bpy.context.scene
    frame = seconds * it.render.fps
    it.frame_set(int(frame), subframe=frame - int(frame))
    it.cycles.seed, it.render.filepath = seed, picture
    bpy.ops.render.render(write_still=True)


def run_blender(script, *arguments):
    subprocess.run(["blender", "-b", "--factory-startup", "-noaudio", "--python-exit-code", "1", "--python", script, "--",
                    "--inside", *map(str, arguments)], check=True, stdout=subprocess.DEVNULL)


def inside_blender():
    """The arguments of run_blender() there, and None elsewhere."""
    return sys.argv[sys.argv.index("--inside") + 1:] if "--inside" in sys.argv else None


def main():
    if arguments := inside_blender():
        scene, picture, *numbers = arguments
        width, height, spp, bounces, diffuse = map(int, numbers)
        open_in_blender(scene, (width, height), spp, bounces, diffuse)
        return render_in_blender(picture, 0)
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("model", type=pathlib.Path)
    p.add_argument("folder", type=pathlib.Path)
    p.add_argument("--build", type=pathlib.Path, default="build/dev")
    p.add_argument("--size", type=lambda s: [int(n) for n in s.split("x")], default=[320, 240])
    p.add_argument("--spp", default="256")
    p.add_argument("--bounces", default="4")
    p.add_argument("--blocks", default="16")
    p.add_argument("--camera", type=lambda s: [float(n) for n in s.split(",")])
    p.add_argument("--diffuse", action="store_true")
    a = p.parse_args()
    scene = copy_model(a.model, a.folder / "scene", a.size, a.camera, a.diffuse)
    theirs, ours = a.folder / "cycles.exr", a.folder / "ours.exr"
    run_blender(__file__, scene.resolve(), theirs.resolve(), *a.size, a.spp, a.bounces, int(a.diffuse))
    evaluate = a.build / "bin/saccade-eval"
    subprocess.run([evaluate, "render", scene, "--size", "x".join(map(str, a.size)), "--spp", a.spp, "--bounces", a.bounces,
                    "-o", ours], check=True)
    subprocess.run([evaluate, "compare-renders", ours, theirs, "--blocks", a.blocks], check=True)


if __name__ == "__main__":
    main()

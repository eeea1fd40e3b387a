"""The add-on of Blender: a scene that it exports looks and moves in Saccade as in Blender's Cycles.

The two programs share no code: the poses are compared with Blender's own matrices, and pictures at the first frame
and at a quarter of a frame with those of Cycles, as means over blocks.
"""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

EXPORT = pathlib.Path(__file__).resolve().parents[2] / "client/blender/saccade_export.py"
FPS, FRAME, PART = 24, 7, 0.25  # the scene begins at frame 1
SECONDS = (FRAME - 1 + PART) / FPS
SIZE, BLOCKS = (96, 72), (12, 9)


# ---- Inside Blender


def material(name, color):
    import bpy

    made = bpy.data.materials.new(name)
    made.use_nodes = True
    inputs = made.node_tree.nodes["Principled BSDF"].inputs
    inputs["Base Color"].default_value = (*color, 1)
    inputs["Roughness"].default_value = 0.5  # where the diffuse part of Blender 3 is nearest to a Lambertian one
    inputs["Specular IOR Level" if "Specular IOR Level" in inputs else "Specular"].default_value = 0
    return made


def add(name, data, **values):
    import bpy

    item = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(item)
    for key, value in values.items():
        setattr(item, key, value)
    return item


def animate(item, path, values):
    """Bezier curves from frame 1 to 13."""
    for frame, value in zip((1, 5, 13), values):
        setattr(item, path, value)
        item.keyframe_insert(path, frame=frame)


def shape(name, faces, corners, color, **values):
    import bpy

    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(corners, [], faces)
    mesh.materials.append(material(name, color))
    return add(name, mesh, **values)


def build():
    """A cube on a turning parent, a camera that follows it, and lamps that move and turn, all along Bezier curves."""
    import bpy

    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.fps, scene.frame_start, scene.frame_end = FPS, 1, 13
    shape("floor", [(0, 1, 2, 3)], [(-4, -4, 0), (4, -4, 0), (4, 4, 0), (-4, 4, 0)], (0.6, 0.6, 0.5))
    arm = add("arm", None, scale=(1.2, 0.8, 1))
    animate(arm, "rotation_euler", [(0, 0, 0), (0, 0, 0.9), (0, 0, 1.4)])
    corners = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    cube = shape("the cube", faces, corners, (0.7, 0.2, 0.1), parent=arm)
    animate(cube, "location", [(0, 0, 0.1), (0.3, 0.2, 0.8), (0.9, 0, 0.3)])
    eye = add("Eye", bpy.data.cameras.new("Eye"))
    animate(eye, "location", [(5, -6, 4), (6, -3, 3.5), (6, 1, 4)])
    follow = eye.constraints.new("TRACK_TO")
    follow.target, follow.track_axis, follow.up_axis = cube, "TRACK_NEGATIVE_Z", "UP_Y"
    add("Another", bpy.data.cameras.new("Another"), location=(0, 0, 9))
    lamp = bpy.data.lights.new("Area", "AREA")
    lamp.shape, lamp.size, lamp.size_y, lamp.energy, lamp.color = "RECTANGLE", 1, 2, 300, (1, 0.9, 0.7)
    animate(add("Area", lamp, scale=(1.5, 1, 1)), "location", [(-1, 0, 4), (0, 1, 4), (-2, 2, 4.5)])
    torch = bpy.data.lights.new("Torch", "SPOT")
    torch.energy, torch.color, torch.shadow_soft_size, torch.spot_blend, torch.spot_size = 400, (0.6, 0.8, 1), 0, 0, 1
    turning = add("Torch", torch, location=(2, -3, 4))
    animate(turning, "rotation_euler", [(0.8, 0, 0.3), (0.6, 0.2, 0.5), (0.9, 0, 0.2)])
    scene.camera = eye
    scene.world = bpy.data.worlds.new("World")
    scene.world.use_nodes = True
    background = scene.world.node_tree.nodes["Background"].inputs
    background["Color"].default_value = (0.3, 0.4, 0.6, 1)
    background["Strength"].default_value = 0.5
    return eye, cube


def take_picture(folder):
    """A world with a picture that is turned: a gradient, and a bright spot."""
    import bpy

    width, height = 64, 32
    image = bpy.data.images.new("sky", width, height, float_buffer=True)
    image.pixels = [0.2 + 0.02 * x * (c == 0) + 0.05 * y * (c == 1) + 8 * (abs(x - 20) < 4 and abs(y - 22) < 4)
                    for y in range(height) for x in range(width) for c in range(4)]
    image.file_format, image.filepath_raw = "OPEN_EXR", f"{folder}/sky source.exr"
    image.save()
    tree = bpy.context.scene.world.node_tree
    kinds = "TexEnvironment", "Mapping", "TexCoord"
    texture, mapping, place = (tree.nodes.new("ShaderNode" + kind) for kind in kinds)
    texture.image = bpy.data.images.load(image.filepath_raw)
    mapping.inputs["Rotation"].default_value = 0.3, -0.2, 0.8
    tree.links.new(place.outputs["Generated"], mapping.inputs["Vector"])
    tree.links.new(mapping.outputs["Vector"], texture.inputs["Vector"])
    tree.links.new(texture.outputs["Color"], tree.nodes["Background"].inputs["Color"])


def render(path):
    import bpy

    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    cycles = scene.cycles
    cycles.samples, cycles.use_denoising, cycles.use_adaptive_sampling = 256, False, False
    cycles.pixel_filter_type = "BOX"
    cycles.max_bounces = cycles.diffuse_bounces = 4
    cycles.sample_clamp_indirect = cycles.sample_clamp_direct = 0
    scene.render.threads_mode, scene.render.threads = "FIXED", 2
    scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = *SIZE, 100
    scene.view_settings.view_transform = "Standard"
    scene.render.image_settings.file_format, scene.render.image_settings.color_depth = "OPEN_EXR", "32"
    scene.render.filepath = path
    bpy.ops.render.render(write_still=True)


def truth(eye, cube):
    """The camera's centre and its axes right, down and forward, and the corners of the cube; y is up."""
    y_up = lambda v: [v.x, v.z, -v.y]
    axes = eye.matrix_world.to_3x3().normalized()
    return {"eye": y_up(eye.matrix_world.translation),
            "axes": [y_up(axes.col[0]), y_up(-axes.col[1]), y_up(-axes.col[2])],
            "corners": [y_up(cube.matrix_world @ v.co) for v in cube.data.vertices]}


def make(folder):
    """The scene, pictures of it, and where its parts are."""
    import bpy
    import numpy

    numpy.bool = bool  # Blender 3.4 of Debian 12 takes NumPy's former name
    eye, cube = build()
    found = {}
    for name, frame, part in (("first", 1, 0), ("later", FRAME, PART), ("next", FRAME, 2 * PART)):
        bpy.context.scene.frame_set(frame, subframe=part)
        found[name] = truth(eye, cube)
        render(f"{folder}/{name}.exr")
    pathlib.Path(folder, "truth.json").write_text(json.dumps(found))
    bpy.ops.wm.save_as_mainfile(filepath=f"{folder}/cube.blend")
    take_picture(folder)
    bpy.context.scene.frame_set(1)
    render(f"{folder}/picture.exr")
    bpy.ops.wm.save_as_mainfile(filepath=f"{folder}/picture.blend")


def blocks(path):
    """Mean luminance of blocks."""
    import bpy
    import numpy

    image = bpy.data.images.load(path)
    width, height = image.size
    picture = numpy.array(image.pixels).reshape(height, width, 4)
    grey = picture[..., :3] @ [0.2126, 0.7152, 0.0722]
    across, down = BLOCKS
    return grey.reshape(down, height // down, across, width // across).mean((1, 3))


def compare(ours, theirs):
    ratio = blocks(ours) / blocks(theirs)
    print("RATIO", json.dumps({"mean": ratio.mean(), "close": (abs(ratio - 1) < 0.05).mean()}))


def compare_change(ours, before, after):
    change, theirs = blocks(ours), blocks(after) - blocks(before)
    print("CHANGE", json.dumps({"error": ((change - theirs) ** 2).mean() ** 0.5 / (theirs ** 2).mean() ** 0.5,
                                "share": (change * theirs).mean() / (theirs ** 2).mean()}))


def export_twice(folder):
    """Which objects there are after exports from inside, and at which frame. There is a lamp with a radius besides."""
    import bpy

    bulb = bpy.data.lights.new("Bulb", "POINT")
    bulb.shadow_soft_size = 0.1
    add("Bulb", bulb)

    sys.path.insert(0, str(EXPORT.parent))
    import saccade_export

    saccade_export.register()
    bpy.context.scene.frame_set(3, subframe=0.5)
    for _ in range(2):
        bpy.ops.export_scene.saccade(filepath=folder, samples_per_frame=8)
    kinds = bpy.data.objects, bpy.data.meshes, bpy.data.materials
    left = sorted(block.name for kind in kinds for block in kind)
    print("LEFT", json.dumps([left, bpy.context.scene.frame_current_final]))


# ---- Outside


def blender(*arguments):
    done = subprocess.run(["blender", "-b", "-noaudio", "--factory-startup", "--python-exit-code", "1", *arguments],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=300)
    assert done.returncode == 0, done.stdout
    return done.stdout


def inside(step, *arguments, scene=()):
    return blender(*scene, "--python", __file__, "--", "--inside", step, *map(str, arguments))


def answer(printed, word):
    return json.loads(next(line for line in printed.splitlines() if line.startswith(word)).removeprefix(word))


def turned(q, v):
    """v turned by the quaternion x, y, z, w."""
    x, y, z, w = q
    cross = lambda a, b: [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    t = [2 * c for c in cross([x, y, z], v)]
    return [a + w * b + c for a, b, c in zip(v, t, cross([x, y, z], t))]


def poses(path):
    """Position and quaternion by time."""
    lines = path.read_text().splitlines()[1:]
    rows = [[float(number) for number in line.split(",")] for line in lines]
    return {round(row[0], 6): (row[1:4], row[4:]) for row in rows}


class Export(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.kept = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.kept.name)
        inside("make", cls.folder)
        cls.truth = json.loads((cls.folder / "truth.json").read_text())
        cls.scene = cls.folder / "scenes/cube"
        told = blender(cls.folder / "cube.blend", "--python", EXPORT, "--", cls.scene)
        assert "Warning" not in told, told

    @classmethod
    def tearDownClass(cls):
        cls.kept.cleanup()

    def assert_near(self, found, wanted, most):
        self.assertLess(max(abs(a - b) for a, b in zip(found, wanted, strict=True)), most, (found, wanted))

    def evaluate(self, *arguments):
        return subprocess.run([EVALUATE, *map(str, arguments)], check=True, stdout=subprocess.PIPE, text=True).stdout

    def test_the_camera_is_where_blender_has_it(self):
        place, turn = poses(self.scene / "trajectories/Eye.csv")[round(SECONDS, 6)]
        self.assert_near(place, self.truth["later"]["eye"], 1e-5)
        for axis, wanted in zip(([1, 0, 0], [0, 1, 0], [0, 0, 1]), self.truth["later"]["axes"], strict=True):
            self.assert_near(turned(turn, axis), wanted, 1e-5)

    def test_a_camera_that_stands_has_no_file(self):
        self.assertEqual([path.name for path in (self.scene / "trajectories").iterdir()], ["Eye.csv"])

    # The parent is scaled before it turns, so that the cube keeps its form.
    def test_bodies_are_where_blender_has_them(self):
        path = poses(next((self.scene / "poses").glob("*the cube.csv")))
        centre, still = path[0]
        self.assert_near(still, [0, 0, 0, 1], 1e-6)
        corners = self.truth["first"]["corners"]
        self.assert_near(centre, [(min(c) + max(c)) / 2 for c in zip(*corners)], 1e-5)
        place, turn = path[round(SECONDS, 6)]
        for corner, wanted in zip(corners, self.truth["later"]["corners"], strict=True):
            moved = turned(turn, [a - b for a, b in zip(corner, centre)])
            self.assert_near([a + b for a, b in zip(place, moved)], wanted, 1e-5)

    def test_lamps_turn(self):
        path = poses(next((self.scene / "poses").glob("*Torch.csv")))
        self.assert_near(path[0][0], [2, 4, 3], 1e-5)  # with y up
        self.assertGreater(abs(path[round(SECONDS, 6)][1][3] - 1), 1e-3)

    def render_as(self, scene, theirs):
        ours = self.folder / f"ours of {theirs}"
        size = "x".join(map(str, SIZE))
        self.evaluate("render", scene, "--size", size, "--spp", 256, "--bounces", 4, "-o", ours)
        self.assert_alike(ours, self.folder / theirs)

    def test_the_first_picture_is_that_of_cycles(self):
        self.render_as(self.scene, "first.exr")

    def test_a_picture_of_the_world_is_that_of_cycles(self):
        scene = self.folder / "scenes/picture"
        self.assertNotIn("Warning", blender(self.folder / "picture.blend", "--python", EXPORT, "--", scene))
        self.render_as(scene, "picture.exr")

    # At a rate of 1 / SECONDS the first frame after frame 0 is the one of Blender. Its paths start at the centres
    # of pixels, so that a larger one is needed for smooth edges.
    def test_a_later_picture_is_that_of_cycles(self):
        self.evaluate("frames", self.scene, "--trajectory", "Eye", "--size", "x".join(str(3 * n) for n in SIZE),
                      "--rate", f"{1 / SECONDS:.9f}", "--bounces", 4, "--method", "pt", "--spp", 32, "--frames", "2:2",
                      "--dump", self.folder / "dump")
        self.assert_alike(self.folder / "dump/Iprev_00002.exr", self.folder / "later.exr")

    # The camera, the cube and the lamps move. Without a change the error is 1 and the share 0.
    def test_a_change_is_that_of_cycles(self):
        rate = FPS / PART
        frame = round(SECONDS * rate) + 1
        for way in ("--reference", "512"), ("--method", "irradiance_cache"):
            self.evaluate("frames", self.scene, "--trajectory", "Eye", "--size", "x".join(map(str, SIZE)), "--rate", rate,
                          "--bounces", 4, "--jitter", *way, "--frames", f"{frame}:{frame}", "--dump", self.folder / way[0])
            ours = self.folder / way[0] / f"dI_{frame:05}.exr"
            found = answer(inside("change", ours, self.folder / "later.exr", self.folder / "next.exr"), "CHANGE")
            self.assertLess(found["error"], 0.15, (way, found))
            self.assertAlmostEqual(found["share"], 1, delta=0.08, msg=(way, found))

    def assert_alike(self, ours, theirs):
        ratio = answer(inside("compare", ours, theirs), "RATIO")
        self.assertAlmostEqual(ratio["mean"], 1, delta=0.02, msg=ratio)
        self.assertGreater(ratio["close"], 0.95, ratio)

    def test_the_file_of_blender_stays_as_it_was(self):
        told = inside("twice", self.folder / "again", scene=[self.folder / "cube.blend"])
        self.assertIn("Warning: the lamp Bulb has a radius; its shadows are hard", told)
        left, frame = answer(told, "LEFT")
        objects = ["arm", "the cube", "floor", "Eye", "Another", "Area", "Bulb", "Torch"]
        self.assertEqual(left, sorted(objects + 2 * ["the cube", "floor"]))  # and their meshes and materials
        self.assertEqual(frame, 3.5)
        self.assertEqual(len(poses(self.folder / "again/trajectories/Eye.csv")), 12 * 8 + 1)


if __name__ == "__main__":
    if "--inside" in sys.argv:
        step, *arguments = sys.argv[sys.argv.index("--inside") + 1:]
        {"make": make, "compare": compare, "change": compare_change, "twice": export_twice}[step](*arguments)
    elif not shutil.which("blender"):
        print("skipped: there is no program blender")
        sys.exit(77)
    else:
        EVALUATE = sys.argv.pop(1)
        unittest.main(verbosity=2)

"""Blender add-on: File > Export > Saccade writes a scene folder for saccaded.

    blender -b kitchen.blend --python saccade_export.py -- my-scenes/kitchen [SAMPLES_PER_FRAME]

does the same without a window. README.md beside this file says what is exported.
"""
import contextlib
import json
import math
import pathlib
import re
import shutil
import struct
import sys

import bpy
import numpy
from bpy_extras.io_utils import ExportHelper
from mathutils import Euler, Matrix

bl_info = {
    "name": "Export to Saccade",
    "author": "The Saccade authors",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "File > Export > Saccade",
    "description": "Writes a scene folder for the event-camera simulator Saccade",
    "category": "Import-Export",
}

TO_Y_UP = Matrix(((1, 0, 0, 0), (0, 0, 1, 0), (0, -1, 0, 0), (0, 0, 0, 1)))  # as Blender's exporter turns the world
CAMERA_AXES = Matrix.Diagonal((1, -1, -1, 1))  # from x right, y up, z backward to x right, y down, z forward
SKY_AXES = Matrix.Rotation(math.pi / 2, 4, "Y")  # from directions of SACCADE_sky to those of Blender's, with y up
SHAPES = {"MESH", "CURVE", "SURFACE", "FONT", "META"}
DEFORMERS = {"ARMATURE", "CLOTH", "LATTICE", "SOFT_BODY", "SURFACE_DEFORM", "MESH_DEFORM", "MESH_CACHE",
             "MESH_SEQUENCE_CACHE", "OCEAN", "FLUID", "EXPLODE", "WAVE"}
MOST_MOVERS = 64  # that the server reads
STANDS = 1e-6  # the largest change of a matrix of what stands
RIGID = 1e-3  # how far the axes of a rotation may be from unit length
DISK_CORNERS = 32


# ---- Motion


class Track:
    """The world matrices of an object over time, with y up. Only the ends of a stand are kept."""

    def __init__(self, item):
        self.item = item
        self.keys = []  # (seconds, matrix)

    def add(self, time, matrix):
        if len(self.keys) > 1 and matrix == self.keys[-1][1] == self.keys[-2][1]:
            self.keys.pop()
        self.keys.append((time, matrix))

    def moves(self):
        """Whether it can be seen. A point shines alike however it turns, and a sun wherever it is."""
        kind = self.item.data.type if self.item.type == "LIGHT" else None
        columns = {"POINT": slice(3, 4), "SUN": slice(0, 3)}.get(kind, slice(0, 4))
        matrices = [numpy.array(matrix)[:3, columns] for _, matrix in self.keys]
        return any(abs(matrix - matrices[0]).max() > STANDS for matrix in matrices)


def sample(context, items, samples_per_frame):
    """Tracks of objects from the scene's first frame to its last. Leaves the scene at the first."""
    scene = context.scene
    step = scene.render.fps_base / scene.render.fps / samples_per_frame
    tracks = [Track(item) for item in items]
    for i in range((scene.frame_end - scene.frame_start) * samples_per_frame + 1):
        frame, part = divmod(i, samples_per_frame)
        scene.frame_set(scene.frame_start + frame, subframe=part / samples_per_frame)
        graph = context.evaluated_depsgraph_get()
        for track in tracks:
            track.add(i * step, TO_Y_UP @ track.item.evaluated_get(graph).matrix_world)
    scene.frame_set(scene.frame_start)
    return tracks


def write_poses(path, poses):
    """A file of (seconds, matrix of a rotation and a translation)."""
    path.parent.mkdir(exist_ok=True)
    lines = ["t_s,x,y,z,qx,qy,qz,qw"]
    for time, matrix in poses:
        place, turn, _ = matrix.decompose()
        lines.append(",".join(f"{number:.9g}" for number in (time, *place, turn.x, turn.y, turn.z, turn.w)))
    path.write_text("\n".join(lines) + "\n")


def file_name(name):
    return re.sub(r"[/\\\x00-\x1f]", "_", name) + ".csv"


def write_cameras(folder, tracks, tell):
    for track in tracks:
        name = track.item.name
        path = folder / "trajectories" / file_name(name)
        path.unlink(missing_ok=True)  # of an earlier export
        if not track.moves():
            continue
        write_poses(path, [(time, matrix @ CAMERA_AXES) for time, matrix in track.keys])
        if path.stem != name:
            tell(f"the trajectory of the camera {name} is named {path.stem}")


def surface_points(context, item):
    """The corners of an object's faces, in its own axes. Of a lamp without a face the place where it is."""
    if item.type == "LIGHT":
        return numpy.array(lamp_corners(item.data) if item.data.type == "AREA" else [(0, 0, 0)])
    evaluated = item.evaluated_get(context.evaluated_depsgraph_get())
    mesh = evaluated.to_mesh()
    corners = numpy.empty(len(mesh.loops), numpy.int32)
    mesh.loops.foreach_get("vertex_index", corners)
    points = numpy.empty(3 * len(mesh.vertices), numpy.float32)
    mesh.vertices.foreach_get("co", points)
    evaluated.to_mesh_clear()
    return points.reshape(-1, 3)[numpy.unique(corners)]


def box_centre(context, track):
    """The centre of the box around an object, with the axes of the world."""
    matrix = numpy.array(track.keys[0][1], numpy.float64)
    placed = surface_points(context, track.item) @ matrix[:3, :3].T + matrix[:3, 3]
    return (placed.min(0) + placed.max(0)) / 2


def body_poses(context, track, tell):
    """Where its centre goes, and how it has turned about it. Empty where it has no size at first."""
    first = numpy.array(track.keys[0][1], numpy.float64)
    if abs(numpy.linalg.det(first)) < 1e-12:
        tell(f"{track.item.name} has no size at the first frame; it stands")
        return []
    centre = box_centre(context, track)
    poses, rigid = [], True
    for time, matrix in track.keys:
        moved = numpy.array(matrix, numpy.float64) @ numpy.linalg.inv(first)
        axes = moved[:3, :3]
        rigid = rigid and abs(axes.T @ axes - numpy.eye(3)).max() < 2 * RIGID
        pose = Matrix(moved.tolist())
        pose.translation = axes @ centre + moved[:3, 3]
        poses.append((time, pose))
    if not rigid:
        tell(f"the size of {track.item.name} changes; it keeps its first")
    return poses


def write_bodies(context, folder, tracks, exported, tell):
    """motion.toml and poses/ of the tracks that move and whose object the file `exported` names."""
    shutil.rmtree(folder / "poses", ignore_errors=True)
    tables = []
    for track in tracks:
        name = track.item.name
        moves = track.moves()
        if moves and track.item.type == "LIGHT" and name not in exported:
            tell(f"the lamp {name} moves, and has another name in the file; it stands where it is at the first frame")
        poses = body_poses(context, track, tell) if moves and name in exported else []
        if not poses:
            continue
        if len(tables) == MOST_MOVERS:
            tell(f"only the first {MOST_MOVERS} objects move")
            break
        path = folder / "poses" / f"{len(tables)}-{file_name(name)}"
        write_poses(path, poses)
        tables.append(f"[{json.dumps(name, ensure_ascii=False)}]\n"
                      f"poses = {json.dumps('poses/' + path.name, ensure_ascii=False)}\n")
    (folder / "motion.toml").unlink(missing_ok=True)
    if tables:
        (folder / "motion.toml").write_text("\n".join(tables), encoding="utf-8")


# ---- Light


def background_of(world):
    """The shader of a world that is nothing but a background."""
    output = world.node_tree.get_output_node("CYCLES")
    links = output.inputs["Surface"].links if output else ()
    shader = links[0].from_node if links else None
    return shader if shader and shader.type == "BACKGROUND" and not shader.inputs["Strength"].is_linked else None


def save_picture(image, folder):
    """A copy of the file of a picture, in the folder; None where it has no file."""
    suffix = pathlib.Path(image.filepath).suffix
    source = pathlib.Path(bpy.path.abspath(image.filepath, library=image.library))
    data = image.packed_file.data if image.packed_file else source.read_bytes() if source.is_file() else None
    if image.source != "FILE" or not suffix or not data:
        return None
    path = folder / f"sky{suffix}"
    path.write_bytes(data)
    return path.name


def rotation_of_sky(node):
    """How an environment texture turns its directions; None where it does more than that."""
    turn = Matrix()
    if node.inputs["Vector"].is_linked:
        mapping = node.inputs["Vector"].links[0].from_node
        if mapping.type == "MAPPING":
            values = {key: mapping.inputs[key] for key in ("Location", "Rotation", "Scale") if key in mapping.inputs}
            plain = {"Location": (0, 0, 0), "Scale": (1, 1, 1)}
            if any(socket.is_linked or key in plain and tuple(socket.default_value) != plain[key]
                   for key, socket in values.items()):
                return None
            turn = Euler(values["Rotation"].default_value).to_matrix().to_4x4()
            if mapping.vector_type == "TEXTURE":
                turn.transpose()
            link = mapping.inputs["Vector"].links
        else:
            link = node.inputs["Vector"].links
        if not link or link[0].from_socket.name != "Generated":
            return None
    return (TO_Y_UP @ turn.inverted() @ TO_Y_UP.inverted() @ SKY_AXES).to_quaternion()


def picture_of_sky(socket, folder):
    """What SACCADE_sky says of a picture; None where the colour is another thing."""
    node = socket.links[0].from_node
    if node.type != "TEX_ENVIRONMENT" or node.projection != "EQUIRECTANGULAR" or not node.image:
        return None
    turn = rotation_of_sky(node)
    name = save_picture(node.image, folder) if turn else None
    return {"picture": name, "rotation": [turn.x, turn.y, turn.z, turn.w]} if name else None


def sky_of(world, folder, tell):
    """SACCADE_sky of a world, a colour or a picture. None where it is black or another thing."""
    if not world or not world.use_nodes:
        return {"radiance": list(world.color)} if world and max(world.color) > 0 else None
    shader = background_of(world)
    if not shader:
        tell("the world is more than a background, and is not exported")
        return None
    strength, color = shader.inputs["Strength"].default_value, shader.inputs["Color"]
    if not color.is_linked:
        radiance = [strength * part for part in color.default_value[:3]]
        return {"radiance": radiance} if max(radiance) > 0 else None
    picture = picture_of_sky(color, folder)
    if not picture:
        tell("the world is neither a colour nor a picture from a file, and is not exported")
        return None
    return {"radiance": [strength] * 3, **picture}


def lamp_corners(lamp):
    """The outline of an area lamp, counter-clockwise as seen from -z, where it shines."""
    x = lamp.size / 2
    y = lamp.size_y / 2 if lamp.shape in {"RECTANGLE", "ELLIPSE"} else x
    if lamp.shape in {"SQUARE", "RECTANGLE"}:
        return [(-x, -y, 0), (-x, y, 0), (x, y, 0), (x, -y, 0)]
    angles = [-2 * math.pi * i / DISK_CORNERS for i in range(DISK_CORNERS)]
    return [(x * math.cos(a), y * math.sin(a), 0) for a in angles]


def lamp_power(lamp, area):
    """The power of an area lamp in its three colours. Blender 4.5 and later have more than energy and colour."""
    warmth = lamp.temperature_color if getattr(lamp, "use_temperature", False) else (1, 1, 1)
    scale = lamp.energy * 2 ** getattr(lamp, "exposure", 0) * (1 if getattr(lamp, "normalize", True) else area)
    return [scale * part * warm for part, warm in zip(lamp.color, warmth)]


def emission(name, color):
    """A black material that emits this radiance from its front."""
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    material.use_backface_culling = True
    strength = max(color)
    inputs = next(n for n in material.node_tree.nodes if n.type == "BSDF_PRINCIPLED").inputs
    for keys, value in ((("Base Color",), (0, 0, 0, 1)), (("Roughness",), 1),
                        (("Specular IOR Level", "Specular"), 0),  # of Blender 4, and 3
                        (("Emission Color", "Emission"), (*(part / strength for part in color), 1)),
                        (("Emission Strength",), strength)):
        inputs[next(key for key in keys if key in inputs)].default_value = value
    return material


@contextlib.contextmanager
def area_lamps_as_shapes(context, items):
    """While it lasts, a shape that emits stands for each area lamp, and has its name.

    Cycles spreads a quarter of the power over the area as radiance: L = P / (4 A). (A Lambertian lamp of the
    power P would have P / (pi A).)
    """
    made = []
    try:
        for item in items:
            lamp, name = item.data, item.name
            mesh = bpy.data.meshes.new(name)
            corners = lamp_corners(lamp)
            mesh.from_pydata(corners, [], [range(len(corners))])
            mesh.update()
            matrix = item.matrix_world.copy()
            area = mesh.polygons[0].area * matrix.col[0].length * matrix.col[1].length
            power = lamp_power(lamp, area)
            if max(power) <= 0 or area <= 0:
                bpy.data.meshes.remove(mesh)
                continue
            material = emission(name, [part / (4 * area) for part in power])
            mesh.materials.append(material)
            item.name = name + ".lamp"
            shape = bpy.data.objects.new(name, mesh)
            made.append((item, name, shape, mesh, material))
            context.scene.collection.objects.link(shape)
            shape.matrix_world = matrix
        context.view_layer.update()
        yield
    finally:
        for item, name, shape, mesh, material in made:
            bpy.data.objects.remove(shape)
            bpy.data.meshes.remove(mesh)
            bpy.data.materials.remove(material)
            item.name = name


# ---- The glTF file


def export_gltf(path):
    """By Blender's own exporter: the first frame, without animations."""
    options = dict(
        export_format="GLB", use_renderable=True, use_active_scene=True, export_cameras=True, export_lights=True,
        export_apply=True, export_yup=True, export_animations=False, export_current_frame=True, export_skins=False,
        export_morph=False, export_extras=False, convert_lighting_mode="SPEC",
        export_import_convert_lighting_mode="SPEC")
    known = bpy.ops.export_scene.gltf.get_rna_type().properties.keys()
    bpy.ops.export_scene.gltf(filepath=str(path), **{key: options[key] for key in options if key in known})


def put_first(gltf, name):
    """Puts the node of this name before all others: the server looks through the first camera."""
    nodes = gltf["nodes"]
    index = next((i for i, node in enumerate(nodes) if node.get("name") == name and "camera" in node), None)
    lists = [scene["nodes"] for scene in gltf["scenes"]] + [node["children"] for node in nodes if "children" in node]
    while index is not None:
        siblings = next(entries for entries in lists if index in entries)
        siblings.sort(key=lambda i: i != index)
        index = next((i for i, node in enumerate(nodes) if node.get("children") is siblings), None)


def edit_glb(path, edit):
    """Changes the JSON of a binary file [glTF 2.0, 4.4]."""
    data = path.read_bytes()
    size, = struct.unpack_from("<I", data, 12)
    gltf = json.loads(data[20:20 + size])
    edit(gltf)
    text = json.dumps(gltf, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    rest = data[20 + size:]
    path.write_bytes(struct.pack("<4sIII4s", b"glTF", 2, 20 + len(text) + len(rest), len(text), b"JSON") + text + rest)


def finish_glb(path, camera, sky):
    """Names what the file shows."""
    exported = set()

    def edit(gltf):
        if camera:
            put_first(gltf, camera.name)
        if sky:
            gltf["scenes"][gltf.get("scene", 0)].setdefault("extensions", {})["SACCADE_sky"] = sky
            gltf.setdefault("extensionsUsed", []).append("SACCADE_sky")
        exported.update(node["name"] for node in gltf["nodes"]
                        if "mesh" in node or "KHR_lights_punctual" in node.get("extensions", {}))

    edit_glb(path, edit)
    return exported


# ---- What is not exported


def is_animated(block):
    data = block.animation_data if block else None
    return bool(data and (data.action or data.drivers))


def tell_of_rest(scene, items, tracks, tell):
    for track in tracks:
        if track.item.instance_type != "NONE" and track.moves():
            tell(f"the instances of {track.item.name} move; they stand where they are at the first frame")
    for item in items:
        data = item.data
        if item.type == "LIGHT":
            if data.type in {"POINT", "SPOT"} and data.shadow_soft_size > 0:
                tell(f"the lamp {item.name} has a radius; its shadows are hard")
            if data.type == "SUN" and data.angle > 0:
                tell(f"the sun {item.name} has an angle; its shadows are hard")
            if data.type == "AREA" and data.spread < math.pi - 1e-3:
                tell(f"the spread of the lamp {item.name} is not exported")
        if item.type == "CAMERA" and (data.shift_x or data.shift_y):
            tell(f"the shift of the camera {item.name} is not exported")
        if item.type in {"LIGHT", "CAMERA"} and is_animated(data):
            tell(f"values of {item.name} change; they keep those of the first frame")
        if item.type in SHAPES and (getattr(data, "shape_keys", None) or
                                    any(modifier.type in DEFORMERS for modifier in item.modifiers)):
            tell(f"{item.name} keeps the form of the first frame")
    blocks = [material for item in items for material in (slot.material for slot in item.material_slots) if material]
    for block in {*blocks, *([scene.world] if scene.world else [])}:
        if is_animated(block) or is_animated(block.node_tree):
            tell(f"{block.name} changes; it keeps its look of the first frame")


# ---- The operator


def export(context, folder, samples_per_frame, tell):
    """Writes the scene folder. Replaces what an earlier export has written there."""
    scene, frame, part = context.scene, context.scene.frame_current, context.scene.frame_subframe
    folder.mkdir(parents=True, exist_ok=True)
    items = [item for item in context.view_layer.objects if not item.hide_render]
    try:
        movable = [i for i in items if i.type in SHAPES | {"CAMERA", "LIGHT"} or i.instance_type != "NONE"]
        tracks = sample(context, movable, samples_per_frame)
        lamps = [item for item in items if item.type == "LIGHT" and item.data.type == "AREA"]
        with area_lamps_as_shapes(context, lamps):
            export_gltf(folder / "scene.glb")
        exported = finish_glb(folder / "scene.glb", scene.camera, sky_of(scene.world, folder, tell))
        write_cameras(folder, [t for t in tracks if t.item.type == "CAMERA"], tell)
        write_bodies(context, folder, [t for t in tracks if t.item.type in SHAPES | {"LIGHT"}], exported, tell)
        tell_of_rest(scene, items, tracks, tell)
    finally:
        scene.frame_set(frame, subframe=part)


class ExportSaccade(bpy.types.Operator, ExportHelper):
    """Write a scene folder for Saccade"""

    bl_idname = "export_scene.saccade"
    bl_label = "Export to Saccade"
    filename_ext = ""
    check_extension = None

    samples_per_frame: bpy.props.IntProperty(
        name="Samples per frame", default=4, min=1, max=64,
        description="Poses of cameras and objects per frame; in between they move evenly")

    def execute(self, context):
        folder = pathlib.Path(bpy.path.abspath(self.filepath))
        export(context, folder, self.samples_per_frame, lambda text: self.report({"WARNING"}, text))
        self.report({"INFO"}, f"wrote {folder}")
        return {"FINISHED"}


def menu_entry(self, _context):
    self.layout.operator(ExportSaccade.bl_idname, text="Saccade (folder)")


def register():
    bpy.utils.register_class(ExportSaccade)
    bpy.types.TOPBAR_MT_file_export.append(menu_entry)


def unregister():
    bpy.types.TOPBAR_MT_file_export.remove(menu_entry)
    bpy.utils.unregister_class(ExportSaccade)


if __name__ == "__main__":
    register()
    arguments = sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else []
    if arguments:
        samples = {"samples_per_frame": int(arguments[1])} if len(arguments) > 1 else {}
        bpy.ops.export_scene.saccade(filepath=str(pathlib.Path(arguments[0]).resolve()), **samples)

"""Opens a scene of Mitsuba's format in Blender, and runs there: diffuse meshes of OBJ files, and lamps of one side."""
import math
import pathlib
import xml.etree.ElementTree as xml

import bpy
from mathutils import Matrix, Vector

MESHES = "/usr/share/glmark2/models"


def numbers(text):
    return [float(n) for n in text.replace(",", " ").split()]


def transform_of(shape):
    """Of a shape of Mitsuba, as a matrix of Blender."""
    matrix = Matrix()
    for step in shape.find("transform") if shape.find("transform") is not None else []:
        axes = {axis: float(step.get(axis)) for axis in "xyz" if step.get(axis)}
        vector = Vector(axes.get(axis, 0) for axis in "xyz")
        if step.tag == "rotate":
            matrix = Matrix.Rotation(math.radians(float(step.get("angle"))), 4, vector) @ matrix
        elif step.tag == "translate":
            matrix = Matrix.Translation(vector) @ matrix
        else:
            matrix = Matrix.Scale(float(step.get("value")), 4) @ matrix
    return matrix


def material_of(shape, scene):
    """A diffuse surface, or light to one side."""
    material = bpy.data.materials.new(shape.get("id"))
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    reflectance = scene.find(f"bsdf[@id='{shape.find('ref').get('id')}']//rgb").get("value")
    shown = nodes.new("ShaderNodeBsdfDiffuse")
    shown.inputs["Color"].default_value = (*numbers(reflectance), 1)
    if (radiance := shape.find("emitter/rgb")) is not None:
        light, sides = nodes.new("ShaderNodeEmission"), nodes.new("ShaderNodeMixShader")
        light.inputs["Color"].default_value = (*numbers(radiance.get("value")), 1)
        is_back = nodes.new("ShaderNodeNewGeometry").outputs["Backfacing"]
        for of_side, output in enumerate((is_back, light.outputs[0], shown.outputs[0])):
            links.new(output, sides.inputs[of_side])
        shown = sides
    links.new(shown.outputs[0], nodes.new("ShaderNodeOutputMaterial").inputs["Surface"])
    return material


def add_mesh(shape, scene, folder):
    name = shape.find("string[@name='filename']").get("value")
    path = next(f for f in (folder / name, pathlib.Path(MESHES) / name) if f.exists())
    lines = [line.split() for line in path.read_text().splitlines() if line.strip()]
    corners = [list(map(float, line[1:4])) for line in lines if line[0] == "v"]
    faces = [[int(word.split("/")[0]) - 1 for word in line[1:]] for line in lines if line[0] == "f"]
    mesh = bpy.data.meshes.new(shape.get("id"))
    mesh.from_pydata(corners, [], faces)
    mesh.materials.append(material_of(shape, scene))
    is_smooth = shape.find("boolean[@name='face_normals']") is None
    mesh.polygons.foreach_set("use_smooth", [is_smooth] * len(faces))
    item = bpy.data.objects.new(shape.get("id"), mesh)
    item.matrix_world = transform_of(shape)
    bpy.context.scene.collection.objects.link(item)


def add_camera(sensor):
    view = sensor.find("transform/lookat")
    eye, target, up = (Vector(numbers(view.get(name))) for name in ("origin", "target", "up"))
    back = (eye - target).normalized()
    right = up.cross(back).normalized()
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.data.sensor_fit = "HORIZONTAL"
    camera.data.angle = math.radians(float(sensor.find("float[@name='fov']").get("value")))
    camera.matrix_world = Matrix.Translation(eye) @ Matrix((right, back.cross(right), back)).transposed().to_4x4()
    bpy.context.scene.collection.objects.link(camera)
    bpy.context.scene.camera = camera


def open_scene(path):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = xml.parse(path).getroot()
    for shape in scene.iter("shape"):
        add_mesh(shape, scene, path.parent)
    add_camera(scene.find("sensor"))

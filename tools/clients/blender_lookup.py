"""Runs inside Blender: blender -b --factory-startup -P blender_lookup.py -- REQUEST.json ANSWER.json

Loads a latlong picture as the world and lets Cycles look at it: in single directions, all around, at a white plane, and at the
shadow of a pole under a sun lamp. Z is up, +X east, +Y north.
"""

import json
import math
import pathlib
import sys

import bpy
import numpy
from mathutils import Matrix, Vector

REQUEST, ANSWER = map(pathlib.Path, sys.argv[sys.argv.index("--") + 1:])


class Studio:
    """An empty scene with the sky and a camera, and pixels as linear floats."""

    def __init__(self, picture):
        bpy.ops.wm.read_factory_settings(use_empty=True)
        self.scene = bpy.context.scene
        render, cycles = self.scene.render, self.scene.cycles
        render.engine = "CYCLES"
        render.threads_mode, render.threads = "FIXED", 2
        render.image_settings.file_format, render.image_settings.color_depth = "OPEN_EXR", "32"
        cycles.use_adaptive_sampling = cycles.use_denoising = False
        cycles.pixel_filter_type = "BOX"
        cycles.filter_width = 0.01
        cycles.max_bounces = 0
        world = bpy.data.worlds.new("sky")
        self.scene.world = world
        world.use_nodes = True
        nodes = world.node_tree.nodes
        environment = nodes.new("ShaderNodeTexEnvironment")
        environment.image = bpy.data.images.load(str(picture))
        world.node_tree.links.new(environment.outputs["Color"], nodes["Background"].inputs["Color"])
        self.camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
        self.scene.collection.objects.link(self.camera)
        self.scene.camera = self.camera

    def pixels(self, axes, size, position=(0, 0, 0), samples=1, **lens):
        """Array [row from below][column][RGB] of a camera with axes (right, up, backwards)."""
        self.camera.matrix_world = Matrix.Translation(position) @ Matrix(axes).transposed().to_4x4()
        for name, value in lens.items():
            setattr(self.camera.data, name, value)
        self.scene.cycles.samples = samples
        render = self.scene.render
        render.resolution_x = render.resolution_y = size
        render.filepath = str(ANSWER.with_suffix(".exr"))
        bpy.ops.render.render(write_still=True)
        image = bpy.data.images.load(render.filepath)
        image.colorspace_settings.name = "Non-Color"
        array = numpy.array(image.pixels[:]).reshape(size, size, -1)[..., :3]
        bpy.data.images.remove(image)
        return array

    def add(self, name, vertices, faces, **properties):
        mesh = bpy.data.meshes.new(name)
        mesh.from_pydata(vertices, [], faces)
        white = bpy.data.materials.new(name)
        white.use_nodes = True
        nodes = white.node_tree.nodes
        nodes.clear()
        diffuse = nodes.new("ShaderNodeBsdfDiffuse")
        diffuse.inputs["Color"].default_value = (1, 1, 1, 1)
        output = nodes.new("ShaderNodeOutputMaterial")
        white.node_tree.links.new(diffuse.outputs[0], output.inputs["Surface"])
        mesh.materials.append(white)
        thing = bpy.data.objects.new(name, mesh)
        for key, value in properties.items():
            setattr(thing, key, value)
        self.scene.collection.objects.link(thing)
        return thing

    def add_sun(self, towards, rgb_lux):
        """A lamp's local +Z points to where its light comes from; its strength is the irradiance on a plane normal to it."""
        lamp = bpy.data.lights.new("sun", "SUN")
        lamp.energy = max(rgb_lux)
        lamp.color = [value / max(rgb_lux) for value in rgb_lux]
        lamp.angle = math.radians(0.533)
        sun = bpy.data.objects.new("sun", lamp)
        sun.rotation_mode = "QUATERNION"
        sun.rotation_quaternion = Vector(towards).to_track_quat("Z", "Y")
        self.scene.collection.objects.link(sun)


def axes_towards(forwards):
    """Right, up and backwards of a camera that looks there."""
    forwards = Vector(forwards)
    help_axis = Vector((0, 0, 1)) if abs(forwards.z) < 0.9 else Vector((0, 1, 0))
    right = forwards.cross(help_axis).normalized()
    return right, right.cross(forwards), -forwards


def brightest(studio, size):
    """Direction of the brightest pixel of six square views."""
    best, where = 0.0, None
    for forwards in ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)):
        axes = axes_towards(forwards)
        view = studio.pixels(axes, size, angle=math.pi / 2)
        row, column = numpy.unravel_index(view[..., 1].argmax(), view.shape[:2])
        if view[row, column, 1] > best:
            best = view[row, column, 1]
            across, upwards = 2 * (column + 0.5) / size - 1, 2 * (row + 0.5) / size - 1
            where = list(axes[0] * across + axes[1] * upwards - axes[2])
    return where


def shadow(studio, height):
    """Centre of gravity of a pole's shadow on the ground, (east, north); the camera looks down and does not see the pole."""
    studio.add("pole", [(x, y, z) for z in (0, height) for x, y in ((-.05, -.05), (.05, -.05), (.05, .05), (-.05, .05))],
               [(0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7), (4, 5, 6, 7)], visible_camera=False)
    size, span = 128, 8.0
    view = studio.pixels(((1, 0, 0), (0, 1, 0), (0, 0, 1)), size, position=(0, 0, 20), samples=64, type="ORTHO", ortho_scale=span)
    light = view[..., 1]
    missing = numpy.where(light < 0.5 * numpy.median(light), 1.0, 0.0)
    rows, columns = numpy.indices(light.shape)
    return [float((missing * ((place + 0.5) / size - 0.5)).sum() / missing.sum() * span) for place in (columns, rows)]


def main():
    request = json.loads(REQUEST.read_text(encoding="utf-8"))
    studio = Studio(request["picture"])
    answer = {"version": bpy.app.version_string}
    answer["rgb"] = [studio.pixels(axes_towards(direction), 4, angle=math.radians(0.02))[1, 1].tolist()
                     for direction in request["directions"]]
    answer["brightest"] = brightest(studio, 256)
    studio.add("ground", [(-1000, -1000, 0), (1000, -1000, 0), (1000, 1000, 0), (-1000, 1000, 0)], [(0, 1, 2, 3)])
    down = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
    above = {"position": (0, 0, 20), "samples": 256, "type": "ORTHO", "ortho_scale": 1.0}
    answer["sky_on_horizontal"] = (math.pi * studio.pixels(down, 32, **above).mean(axis=(0, 1))).tolist()
    studio.add_sun(request["sun"], request["sun_rgb_lux"])
    answer["both_on_horizontal"] = (math.pi * studio.pixels(down, 32, **above).mean(axis=(0, 1))).tolist()
    answer["shadow"] = shadow(studio, 2.0)
    ANSWER.write_text(json.dumps(answer), encoding="utf-8")


main()

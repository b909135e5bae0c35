# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Within Blender: the exports of a run in the folder at hand, read back and compared, vertex by vertex,
with the VTK files of the same frames, which it reads by itself. Exits 1 where one is off."""
import math
import os
import sys
import xml.etree.ElementTree

import bpy
import numpy

numpy.bool = bool  # Debian 12's Blender asks for a name that its numpy has no more
NEAREST_FLOAT = 1e-6  # m: glTF has differences of floats


def vtu_points(path):
    numbers = xml.etree.ElementTree.parse(path).find(".//Points/DataArray").text.split()
    return [tuple(map(float, numbers[k : k + 3])) for k in range(0, len(numbers), 3)]


def points(thing):
    seen = thing.evaluated_get(bpy.context.evaluated_depsgraph_get())
    return [tuple(seen.matrix_world @ vertex.co) for vertex in seen.to_mesh().vertices]


def compare(what, found, expected):
    if len(found) != len(expected):
        sys.exit(f"{what}: {len(found)} vertices, expected {len(expected)}")
    far = max(math.dist(a, b) for a, b in zip(found, expected))
    if not far <= NEAREST_FLOAT:
        sys.exit(f"{what}: a vertex is {far} m off")


def clear():
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)


def at(time):
    bpy.context.scene.frame_set(math.floor(time), subframe=time % 1)


def import_gltf(name):
    """The cloth of such a file, beside its two colliders."""
    clear()
    bpy.ops.import_scene.gltf(filepath=os.path.abspath(name), merge_vertices=False)
    meshes = [thing for thing in bpy.data.objects if thing.type == "MESH"]
    cloth = next(thing for thing in meshes if thing.data.shape_keys)
    if len(cloth.data.shape_keys.key_blocks) != len(frames) or len(meshes) != 3:
        sys.exit(f"{name}: expected {len(frames)} shapes of the cloth, and two colliders")
    return cloth


def read_gltf(name):
    cloth = import_gltf(name)
    animation = cloth.data.shape_keys.animation_data
    animation.action = animation.action or animation.nla_tracks[0].strips[0].action
    for time, expected in zip(animation.action.frame_range, ends):
        at(time)
        compare(name, points(cloth), expected)


frames = sorted(name for name in os.listdir("vtu") if name.endswith(".vtu"))
ends = [vtu_points(os.path.join("vtu", name)) for name in (frames[0], frames[-1])]
read_gltf("cloth.glb")
read_gltf("cloth.gltf")
print("Blender has read all back")

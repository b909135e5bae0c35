/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A run as one animated glTF 2.0 file. The cloth is a mesh with a morph target for each frame but
 * the first, whose weight is 1 at the frame's time and 0 at the others', linear in between;
 * colliders are meshes of their own, moved by their nodes. glTF's y is up: (x, y, z) of the scene
 * is (x, z, -y) there. Metres and seconds.
 */
#ifndef FABRIC_VIEW_GLTF_H
#define FABRIC_VIEW_GLTF_H

#include "scene/scene.h"
#include "view/cloth_frames.h"

/* Limits of known readers, which reject more bytes, or more morph targets than a graphics card has
 * texture layers. */
enum { GLTF_MOST_FRAMES = 2000, GLTF_MOST_MEGABYTES = 1000 };

/** Writes a temporary file and renames it to `path`; `binary`: as GLB, else as JSON with the
 *  numbers in base64. 0, or -1 after a message on standard error. */
int gltf_write(const cloth_frames *frames, const scene *of, int binary, const char *path);

#endif

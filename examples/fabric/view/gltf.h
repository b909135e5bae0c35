/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A run as one animated glTF 2.0 file. The cloth is a mesh with a morph target for each frame
 * except the first. A target's weight is 1 at its frame's time and 0 at the other frames' times,
 * linear in between. Each collider is a separate mesh, moved by its node. In glTF y is up: (x, y,
 * z) of the scene becomes (x, z, -y). Units are metres and seconds.
 */
#ifndef FABRIC_VIEW_GLTF_H
#define FABRIC_VIEW_GLTF_H

#include "scene/scene.h"
#include "view/cloth_frames.h"

/* Limits of common readers: number of morph targets, which some store in the texture layers of a
 * graphics card, and megabytes. */
enum { GLTF_MOST_FRAMES = 2000, GLTF_MOST_MEGABYTES = 1000 };

/** Writes a temporary file and renames it to `path`. If `binary`, the format is GLB, else JSON with
 *  the numbers in base64. Returns 0, or -1 after a message on standard error. */
int gltf_write(const cloth_frames *frames, const scene *of, int binary, const char *path);

#endif

/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** A run as an MP4 film, by the program ffmpeg. */
#ifndef FABRIC_VIEW_VIDEO_H
#define FABRIC_VIEW_VIDEO_H

/** Draws the frames of the run in `folder` in this size (even numbers of pixels) and has ffmpeg
 *  make a film of them that takes as long as what it shows; written to a temporary file, then
 *  renamed to `path`. No picture is kept. *count: frames. 0, or -1 after a message on standard
 *  error: ffmpeg is not there, or fails. */
int video_write(const char *folder, int width, int height, const char *path, int *count);

#endif

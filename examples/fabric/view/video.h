/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** A run as an MP4 film, by the program ffmpeg. */
#ifndef FABRIC_VIEW_VIDEO_H
#define FABRIC_VIEW_VIDEO_H

/** Draws the frames of the run in `folder` in this size (even numbers of pixels) and pipes them to
 *  ffmpeg, which makes a film in real time. It is written to a temporary file, then renamed to
 * `path`. *count: the number of frames. 0, or -1 after a message on standard error: ffmpeg is not
 * installed, or fails. */
int video_write(const char *folder, int width, int height, const char *path, int *count);

#endif

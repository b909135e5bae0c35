/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** A run as an MP4 film, by the program ffmpeg. */
#ifndef FABRIC_VIEW_VIDEO_H
#define FABRIC_VIEW_VIDEO_H

/** Draws the frames of the run in `folder` in this size (even numbers of pixels) and pipes them to
 *  ffmpeg. The film shows the run in real time. It is written to a temporary file, then renamed to
 *  `path`. *count receives the number of frames. Returns 0, or -1 after a message on standard
 *  error, for instance if ffmpeg is not installed. */
int video_write(const char *folder, int width, int height, const char *path, int *count);

#endif

/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Pictures of a run's frames, all from one camera. */
#ifndef FABRIC_VIEW_FILM_H
#define FABRIC_VIEW_FILM_H

#include "view/frames.h"
#include "view/picture.h"

typedef struct film film;

/** Ready to draw pictures of this size (even numbers of pixels) of the run in a folder, which it
 *  keeps by reference. NULL after a message on standard error. One at a time (see stage.h). */
film *film_open(const char *folder, int width, int height);
void film_close(film *f);

/** The run's frames. */
const frames *film_frames(const film *f);

/** Draws one, with its time in a corner, into p, which picture_free frees. *time: of the frame, s.
 *  0, or -1 after a message on standard error. */
int film_draw(film *f, int number, picture *p, double *time);

#endif

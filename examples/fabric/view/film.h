/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Pictures of a run's frames, all from one camera. */
#ifndef FABRIC_VIEW_FILM_H
#define FABRIC_VIEW_FILM_H

#include "view/frames.h"
#include "view/picture.h"

typedef struct film film;

/** Prepares pictures of this size (even numbers of pixels) of the run in `folder`; keeps the
 *  pointer `folder`. Returns NULL after a message on standard error. Only one film may exist at a
 *  time (see stage.h). */
film *film_open(const char *folder, int width, int height);
void film_close(film *f);

/** The run's frames. */
const frames *film_frames(const film *f);

/** Draws a frame, with its time in a corner, into p, which picture_free frees. *time receives the
 *  frame's time, s. Returns 0, or -1 after a message on standard error. */
int film_draw(film *f, int number, picture *p, double *time);

#endif

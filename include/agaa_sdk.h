/* AGAA SDK: anti-aliasing for deferred shading without history.
 * SPDX-License-Identifier: MIT
 *
 * Pure C99. Sources named below: "AGAA" is Crassin et al., Aggregate G-Buffer Anti-Aliasing, TVCG 2016.
 *
 * Conventions
 *   Errors     Every function that can fail returns an AgaaResult: 0 ok, > 0 not an error, < 0 an error.
 *              Functions that are given a context, a view or a log also tell the error through the log
 *              callback, in one sentence; others, and calls with a null handle or a log that was not initialised,
 *              return the code alone.
 *              A call that fails validation has recorded and changed nothing.
 *   Lifetime   Pointers in parameters need to live until the call returns, unless stated otherwise.
 *   Threading  Functions without a handle may be called from any thread. Calls that share a context
 *              must not overlap in time.
 *   Spaces     Shading space: the host's axes with the origin at the eye ("camera-relative world").
 *              View space: right-handed, x right, y up, looking down -z. Matrices are column-major.
 *              Colours are linear. Lengths are in the host's unit.
 */
#ifndef AGAA_SDK_H
#define AGAA_SDK_H

#include "agaa/base.h"
#include "agaa/config.h"
#include "agaa/frame.h"
#include "agaa/functions.h"
#include "agaa/query.h"
#include "agaa/statistics.h"

#endif /* AGAA_SDK_H */

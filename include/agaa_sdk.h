/* AGAA SDK: anti-aliasing for deferred shading, without temporal history unless a host asks for it.
 * SPDX-License-Identifier: MIT
 *
 * Pure C99. "AGAA" in comments is Crassin et al., Aggregate G-Buffer Anti-Aliasing, TVCG 2016.
 *
 * Conventions
 *   Results    Functions that can fail return an AgaaResult: 0 is success, > 0 is no error, < 0 is an error.
 *   Errors     If a function has a context, a view or a log, it also reports the error through the log callback, in one
 *              sentence. Functions without these, calls with a null handle, and calls with a log that is not
 *              initialised return the code only. Unless a comment says otherwise, a call that fails has recorded and
 *              changed nothing. Every function that returns an AgaaResult may return, beside the errors that its
 *              comment lists:
 *              AGAA_ERROR_OUT_OF_MEMORY      host memory could not be allocated
 *              AGAA_ERROR_INTERNAL           an error of the library itself
 *              Every function that takes a struct may also return:
 *              AGAA_ERROR_INVALID_ARGUMENT   a required pointer is null
 *              AGAA_ERROR_STRUCT             a struct is not initialised
 *              AGAA_ERROR_VERSION            a struct has data that this library does not know
 *              AGAA_ERROR_UNKNOWN_STRUCT     a chain holds an unknown struct, a struct twice, or does not end
 *              AGAA_ERROR_OUT_OF_RANGE       a member is out of its range, an enumeration or a flag has an unknown
 *                                            value, or a reserved member is not 0
 *   Lifetime   Pointers in parameters must be valid until the call returns, unless a comment says otherwise.
 *   Threads    Functions without a handle may be called from any thread at any time. Calls that share a context must
 *              not overlap in time.
 *   Spaces     Shading space has the axes of the host and its origin at the eye ("camera-relative world"). View space
 *              is right-handed: x right, y up, looking along -z. Matrices are column-major. Colours are linear. Lengths
 *              are in the unit of the host.
 */
#ifndef AGAA_SDK_H
#define AGAA_SDK_H

#include "agaa/adaptive.h"
#include "agaa/base.h"
#include "agaa/config.h"
#include "agaa/frame.h"
#include "agaa/functions.h"
#include "agaa/goal.h"
#include "agaa/outputs.h"
#include "agaa/price.h"
#include "agaa/query.h"
#include "agaa/statistics.h"
#include "agaa/temporal.h"

#endif /* AGAA_SDK_H */

/* Calls agaa.dll without a C library, so that any compiler and linker for Windows can build it. Returns 7.
 * SPDX-License-Identifier: MIT
 */
#include "agaa_gl.h"
#include "agaa_vk.h"

#ifdef __cplusplus
extern "C"
#endif
    int
    start(void);

int start(void) { return agaaGetVersion() == AGAA_HEADER_VERSION ? 7 : 1; }

/* What the minimal hosts do without a graphics API: errors, the SDK's figures and the image file.
 * SPDX-License-Identifier: MIT
 */
#ifndef HOST_H
#define HOST_H

#include "scene.h"

#include <inttypes.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Every failure ends the program with one sentence. An engine would return it. */
static void fail(const char* format, ...) {
    va_list arguments;
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    fputc('\n', stderr);
    exit(EXIT_FAILURE);
}

/* [log] */
/* The SDK's sentences begin with the name of the function that failed. */
static char lastError[1024];

static void AGAA_CALL onLog(void* user, uint32_t severity, AgaaResult code, const char* message) {
    (void)user, (void)code;
    if (severity >= AGAA_SEVERITY_ERROR)
        snprintf(lastError, sizeof lastError, "%s", message);
}

static void checkSdk(AgaaResult result, const char* call) {
    if (result < 0 && lastError[0])
        fail("%s", lastError);
    if (result < 0) /* before a context has the log */
        fail("%s: %s.", call, agaaResultString(result));
}
/* [/log] */

/* [statistics] */
static void reportFrame(AgaaView view, uint64_t completedFrame) {
    AgaaFrameStatistics statistics = AGAA_FRAME_STATISTICS_INIT;
    AgaaFrameValidation validation = AGAA_FRAME_VALIDATION_INIT;
    const AgaaResult result = agaaGetFrameStatistics(view, completedFrame, &statistics);
    checkSdk(result, "agaaGetFrameStatistics");
    if (result == AGAA_NOT_READY)
        fail("Frame %" PRIu64 " has finished, but has no statistics.", completedFrame);
    printf("frame %" PRIu64 ": visible %" PRIu64 " once %" PRIu64 " missed %" PRIu64 " multi %" PRIu64
           " shadingEvents %" PRIu64 "\n",
           statistics.frameIndex, statistics.counters.visible, statistics.counters.once,
           statistics.counters.missed, statistics.counters.multi, statistics.counters.shadingEvents);
    checkSdk(agaaValidateFrame(view, completedFrame, &validation), "agaaValidateFrame");
    if (!validation.isValid)
        fail("Frame %" PRIu64 ": %s", validation.frameIndex, validation.explanation);
}
/* [/statistics] */

/* Linear RGBA, row 0 on top, as binary PPM in sRGB. */
static void writeImage(const char* path, const float* pixels) {
    FILE* file = fopen(path, "wb");
    int i, channel, isWritten;
    if (!file)
        fail("The file \"%s\" cannot be opened for writing.", path);
    fprintf(file, "P6\n%d %d\n255\n", width, height);
    for (i = 0; i < width * height; ++i)
        for (channel = 0; channel < 3; ++channel) {
            const float linear = fminf(fmaxf(pixels[4 * i + channel], 0.0f), 1.0f);
            const float coded = linear <= 0.0031308f ? 12.92f * linear
                                                     : 1.055f * powf(linear, 1.0f / 2.4f) - 0.055f;
            fputc((int)(coded * 255.0f + 0.5f), file);
        }
    isWritten = !ferror(file);
    if (fclose(file) != 0 || !isWritten)
        fail("The file \"%s\" could not be written.", path);
}

#endif

/* The smallest use of the library from C: memory of a view without a device. */
#include "agaa_sdk.h"

#include <stdio.h>

int main(void) {
    AgaaConfig config = AGAA_CONFIG_INIT;
    AgaaSceneFacts facts = AGAA_SCENE_FACTS_INIT;
    AgaaViewDesc view = AGAA_VIEW_DESC_INIT;
    AgaaMemoryReport report = AGAA_MEMORY_REPORT_INIT;
    AgaaLayout layout = AGAA_LAYOUT_INIT;
    AgaaResult result;
    if (agaaGetVersion() != AGAA_HEADER_VERSION)
        return 1;
    if (agaaGetBuiltinLayout("paper16", &layout) != AGAA_OK)
        return 2;
    config.layout = &layout;
    config.visibilityTier = AGAA_TIER_NATIVE;
    config.generationTier = AGAA_TIER_NV_MIXED_SAMPLES;
    facts.maxLights = 1; /* more lights have masks for each tile of pixels */
    view.width = 640;
    view.height = 360;
    view.config = &config;
    view.facts = &facts;
    result = agaaQueryMemory(&view, NULL, NULL, &report, NULL, NULL);
    printf("%s: %.1f bytes per pixel\n", agaaResultName(result), report.bytesPerPixel);
    return result == AGAA_OK && report.bytesPerPixel == 81.0 ? 0 : 3;
}

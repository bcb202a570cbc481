// Values of hosts in sentences, and descriptions of devices that do not exist.
#include "core/base/names.h"

#include "agaa_sdk.h"

#include <gtest/gtest.h>

#include <string>

namespace {

std::string logged;

AgaaLog keepingLog() {
    AgaaLog log = AGAA_LOG_INIT;
    log.callback = [](void*, uint32_t, AgaaResult, const char* text) { logged = text; };
    return log;
}

AgaaResult query(const char* technique, uint32_t sampleCounts) {
    logged.clear();
    AgaaConfig config = AGAA_CONFIG_INIT;
    config.technique = technique;
    AgaaViewDesc view = AGAA_VIEW_DESC_INIT;
    view.width = view.height = 64;
    view.config = &config;
    AgaaSceneFacts facts = AGAA_SCENE_FACTS_INIT;
    view.facts = &facts;
    AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
    caps.sampleCounts = sampleCounts;
    caps.maxImageSize = 16384;
    caps.maxStorageRange = uint64_t(1) << 30;
    caps.maxSharedBytes = 32768;
    AgaaTarget target = AGAA_TARGET_INIT;
    const AgaaLog log = keepingLog();
    return agaaQueryTarget(&view, &caps, &log, &target);
}

TEST(HostValues, NamesInSentencesAreOneLine) {
    EXPECT_EQ(query("ss\naa\x1b[31m", 0x5), AGAA_ERROR_UNSUPPORTED);
    EXPECT_NE(logged.find("no technique is called \"ss\\x0Aaa\\x1B[31m\"."), std::string::npos) << logged;
    for (const char c : logged)
        EXPECT_GE(static_cast<unsigned char>(c), 0x20) << logged;
    EXPECT_EQ(agaa::printable(std::string(1000, 'x').c_str()).size(), 64u);
    EXPECT_EQ(agaa::printable("blätter"), "blätter");
}

// A mask with more than 64 samples is of no device.
TEST(HostValues, SampleCountsAreThoseOfDevices) {
    for (const uint32_t counts : {0x1u, 0x5u, 0x1Fu, 0x3Fu, 0x7Fu})
        EXPECT_EQ(query("single", counts), AGAA_OK) << counts << logged;
    for (const uint32_t counts : {0x85u, 0x80000001u, ~0u}) {
        EXPECT_EQ(query("single", counts), AGAA_ERROR_OUT_OF_RANGE) << counts;
        EXPECT_NE(logged.find("AgaaDeviceCaps::sampleCounts"), std::string::npos) << logged;
    }
}

} // namespace

// The defaults of structs, and the chains that the library accepts.
#include "agaa_gl.hpp"
#include "agaa_vk.hpp"

#include <gtest/gtest.h>

#include <cstring>

namespace {

// ---- defaults -----------------------------------------------------------------------------------

template <class T> bool equals(T made, T expected) { return std::memcmp(&made, &expected, sizeof(T)) == 0; }
bool equals(AgaaConfig made, AgaaConfig expected) {
    if (std::string_view(made.technique) != expected.technique)
        return false;
    made.technique = expected.technique; // another address of the same text
    return std::memcmp(&made, &expected, sizeof made) == 0;
}

// T as its function agaaInit… leaves it, which sets all bytes.
template <class T> T byFunction(void (*initialise)(T*, size_t)) {
    T made;
    std::memset(&made, 0xEE, sizeof made);
    initialise(&made, sizeof made);
    return made;
}

TEST(Defaults, AreThoseOfTheLibrary) {
#define AGAA_STRUCT(name, type, size)                                                                                  \
    EXPECT_TRUE(equals(agaa::init<Agaa##name>(), byFunction(agaaInit##name)) || std::string_view(#name) == "Frame")    \
        << #name;
#define AGAA_VK_STRUCT AGAA_STRUCT
#define AGAA_GL_STRUCT AGAA_STRUCT
#include "core/base/structs.inc"
    EXPECT_TRUE(equals(agaa::init<AgaaLight>(), byFunction(agaaInitLight)));
    EXPECT_TRUE(equals(agaa::init<AgaaShadow>(), byFunction(agaaInitShadow)));
    AgaaLayoutAttribute attribute;
    agaaInitLayoutAttribute(&attribute);
    EXPECT_TRUE(equals(agaa::init<AgaaLayoutAttribute>(), attribute));
    // The function leaves the sizes of arrays to the host.
    AgaaFrame frame = byFunction(agaaInitFrame);
    frame.lightSize = sizeof(AgaaLight);
    frame.shadowSize = sizeof(AgaaShadow);
    EXPECT_TRUE(equals(agaa::init<AgaaFrame>(), frame));
}
static_assert(agaa::init<AgaaConfig>().samples == 8, "Defaults are constants.");

// ---- chains -------------------------------------------------------------------------------------

TEST(Chains, HaveTheStructsInTheirOrder) {
    AgaaConfig config = agaa::init<AgaaConfig>();
    AgaaAggregation aggregation = agaa::init<AgaaAggregation>();
    AgaaMeasurement measurement = agaa::init<AgaaMeasurement>();
    EXPECT_EQ(&agaa::chain(config, aggregation, measurement), &config);
    EXPECT_EQ(config.pNext, &aggregation);
    EXPECT_EQ(aggregation.pNext, &measurement);
    EXPECT_EQ(measurement.pNext, nullptr);
    agaa::chain(config, measurement); // in place of the earlier chain
    EXPECT_EQ(config.pNext, &measurement);
    EXPECT_EQ(measurement.pNext, nullptr);
    agaa::chain(config);
    EXPECT_EQ(config.pNext, nullptr);
}

// The result of a query whose view or configuration has a struct chained.
AgaaResult queryWith(const void* nextOfView, const void* nextOfConfig) {
    AgaaConfig config = agaa::init<AgaaConfig>();
    const AgaaSceneFacts facts = agaa::init<AgaaSceneFacts>();
    AgaaViewDesc view = agaa::init<AgaaViewDesc>();
    view.width = view.height = 64;
    view.config = &config;
    view.facts = &facts;
    config.pNext = nextOfConfig;
    view.pNext = nextOfView;
    return agaa::queryMemory(view).code();
}

// Descriptions of contexts without a device fail in any case.
AgaaResult createWith(agaa::Result<agaa::Context> (*create)(const AgaaContextDesc&, uint32_t), const void* next) {
    AgaaContextDesc desc = agaa::init<AgaaContextDesc>();
    desc.pNext = next;
    return create(desc, agaa::headerVersion).code();
}

// Compares what compiles with what the library accepts. It refuses structs of the other graphics API.
template <class T> void checkChains(const char* name, bool isOfVulkan, bool isOfOpenGl) {
    const T next = agaa::init<T>();
    EXPECT_EQ(queryWith(nullptr, &next) != AGAA_ERROR_UNKNOWN_STRUCT, (agaa::isChainable<AgaaConfig, T>)) << name;
    EXPECT_EQ(queryWith(&next, nullptr) != AGAA_ERROR_UNKNOWN_STRUCT, (agaa::isChainable<AgaaViewDesc, T>)) << name;
    constexpr bool isOfContexts = agaa::isChainable<AgaaContextDesc, T>;
    EXPECT_EQ(createWith(agaa::vk::createContext, &next) != AGAA_ERROR_UNKNOWN_STRUCT, isOfContexts && !isOfOpenGl)
        << name;
    EXPECT_EQ(createWith(agaa::gl::createContext, &next) != AGAA_ERROR_UNKNOWN_STRUCT, isOfContexts && !isOfVulkan)
        << name;
}

TEST(Chains, AreThoseOfTheLibrary) {
#define AGAA_STRUCT(name, type, size) checkChains<Agaa##name>(#name, false, false);
#define AGAA_VK_STRUCT(name, type, size) checkChains<Agaa##name>(#name, true, false);
#define AGAA_GL_STRUCT(name, type, size) checkChains<Agaa##name>(#name, false, true);
#include "core/base/structs.inc"
}

} // namespace

// Calls every function of the C++ headers. It is compiled with all warnings, without exceptions and RTTI, in each
// version of C++; the other files of this folder run the functions.
#include "agaa_gl.hpp"
#include "agaa_vk.hpp"

#include <array>
#if __has_include(<span>)
#include <span>
#endif

namespace {

struct Draw {
    uint32_t calls = 0;
    AgaaResult operator()(const AgaaDrawTarget*) noexcept {
        ++calls;
        return AGAA_OK;
    }
};
// Callbacks of two types with one user pointer.
struct HostMemory {
    void* operator()(size_t, size_t) noexcept { return nullptr; }
    void operator()(void*) noexcept {}
};

template <class T> AgaaResult codeOf(const agaa::Result<T>& result) {
    return result ? AGAA_OK : result.isError() ? result.code() : AGAA_NOT_READY;
}

AgaaResult useQueries(const AgaaViewDesc& view, const AgaaDeviceCaps& caps, const AgaaLog* log) {
    AgaaResult result = AGAA_OK;
    result |= codeOf(agaa::getNames(AGAA_NAMES_TIERS)) | codeOf(agaa::tierFromName("ids"));
    result |= codeOf(agaa::getBuiltinLayout("precise")) | codeOf(agaa::getJitter(1, 8));
    result |= codeOf(agaa::queryCapabilities(&caps)) | codeOf(agaa::queryMemory(view, &caps, log));
    result |= codeOf(agaa::querySurfaces(view, &caps, log)) | codeOf(agaa::queryTarget(view, &caps, log));
    result |= codeOf(agaa::queryPrices(view, &caps, log)) | codeOf(agaa::planToJson(view, &caps, log));
    result |= codeOf(agaa::getAggregateGlsl(view, &caps, log)) | codeOf(agaa::getCoverageGlsl(log));
    AgaaConfig config = agaa::init<AgaaConfig>();
    AgaaAggregation aggregation = agaa::init<AgaaAggregation>();
    AgaaMeasurement measurement = agaa::init<AgaaMeasurement>();
    agaa::chain(config, aggregation, measurement);
    result |= agaa::applyPreset("fast", config, aggregation, &measurement);
    AgaaObservation observation = agaa::init<AgaaObservation>();
    result |= agaa::observe(view, &caps, log, agaa::init<AgaaFrameStatistics>(), observation);
    const agaa::Result<AgaaChoice> choice =
        agaa::chooseSettings(view, &caps, log, agaa::init<AgaaGoal>(), &observation);
    if (choice)
        result |= agaa::applyChoice(*choice, config, aggregation, &measurement);
    const bool isNamed = agaa::tierName(0).empty() || agaa::stageName(0).empty() || agaa::resultName(0).empty();
    return isNamed || agaa::resultString(0).empty() || agaa::getVersion() == 0 ? AgaaResult(AGAA_ERROR_INTERNAL)
                                                                               : result;
}

AgaaResult useView(AgaaView view) {
    AgaaResult result = agaa::resizeView(view, 64, 64);
    const std::vector<AgaaSceneFacts> facts(2, agaa::init<AgaaSceneFacts>());
    result |= agaa::prepareVariants(view, facts) | agaa::prepareVariants(view, {facts.data(), 1});
#ifdef __cpp_lib_span
    result |= agaa::prepareVariants(view, std::span(facts));
#endif
    result |= codeOf(agaa::getDrawPasses(view)) | codeOf(agaa::getGlslResources(view, 0));
    result |= codeOf(agaa::getSurface(view, "depth")) | codeOf(agaa::getFrameStatistics(view, 1));
    AgaaFrameStatistics statistics = agaa::init<AgaaFrameStatistics>();
    result |= agaa::getFrameStatistics(view, 1, statistics);
    return result | codeOf(agaa::validateFrame(view, 1)) | codeOf(agaa::getFactReport(view, 1)) |
           codeOf(agaa::getBreadcrumbs(view));
}

AgaaFrame makeFrame(Draw& draw) {
    static constexpr std::array<AgaaLight, 2> lights{agaa::init<AgaaLight>(), agaa::init<AgaaLight>()};
    static const AgaaShadow shadows[1] = {agaa::init<AgaaShadow>()};
    static AgaaTemporalFrame temporal = agaa::init<AgaaTemporalFrame>();
    AgaaFrame frame = agaa::init<AgaaFrame>();
    agaa::chain(frame, temporal);
    agaa::setLights(frame, lights);
    agaa::setShadows(frame, shadows);
    agaa::bind(frame.draw, frame.drawUser, draw);
    return frame;
}

AgaaResult useVulkan(agaa::Context& context, AgaaContextDesc& desc, const AgaaViewDesc& viewDesc) {
    AgaaVkDeviceDesc device = agaa::init<AgaaVkDeviceDesc>();
    AgaaVkAllocator allocator = agaa::init<AgaaVkAllocator>();
    const agaa::Result<AgaaVkRequirements> requirements = agaa::vk::getRequirements();
    AgaaResult result = codeOf(requirements) | codeOf(agaa::vk::getDeviceCaps(nullptr, nullptr, nullptr));
    if (agaa::Result<agaa::Context> created = agaa::vk::createContext(agaa::chain(desc, device, allocator)))
        context = *std::move(created);
    result |= codeOf(agaa::vk::getContextCaps(context.get()));
    const agaa::View view = agaa::vk::createView(context.get(), viewDesc).valueOr(agaa::View());
    result |= codeOf(agaa::vk::getDrawPasses(view.get())) | codeOf(agaa::vk::getSurface(view.get(), "depth"));
    Draw draw;
    return result | agaa::vk::recordFrame(view.get(), makeFrame(draw), agaa::init<AgaaVkFrame>());
}

AgaaResult useOpenGl(agaa::Context& context, AgaaContextDesc& desc, const AgaaViewDesc& viewDesc) {
    AgaaGlDeviceDesc device = agaa::init<AgaaGlDeviceDesc>();
    AgaaGlProgramCache cache = agaa::init<AgaaGlProgramCache>();
    const auto load = [](const char*) noexcept -> AgaaGlFunction { return nullptr; };
    agaa::bind(device.getProcAddr, device.getProcUser, load);
    const agaa::Result<AgaaGlRequirements> requirements = agaa::gl::getRequirements();
    AgaaResult result = codeOf(requirements) | codeOf(agaa::gl::getDeviceCaps(device.getProcAddr, device.getProcUser));
    if (agaa::Result<agaa::Context> created = agaa::gl::createContext(agaa::chain(desc, device, cache)))
        context = std::move(created).value();
    result |= codeOf(agaa::gl::getContextCaps(context.get())) | codeOf(agaa::gl::getProgramCache(context.get()));
    const agaa::View view = agaa::gl::createView(context.get(), viewDesc).valueOr(agaa::View());
    result |= codeOf(agaa::gl::getDrawPasses(view.get())) | codeOf(agaa::gl::getSurface(view.get(), "depth"));
    Draw draw;
    return result | agaa::gl::recordFrame(view.get(), makeFrame(draw), agaa::init<AgaaGlFrame>()) | useView(view.get());
}

} // namespace

AgaaResult useEverything();
AgaaResult useEverything() {
    size_t length = 0;
    agaa::LogSink sink([&](AgaaSeverity, AgaaResult, std::string_view message) noexcept { length += message.size(); });
    HostMemory memory;
    AgaaContextDesc desc = agaa::init<AgaaContextDesc>();
    desc.log = sink.get();
    agaa::bind(desc.allocate, desc.allocateUser, memory);
    agaa::bind(desc.free, desc.allocateUser, memory);
    const AgaaConfig config = agaa::init<AgaaConfig>();
    const AgaaSceneFacts facts = agaa::init<AgaaSceneFacts>();
    AgaaViewDesc view = agaa::init<AgaaViewDesc>();
    view.config = &config;
    view.facts = &facts;
    const AgaaDeviceCaps caps = agaa::init<AgaaDeviceCaps>();
    agaa::Context context, other;
    swap(context, other);
    AgaaResult result = useQueries(view, caps, sink.get()) | useVulkan(context, desc, view) | context.reset();
    result |= useOpenGl(other, desc, view);
    [[maybe_unused]] const AgaaContext handle = other ? other.release() : nullptr;
    return length > 0 && agaa::text(caps.deviceName).empty() ? result : AgaaResult(AGAA_OK);
}

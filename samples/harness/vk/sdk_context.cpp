#include "vk/sdk_context.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <stdexcept>

namespace harness::vk {

namespace {

constexpr size_t keptViews = 2;

// Plain values one after the other: equal bytes mean equal views. Members are added one by one,
// since the padding of a struct may hold anything.
class Key {
public:
    template <class Value>
    void add(const Value& value) {
        static_assert(std::is_arithmetic_v<Value>);
        bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    void add(const char* text) { bytes_ += std::string(text ? text : "") + '\0'; }
    std::string take() { return std::move(bytes_); }

private:
    std::string bytes_;
};

void addLayout(Key& key, const AgaaLayout& layout) {
    key.add(layout.attributeCount);
    for (uint32_t i = 0; i < std::min<uint32_t>(layout.attributeCount, AGAA_MAX_LAYOUT_ATTRIBUTES);
         ++i) {
        const AgaaLayoutAttribute& a = layout.attributes[i];
        for (const uint32_t value : {a.semantic, a.channels, a.sampleBits, a.aggregateBits,
                                     a.chromaBits, a.encoding, a.reserved})
            key.add(value);
        key.add(a.range);
    }
}

// Empty where chained structs, which are unknown here, make the view one of its kind.
std::string keyOf(const AgaaViewDesc& desc) {
    const AgaaConfig& config = *desc.config;
    if (desc.pNext || config.pNext || desc.facts->pNext || (config.layout && config.layout->pNext))
        return {};
    Key key;
    key.add(desc.width);
    key.add(desc.height);
    key.add(desc.flags);
    key.add(config.technique);
    for (const uint32_t value :
         {config.samples, config.aggregates, config.brdf, config.ndf, config.seeds,
          config.shadowTaps, config.visibilityTier, config.generationTier, config.shadingCost})
        key.add(value);
    for (const float value : {config.characteristicLength, config.characteristicLengthPerDistance,
                              config.aggregateThreshold})
        key.add(value);
    key.add(config.flags);
    key.add(uint32_t(config.layout != nullptr));
    if (config.layout)
        addLayout(key, *config.layout);
    key.add(desc.facts->flags);
    key.add(desc.facts->maxLights);
    key.add(desc.facts->shadowMapCount);
    return key.take();
}

} // namespace

AgaaLog SdkLog::log() {
    AgaaLog log = AGAA_LOG_INIT;
    log.callback = onMessage;
    log.user = this;
    return log;
}

void SdkLog::check(AgaaResult result, const char* call) {
    if (result >= 0) {
        lastError_.clear();
        return;
    }
    std::string sentence = std::exchange(lastError_, {});
    if (sentence.empty())
        sentence = std::string(call) + " failed: " + agaaResultString(result) + ".";
    throw std::runtime_error(sentence);
}

void AGAA_CALL SdkLog::onMessage(void* user, uint32_t severity, AgaaResult, const char* message) {
    if (severity < AGAA_SEVERITY_WARNING)
        return;
    SdkLog& log = *static_cast<SdkLog*>(user);
    log.texts_.emplace_back(message ? message : "");
    if (severity >= AGAA_SEVERITY_ERROR)
        log.lastError_ = log.texts_.back();
}

SdkContext::SdkContext(const Device& device, const RendererOptions& options,
                       uint32_t descriptorSet) {
    createContext(device, options, descriptorSet);
}

void SdkContext::createContext(const Device& device, const RendererOptions& options,
                               uint32_t descriptorSet) {
    const AgaaLog log = log_.log();
    log_.check(agaaVkGetDeviceCaps(device.instance(), device.physicalDevice(), Device::getProcAddr,
                                   &log, &caps_),
               "agaaVkGetDeviceCaps");
    AgaaVkContextDesc desc = AGAA_VK_CONTEXT_DESC_INIT;
    desc.instance = device.instance();
    desc.physicalDevice = device.physicalDevice();
    desc.device = device.get();
    desc.queueFamily = device.queueFamily();
    desc.apiVersion = device.apiVersion();
    desc.getProcAddr = Device::getProcAddr;
    desc.enabledExtensions = device.extensions().data();
    desc.enabledExtensionCount = uint32_t(device.extensions().size());
    desc.rendering = options.renderPass ? AGAA_VK_RENDERING_RENDER_PASS : AGAA_VK_RENDERING_AUTO;
    desc.recording =
        options.inlineRecording ? AGAA_VK_RECORDING_INLINE : AGAA_VK_RECORDING_SECONDARY;
    desc.descriptorSet = descriptorSet;
    desc.log = &log;
    log_.check(agaaVkCreateContext(AGAA_HEADER_VERSION, &desc, &context_), "agaaVkCreateContext");
    // Less what was not enabled.
    log_.check(agaaVkGetContextCaps(context_, &caps_), "agaaVkGetContextCaps");
}

SdkContext::~SdkContext() {
    for (const SdkView& view : views_)
        agaaDestroyView(view.view);
    agaaDestroyContext(context_);
}

const SdkView& SdkContext::view(const AgaaViewDesc& desc) {
    const std::string key = keyOf(desc);
    const auto found = std::find_if(views_.begin(), views_.end(), [&](const SdkView& view) {
        return !key.empty() && view.key == key;
    });
    if (found != views_.end()) {
        views_.splice(views_.begin(), views_, found);
        return views_.front();
    }
    // Before the new one takes its memory.
    while (views_.size() >= keptViews) {
        agaaDestroyView(views_.back().view);
        views_.pop_back();
    }

    AgaaView handle = nullptr;
    log_.check(agaaVkCreateView(context_, &desc, &handle), "agaaVkCreateView");
    views_.push_front({handle, {}, key});
    SdkView& view = views_.front();
    uint32_t count = 0;
    log_.check(agaaVkGetDrawPasses(handle, &count, nullptr), "agaaVkGetDrawPasses");
    view.passes.assign(count, AgaaVkDrawPass AGAA_VK_DRAW_PASS_INIT);
    log_.check(agaaVkGetDrawPasses(handle, &count, view.passes.data()), "agaaVkGetDrawPasses");
    view.passes.resize(count);
    return view;
}

AgaaMemoryReport SdkContext::memory(const AgaaViewDesc& desc) {
    const AgaaLog log = log_.log();
    AgaaMemoryReport report = AGAA_MEMORY_REPORT_INIT;
    uint32_t surfaceCount = 0;
    log_.check(agaaQueryMemory(&desc, &caps_, &log, &report, &surfaceCount, nullptr),
               "agaaQueryMemory");
    return report;
}

std::vector<std::pair<std::string, std::string>> SdkContext::tiers(const AgaaViewDesc& desc) {
    const AgaaLog log = log_.log();
    size_t size = 0;
    log_.check(agaaPlanToJson(&desc, &caps_, &log, &size, nullptr), "agaaPlanToJson");
    std::vector<char> text(size);
    log_.check(agaaPlanToJson(&desc, &caps_, &log, &size, text.data()), "agaaPlanToJson");
    std::vector<std::pair<std::string, std::string>> result;
    const auto plan = nlohmann::ordered_json::parse(text.data());
    for (const auto& [stage, tier] : plan.at("tiers").items())
        result.emplace_back(stage, tier.get<std::string>());
    return result;
}

} // namespace harness::vk

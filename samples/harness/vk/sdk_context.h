// The SDK's context and views, with its errors as exceptions.
#pragma once

#include "vk/device.h"

#include <list>
#include <string>
#include <vector>

namespace harness::vk {

// What the SDK says through its log callback.
class SdkLog {
public:
    AgaaLog log();
    // Throws std::runtime_error with the SDK's sentence where the result is an error.
    void check(AgaaResult result, const char* call);
    // Warnings and errors so far.
    const std::vector<std::string>& texts() const { return texts_; }

private:
    static void AGAA_CALL onMessage(void* user, uint32_t severity, AgaaResult code,
                                    const char* message);

    std::vector<std::string> texts_;
    std::string lastError_;
};

struct SdkView {
    AgaaView view = nullptr;
    std::vector<AgaaVkDrawPass> passes;
    std::string key; // the settings that it was made for
};

class SdkContext {
public:
    SdkContext(const Device& device, const RendererOptions& options, uint32_t descriptorSet);
    ~SdkContext();
    SdkContext(const SdkContext&) = delete;
    SdkContext& operator=(const SdkContext&) = delete;

    const AgaaDeviceCaps& caps() const { return caps_; }
    SdkLog& log() { return log_; }

    // Valid until the next call but one: measurements alternate between two views. All frames must
    // have finished.
    const SdkView& view(const AgaaViewDesc& desc);
    AgaaMemoryReport memory(const AgaaViewDesc& desc);
    std::vector<std::pair<std::string, std::string>> tiers(const AgaaViewDesc& desc);

private:
    void createContext(const Device& device, const RendererOptions& options,
                       uint32_t descriptorSet);

    SdkLog log_;
    AgaaContext context_ = nullptr;
    AgaaDeviceCaps caps_ = AGAA_DEVICE_CAPS_INIT;
    std::list<SdkView> views_; // the most recently used first
};

} // namespace harness::vk

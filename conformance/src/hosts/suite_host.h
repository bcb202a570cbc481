// An engine on a device of the suite, for the checks of integrations. It is correct except for Device::mistakes.
#pragma once

#include "device.h"

#include <optional>

namespace agaa::conformance {

class SuiteHost {
public:
    SuiteHost(Test& test, Device& device);
    const AgaaConformanceHost* get() const { return &host_; }

private:
    static AgaaResult prepareView(void* user, AgaaView view);
    static void releaseView(void* user, AgaaView view);
    static AgaaResult renderFrame(void* user, AgaaView view, AgaaFrame* frame, float* outPixels);
    static const char* takeMessages(void* user);
    static void hideMasked(void* user, uint32_t isHidden);

    const Functions& sdk_;
    Device& device_;
    ScopedContext context_;
    AgaaSceneFacts facts_;
    AgaaViewDesc desc_;
    Scene scene_, opaque_; // all surfaces, and those without alpha mask
    bool isMaskedHidden_ = false;
    std::string messages_;
    AgaaConformanceHost host_;
};

} // namespace agaa::conformance

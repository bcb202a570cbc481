// An engine made of a device of the suite, to be checked as engines are. A right host unless Device::mistakes says otherwise.
#pragma once

#include "device.h"

#include <optional>

namespace agaa::conformance {

class OwnHost {
public:
    OwnHost(Test& test, Device& device);
    const AgaaConformanceHost* get() const { return &host_; }

private:
    static AgaaResult prepareView(void* user, AgaaView view);
    static void releaseView(void* user, AgaaView view);
    static AgaaResult renderFrame(void* user, AgaaView view, AgaaFrame* frame, float* outPixels);
    static const char* takeMessages(void* user);
    static void hideMasked(void* user, uint32_t isHidden);

    const Functions& sdk_;
    Device& device_;
    OwnContext context_;
    AgaaSceneFacts facts_;
    AgaaViewDesc desc_;
    Scene scene_, opaque_; // all, and without alpha-masked surfaces
    bool isMaskedHidden_ = false;
    std::string messages_;
    AgaaConformanceHost host_;
};

} // namespace agaa::conformance

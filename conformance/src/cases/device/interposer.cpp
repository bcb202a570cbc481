#include "interposer.h"

#include "gl_interposer.h"
#include "vk_interposer.h"

namespace agaa::conformance {

void Interposer::failAt(uint32_t nth, int64_t error) {
    const std::lock_guard<std::mutex> lock(mutex_);
    remaining_ = nth;
    error_ = error;
    failed_.clear();
}

void Interposer::loseAt(uint32_t nth) {
    const std::lock_guard<std::mutex> lock(mutex_);
    callsUntilLoss_ = nth;
    isLost_ = false;
}

bool Interposer::findsLost() {
    if (callsUntilLoss_ && --callsUntilLoss_ == 0)
        isLost_ = true;
    return isLost_;
}

bool Interposer::mustFail(const char* function) {
    called.push_back(function);
    if (!remaining_ || --remaining_)
        return false;
    failed_ = function;
    return true;
}

void Interposer::count(const char* kind, int64_t difference) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if ((objects[kind] += difference) == 0)
        objects.erase(kind);
}

std::unique_ptr<Interposer> makeInterposer(const Device& device) {
    if (device.backend() == Backend::Vulkan)
        return std::make_unique<VulkanInterposer>();
    return std::make_unique<OpenGlInterposer>();
}

} // namespace agaa::conformance

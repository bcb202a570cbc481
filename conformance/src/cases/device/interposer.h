// Stands between the SDK and a graphics API: functions fail, and objects are counted.
#pragma once

#include "creation.h"

#include <map>
#include <memory>
#include <mutex>

namespace agaa::conformance {

// One at a time. It outlives the contexts that are created with it.
class Interposer {
public:
    Interposer() = default;
    virtual ~Interposer() = default;
    Interposer(const Interposer&) = delete;
    Interposer& operator=(const Interposer&) = delete;

    // Makes the SDK load its functions here.
    virtual void chainTo(ContextDescription& description) = 0;

    // The nth call from now on that can fail does so with the error (VkResult, or what glGetError returns). 0: none.
    void failAt(uint32_t nth, int64_t error);
    const std::string& failed() const { return failed_; } // the function that failed; empty if none did
    std::vector<std::string> called; // functions that can fail, in the order of their calls

    // Objects that were created and not destroyed, by kind; kinds without such objects are not listed.
    std::map<std::string, int64_t> objects;
    void count(const char* kind, int64_t difference);

protected:
    // Whether this call is the one.
    bool isTurnOf(const char* function);
    std::mutex mutex_; // functions may be called from any thread
    int64_t error_ = 0;
    std::string failed_;

private:
    uint32_t remaining_ = 0;
};

// Of the device's API.
std::unique_ptr<Interposer> makeInterposer(const Device& device);

} // namespace agaa::conformance

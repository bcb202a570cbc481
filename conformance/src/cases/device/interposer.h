// An interposer between the SDK and a graphics API. It makes functions fail, and counts objects.
#pragma once

#include "creation.h"

#include <map>
#include <memory>
#include <mutex>

namespace agaa::conformance {

// Only one may exist. It must outlive the contexts that are created with it.
class Interposer {
public:
    Interposer() = default;
    virtual ~Interposer() = default;
    Interposer(const Interposer&) = delete;
    Interposer& operator=(const Interposer&) = delete;

    // Changes the description so that the SDK loads its functions from the interposer.
    virtual void chainTo(ContextDescription& description) = 0;

    // Makes the nth call from now on fail with the error (a VkResult, or a value of glGetError). 0: none. Only calls
    // that can fail count.
    void failAt(uint32_t nth, int64_t error);
    // The nth call of a function from now on, and all later ones, find the device or the context lost. 0: none. On
    // OpenGL, functions then have no effect.
    void loseAt(uint32_t nth);
    bool isLost() const { return isLost_; }
    const std::string& failed() const { return failed_; } // name of the function that failed; empty if none did
    std::vector<std::string> called;                      // functions that can fail, in call order

    // Returns the number of live objects by kind. Kinds without live objects are not listed.
    std::map<std::string, int64_t> objects;
    void count(const char* kind, int64_t difference);

protected:
    // Returns whether this call must fail.
    bool mustFail(const char* function);
    // Counts a call, and returns whether the device or the context is lost.
    bool findsLost();
    std::mutex mutex_; // functions may be called from any thread
    int64_t error_ = 0;
    uint32_t remaining_ = 0; // calls until the one that fails; 0: none fails
    std::string failed_;
    uint32_t callsUntilLoss_ = 0; // 0: no loss follows
    bool isLost_ = false;
};

// Creates the interposer of the device's API.
std::unique_ptr<Interposer> makeInterposer(const Device& device);

} // namespace agaa::conformance

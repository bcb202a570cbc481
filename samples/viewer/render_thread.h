// Renders in a thread of its own, so that the window answers while a frame takes long. The thread owns all devices.
#pragma once

#include "render_session.h"

#include <condition_variable>
#include <mutex>
#include <thread>

namespace viewer {

class RenderThread {
public:
    // wake: called by the thread after each new snapshot.
    explicit RenderThread(std::function<void()> wake, RendererFactory factory = harness::makeRenderer);
    // Waits for the frame that is being rendered.
    ~RenderThread();
    RenderThread(const RenderThread&) = delete;
    RenderThread& operator=(const RenderThread&) = delete;

    // Replaces the request and returns its serial. A frame that is being rendered is finished before.
    uint64_t request(ViewRequest request);
    // Returns the newest snapshot, or null.
    std::shared_ptr<const Snapshot> newest() const;

private:
    void run();

    std::function<void()> wake_;
    RendererFactory factory_;
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    ViewRequest request_;
    uint64_t serial_ = 0; // 0: no request yet
    bool ends_ = false;
    std::shared_ptr<const Snapshot> newest_;
    std::thread thread_; // last, because it uses the other members
};

} // namespace viewer

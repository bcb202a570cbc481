#include "render_thread.h"

namespace viewer {

RenderThread::RenderThread(std::function<void()> wake, RendererFactory factory)
    : wake_(std::move(wake)), factory_(std::move(factory)), thread_([this] { run(); }) {}

RenderThread::~RenderThread() {
    {
        const std::lock_guard lock(mutex_);
        ends_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

uint64_t RenderThread::request(ViewRequest request) {
    const std::lock_guard lock(mutex_);
    request_ = std::move(request);
    changed_.notify_all();
    return ++serial_;
}

std::shared_ptr<const Snapshot> RenderThread::newest() const {
    const std::lock_guard lock(mutex_);
    return newest_;
}

void RenderThread::run() {
    RenderSession session(factory_);
    uint64_t restsSince = 0; // serial of a request for which nothing is left to do
    for (;;) {
        ViewRequest request;
        uint64_t serial = 0;
        {
            std::unique_lock lock(mutex_);
            changed_.wait(lock, [&] { return ends_ || serial_ != restsSince; });
            if (ends_)
                return;
            request = request_;
            serial = serial_;
        }
        const std::shared_ptr<const Snapshot> result = session.step(request);
        if (!result) {
            restsSince = serial;
            continue;
        }
        auto numbered = std::make_shared<Snapshot>(*result);
        numbered->serial = serial;
        {
            const std::lock_guard lock(mutex_);
            newest_ = numbered;
        }
        wake_();
    }
}

} // namespace viewer

// The SDK's views that a renderer keeps, because measurements alternate between two views.
#pragma once

#include "render/draw_pass.h"
#include "render/sdk_log.h"
#include "render/view_key.h"

#include <algorithm>
#include <list>

namespace harness {

template <class DrawPass> struct SdkView {
    AgaaView view = nullptr;
    std::vector<DrawPass> passes;
    std::string key; // key of the view's settings
};

template <class DrawPass> class SdkViews {
public:
    explicit SdkViews(size_t kept) : kept_(kept) {}
    ~SdkViews() {
        for (const SdkView<DrawPass>& view : views_)
            agaaDestroyView(view.view);
    }
    SdkViews(const SdkViews&) = delete;
    SdkViews& operator=(const SdkViews&) = delete;

    // Returns the view of the settings, which stays valid for one further call. All frames must have finished.
    // create(desc) creates a view, list(view) returns its draw passes.
    template <class Create, class List>
    const SdkView<DrawPass>& get(const AgaaViewDesc& desc, const Create& create, const List& list) {
        const std::string key = viewKey(desc);
        const auto found = std::find_if(views_.begin(), views_.end(),
                                        [&](const SdkView<DrawPass>& view) { return !key.empty() && view.key == key; });
        if (found != views_.end()) {
            views_.splice(views_.begin(), views_, found);
            return views_.front();
        }
        // The oldest view must go before the new view takes memory.
        while (views_.size() >= kept_) {
            agaaDestroyView(views_.back().view);
            views_.pop_back();
        }
        views_.push_front({create(desc), {}, key});
        views_.front().passes = list(views_.front().view);
        return views_.front();
    }

private:
    size_t kept_;                        // at least 2
    std::list<SdkView<DrawPass>> views_; // most recently used first
};

} // namespace harness

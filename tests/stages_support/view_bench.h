// One view of a small host that renders many frames, so that its pipelines are compiled once.
#pragma once

#include "shown.h"

#include <optional>

namespace agaa::test {

template <class Host> class ViewBench {
public:
    // shot   Read during the call, but for its functions. Its triangles are the most that the view shows.
    ViewBench(typename Host::Context& context, ViewSettings settings, const Shot& shot)
        : lights_(shot.lights), change_(shot.change) {
        settings.config.flags |= AGAA_CONFIG_COUNTERS;
        if (settings.fetches())
            ids_.emplace(context, settings, shot);
        else
            own_.emplace(context, settings);
    }
    typename Host::View& view() { return ids_ ? ids_->view() : *own_; }
    void setTriangles(const std::vector<Triangle>& triangles) {
        if (ids_)
            ids_->setTriangles(triangles);
        else
            own_->setTriangles(triangles);
    }
    std::function<void(typename Host::Frame&)> change; // what frames have besides; may be empty
    bool keepsOutput = false;                          // a frame begins with the output of the one before
    std::vector<uint64_t> segments{AGAA_SEGMENT_ALL};  // AgaaFrame::segments of each recording of a frame
    // Renders the next frame and returns its pixels.
    std::vector<float> rgb() {
        AgaaFrame frame = view().frame();
        frame.lights = lights_.data();
        frame.lightCount = uint32_t(lights_.size());
        if (change_)
            change_(frame);
        Host::run(view(), [&](typename Host::Frame& native) {
            if (ids_)
                ids_->bind(native);
            if constexpr (requires { native.outputLayoutIn; })
                if (keepsOutput && hasOutput_)
                    native.outputLayoutIn = native.outputLayoutOut;
            hasOutput_ = true;
            if (change)
                change(native);
            for (const uint64_t recorded : segments) {
                frame.segments = recorded;
                EXPECT_EQ(Host::recordFrame(view().get(), &frame, &native), AGAA_OK);
            }
        });
        return withoutAlpha(Host::rgba(view()));
    }
    Shown show(const std::vector<Triangle>& triangles) {
        setTriangles(triangles);
        Shown shown;
        shown.rgb = rgb();
        shown.counters = view().statistics().counters;
        return shown;
    }

private:
    bool hasOutput_ = false;
    std::vector<AgaaLight> lights_;
    std::function<void(AgaaFrame&)> change_;
    std::optional<typename Host::Ids> ids_;
    std::optional<typename Host::View> own_;
};

} // namespace agaa::test

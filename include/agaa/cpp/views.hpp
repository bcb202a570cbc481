// Functions with a view of either graphics API, and arrays of frames. Part of agaa.hpp.
// SPDX-License-Identifier: MIT
//
// Threads   One call at a time per context, except for prepareVariants on Vulkan.
// OpenGL    The context must be current.
#ifndef AGAA_CPP_VIEWS_HPP
#define AGAA_CPP_VIEWS_HPP

#include "agaa/cpp/array_view.hpp"
#include "agaa/cpp/init.hpp"
#include "agaa/cpp/lists.hpp"
#include "agaa_sdk.h"

namespace agaa {

// The view keeps its size on failure.
[[nodiscard]] inline AgaaResult resizeView(AgaaView view, uint32_t width, uint32_t height) noexcept {
    return agaaResizeView(view, width, height);
}

[[nodiscard]] inline AgaaResult prepareVariants(AgaaView view, ArrayView<AgaaSceneFacts> facts) noexcept {
    return agaaPrepareVariants(view, facts.count(), facts.data());
}

// The view owns the texts of the draw passes. They stay valid until it is resized or destroyed.
// agaa::vk::getDrawPasses and agaa::gl::getDrawPasses also return formats and objects of the graphics API.
[[nodiscard]] inline Result<std::vector<AgaaDrawPass>> getDrawPasses(AgaaView view) {
    return detail::list<uint32_t>(init<AgaaDrawPass>(), [&](uint32_t* count, AgaaDrawPass* elements) {
        return agaaGetDrawPasses(view, count, elements);
    });
}

// pass   Index of the draw pass in getDrawPasses.
[[nodiscard]] inline Result<std::vector<AgaaGlslResource>> getGlslResources(AgaaView view, uint32_t pass) {
    return detail::list<uint32_t>(AgaaGlslResource{}, [&](uint32_t* count, AgaaGlslResource* elements) {
        return agaaGetGlslResources(view, pass, count, elements);
    });
}

// The view owns the surface. agaa::vk::getSurface and agaa::gl::getSurface also return its handles.
[[nodiscard]] inline Result<AgaaSurface> getSurface(AgaaView view, const char* name) noexcept {
    return detail::filled(init<AgaaSurface>(),
                          [&](AgaaSurface* surface) { return agaaGetSurface(view, name, surface); });
}

// AGAA_NOT_READY: no frame has statistics yet.
[[nodiscard]] inline Result<AgaaFrameStatistics> getFrameStatistics(AgaaView view, uint64_t completedFrame) noexcept {
    return detail::filled(init<AgaaFrameStatistics>(), [&](AgaaFrameStatistics* statistics) {
        return agaaGetFrameStatistics(view, completedFrame, statistics);
    });
}

// Fills the caller's struct. AGAA_NOT_READY sets only the bytes, geometryPasses, and the members from variantCount on.
[[nodiscard]] inline AgaaResult getFrameStatistics(AgaaView view, uint64_t completedFrame,
                                                   AgaaFrameStatistics& statistics) noexcept {
    return agaaGetFrameStatistics(view, completedFrame, &statistics);
}

// AGAA_NOT_READY: the device has begun no pass.
[[nodiscard]] inline Result<AgaaBreadcrumbs> getBreadcrumbs(AgaaView view) noexcept {
    return detail::filled(init<AgaaBreadcrumbs>(),
                          [&](AgaaBreadcrumbs* breadcrumbs) { return agaaGetBreadcrumbs(view, breadcrumbs); });
}

// AGAA_NOT_READY: no frame can be validated yet.
[[nodiscard]] inline Result<AgaaFrameValidation> validateFrame(AgaaView view, uint64_t completedFrame) noexcept {
    return detail::filled(init<AgaaFrameValidation>(), [&](AgaaFrameValidation* validation) {
        return agaaValidateFrame(view, completedFrame, validation);
    });
}

// AGAA_NOT_READY: no frame was inspected yet.
[[nodiscard]] inline Result<AgaaFactReport> getFactReport(AgaaView view, uint64_t completedFrame) noexcept {
    return detail::filled(init<AgaaFactReport>(),
                          [&](AgaaFactReport* report) { return agaaGetFactReport(view, completedFrame, report); });
}

// Set the array, its length and the size of its elements. The array must exist until the frame is recorded.
inline void setLights(AgaaFrame& frame, ArrayView<AgaaLight> lights) noexcept {
    frame.lights = lights.data();
    frame.lightCount = lights.count();
    frame.lightSize = static_cast<uint32_t>(sizeof(AgaaLight));
}
inline void setShadows(AgaaFrame& frame, ArrayView<AgaaShadow> shadows) noexcept {
    frame.shadows = shadows.data();
    frame.shadowCount = shadows.count();
    frame.shadowSize = static_cast<uint32_t>(sizeof(AgaaShadow));
}

namespace detail {

// Returns the draw passes with a struct Chained, which C receives by pNext. pNext of the results is null, so that they
// can be copied.
template <class Both, class Chained> Result<std::vector<Both>> drawPassesWith(AgaaView view, Chained Both::*member) {
    std::vector<Chained> chained;
    const auto passes = list<uint32_t>(init<AgaaDrawPass>(), [&](uint32_t* count, AgaaDrawPass* elements) {
        if (elements != nullptr) {
            chained.assign(*count, init<Chained>());
            for (uint32_t i = 0; i < *count; ++i)
                elements[i].pNext = &chained[i];
        }
        return agaaGetDrawPasses(view, count, elements);
    });
    if (!passes)
        return Failure{passes.code()};
    std::vector<Both> both(passes->size());
    for (size_t i = 0; i < both.size(); ++i) {
        both[i].pass = (*passes)[i];
        both[i].pass.pNext = nullptr;
        both[i].*member = chained[i];
    }
    return both;
}

template <class Both, class Chained>
Result<Both> surfaceWith(AgaaView view, const char* name, Chained Both::*member) noexcept {
    Both both{init<AgaaSurface>(), init<Chained>()};
    both.surface.pNext = &(both.*member);
    const AgaaResult result = agaaGetSurface(view, name, &both.surface);
    if (result != AGAA_OK)
        return Failure{result};
    both.surface.pNext = nullptr;
    return both;
}

} // namespace detail
} // namespace agaa

#endif // AGAA_CPP_VIEWS_HPP

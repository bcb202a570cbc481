// A host of the tier ids: known triangles, whose materials its functions fetch; and what images are compared by.
#pragma once

#include "stage_host.h"

namespace agaa::test {

constexpr uint32_t drawNumber = 5; // of stage_host.cpp

ViewSettings settingsFor(uint32_t n, uint32_t c, uint32_t tier);

// A view of the tier, with what its function reads.
class IdsView {
public:
    // more: of agaaHostMaterial()'s text. chained: a further struct of the view's, or null.
    // announced: of the triangles; 0: all. flags: of the function.
    IdsView(StageContext& context, ViewSettings settings, const std::vector<Triangle>& triangles, const char* more = "",
            const void* chained = nullptr, uint32_t announced = 0, uint64_t flags = 0);
    StageView& view() { return *view_; }
    harness::Image render(const AgaaLight& light = sun(), const AgaaShadow* shadow = nullptr);

private:
    StorageSet set_;
    std::string text_;
    AgaaFetchFunction function_ = AGAA_FETCH_FUNCTION_INIT;
    std::unique_ptr<StageView> view_;
};

// The same frame by a view of another tier.
harness::Image drawn(StageView& view, const std::vector<Triangle>& triangles);

struct Difference {
    double psnr = 0;    // of tone-mapped values, peak 1
    double farPixels = 0; // share of pixels with a channel more than 24/255 off
};
Difference compare(const harness::Image& a, const harness::Image& b);

} // namespace agaa::test

// A host of the tier ids: known triangles, whose materials its functions fetch; and what images are
// compared by.
#pragma once

#include "fetch_text.h"
#include "stage_host.h"

namespace agaa::test {

ViewSettings settingsFor(uint32_t n, uint32_t c, uint32_t tier);

// A view of the tier, with what its function reads.
class IdsView {
public:
    // Of the shot its triangles and what it says of the tier ids.
    IdsView(StageContext& context, ViewSettings settings, const Shot& shot);
    StageView& view() { return *view_; }
    void setTriangles(const std::vector<Triangle>& triangles); // no more than the shot has
    void bind(AgaaVkFrame& vk) const { vk.functionSet = (uint64_t)set_.get(); }
    void render(const AgaaFrame& frame);
    harness::Image render(const AgaaLight& light = sun(), const AgaaShadow* shadow = nullptr);

private:
    StorageSet set_;
    std::string text_;
    AgaaFetchFunction function_;
    std::unique_ptr<StageView> view_;
};

// The same frame by a view of another tier.
harness::Image drawn(StageView& view, const std::vector<Triangle>& triangles);

Difference compare(const harness::Image& a, const harness::Image& b);

} // namespace agaa::test

#include "frame_history.h"

namespace viewer {

void FrameHistory::add(const std::vector<PassTime>& passes) {
    bool hasSamePasses = passes.size() == rows_.size();
    for (size_t i = 0; hasSamePasses && i < passes.size(); ++i)
        hasSamePasses = passes[i].name == rows_[i].name;
    if (!hasSamePasses) {
        rows_.clear();
        for (const PassTime& pass : passes)
            rows_.push_back({pass.name, {}});
    }
    for (size_t i = 0; i < passes.size(); ++i) {
        std::vector<float>& values = rows_[i].milliseconds;
        values.push_back(float(passes[i].milliseconds));
        if (values.size() > length)
            values.erase(values.begin());
    }
}

} // namespace viewer

// Milliseconds of the newest frames, by pass.
#pragma once

#include <string>
#include <vector>

namespace viewer {

struct PassTime {
    std::string name;
    std::string stage;
    double milliseconds = 0;
};

class FrameHistory {
public:
    static constexpr size_t length = 120; // frames

    struct Row {
        std::string name;
        std::vector<float> milliseconds; // oldest first
        float newest() const { return milliseconds.empty() ? 0 : milliseconds.back(); }
    };

    // A frame with other passes than the one before begins a new history.
    void add(const std::vector<PassTime>& passes);
    void clear() { rows_.clear(); }
    const std::vector<Row>& rows() const { return rows_; }

private:
    std::vector<Row> rows_;
};

} // namespace viewer

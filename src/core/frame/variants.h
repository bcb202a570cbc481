// Compute pipelines of a view by the facts of frames: a variant has those of a plan that leaves effects out.
#pragma once

#include "core/plan/plan.h"

#include <functional>
#include <memory>
#include <mutex>
#include <vector>

namespace agaa {

// A pipeline or program of the graphics API's.
struct Compiled {
    uint64_t program = 0;
    bool isCached = false; // it was not compiled from its text
};

struct Variant {
    AgaaSceneFacts facts{};
    std::vector<Pass> passes;
    std::vector<uint64_t> programs; // by pass; 0 where it is no compute pass
};

struct CompileFigures {
    uint32_t variants = 0;
    uint32_t programs = 0;
    uint32_t cached = 0; // of these
    double milliseconds = 0;
};

// Any thread may call any function at any time; additions wait for each other, and nothing else waits for them. A variant stays
// where it is until all of them are destroyed.
class Variants {
public:
    using Compile = std::function<Compiled(const Pass& pass, size_t index)>;

    explicit Variants(const Plan& base) : base_(base) {} // which lives longer

    // Nothing where there is a variant of the plan's facts. The first is that of the base; others differ from it in nothing but
    // the programs of compute passes. Equal passes share a program. What was compiled stays where compile throws.
    void add(const Plan& plan, const Compile& compile);

    // The smallest that has what these facts have. There is one at least, which has all.
    const Variant& smallest(const AgaaSceneFacts& facts) const;
    // In the order in which they were added.
    std::vector<AgaaSceneFacts> facts() const;
    CompileFigures figures() const;
    // All that were compiled, each once.
    std::vector<uint64_t> programs() const;

private:
    uint64_t find(const Pass& pass, size_t index) const; // 0: none is equal
    Compiled compileTimed(const Compile& compile, const Pass& pass, size_t index);

    const Plan& base_;
    std::mutex adding_;         // held while compiling
    mutable std::mutex mutex_;  // of what follows
    std::vector<std::unique_ptr<const Variant>> variants_;
    std::vector<uint64_t> programs_;
    CompileFigures figures_;
};

// Whether a plan's resources, bindings and passes are those of another, so that programs of both run in one view.
bool isVariantOf(const Plan& plan, const Plan& base);

} // namespace agaa

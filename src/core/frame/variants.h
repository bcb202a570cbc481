// Variants: the compute pipelines of a view for frames whose facts have fewer effects than the view.
#pragma once

#include "core/plan/plan.h"

#include <functional>
#include <memory>
#include <mutex>
#include <vector>

namespace agaa {

// A pipeline or program of the graphics API.
struct Compiled {
    uint64_t program = 0;
    bool isCached = false; // it came from a cache
};

struct Variant {
    AgaaSceneFacts facts{};
    std::vector<Pass> passes;
    std::vector<uint64_t> programs; // by pass; 0 for passes that are not compute passes
};

struct CompileFigures {
    uint32_t variants = 0;
    uint32_t programs = 0;
    uint32_t cached = 0; // of the programs
    double milliseconds = 0;
};

// Any thread may call any function at any time. Additions wait for each other; nothing else waits for them. The address
// of a variant is stable.
class Variants {
public:
    using Compile = std::function<Compiled(const Pass& pass, size_t index)>;

    explicit Variants(const Plan& base) : base_(base) {} // must outlive the variants

    // Adds the variant of the plan's facts, unless there is one. The first one must be that of the base plan; others
    // may differ from it in the programs of compute passes only. Equal passes share a program. If compile throws,
    // programs that were compiled before are kept.
    void add(const Plan& plan, const Compile& compile);

    // Returns the variant with the fewest effects that has all effects of the facts. The first variant has all.
    const Variant& smallest(const AgaaSceneFacts& facts) const;
    // Returns the facts of the variants in the order in which they were added.
    std::vector<AgaaSceneFacts> facts() const;
    CompileFigures figures() const;
    // Returns each compiled program once.
    std::vector<uint64_t> programs() const;

private:
    uint64_t find(const Pass& pass, size_t index) const; // 0: no program is equal
    Compiled compileTimed(const Compile& compile, const Pass& pass, size_t index);

    const Plan& base_;
    std::mutex adding_;        // locked during an addition
    mutable std::mutex mutex_; // guards the members below
    std::vector<std::unique_ptr<const Variant>> variants_;
    std::vector<uint64_t> programs_;
    CompileFigures figures_;
};

// Returns whether both plans have the same resources, bindings and passes, so that the programs of both run in one
// view.
bool isVariantOf(const Plan& plan, const Plan& base);

} // namespace agaa

#include "core/frame/variants.h"

#include "core/base/error.h"
#include "core/view/facts.h"

#include <algorithm>
#include <chrono>

namespace agaa {

static bool haveEqualPrograms(const Pass& a, const Pass& b) {
    const ComputePart &first = a.compute(), &second = b.compute();
    return a.constants == b.constants && first.shader == second.shader && first.defines == second.defines &&
           first.text == second.text && first.hostCode == second.hostCode &&
           first.hostCodeExtensions == second.hostCodeExtensions;
}

bool isVariantOf(const Plan& plan, const Plan& base) {
    return plan.resources == base.resources &&
           std::ranges::equal(plan.passes, base.passes, [](const Pass& a, const Pass& b) {
               return a.name == b.name && a.kind() == b.kind() && a.bindings == b.bindings &&
                      (a.kind() != PassKind::Compute || a.compute().dispatch == b.compute().dispatch);
           });
}

uint64_t Variants::find(const Pass& pass, size_t index) const {
    for (const auto& variant : variants_)
        if (haveEqualPrograms(variant->passes[index], pass))
            return variant->programs[index];
    return 0;
}

Compiled Variants::compileTimed(const Compile& compile, const Pass& pass, size_t index) {
    {
        const std::lock_guard lock(mutex_);
        programs_.reserve(programs_.size() + 1); // so that push_back cannot fail and lose the program
    }
    const auto start = std::chrono::steady_clock::now();
    const Compiled compiled = compile(pass, index);
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    const std::lock_guard lock(mutex_);
    programs_.push_back(compiled.program);
    ++figures_.programs;
    figures_.cached += compiled.isCached;
    figures_.milliseconds += took.count();
    return compiled;
}

void Variants::add(const Plan& plan, const Compile& compile) {
    // Only this thread changes variants_, so that it may read it without mutex_.
    const std::lock_guard adding(adding_);
    const AgaaSceneFacts& facts = plan.view.variantFacts;
    for (const auto& variant : variants_)
        if (isWithin(variant->facts, facts) && isWithin(facts, variant->facts))
            return;
    require(isVariantOf(plan, base_), AGAA_ERROR_INTERNAL, "the plan of a variant has other passes than its view.");
    auto variant = std::make_unique<Variant>();
    variant->facts = facts;
    variant->passes = plan.passes;
    variant->programs.resize(plan.passes.size());
    for (size_t i = 0; i < plan.passes.size(); ++i) {
        const Pass& pass = plan.passes[i];
        if (pass.kind() != PassKind::Compute)
            continue;
        uint64_t& program = variant->programs[i];
        program = find(pass, i);
        if (!program)
            program = compileTimed(compile, pass, i).program;
    }
    const std::lock_guard lock(mutex_);
    variants_.push_back(std::move(variant));
    figures_.variants = uint32_t(variants_.size());
}

const Variant& Variants::smallest(const AgaaSceneFacts& facts) const {
    const std::lock_guard lock(mutex_);
    const Variant* best = variants_.front().get();
    for (const auto& variant : variants_)
        if (isWithin(facts, variant->facts) && extentOf(variant->facts) < extentOf(best->facts))
            best = variant.get();
    return *best;
}

std::vector<AgaaSceneFacts> Variants::facts() const {
    const std::lock_guard lock(mutex_);
    std::vector<AgaaSceneFacts> list;
    for (const auto& variant : variants_)
        list.push_back(variant->facts);
    return list;
}

CompileFigures Variants::figures() const {
    const std::lock_guard lock(mutex_);
    return figures_;
}

std::vector<uint64_t> Variants::programs() const {
    const std::lock_guard lock(mutex_);
    return programs_;
}

} // namespace agaa

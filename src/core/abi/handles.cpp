#include "core/abi/handles.h"

#include "core/base/error.h"
#include "core/base/structs.h"
#include "core/reports/fact_report.h"
#include "core/view/facts.h"

namespace agaa {

static const char* backendName(Backend backend) { return backend == Backend::Vulkan ? "Vulkan" : "OpenGL"; }

void requireBackend(AgaaContext context, Backend backend) {
    require(context, AGAA_ERROR_INVALID_ARGUMENT, "the context is null.");
    if (context->backend != backend)
        fail(AGAA_ERROR_INVALID_ARGUMENT,
             format("the context is of %s, not of %s.", backendName(context->backend), backendName(backend)));
}

void requireBackend(AgaaView view, Backend backend) {
    require(view, AGAA_ERROR_INVALID_ARGUMENT, "the view is null.");
    if (view->owner.backend != backend)
        fail(AGAA_ERROR_INVALID_ARGUMENT,
             format("the view is of %s, not of %s.", backendName(view->owner.backend), backendName(backend)));
}

AgaaResult reportFacts(AgaaView_T& view, uint64_t completedFrame, AgaaFactReport& out) {
    const AgaaResult result = factReport(*view.current, completedFrame, out);
    const bool isNews = result == AGAA_OK && out.contradicted && !view.factWarningLogged;
    if (isNews)
        view.owner.log.write(AGAA_SEVERITY_WARNING, AGAA_OK, out.explanation);
    view.factWarningLogged = view.factWarningLogged || isNews;
    return result;
}

void destroyView(AgaaView view) {
    const HostAllocator allocator = view->owner.allocator;
    destroy(allocator, view->current);
    destroy(allocator, view);
}

void resizeView(AgaaView_T& view, uint32_t width, uint32_t height) {
    require(width > 0 && height > 0, AGAA_ERROR_OUT_OF_RANGE,
            "the view would have no pixels: width and height must be at least 1.");
    ViewSettings settings = view.settings;
    settings.width = width;
    settings.height = height;
    ViewState* recreated = view.current->recreate(settings);
    try {
        for (const AgaaSceneFacts& facts : view.current->variants.facts())
            if (!isWithin(settings.facts, facts)) // the new state already has the variant of the view's own facts
                recreated->prepare(settings, facts);
    } catch (...) {
        destroy(view.owner.allocator, recreated);
        throw;
    }
    recreated->sequence.startAfter(view.current->sequence);
    destroy(view.owner.allocator, view.current);
    view.current = recreated;
    view.settings.width = width;
    view.settings.height = height;
}

void prepareVariants(AgaaView_T& view, uint32_t count, const AgaaSceneFacts* first) {
    require(count == 0 || first, AGAA_ERROR_INVALID_ARGUMENT, "the facts pointer is null.");
    std::vector<AgaaSceneFacts> list;
    for (uint32_t i = 0; i < count; ++i) {
        list.push_back(checkFacts(elementOf(first, i)));
        requireEqualSizes(elementOf(first, i), first);
        checkWithin(list.back(), view.settings.facts, format("facts[%u]", i).c_str());
    }
    for (const AgaaSceneFacts& facts : list)
        view.current->prepare(view.settings, facts);
}

} // namespace agaa

// The handles of views, and what both backends do with them.
#pragma once

#include "core/frame/view_state.h"

// What a host's handle leads to: views are made anew when they are resized.
struct AgaaView_T {
    AgaaView_T(AgaaContext_T& context, agaa::ViewSettings viewSettings, agaa::ViewState* view)
        : owner(context), settings(std::move(viewSettings)), current(view) {}

    AgaaContext_T& owner;
    agaa::ViewSettings settings; // as the host described them
    agaa::ViewState* current;    // never null
    bool factWarningLogged = false;  // the log knows of a contradiction
};

namespace agaa {

// Creates a view and its handle. arguments: of T, after the context.
template <class T, class Context, typename... Arguments>
AgaaView createView(Context& context, ViewSettings settings, Arguments&&... arguments) {
    T* view = construct<T>(context.allocator, context, std::forward<Arguments>(arguments)...);
    try {
        return construct<AgaaView_T>(context.allocator, context, std::move(settings), view);
    } catch (...) {
        destroy(context.allocator, static_cast<ViewState*>(view));
        throw;
    }
}
void destroyView(AgaaView view);
// Tells the log of the view's first contradiction.
AgaaResult reportFacts(AgaaView_T& view, uint64_t completedFrame, AgaaFactReport& out);
// Leaves the view as it was where it fails.
void resizeView(AgaaView_T& view, uint32_t width, uint32_t height);
// Compiles variants; elements that are not valid compile nothing.
void prepareVariants(AgaaView_T& view, uint32_t count, const AgaaSceneFacts* facts);

inline Log logOf(AgaaContext context) { return context ? context->log : Log(); }
inline Log logOf(AgaaView view) { return view ? view->owner.log : Log(); }

// Refuses null and handles of another backend.
void requireBackend(AgaaContext context, Backend backend);
void requireBackend(AgaaView view, Backend backend);

} // namespace agaa

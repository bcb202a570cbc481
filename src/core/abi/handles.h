// View handles, and the operations on them that both backends share.
#pragma once

#include "core/frame/view_state.h"

// The object behind a view handle. Resizing replaces its ViewState.
struct AgaaView_T {
    AgaaView_T(AgaaContext_T& context, agaa::ViewSettings viewSettings, agaa::ViewState* view)
        : owner(context), settings(std::move(viewSettings)), current(view) {}

    AgaaContext_T& owner;
    agaa::ViewSettings settings;    // as the host described them
    agaa::ViewState* current;       // never null
    bool factWarningLogged = false; // a contradiction was logged
};

namespace agaa {

// Creates a view and its handle. The arguments follow the context in T's constructor.
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
// Fills the report and logs the first contradiction of the view.
AgaaResult reportFacts(AgaaView_T& view, uint64_t completedFrame, AgaaFactReport& out);
// If it fails, the view is unchanged.
void resizeView(AgaaView_T& view, uint32_t width, uint32_t height);
// Compiles variants. If any element is not valid, nothing is compiled.
void prepareVariants(AgaaView_T& view, uint32_t count, const AgaaSceneFacts* facts);

inline Log logOf(AgaaContext context) { return context ? context->log : Log(); }
inline Log logOf(AgaaView view) { return view ? view->owner.log : Log(); }

// Throws Error for null and for handles of another backend.
void requireBackend(AgaaContext context, Backend backend);
void requireBackend(AgaaView view, Backend backend);

} // namespace agaa

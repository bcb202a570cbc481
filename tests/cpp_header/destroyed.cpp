#include "destroyed.h"

#include <algorithm>
#include <dlfcn.h>

namespace destroyed {

std::vector<void*>& handles() {
    static std::vector<void*> all;
    return all;
}

std::vector<AgaaContext>& refused() {
    static std::vector<AgaaContext> all;
    return all;
}

namespace {

bool isFake(void* handle) { return handle >= fakes && handle < fakes + sizeof fakes; }

template <class Function> Function inLibrary(const char* name) {
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

} // namespace
} // namespace destroyed

AgaaResult agaaDestroyContext(AgaaContext context) {
    const std::vector<AgaaContext>& refused = destroyed::refused();
    if (std::find(refused.begin(), refused.end(), context) != refused.end())
        return AGAA_ERROR_WRONG_ORDER;
    static const auto next = destroyed::inLibrary<decltype(&agaaDestroyContext)>("agaaDestroyContext");
    const AgaaResult result = destroyed::isFake(context) ? AgaaResult(AGAA_OK) : next(context);
    if (result == AGAA_OK)
        destroyed::handles().push_back(context);
    return result;
}

void agaaDestroyView(AgaaView view) {
    static const auto next = destroyed::inLibrary<decltype(&agaaDestroyView)>("agaaDestroyView");
    if (!destroyed::isFake(view))
        next(view);
    destroyed::handles().push_back(view);
}

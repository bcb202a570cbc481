// Creating contexts and views, as tests do that need one call and not a whole host.
#pragma once

#include "device.h"
#include "cases/core/view_parts.h"

#include <map>

namespace agaa::conformance {

using ChangeContext = std::function<void(ContextDescription&)>;

struct ContextRow {
    std::string what; // as a reader of the failure would write it
    AgaaResult expected;
    std::string words;    // of the sentence; may be empty
    ChangeContext change; // of a right description
    bool isSilent = false; // the log itself is wrong: only the result is tested
};

// "agaaVkCreateContext" or "agaaGlCreateContext" of "CreateContext".
std::string apiName(const Device& device, const std::string& function);
// A test of both functions: agaaVk… on Vulkan, agaaGl… on OpenGL.
void addApiCase(Suite& suite, const std::string& function, const std::string& promise, const std::function<void(Test&)>& run);

// Creates a context that must be refused; outContext is unchanged, and no message of the graphics API follows.
void expectContextRefused(Test& test, const ContextRow& row);
void testContextRows(Test& test, const std::vector<ContextRow>& rows);
// Creates a context that must be accepted without errors, and destroys it.
void expectContextAccepted(Test& test, const std::string& what, const ChangeContext& change);

// Descriptions that each API refuses.
std::vector<ContextRow> wrongContexts(); // of AgaaContextDesc
std::vector<ContextRow> wrongVulkanContexts(const Device& device);
std::vector<ContextRow> wrongOpenGlContexts();
// Those of one error.
std::vector<ContextRow> rowsOf(const std::vector<ContextRow>& rows, AgaaResult expected);

// "2 Image, 1 Buffer".
std::string objectsText(const std::map<std::string, int64_t>& objects);

void expectNoMessages(Test& test, const std::string& after);

// A handle that no call returns.
template <class Handle> Handle untouchedHandle() { return reinterpret_cast<Handle>(uintptr_t(0x5A5A5A58)); }

} // namespace agaa::conformance

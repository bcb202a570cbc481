// Creation of contexts and views, for tests that need a single call and no host.
#pragma once

#include "device.h"
#include "cases/core/view_parts.h"

#include <map>

namespace agaa::conformance {

using ChangeContext = std::function<void(ContextDescription&)>;

struct ContextRow {
    std::string what; // name of the call in failures
    AgaaResult expected;
    std::string words;     // part of the sentence; may be empty
    ChangeContext change;  // change of a valid description
    bool isSilent = false; // the log is invalid, so only the result is tested
};

// Returns "agaaVkCreateContext" or "agaaGlCreateContext" for "CreateContext".
std::string apiName(const Device& device, const std::string& function);
// Adds a test of agaaVk… on Vulkan and of agaaGl… on OpenGL.
void addApiCase(Suite& suite, const std::string& function, const std::string& promise,
                const std::function<void(Test&)>& run);

// Creates a context that must be refused. outContext must be unchanged, and the graphics API must not report a message.
void expectContextRefused(Test& test, const ContextRow& row);
void testContextRows(Test& test, const std::vector<ContextRow>& rows);
// Creates a context that must be accepted without errors, and destroys it.
void expectContextAccepted(Test& test, const std::string& what, const ChangeContext& change);

// These functions return descriptions that an API refuses.
std::vector<ContextRow> wrongContexts(); // wrong members of AgaaContextDesc
std::vector<ContextRow> wrongVulkanContexts(const Device& device);
std::vector<ContextRow> wrongOpenGlContexts();
// Returns the rows of one error.
std::vector<ContextRow> rowsOf(const std::vector<ContextRow>& rows, AgaaResult expected);

// Returns for example "2 Image, 1 Buffer".
std::string objectsText(const std::map<std::string, int64_t>& objects);

void expectNoMessages(Test& test, const std::string& after);

// A handle that no call returns.
template <class Handle> Handle untouchedHandle() { return reinterpret_cast<Handle>(uintptr_t(0x5A5A5A58)); }

} // namespace agaa::conformance

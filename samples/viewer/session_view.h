// The parts of a session that its files share.
#pragma once

#include "render_session.h"

#include <set>

namespace viewer {

// A view with the memory that its settings refer to.
struct RenderSession::View {
    View(const OptionSet& options, const harness::RenderArguments& arguments)
        : options(options), arguments(arguments), configuration(arguments.plan) {}

    OptionSet options;
    harness::RenderArguments arguments;
    harness::Configuration configuration;
    harness::RenderSettings settings;
    harness::Renderer* renderer = nullptr;
};

// Returns the options of these names as text.
std::string keyOf(const OptionSet& options, const std::set<std::string>& names);
// Two views of one key have the same device.
std::string deviceKey(const OptionSet& options);

} // namespace viewer

#include "cli/program.h"

#include "cli/arguments.h"
#include "render/messages.h"

#include <cstdio>
#include <exception>
#include <vector>

namespace harness {

bool parseArguments(CLI::App& app, int argc, char** argv) {
    try {
        app.parse(argc, argv);
        return true;
    } catch (const CLI::CallForHelp& help) {
        app.exit(help);
        return false;
    } catch (const CLI::ParseError& error) {
        throw BadArgument(error.what());
    }
}

int runProgram(const char* name, const std::function<void()>& run) {
    try {
        run();
    } catch (const BadArgument& error) {
        std::fprintf(stderr, "%s: %s\n", name, error.what());
        return 2;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s: %s\n", name, error.what());
        return 1;
    }
    const std::vector<ApiMessage> messages = takeLeftoverMessages();
    for (const ApiMessage& message : messages)
        std::fprintf(stderr, "%s: %s: %s\n", name, message.id.c_str(), message.text.c_str());
    return messages.empty() ? 0 : 1;
}

} // namespace harness

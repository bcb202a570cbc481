// The file of --trace, from which tests read the state and the places of buttons.
#pragma once

#include "panels.h"

namespace viewer {

class Trace {
public:
    explicit Trace(std::string path) : path_(std::move(path)) {}
    // Writes the file if its content has changed. It is replaced as a whole.
    void write(const App& app, const Ui& ui);

private:
    std::string path_; // empty: no file
    std::string newest_;
};

} // namespace viewer

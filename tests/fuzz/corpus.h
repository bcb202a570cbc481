// Kept inputs of the targets, and their mutation.
#pragma once

#include "choices.h"

#include <string>
#include <vector>

namespace fuzz {

// Returns the kept inputs of a target in the order of their names.
std::vector<std::string> readCorpus(const std::string& target);

// Changes bytes, words, tokens and lengths of a file.
void mutate(Choices& choices, std::string& text);

} // namespace fuzz

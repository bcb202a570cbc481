// Text of the host in views on OpenGL, which the driver compiles.
#pragma once

#include <functional>
#include <string>

namespace fuzz {

// Creates views with long, deep, unfinished and strange texts. Each is accepted, or refused with one sentence.
void checkGlHostText(const std::function<void(const std::string&)>& report);

} // namespace fuzz

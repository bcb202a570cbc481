// G-buffer layouts of the command line: a built-in name, "reference" or a JSON file
// {"attributes": [{"semantic": "diffuse", "channels": 3, "sampleBits": 8, "aggregateBits": 10,
//                  "encoding": "unorm", "chromaBits": 0, "range": 1}, …]}; custom attributes have "name" and "filter".
#pragma once

#include "agaa_sdk.h"

#include <string>

namespace harness {

// Throws BadArgument if the name is none of these.
AgaaLayout readLayout(const std::string& nameOrFile);

} // namespace harness

// Descriptions of views that every function refuses: the queries, and those that create or resize a view.
#pragma once

#include "view_parts.h"

namespace agaa::conformance {

struct WrongView {
    std::string what; // after "agaaQueryMemory with "
    AgaaResult expected;
    std::string words; // of the sentence; may be empty
    std::function<void(ViewParts&)> spoil;
};

// At least one for each error of agaaVkCreateView that concerns the description, on any device.
const std::vector<WrongView>& wrongViews();

// create: the function under test, with the description and the log of the test. only: an error, or AGAA_OK for all.
void testWrongViews(Test& test, const Device* device, const std::string& function,
                    const std::function<AgaaResult(const ViewParts&, LogRecorder&)>& create, AgaaResult only = AGAA_OK);

} // namespace agaa::conformance

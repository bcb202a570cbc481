// Descriptions of views that every function refuses: the queries, and the functions that create or resize a view.
#pragma once

#include "view_parts.h"

namespace agaa::conformance {

struct WrongView {
    std::string what; // text after "agaaQueryMemory with "
    AgaaResult expected;
    std::string words; // part of the sentence; may be empty
    std::function<void(ViewParts&)> corrupt;
};

// Returns at least one description for each error of agaaVkCreateView that concerns the description, on any device.
const std::vector<WrongView>& wrongViews();

// Tests the function `create` with the wrong views. `only` selects the rows of an error; AGAA_OK selects all rows.
void testWrongViews(Test& test, const Device* device, const std::string& function,
                    const std::function<AgaaResult(const ViewParts&, LogRecorder&)>& create, AgaaResult only = AGAA_OK);

} // namespace agaa::conformance

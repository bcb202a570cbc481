// Names and descriptions of results.
#include "agaa_sdk.h"

namespace {

struct Text {
    const char* name;
    const char* description;
};

// The switch covers the enumeration, so that compilers warn about an enumerator without a text.
Text textOf(AgaaResultCode code) {
    switch (code) {
#define AGAA_ROW(name, description)                                                                                    \
    case name:                                                                                                         \
        return {#name, description};
        AGAA_ROW(AGAA_OK, "success")
        AGAA_ROW(AGAA_NOT_READY, "the result does not exist yet")
        AGAA_ROW(AGAA_ERROR_INVALID_ARGUMENT, "an argument is null or has no valid value")
        AGAA_ROW(AGAA_ERROR_VERSION, "the host uses something that this library does not know")
        AGAA_ROW(AGAA_ERROR_STRUCT, "a struct has the wrong sType or structSize")
        AGAA_ROW(AGAA_ERROR_UNKNOWN_STRUCT, "a pNext chain holds an unknown struct, a struct twice, or does not end")
        AGAA_ROW(AGAA_ERROR_OUT_OF_RANGE, "a value is out of its range")
        AGAA_ROW(AGAA_ERROR_UNSUPPORTED, "the device or this library cannot do what was asked")
        AGAA_ROW(AGAA_ERROR_LAYOUT, "a G-buffer layout is not valid or cannot be packed")
        AGAA_ROW(AGAA_ERROR_TOO_LARGE, "a size exceeds a limit of the device or of 64-bit arithmetic")
        AGAA_ROW(AGAA_ERROR_OUT_OF_MEMORY, "memory could not be allocated")
        AGAA_ROW(AGAA_ERROR_DEVICE, "the graphics API reported an error")
        AGAA_ROW(AGAA_ERROR_CALLBACK, "a host callback reported a failure or returned an invalid value")
        AGAA_ROW(AGAA_ERROR_PARTIAL, "a frame was recorded in part: discard the command buffer")
        AGAA_ROW(AGAA_ERROR_WRONG_ORDER, "the call is not allowed at this point")
        AGAA_ROW(AGAA_ERROR_BUFFER_TOO_SMALL, "the caller's array is too small")
        AGAA_ROW(AGAA_ERROR_INTERNAL, "an error of the library itself")
#undef AGAA_ROW
    case AGAA_RESULT_MAX_ENUM:
        break;
    }
    return {"unknown result", "unknown result"};
}

} // namespace

extern "C" {

const char* AGAA_CALL agaaResultString(AgaaResult result) { return textOf(AgaaResultCode(result)).description; }

const char* AGAA_CALL agaaResultName(AgaaResult result) { return textOf(AgaaResultCode(result)).name; }

} // extern "C"

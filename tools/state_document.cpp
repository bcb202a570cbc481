// Writes docs/state.md from the state table. With --check it compares the file with the table and writes nothing.
// Exit status: 0 on success, 1 if the file cannot be written or is out of date, 2 for wrong arguments.
#include "gl/state_table.h"

#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <string_view>

namespace {

using namespace agaa::gl;

constexpr const char* kBefore = R"(# OpenGL state

<!-- Written by state_document from the table in src/gl/state_*.cpp: change that, then run
     build/bin/state_document docs/state.md -->

A frame changes the state of the host's context. `AgaaGlDeviceDesc::statePolicy` selects how the SDK treats the host's
state:

| Policy | Before each draw callback | When `agaaGlRecordFrame` returns | Cost |
|---|---|---|---|
| `AGAA_GL_STATE_RESTORE` | the listed states have their values on entry | the listed states have their values on entry | a few hundred queries on entry |
| `AGAA_GL_STATE_CALLBACKS` | as `popState` sets it | as `popState` sets it | that of the host's callbacks |
| `AGAA_GL_STATE_NONE` | undefined | undefined | nothing |

With `AGAA_GL_STATE_RESTORE`, "entry" is the entry of the call that records. Changes of a draw callback do not
persist, neither for the next callback nor at return. The SDK also restores the state when a callback or the frame
fails. A frame that is refused changes nothing, whatever the policy. During draw callbacks, the bindings that
`AgaaGlDeviceDesc` names hold the SDK's resources, which the host's shaders read. At return they hold the host's
objects again.

With `AGAA_GL_STATE_CALLBACKS`, the SDK calls `pushState` on entry and after each draw callback. It calls `popState`
before each draw callback and at return. Between the two it leaves the context in any state. After `popState` the SDK
binds its resources at the bindings named in `AgaaGlDeviceDesc`. Before the callback's `pushState`, or when the frame
fails, it restores the host's objects there. Engines that cache their state should use this policy or
`AGAA_GL_STATE_RESTORE`: invalidating the cache afterwards does not always repair it.

## Restored states

States with multiple elements are restored for all elements, or for those that frames use: the texture units and
binding points of the SDK's own passes, and those named in `AgaaGlDeviceDesc`.

)";

constexpr const char* kAfter = R"(
## States that are not restored

- States that frames do not change and that the table therefore omits: matrices, lights, materials and other fixed
  functions, evaluators, feedback, selection, and texture units, binding points and texture targets that the table
  does not list.
- Conditional rendering, queries of `GL_TIME_ELAPSED` and rectangles of `GL_EXT_window_rectangles` must not be active.
  Transform feedback must be paused; otherwise the frame is refused.
- State of objects: the draw buffers of a framebuffer, the attributes of a vertex array, the uniforms of a program.
  The SDK does not change the host's objects, except the output texture. Frames write its contents. While a pass uses
  the texture, its base level is 0 and its swizzle is the identity. If its filter uses mip levels and its storage is
  not immutable, its last level is 0, too. Textures with bindless handles must already have these values, because
  OpenGL refuses to change them.
- Objects that a callback deletes: their bindings are 0 afterwards. A program whose latest link failed is not used
  again.
- A program that the host deletes while it is in use, which is legal. OpenGL drops the program as soon as a frame uses
  another one, and program 0 is in use afterwards. Delete the program after the frame.
- Subroutine uniforms: OpenGL resets them whenever a program is put into use.
- Errors: those that were pending on entry stay pending. Exception: a frame with a texture of a wrong target clears
  and logs them. The host finds errors that OpenGL raises during a frame with `glGetError`.
)";

const char* many(StateArray array) {
    switch (array) {
    case StateArray::Once:
        return "1";
    case StateArray::TextureUnits:
        return "each texture unit that frames use";
    case StateArray::UniformBindings:
        return "each uniform buffer binding that frames use";
    case StateArray::StorageBindings:
        return "each storage buffer binding that frames use";
    case StateArray::ImageUnits:
        return "each image unit that frames use";
    case StateArray::DrawBuffers:
        return "each draw buffer";
    case StateArray::Viewports:
        return "each viewport";
    case StateArray::ClipDistances:
        return "each clip distance";
    case StateArray::SampleMaskWords:
        return "each word of the mask";
    }
    return "";
}

const char* profile(StateProfile profile) {
    switch (profile) {
    case StateProfile::Any:
        return "any";
    case StateProfile::Core:
        return "core";
    case StateProfile::Compatibility:
        return "compatibility";
    }
    return "";
}

std::string codeNames(std::string names) {
    for (size_t comma = names.find(", "); comma != std::string::npos; comma = names.find(", ", comma + 4))
        names.replace(comma, 2, "`, `");
    return '`' + names + '`';
}

std::string document() {
    std::ostringstream out;
    out << kBefore << "| State | Description | Profile | Requires | Elements |\n|---|---|---|---|---|\n";
    for (const StateRow& row : stateTable())
        out << "| " << codeNames(row.name) << " | " << row.description << " | " << profile(row.profile) << " | "
            << (row.need.name == nullptr ? "" : row.need.name) << " | " << many(row.array) << " |\n";
    out << kAfter;
    return out.str();
}

} // namespace

int main(int count, char** arguments) {
    bool check = false;
    const char* path = nullptr;
    for (int i = 1; i < count; ++i) {
        const std::string_view argument = arguments[i];
        if (argument == "--check") {
            check = true;
        } else if (argument.starts_with('-') || path) {
            std::cerr << "state_document does not know the argument \"" << argument
                      << "\"; its arguments are [--check] FILE.\n";
            return 2;
        } else {
            path = arguments[i];
        }
    }
    if (!path) {
        std::cerr << "state_document lacks a file; its arguments are [--check] FILE.\n";
        return 2;
    }
    if (!check) {
        std::ofstream file(path, std::ios::binary);
        file << document();
        return file.flush() ? 0 : 1;
    }
    std::ifstream file(path, std::ios::binary);
    std::ostringstream committed;
    committed << file.rdbuf();
    if (committed.str() == document())
        return 0;
    std::cerr << path << " is out of date: run state_document " << path << '\n';
    return 1;
}

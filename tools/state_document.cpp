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

A frame changes the state of the host's context. What becomes of the host's is chosen when the context is made,
by `AgaaGlDeviceDesc::statePolicy`:

| Policy | Before each draw callback | When `agaaGlRecordFrame` returns | Costs |
|---|---|---|---|
| `AGAA_GL_STATE_RESTORE` | the listed states are as on entry | the listed states are as on entry | a few hundred queries on entry |
| `AGAA_GL_STATE_CALLBACKS` | what `popState` makes of it | what `popState` makes of it | the host's own |
| `AGAA_GL_STATE_NONE` | undefined | undefined | nothing |

With `AGAA_GL_STATE_RESTORE`, "entry" is the entry of the call that records: what a draw callback leaves behind
does not come back, neither for the next callback nor at return. It holds as well when a callback or the frame
fails. A frame that is refused changes nothing, whatever the policy. The bindings that `AgaaGlDeviceDesc` names,
which the host's shaders read, are the SDK's during draw callbacks and the host's again at return.

With `AGAA_GL_STATE_CALLBACKS`, `pushState` is called on entry and after each draw callback, `popState` before each
draw callback and at return; the SDK leaves what lies between in any state. The SDK binds at the places named in
`AgaaGlDeviceDesc` after `popState`, and binds there again what the host had before the callback's `pushState`
is called or the frame fails. Engines that cache what they have set are served best by this or by
`AGAA_GL_STATE_RESTORE`: telling them afterwards that their cache is stale does not always repair it.

## What comes back

States that are repeated come back for all of their elements, or for those that frames use: texture units and
binding points of the SDK's own passes, and those named in `AgaaGlDeviceDesc`.

)";

constexpr const char* kAfter = R"(
## What does not

- States that frames do not change and that the table therefore does not hold: matrices, lights, materials and
  other fixed functions, texture units and binding points beyond those above, texture targets beyond those
  above, evaluators, feedback and selection.
- Conditional rendering, queries of `GL_TIME_ELAPSED` and rectangles of `GL_EXT_window_rectangles`: they must not be
  active. Transform feedback must be paused, or the frame is refused.
- What belongs to objects: the draw buffers of a framebuffer, the attributes of a vertex array, the uniforms of
  a program. The SDK does not touch the host's objects, except the output texture: frames write its contents, and set its
  base level and swizzle to 0 and to the channels in order while a pass uses it, where they are not. If its filter uses mip
  levels and its storage is not immutable, they set its last level to 0 too. Textures with bindless handles must have these
  values already, because OpenGL refuses to change them.
- Objects that a callback deletes: their bindings are 0 afterwards. A program linked anew without success is not
  used again.
- A program that the host has deleted while it is in use, which is legal: OpenGL drops it as soon as a frame uses
  another, and 0 is in use afterwards. Delete it after the frame.
- Subroutine uniforms: OpenGL forgets them whenever a program is put into use.
- Errors: those that were pending on entry stay pending, but for a frame that brings a texture of a wrong target:
  it takes them and tells them to the log. What OpenGL raises in a frame is the host's to find by `glGetError`.
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
    for (size_t comma = names.find(", "); comma != std::string::npos;
         comma = names.find(", ", comma + 4))
        names.replace(comma, 2, "`, `");
    return '`' + names + '`';
}

std::string document() {
    std::ostringstream out;
    out << kBefore << "| State | What | Profile | Needs | How many |\n|---|---|---|---|---|\n";
    for (const StateRow& row : stateTable())
        out << "| " << codeNames(row.name) << " | " << row.description << " | "
            << profile(row.profile) << " | " << (row.need.name == nullptr ? "" : row.need.name)
            << " | " << many(row.array) << " |\n";
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

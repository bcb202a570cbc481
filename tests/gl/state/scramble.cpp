#include "scramble.h"

#include "gl/state_table.h"
#include "scramblers.h"

#include <cstring>

namespace agaa::test {
namespace {

// Capabilities need no scrambler each: the row's parameter is what glEnable takes.
void switchCapability(Scrambling& s) {
    const bool on = s.values.flag();
    if (s.row.array == gl::StateArray::DrawBuffers || s.row.array == gl::StateArray::Viewports)
        (on ? s.gl.Enablei : s.gl.Disablei)(s.row.parameters[0], s.element);
    else
        (on ? s.gl.Enable : s.gl.Disable)(s.row.parameters[0] + s.element);
}

} // namespace

void (*scramblerOf(const gl::StateRow& row))(Scrambling&) {
    for (const gl::StateRow& capability : gl::capabilityRows())
        if (std::strcmp(capability.name, row.name) == 0)
            return switchCapability;
    for (const auto& part : {fixedFunctionScramblers(), bindingScramblers()})
        for (const Scrambler& scrambler : part)
            if (std::strcmp(scrambler.name, row.name) == 0)
                return scrambler.run;
    return nullptr;
}

bool scrambleRow(const gl::StateContext& context, const HostObjects& objects, uint32_t seed, const gl::StateRow& row,
                 uint32_t element) {
    const auto run = scramblerOf(row);
    if (run == nullptr)
        return false;
    const auto index = static_cast<uint32_t>(&row - gl::stateTable().data());
    Scrambling scrambling{context.gl(), objects, context.compatibilityProfile(),
                          row,          element, Values(seed, index, element)};
    run(scrambling);
    return true;
}

void scrambleState(const gl::StateContext& context, const HostObjects& objects, uint32_t seed) {
    for (const gl::StateRow& row : gl::stateTable())
        if (context.has(row))
            for (const uint32_t element : context.elements(row.array))
                scrambleRow(context, objects, seed, row, element);
}

std::vector<StateText> readState(const GladGLContext& gl, const gl::StateScope& scope, bool compatibilityProfile) {
    gl::StateGuard guard(gl, scope, compatibilityProfile);
    guard.capture();
    return describe(guard);
}

std::vector<std::string> differences(const std::vector<StateText>& first, const std::vector<StateText>& second) {
    std::vector<std::string> lines;
    if (first.size() != second.size())
        lines.push_back("not the same states");
    for (size_t i = 0; i < std::min(first.size(), second.size()); ++i)
        if (first[i] != second[i])
            lines.push_back(first[i].name + ": " + first[i].value + ", then " + second[i].value);
    return lines;
}

} // namespace agaa::test

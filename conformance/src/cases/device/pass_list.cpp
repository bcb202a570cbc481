#include "pass_list.h"

#include <map>
#include <memory>

namespace agaa::conformance {

PassList::PassList(Test& test, AgaaView view) {
    const AgaaDrawPass initialPass = AGAA_DRAW_PASS_INIT;
    const AgaaVkDrawPass initialVk = AGAA_VK_DRAW_PASS_INIT;
    const AgaaGlDrawPass initialGl = AGAA_GL_DRAW_PASS_INIT;
    uint32_t count = 0;
    test.requireOk(test.sdk.agaaGetDrawPasses(view, &count, nullptr), "agaaGetDrawPasses");
    passes.assign(count, initialPass);
    vk.assign(count, initialVk);
    gl.assign(count, initialGl);
    for (uint32_t i = 0; i < count; ++i)
        passes[i].pNext = test.device().backend() == Backend::Vulkan ? static_cast<void*>(&vk[i]) : &gl[i];
    test.requireOk(test.sdk.agaaGetDrawPasses(view, &count, passes.data()), "agaaGetDrawPasses");
    test.require(count == passes.size(), "agaaGetDrawPasses changes the number of passes.");
}

void visitView(Test& test, const ScopedContext& context, const ViewDescription& description, const VisitPasses& visit) {
    const BareView view(test, context.get(), description);
    visit(description, PassList(test, view.get()), "\"" + std::string(description.config.technique) + "\"");
}

void forTechniques(Test& test, const VisitPasses& visit) {
    struct Entry {
        std::string technique;
        std::shared_ptr<ViewDescription> description;
        PassList list;
    };
    static std::map<Backend, std::vector<Entry>> listed;
    std::vector<Entry>& entries = listed[test.device().backend()];
    if (entries.empty()) {
        const ScopedContext context(test);
        for (const std::string& technique : techniques(test)) {
            const auto description = std::make_shared<ViewDescription>(&test.device());
            setTechnique(*description, technique, 4);
            visitView(test, context, *description,
                      [&](const ViewDescription&, const PassList& list, const std::string& name) {
                          entries.push_back({name, description, list});
                          for (AgaaDrawPass& pass : entries.back().list.passes)
                              pass.name = pass.name ? "" : nullptr; // the view owns it
                      });
        }
    }
    for (const Entry& entry : entries)
        visit(*entry.description, entry.list, entry.technique);
}

std::string passText(const std::string& technique, const AgaaDrawPass& pass) {
    return "the draw pass " + std::to_string(pass.pass) + " of " + technique;
}

} // namespace agaa::conformance

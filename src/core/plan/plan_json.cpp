// A plan as JSON text. Written by hand: the library links no JSON package, and plans hold only names of
// its own, numbers and sentences.
#include "core/base/names.h"
#include "core/plan/access.h"
#include "core/plan/plan.h"
#include "core/plan/traffic.h"
#include "core/view/lanes.h"

#include <charconv>
#include <cstdio>
#include <set>

namespace agaa {

namespace {

class Writer {
public:
    std::string text;

    void open(char bracket) {
        separate();
        text += bracket;
        first_ = true;
    }
    void close(char bracket) {
        text += bracket;
        first_ = false;
    }
    void key(const char* name) {
        separate();
        quote(name);
        text += ':';
        first_ = true; // the value follows without a comma
    }
    void value(const std::string& string) {
        separate();
        quote(string);
    }
    void value(uint64_t number) {
        separate();
        text += std::to_string(number);
    }
    void value(double number) {
        separate();
        char digits[40]; // std::to_chars: no locale writes a decimal comma
        text.append(digits, std::to_chars(digits, digits + sizeof digits, number).ptr);
    }
    void flag(bool on) {
        separate();
        text += on ? "true" : "false";
    }
    template <typename T> void field(const char* name, const T& v) {
        key(name);
        if constexpr (std::is_same_v<T, bool>)
            flag(v);
        else if constexpr (std::is_floating_point_v<T>)
            value(double(v));
        else if constexpr (std::is_integral_v<T>)
            value(uint64_t(v));
        else
            value(std::string(v));
    }
    void strings(const char* name, const std::vector<std::string>& list) {
        key(name);
        open('[');
        for (const std::string& entry : list)
            value(entry);
        close(']');
    }

private:
    void separate() {
        if (!first_)
            text += ',';
        first_ = false;
    }
    void quote(const std::string& string) {
        text += '"';
        for (char c : string) {
            if (c == '"' || c == '\\')
                text += '\\';
            text += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
        }
        text += '"';
    }
    bool first_ = true;
};

const char* kindName(ResourceKind kind) {
    switch (kind) {
    case ResourceKind::Image:
        return "image";
    case ResourceKind::Buffer:
        return "buffer";
    case ResourceKind::SmallBuffer:
        return "constant";
    case ResourceKind::UploadBuffer:
        return "upload";
    case ResourceKind::ReadbackBuffer:
        return "readback";
    case ResourceKind::Output:
    case ResourceKind::ShadowMap:
        return "host";
    }
    return "unknown";
}

const char* kindName(PassKind kind) {
    switch (kind) {
    case PassKind::HostDraw:
        return "host-draw";
    case PassKind::Compute:
        return "compute";
    case PassKind::Fill:
        return "fill";
    case PassKind::Copy:
        return "copy";
    }
    return "unknown";
}

void writeResource(Writer& w, const Resource& r) {
    w.open('{');
    w.field("name", r.name);
    w.field("kind", kindName(r.kind));
    w.field("format", formatName(r.format));
    w.field("width", r.width);
    w.field("height", r.height);
    w.field("samples", r.samples);
    w.field("layers", r.layers);
    w.field("bytes", r.bytes);
    w.field("copies", r.copies);
    w.field("firstPass", r.firstPass);
    w.field("lastPass", r.lastPass);
    w.close('}');
}

void writePass(Writer& w, const Plan& plan, size_t index) {
    const Pass& pass = plan.passes[index];
    w.open('{');
    w.field("name", pass.name);
    w.field("stage", stageName(pass.stage));
    w.field("kind", kindName(pass.kind()));
    w.field("segment", pass.segment);
    if (pass.kind() == PassKind::Compute) {
        const Dispatch& dispatch = pass.compute().dispatch;
        w.field("shader", pass.compute().shader);
        if (dispatch.kind == DispatchKind::Items)
            w.field("items", dispatch.items);
        if (dispatch.kind == DispatchKind::Indirect)
            w.field("groupsFrom", plan.resources[dispatch.arguments].name);
    }
    for (const Repeat& repeat : plan.repeats)
        if (index >= repeat.firstPass && index <= repeat.lastPass)
            w.field("times", repeat.times);
    for (const bool writes : {false, true}) {
        w.key(writes ? "writes" : "reads");
        w.open('[');
        std::set<ResourceId> named;
        for (const Access& access : accessesOf(pass))
            if ((writes ? access.writes() : access.reads()) && named.insert(access.resource).second)
                w.value(plan.resources[access.resource].name);
        w.close(']');
    }
    w.key("traffic");
    w.open('{');
    for (const auto& [id, bytes] : trafficOf(plan, pass))
        if (bytes > 0)
            w.field(plan.resources[id].name.c_str(), bytes);
    w.close('}');
    const bool isDraw = pass.kind() == PassKind::HostDraw;
    w.strings("extensions", isDraw ? pass.draw().extensions : std::vector<std::string>());
    if (isDraw) {
        w.field("stencilTest", pass.draw().state.stencilTest != 0);
        w.field("readsAttachments", pass.draw().state.readsAttachments != 0);
        w.field("additive", pass.draw().state.additive != 0);
        w.field("colorSamples", pass.draw().state.colorSamples);
        w.field("multicast", pass.draw().state.multicast);
        w.field("sampleLocations", pass.draw().state.sampleLocations != 0);
        w.field("sampleShading", pass.draw().state.sampleShading != 0);
    }
    w.close('}');
}

} // namespace

std::string planToJson(const Plan& plan) {
    Writer w;
    w.open('{');
    w.field("technique", plan.view.technique->name);
    w.field("width", plan.view.width);
    w.field("height", plan.view.height);
    w.field("samples", plan.view.samples);
    w.field("aggregates", plan.view.aggregates);
    w.field("deviceSamples", plan.view.hwSamples);
    w.field("scaleX", plan.view.scaleX);
    w.field("scaleY", plan.view.scaleY);
    w.field("layers", plan.view.layers);
    w.key("tiers");
    w.open('{');
    w.field("visibility", tierName(plan.view.visibilityTier));
    if (plan.view.generationTier != AGAA_TIER_AUTO)
        w.field("generation", tierName(plan.view.generationTier));
    w.close('}');
    if (plan.view.lanes != AGAA_LANES_AUTO)
        w.field("lanes", lanesName(plan.view.lanes));
    w.field("runnable", plan.runnable);
    w.strings("notes", plan.notes);
    w.strings("effects", plan.effects);
    w.key("bytes");
    w.open('{');
    w.field("total", plan.totalBytes());
    w.field("constant", plan.constantBytes());
    w.field("peak", plan.peakBytes());
    w.field("perPixel", plan.bytesPerPixel());
    w.field("perAggregate", plan.bytesPerAggregate);
    w.close('}');
    w.field("geometryPasses", plan.geometryPasses());
    w.key("resources");
    w.open('[');
    for (const Resource& resource : plan.resources)
        writeResource(w, resource);
    w.close(']');
    w.key("passes");
    w.open('[');
    for (size_t i = 0; i < plan.passes.size(); ++i)
        writePass(w, plan, i);
    w.close(']');
    w.close('}');
    return w.text;
}

} // namespace agaa

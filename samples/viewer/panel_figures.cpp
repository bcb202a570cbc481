// Milliseconds by pass, bytes, counters and errors of both views.
#include "panels.h"

#include <imgui.h>

namespace viewer {

namespace {

void row(const char* name, const std::string& a, const std::string& b) {
    ImGui::TableNextRow();
    for (const char* text : {name, a.c_str(), b.c_str()}) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(text);
    }
}

std::string number(const char* format, double value) {
    char text[48];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

// Draws a row of a figure that a view may lack.
template <class Figure> void figureRow(const char* name, const ViewResult& a, const ViewResult& b, Figure figure) {
    row(name, a.image ? figure(a) : "", b.image ? figure(b) : "");
}

template <class Count> void counterRow(const char* name, const ViewResult& a, const ViewResult& b, Count count) {
    figureRow(name, a, b, [&](const ViewResult& view) {
        return view.figures.counters ? count(*view.figures.counters) : std::string();
    });
}

double pixelsOf(const App& app) { return app.imageA() ? double(app.imageA()->pixelCount()) : 1; }

double ratio(uint64_t a, double b) { return b > 0 ? double(a) / b : 0; }

void drawTable(const App& app) {
    const ViewResult &a = app.shown().a, &b = app.shown().b;
    const double pixels = pixelsOf(app);
    const auto kilobytes = [](uint64_t bytes) { return number("%.0f KB", double(bytes) / 1e3); };
    figureRow("frame", a, b, [](const ViewResult& v) { return number("%.1f ms", v.figures.frameMs); });
    figureRow("geometry passes", a, b, [](const ViewResult& v) { return std::to_string(v.figures.geometryPasses); });
    figureRow("bytes per pixel", a, b,
              [](const ViewResult& v) { return number("%.1f", v.figures.memory.bytesPerPixel); });
    figureRow("payload", a, b, [&](const ViewResult& v) { return kilobytes(v.figures.payloadBytes); });
    figureRow("peak", a, b, [&](const ViewResult& v) { return kilobytes(v.figures.peakBytes); });
    figureRow("driver", a, b, [&](const ViewResult& v) {
        return v.figures.driverBytes ? kilobytes(v.figures.driverBytes) : std::string("not reported");
    });
    counterRow("events per pixel", a, b,
               [&](const AgaaCounters& c) { return number("%.3f", ratio(c.shadingEvents, pixels)); });
    counterRow("events, at most", a, b, [](const AgaaCounters& c) { return std::to_string(c.maxEventsPerPixel); });
    counterRow("lights per event", a, b, [](const AgaaCounters& c) {
        return number("%.2f", ratio(c.lightEvaluations, double(c.shadingEvents)));
    });
    counterRow("shadow taps per event", a, b,
               [](const AgaaCounters& c) { return number("%.2f", ratio(c.shadowTaps, double(c.shadingEvents))); });
    counterRow("widened lobes", a, b, [](const AgaaCounters& c) { return std::to_string(c.widenedLobes); });
    counterRow("aggregates", a, b, [](const AgaaCounters& c) { return std::to_string(c.aggregates); });
    counterRow("primitives", a, b, [](const AgaaCounters& c) { return std::to_string(c.primitives); });
    counterRow("materials", a, b, [](const AgaaCounters& c) { return std::to_string(c.materials); });
    counterRow("visible samples", a, b, [](const AgaaCounters& c) { return std::to_string(c.visible); });
    counterRow("uncovered", a, b, [](const AgaaCounters& c) { return std::to_string(c.uncovered); });
    counterRow("ties", a, b, [](const AgaaCounters& c) { return std::to_string(c.ties); });
    counterRow("fragments", a, b, [](const AgaaCounters& c) { return std::to_string(c.fragments); });
    counterRow("lost fragments", a, b, [](const AgaaCounters& c) { return std::to_string(c.lostFragments); });
    const auto error = [](auto member) {
        return [member](const ViewResult& v) { return v.error ? number("%.3g", (*v.error).*member) : std::string(); };
    };
    figureRow("error (mseTm)", a, b, error(&harness::Metrics::mseTm));
    figureRow("FLIP", a, b, error(&harness::Metrics::flip));
    figureRow("PSNR", a, b, error(&harness::Metrics::psnr));
    for (const auto& [stage, tier] : a.figures.plan.tiers) {
        std::string other;
        for (const auto& [otherStage, otherTier] : b.figures.plan.tiers)
            if (otherStage == stage)
                other = otherTier;
        row((stage + " tier").c_str(), tier, other);
    }
}

void drawHistory(const char* title, const FrameHistory& history) {
    if (history.rows().empty() || !ImGui::TreeNodeEx(title, ImGuiTreeNodeFlags_DefaultOpen))
        return;
    float most = 0, sum = 0;
    for (const FrameHistory::Row& pass : history.rows()) {
        sum += pass.newest();
        for (const float value : pass.milliseconds)
            most = std::max(most, value);
    }
    ImGui::Text("all passes %.2f ms", double(sum));
    for (const FrameHistory::Row& pass : history.rows()) {
        const std::string label = "##" + pass.name;
        ImGui::PlotLines(label.c_str(), pass.milliseconds.data(), int(pass.milliseconds.size()), 0, nullptr, 0, most,
                         {100, 18});
        ImGui::SameLine();
        ImGui::Text("%7.2f ms %s", double(pass.newest()), pass.name.c_str());
    }
    ImGui::TreePop();
}

} // namespace

void drawFigures(App& app) {
    const Snapshot& shown = app.shown();
    drawHistory("milliseconds by pass, A", app.historyA());
    if (app.shown().b.image)
        drawHistory("milliseconds by pass, B", app.historyB());
    if (shown.referenceSamples > 0)
        ImGui::TextWrapped("reference: %u samples per pixel, its own error %.2g", shown.referenceSamples,
                           shown.referenceError);
    if (ImGui::BeginTable("figures", 3, ImGuiTableFlags_RowBg)) {
        ImGui::TableSetupColumn("figure", ImGuiTableColumnFlags_WidthFixed, 150);
        ImGui::TableSetupColumn("view A");
        ImGui::TableSetupColumn("view B");
        ImGui::TableHeadersRow();
        drawTable(app);
        ImGui::EndTable();
    }
    for (const std::string& note : shown.notes)
        ImGui::TextWrapped("%s", note.c_str());
}

} // namespace viewer

// Mistakes that the compiler must report. Behind EXPECT stands a part of the report: the message of an assertion, or
// the comment itself, which compilers repeat with the line.
#include "agaa_gl.hpp"
#include "agaa_vk.hpp"

void mistakes(AgaaView handle, agaa::View& view, AgaaFrame& frame);
void mistakes(AgaaView handle, agaa::View& view, AgaaFrame& frame) {
    AgaaConfig config = agaa::init<AgaaConfig>();
    AgaaTemporalFrame temporal = agaa::init<AgaaTemporalFrame>();
    agaa::chain(config, temporal); // EXPECT: A struct may not be chained to the first one.
    AgaaAggregation aggregation = agaa::init<AgaaAggregation>();
    agaa::chain(config, aggregation, aggregation); // EXPECT: A chain holds a struct twice.

    auto throwing = [](const AgaaDrawTarget*) { return AgaaResult(AGAA_OK); };
    agaa::bind(frame.draw, frame.drawUser, throwing); // EXPECT: take the callback's parameters and be noexcept
    agaa::bind(frame.draw, frame.drawUser, [](const AgaaDrawTarget*) noexcept { return AGAA_OK; }); // EXPECT: dangles
    auto log = [](AgaaSeverity, AgaaResult, std::string_view) {};
    agaa::LogSink<decltype(log)> sink(log); // EXPECT: take (AgaaSeverity, AgaaResult, std::string_view) and be noexcept

    static_cast<void>(agaa::init<AgaaDrawTarget>()); // EXPECT: has no defaults
    agaa::View copied(view);                         // EXPECT: owners are not copied
    agaa::View implicit = handle;                    // EXPECT: ownership is explicit
    agaa::getFrameStatistics(handle, 1);             // EXPECT: the result is unused
    agaa::resizeView(handle, 1, 1);                  // EXPECT: the code is unused
}

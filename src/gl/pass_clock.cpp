#include "gl/pass_clock.h"

#include "gl/errors.h"
#include "gl/query_buffer.h"

#include <algorithm>

namespace agaa::gl {

PassClock::PassClock(const Context& context, std::span<const Step> steps, size_t passCount, uint32_t slotCount)
    : context_(context), steps_(steps), passCount_(passCount), hasTime_(steps.size() * slotCount) {
    if (context.timeSource == AGAA_TIME_DEVICE) {
        queries_.resize(2 * hasTime_.size());
        context.gl.CreateQueries(GL_TIMESTAMP, GLsizei(queries_.size()), queries_.data());
        try {
            requireObject(context.gl, *std::min_element(queries_.begin(), queries_.end()), "glCreateQueries");
        } catch (...) {
            context.gl.DeleteQueries(GLsizei(queries_.size()), queries_.data());
            throw;
        }
    } else {
        times_.resize(hasTime_.size());
    }
}

PassClock::~PassClock() { context_.gl.DeleteQueries(GLsizei(queries_.size()), queries_.data()); }

void PassClock::begin(uint32_t slot, size_t step) {
    if (!queries_.empty()) {
        context_.gl.QueryCounter(queries_[2 * index(slot, step)], GL_TIMESTAMP);
        return;
    }
    context_.gl.Finish();
    begin_ = std::chrono::steady_clock::now();
}

void PassClock::end(uint32_t slot, size_t step) {
    hasTime_[index(slot, step)] = true;
    if (!queries_.empty()) {
        context_.gl.QueryCounter(queries_[2 * index(slot, step) + 1], GL_TIMESTAMP);
        return;
    }
    context_.gl.Finish();
    times_[index(slot, step)] =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin_).count();
}

double PassClock::millisecondsOf(size_t index) const {
    if (queries_.empty())
        return times_[index];
    GLuint64 ticks[2] = {0, 0};
    for (size_t i = 0; i < 2; ++i)
        context_.gl.GetQueryObjectui64v(queries_[2 * index + i], GL_QUERY_RESULT, &ticks[i]);
    return millisecondsBetween(ticks[0], ticks[1], context_.timestampBits);
}

std::vector<double> PassClock::milliseconds(uint32_t slot) const {
    const NoQueryBuffer none(context_.gl);
    std::vector<double> times(passCount_);
    for (size_t step = 0; step < steps_.size(); ++step)
        if (hasTime_[index(slot, step)])
            addStepTime(times[steps_[step].pass], millisecondsOf(index(slot, step)));
    return times;
}

} // namespace agaa::gl

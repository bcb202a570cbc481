#include "gl/pass_clock.h"

#include "gl/errors.h"
#include "gl/query_buffer.h"

#include <algorithm>

namespace agaa::gl {

PassClock::PassClock(const Context& context, size_t passCount, uint32_t slotCount)
    : context_(context), passCount_(passCount) {
    if (context.timeSource == AGAA_TIME_DEVICE) {
        queries_.resize(2 * passCount * slotCount);
        context.gl.CreateQueries(GL_TIMESTAMP, GLsizei(queries_.size()), queries_.data());
        try {
            requireObject(context.gl, *std::min_element(queries_.begin(), queries_.end()), "glCreateQueries");
        } catch (...) {
            context.gl.DeleteQueries(GLsizei(queries_.size()), queries_.data());
            throw;
        }
    } else {
        times_.resize(passCount * slotCount);
        begins_.resize(passCount);
    }
}

PassClock::~PassClock() { context_.gl.DeleteQueries(GLsizei(queries_.size()), queries_.data()); }

void PassClock::begin(uint32_t slot, size_t pass) {
    if (!queries_.empty()) {
        context_.gl.QueryCounter(queries_[2 * index(slot, pass)], GL_TIMESTAMP);
        return;
    }
    context_.gl.Finish();
    begins_[pass] = std::chrono::steady_clock::now();
}

void PassClock::end(uint32_t slot, size_t pass) {
    if (!queries_.empty()) {
        context_.gl.QueryCounter(queries_[2 * index(slot, pass) + 1], GL_TIMESTAMP);
        return;
    }
    context_.gl.Finish();
    times_[index(slot, pass)] =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begins_[pass]).count();
}

std::vector<double> PassClock::milliseconds(uint32_t slot) const {
    const NoQueryBuffer none(context_.gl);
    std::vector<double> times;
    for (size_t pass = 0; pass < passCount_; ++pass) {
        if (queries_.empty()) {
            times.push_back(times_[index(slot, pass)]);
            continue;
        }
        GLuint64 ticks[2] = {0, 0};
        for (size_t i = 0; i < 2; ++i)
            context_.gl.GetQueryObjectui64v(queries_[2 * index(slot, pass) + i], GL_QUERY_RESULT, &ticks[i]);
        times.push_back(millisecondsBetween(ticks[0], ticks[1], context_.timestampBits));
    }
    return times;
}

} // namespace agaa::gl

#include "core/frame/temporal.h"

#include "core/base/arguments.h"
#include "core/base/structs.h"
#include "core/frame/frame_checks.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace agaa {

namespace {

// Column-major, as matrices of the API.
using Matrix = std::array<double, 16>;

Matrix multiply(const Matrix& a, const Matrix& b) {
    Matrix product{};
    for (size_t column = 0; column < 4; ++column)
        for (size_t row = 0; row < 4; ++row)
            for (size_t i = 0; i < 4; ++i)
                product[4 * column + row] += a[4 * i + row] * b[4 * column + i];
    return product;
}

Matrix matrixOf(const float (&elements)[16]) {
    Matrix matrix;
    std::copy_n(elements, 16, matrix.begin());
    return matrix;
}

Matrix transposed(const Matrix& m) {
    Matrix out;
    for (size_t i = 0; i < 16; ++i)
        out[i] = m[4 * (i % 4) + i / 4];
    return out;
}

AgaaTemporalFrame temporalOf(const AgaaFrame& frame) {
    return readChained<AgaaTemporalFrame>(&frame).value_or(AgaaTemporalFrame AGAA_TEMPORAL_FRAME_INIT);
}

} // namespace

void checkTemporalFrame(const AgaaFrame& frame) {
    const std::optional<AgaaTemporalFrame> chained = readChained<AgaaTemporalFrame>(&frame);
    require(chained.has_value(), AGAA_ERROR_INVALID_ARGUMENT,
            "the view accumulates frames, and the frame has no AgaaTemporalFrame.");
    checkRange(uint64_t(chained->resets), 0, 1, "AgaaTemporalFrame::resets");
    checkReserved(chained->reserved, "AgaaTemporalFrame::reserved");
    for (const float offset : chained->jitter)
        checkRange(double(offset), -1.0, 1.0, "AgaaTemporalFrame::jitter");
    if (chained->resets)
        return; // the previous camera is not read
    for (const float element : chained->toPreviousView)
        checkRange(double(element), -1e18, 1e18, "AgaaTemporalFrame::toPreviousView");
    const float* m = chained->toPreviousView;
    require(m[3] == 0 && m[7] == 0 && m[11] == 0 && m[15] == 1, AGAA_ERROR_OUT_OF_RANGE,
            "AgaaTemporalFrame::toPreviousView has a last row other than 0, 0, 0, 1; matrices are column-major.");
    checkRotation(m, "AgaaTemporalFrame::toPreviousView");
    checkProjection(chained->previousProjection, "AgaaTemporalFrame::previousProjection");
}

void writeTemporal(const AgaaFrame& frame, const HistoryTurn& turn, FrameConstants& out) {
    const AgaaTemporalFrame temporal = temporalOf(frame);
    std::copy_n(temporal.jitter, 2, out.jitter);
    out.historySlot = turn.slot;
    out.frameStamp = stampOf(frame.frameIndex);
    if (temporal.resets || turn.previousFrame == 0)
        return;
    out.historyStamp = stampOf(turn.previousFrame);
    // The inverse of a rotation is its transpose.
    const Matrix toPrevious = multiply(matrixOf(temporal.toPreviousView), transposed(matrixOf(frame.view)));
    const Matrix clip = multiply(matrixOf(temporal.previousProjection), toPrevious);
    std::ranges::transform(clip, out.previousClip, [](double element) { return float(element); });
    for (size_t i = 0; i < 4; ++i) // the view looks along -z
        out.previousDistance[i] = float(-toPrevious[4 * i + 2]);
}

// The inverse of the digits of a number after the point (Halton 1960), [0, 1).
static double radicalInverse(uint64_t index, uint32_t base) {
    double sum = 0, digit = 1;
    for (; index > 0; index /= base)
        sum += double(index % base) * (digit /= base);
    return sum;
}

std::array<float, 2> jitterOf(uint64_t index, uint32_t count) {
    if (count == 1)
        return {0, 0};
    if (count == 2)
        return index == 0 ? std::array{0.25f, 0.25f} : std::array{-0.25f, -0.25f};
    return {float(radicalInverse(index + 1, 2) - 0.5), float(radicalInverse(index + 1, 3) - 0.5)};
}

} // namespace agaa

// The figures of a numerically hard case (docs/numerics.md): the errors of the naive form and of the form that the SDK
// uses, over the same inputs.
#ifndef AGAA_TESTS_HARD_CASE_FIGURES_H
#define AGAA_TESTS_HARD_CASE_FIGURES_H

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>

#include <gtest/gtest.h>

namespace test_math {

// Keeps the largest error of each form. On destruction it prints one line, which tools/hard_cases.py reads, and fails
// the test if the naive form stays within the bound, if the SDK's form exceeds it, or if there were fewer than 100,000
// inputs. A case has one object of this class in all tests.
class HardCaseFigures {
public:
    // measure   Names the error and its unit. It must not contain quotation marks.
    HardCaseFigures(int number, std::string measure, double bound)
        : number_(number), measure_(std::move(measure)), bound_(bound) {}
    HardCaseFigures(const HardCaseFigures&) = delete;
    HardCaseFigures& operator=(const HardCaseFigures&) = delete;
    ~HardCaseFigures() {
        std::printf("[hard case] {\"case\": %d, \"measure\": \"%s\", \"naive\": %s, \"ours\": %s, \"bound\": %.4g, "
                    "\"inputs\": %llu}\n",
                    number_, measure_.c_str(), text(naive_).c_str(), text(ours_).c_str(), bound_,
                    static_cast<unsigned long long>(inputs_));
        EXPECT_GT(naive_, bound_) << "the naive form does not fail: " << measure_;
        EXPECT_LE(ours_, bound_) << measure_;
        EXPECT_GE(inputs_, 100000u);
    }

    // NaN counts as an infinite error.
    void naive(double error) { naive_ = std::max(naive_, std::isnan(error) ? infinity : error); }
    void ours(double error, std::uint64_t inputs = 1) {
        ours_ = std::max(ours_, std::isnan(error) ? infinity : error);
        inputs_ += inputs;
    }
    void add(double naiveError, double error) {
        naive(naiveError);
        ours(error);
    }
    // Errors relative to the reference, or to `floor` if the reference is smaller.
    void relative(double naiveValue, double value, double reference, double floor = 1e-300) {
        const double scale = std::max(std::abs(reference), floor);
        add(std::abs(naiveValue - reference) / scale, std::abs(value - reference) / scale);
    }
    double worstNaive() const { return naive_; }

private:
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    static std::string text(double value) {
        char buffer[32] = "\"not finite\"";
        if (std::isfinite(value))
            std::snprintf(buffer, sizeof buffer, "%.3g", value);
        return buffer;
    }

    int number_;
    std::string measure_;
    double bound_;
    double naive_ = 0.0, ours_ = 0.0;
    std::uint64_t inputs_ = 0;
};

// Counts inputs that a form gets wrong, for measures that are shares of the inputs.
class Share {
public:
    void add(bool isWrong) {
        ++inputs_;
        wrong_ += isWrong;
    }
    std::uint64_t inputs() const { return inputs_; }
    double value() const { return inputs_ == 0 ? 0.0 : double(wrong_) / double(inputs_); }

private:
    std::uint64_t inputs_ = 0, wrong_ = 0;
};

} // namespace test_math

#endif

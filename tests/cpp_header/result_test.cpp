// Results, views of arrays and callbacks, without the library's objects.
#include "agaa.hpp"

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace {

using agaa::Failure;
using agaa::Result;

// ---- results ------------------------------------------------------------------------------------

static_assert(std::is_nothrow_move_constructible_v<Result<std::string>>);
static_assert(!std::is_copy_constructible_v<Result<agaa::View>>, "A result is copied like its value.");
static_assert(!std::is_constructible_v<Result<std::string>, AgaaResult>, "A code alone is no result: Failure is.");

TEST(Results, WithAValue) {
    Result<std::string> result = std::string("value");
    EXPECT_TRUE(result);
    EXPECT_TRUE(result.hasValue());
    EXPECT_FALSE(result.isError());
    EXPECT_EQ(result.code(), AGAA_OK);
    EXPECT_EQ(result.value(), "value");
    EXPECT_EQ(*result, "value");
    EXPECT_EQ(result->size(), 5u);
    EXPECT_EQ(result.valueOr("other"), "value");
    result->push_back('s');
    EXPECT_EQ(std::as_const(result).value() + *std::as_const(result), "valuesvalues");
    const std::string taken = *std::move(result);
    EXPECT_EQ(taken, "values");
}

TEST(Results, WithAnError) {
    const Result<std::string> result = Failure{AGAA_ERROR_LAYOUT};
    EXPECT_FALSE(result);
    EXPECT_FALSE(result.hasValue());
    EXPECT_TRUE(result.isError());
    EXPECT_EQ(result.code(), AGAA_ERROR_LAYOUT);
    EXPECT_EQ(result.valueOr("other"), "other");
    EXPECT_DEATH(static_cast<void>(result.value()), "hasValue");
    EXPECT_DEATH(static_cast<void>(*result), "hasValue");
    EXPECT_DEATH(static_cast<void>(result->size()), "hasValue");
    EXPECT_DEATH(static_cast<void>(Result<int>(Failure{AGAA_ERROR_LAYOUT}).value()), "hasValue");
}

TEST(Results, NotReady) {
    const Result<std::string> result = Failure{AGAA_NOT_READY};
    EXPECT_FALSE(result);
    EXPECT_FALSE(result.isError());
    EXPECT_EQ(result.code(), AGAA_NOT_READY);
    EXPECT_DEATH(static_cast<void>(result.value()), "hasValue");
}

TEST(Results, FailuresHaveACode) { EXPECT_DEATH(static_cast<void>(Result<int>(Failure{AGAA_OK})), "AGAA_OK"); }

TEST(Results, MoveOnlyValues) {
    using Value = std::vector<std::unique_ptr<int>>;
    Result<Value> result = Value(3);
    Result<Value> moved = std::move(result);
    EXPECT_EQ(moved->size(), 3u);
    moved = Failure{AGAA_ERROR_DEVICE};
    EXPECT_EQ(moved.code(), AGAA_ERROR_DEVICE);
    EXPECT_EQ(std::move(moved).valueOr(Value(4)).size(), 4u);
    moved = Value(5);
    EXPECT_EQ(moved.code(), AGAA_OK);
    EXPECT_EQ(std::move(moved).valueOr(Value()).size(), 5u);
}

TEST(Results, Texts) {
    EXPECT_EQ(agaa::resultName(AGAA_ERROR_LAYOUT), "AGAA_ERROR_LAYOUT");
    EXPECT_EQ(agaa::resultString(AGAA_ERROR_LAYOUT), agaaResultString(AGAA_ERROR_LAYOUT));
    EXPECT_EQ(agaa::resultName(-99), "unknown result");
    EXPECT_TRUE(agaa::isError(AGAA_ERROR_INTERNAL));
    EXPECT_FALSE(agaa::isError(AGAA_OK) || agaa::isError(AGAA_NOT_READY));
    EXPECT_EQ(agaa::getVersion(), agaa::headerVersion);
    EXPECT_EQ(agaa::headerVersion, AGAA_HEADER_VERSION);
}

// ---- views of arrays ----------------------------------------------------------------------------

uint32_t sum(agaa::ArrayView<uint32_t> view) {
    uint32_t total = 0;
    for (const uint32_t element : view)
        total += element;
    return total + 100 * view.count();
}

TEST(ArrayViews, OfEveryArray) {
    const uint32_t array[] = {1, 2};
    std::vector<uint32_t> vector{1, 2, 3};
    EXPECT_EQ(sum(array), 203u);
    EXPECT_EQ(sum(vector), 306u);
    EXPECT_EQ(sum(std::array<uint32_t, 1>{7}), 107u);
    EXPECT_EQ(sum({vector.data() + 1, 1}), 102u);
    EXPECT_EQ(sum({}), 0u);
    EXPECT_TRUE(agaa::ArrayView<uint32_t>().empty());
    EXPECT_EQ(agaa::ArrayView<uint32_t>(vector)[2], 3u);
    EXPECT_DEATH(static_cast<void>(agaa::ArrayView<uint32_t>(vector)[3]), "index");
}
static_assert(!std::is_constructible_v<agaa::ArrayView<uint32_t>, std::vector<int>>);
static_assert(!std::is_constructible_v<agaa::ArrayView<uint32_t>, uint32_t>);

TEST(Texts, EndAtTheirZeroOrWithTheArray) {
    const char some[8] = "abc";
    const char full[3] = {'a', 'b', 'c'};
    EXPECT_EQ(agaa::text(some), "abc");
    EXPECT_EQ(agaa::text(full), "abc");
}

// ---- callbacks ----------------------------------------------------------------------------------

TEST(Callbacks, CallTheObject) {
    AgaaFrame frame = agaa::init<AgaaFrame>();
    uint32_t calls = 0;
    auto draw = [&](const AgaaDrawTarget* target) noexcept {
        calls += target->pass;
        return AgaaResult(AGAA_ERROR_CALLBACK);
    };
    agaa::bind(frame.draw, frame.drawUser, draw);
    EXPECT_EQ(frame.drawUser, &draw);
    AgaaDrawTarget target{};
    target.pass = 3;
    EXPECT_EQ(frame.draw(frame.drawUser, &target), AGAA_ERROR_CALLBACK);
    EXPECT_EQ(calls, 3u);
}

TEST(Callbacks, ShareAnObjectWithSeveralOperators) {
    struct Memory {
        size_t allocated = 0, freed = 0;
        void* operator()(size_t size, size_t) noexcept {
            allocated += size;
            return this;
        }
        void operator()(void* memory) noexcept { freed += memory == this; }
    } memory;
    AgaaContextDesc desc = agaa::init<AgaaContextDesc>();
    agaa::bind(desc.allocate, desc.allocateUser, memory);
    agaa::bind(desc.free, desc.allocateUser, memory);
    desc.free(desc.allocateUser, desc.allocate(desc.allocateUser, 16, 8));
    EXPECT_EQ(memory.allocated, 16u);
    EXPECT_EQ(memory.freed, 1u);
}

TEST(Callbacks, ConstantObjects) {
    struct Answer {
        AgaaResult operator()(const AgaaDrawTarget*) const noexcept { return AGAA_NOT_READY; }
    };
    static const Answer answer;
    AgaaFrame frame = agaa::init<AgaaFrame>();
    agaa::bind(frame.draw, frame.drawUser, answer);
    EXPECT_EQ(frame.draw(frame.drawUser, nullptr), AGAA_NOT_READY);
}

TEST(LogSinks, ReceiveMessages) {
    std::string received;
    agaa::LogSink sink([&](AgaaSeverity severity, AgaaResult code, std::string_view message) noexcept {
        received += std::to_string(severity) + " " + std::to_string(code) + " " + std::string(message) + "\n";
    });
    const AgaaLog& log = *sink.get();
    EXPECT_EQ(log.sType, AGAA_STRUCTURE_TYPE_LOG);
    log.callback(log.user, AGAA_SEVERITY_WARNING, AGAA_OK, "text");
    EXPECT_EQ(received, "1 0 text\n");
    static_assert(!std::is_copy_constructible_v<decltype(sink)> && !std::is_move_constructible_v<decltype(sink)>);
}

} // namespace

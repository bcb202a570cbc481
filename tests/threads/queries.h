// Queries that need no context, which run on threads of their own beside those of contexts.
#pragma once

#include <atomic>
#include <thread>
#include <vector>

namespace agaa::test {

// Repeats queries on two threads until it is destroyed. Each result must equal that of the first call.
class ConcurrentQueries {
public:
    ConcurrentQueries();
    ~ConcurrentQueries();
    ConcurrentQueries(const ConcurrentQueries&) = delete;
    ConcurrentQueries& operator=(const ConcurrentQueries&) = delete;

private:
    std::atomic<bool> hasEnded_ = false;
    std::atomic<uint32_t> calls_ = 0, wrong_ = 0;
    std::vector<std::thread> threads_;
};

// Runs both functions at the same time and rethrows the first exception of each as a failure of the test.
template <class First, class Second> void runTogether(const First& first, const Second& second);

} // namespace agaa::test

#include <gtest/gtest.h>

namespace agaa::test {

template <class First, class Second> void runTogether(const First& first, const Second& second) {
    std::atomic<int> waiting = 2;
    const auto run = [&](const auto& work) {
        --waiting;
        while (waiting > 0)
            std::this_thread::yield();
        try {
            work();
        } catch (const std::exception& error) {
            ADD_FAILURE() << error.what();
        }
    };
    std::thread one([&] { run(first); }), other([&] { run(second); });
    one.join();
    other.join();
}

} // namespace agaa::test

#include "hard/run.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace harness::hard {

namespace {

// Returns the values of a job that a covering set must show.
std::vector<std::string> valuesOf(const HardJob& job) {
    const HardConfiguration& c = hardConfigurations()[job.configuration];
    const std::string frame = hardFrames()[job.frame].name;
    std::vector<std::string> values = {c.technique + " n=" + std::to_string(c.samples),
                                       c.technique + " c=" + std::to_string(c.aggregates),
                                       c.technique + " tier=" + std::to_string(c.generationTier),
                                       c.technique + " " + job.backend, frame + " " + job.backend};
    if (c.isAccurate)
        values.push_back(c.technique + " accurate");
    return values;
}

} // namespace

std::vector<HardJob> coveringJobs(const std::vector<HardJob>& jobs, uint32_t perPair) {
    std::map<std::pair<size_t, std::string>, std::vector<const HardJob*>> pairs; // by frame and technique
    for (const HardJob& job : jobs)
        pairs[{job.frame, hardConfigurations()[job.configuration].technique}].push_back(&job);
    std::map<std::string, size_t> shown;
    std::vector<HardJob> chosen;
    // The values that were shown least often come next. The first of equal candidates wins.
    const auto rarity = [&shown](const HardJob* job) {
        double sum = 0;
        for (const std::string& value : valuesOf(*job))
            sum += 1.0 / double(1 + shown[value] * shown[value]);
        return sum;
    };
    for (uint32_t round = 0; round < perPair; ++round)
        for (auto& [pair, candidates] : pairs) {
            if (candidates.empty())
                continue;
            auto best = candidates.begin();
            double most = rarity(*best);
            for (auto job = best + 1; job != candidates.end(); ++job)
                if (const double sum = rarity(*job); sum > most + 1e-9) {
                    best = job;
                    most = sum;
                }
            for (const std::string& value : valuesOf(**best))
                ++shown[value];
            chosen.push_back(**best);
            candidates.erase(best);
        }
    std::stable_sort(chosen.begin(), chosen.end(), [](const HardJob& a, const HardJob& b) {
        return std::tie(a.frame, a.backend) < std::tie(b.frame, b.backend);
    });
    return chosen;
}

} // namespace harness::hard

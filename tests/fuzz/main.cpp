// Runs fuzz targets with kept inputs, then with choices or mutations from a seed:
//   agaa-fuzz TARGET RUNS|SECONDSs [SEED [FIRST]]
// Run number i depends on the seed and i only, so SEED and FIRST repeat a finding.
#include "corpus.h"
#include "target.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define AGAA_HAS_ASAN
#endif
#elif defined(__SANITIZE_ADDRESS__)
#define AGAA_HAS_ASAN
#endif
#if defined(AGAA_HAS_ASAN)
extern "C" void __sanitizer_set_death_callback(void (*callback)(void));
#endif

namespace {

struct State {
    const fuzz::Target* target = nullptr;
    uint64_t seed = 1, run = 0, accepted = 0, findings = 0;
    bool isKept = false; // run is the number of a kept input
} state;

#if defined(AGAA_HAS_ASAN)
void reportDeath() {
    fuzz::report("a sanitizer ended the program");
    std::fflush(stdout);
}
#endif

void runSeeded(const std::vector<std::string>& corpus) {
    fuzz::Choices choices(state.seed, state.run);
    if (state.target->choose)
        return state.target->choose(choices);
    std::string text = corpus.empty() ? std::string() : choices.of(corpus);
    fuzz::mutate(choices, text);
    state.target->read(text);
}

void runKept(const std::string& text) {
    fuzz::Choices choices(std::span(reinterpret_cast<const uint8_t*>(text.data()), text.size()));
    if (state.target->choose)
        state.target->choose(choices);
    else
        state.target->read(text);
}

template <class Run> void guarded(const Run& run) {
    try {
        run();
    } catch (const std::exception& error) {
        fuzz::report(std::string("an exception left the call: ") + error.what());
    }
}

} // namespace

void fuzz::report(const std::string& text) {
    ++state.findings;
    if (state.findings <= 20)
        std::printf("%s: %s, run %llu: %s\n", state.target->name,
                    state.isKept ? "kept inputs" : ("seed " + std::to_string(state.seed)).c_str(),
                    static_cast<unsigned long long>(state.run), text.c_str());
}

void fuzz::countAccepted() { ++state.accepted; }

int main(int count, char** arguments) {
    const std::string name = count > 1 ? arguments[1] : "", length = count > 2 ? arguments[2] : "";
    const uint64_t number = std::strtoull(length.c_str(), nullptr, 10);
    for (const fuzz::Target& target : fuzz::targets)
        if (name == target.name)
            state.target = &target;
    if (!state.target || number == 0 || count > 5) {
        std::fprintf(stderr, "usage: agaa-fuzz TARGET RUNS|SECONDSs [SEED [FIRST]]\ntargets:");
        for (const fuzz::Target& target : fuzz::targets)
            std::fprintf(stderr, " %s", target.name);
        std::fprintf(stderr, "\n");
        return 2;
    }
    state.seed = count > 3 ? std::strtoull(arguments[3], nullptr, 10) : 1;
    const uint64_t first = count > 4 ? std::strtoull(arguments[4], nullptr, 10) : 0;
#if defined(AGAA_HAS_ASAN)
    __sanitizer_set_death_callback(reportDeath);
#endif
    const std::vector<std::string> corpus = fuzz::readCorpus(name);
    state.isKept = true;
    if (first == 0)
        for (; state.run < corpus.size(); ++state.run)
            guarded([&] { runKept(corpus[state.run]); });
    const uint64_t kept = state.run;
    state.isKept = false;
    const bool isTimed = length.ends_with('s');
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(isTimed ? number : 0);
    for (state.run = first; isTimed ? std::chrono::steady_clock::now() < end : state.run < first + number; ++state.run)
        guarded([&] { runSeeded(corpus); });
    std::printf("%s: seed %llu, kept inputs %llu, runs %llu, accepted calls %llu, findings %llu\n", name.c_str(),
                static_cast<unsigned long long>(state.seed), static_cast<unsigned long long>(kept),
                static_cast<unsigned long long>(state.run - first), static_cast<unsigned long long>(state.accepted),
                static_cast<unsigned long long>(state.findings));
    return state.findings != 0;
}

#include "viewer_state.h"

#include "scene/shortened.h"

#include <cmath>
#include <fstream>
#include <set>

namespace viewer {

using harness::BadArgument;
using nlohmann::json;

namespace {

constexpr int fileVersion = 1;
constexpr const char* modeNames[] = {"a", "b", "split", "difference"};
constexpr const char* otherNames[] = {"configuration", "reference"};

// Reads the members of one object and refuses members that nobody reads.
class Reader {
public:
    Reader(const json& object, std::string place) : object_(object), place_(std::move(place)) {
        if (!object.is_object())
            throw BadArgument(place_ + " must be a JSON object.");
    }

    const json* find(const char* name) {
        known_.insert(name);
        const auto found = object_.find(name);
        return found == object_.end() ? nullptr : &*found;
    }
    void read(const char* name, bool& value) {
        if (const json* found = find(name)) {
            if (!found->is_boolean())
                fail(name, "it can be true or false");
            value = found->get<bool>();
        }
    }
    void read(const char* name, double& value, double least, double most) {
        if (const json* found = find(name)) {
            if (!found->is_number() || !(found->get<double>() >= least && found->get<double>() <= most))
                fail(name, "it can be a number from " + json(least).dump() + " to " + json(most).dump());
            value = found->get<double>();
        }
    }
    void read(const char* name, uint32_t& value, uint32_t least, uint32_t most) {
        double number = value;
        read(name, number, least, most);
        if (number != std::floor(number))
            fail(name, "it can be a whole number");
        value = uint32_t(number);
    }
    template <class Enum, size_t count> void read(const char* name, Enum& value, const char* const (&names)[count]) {
        const json* found = find(name);
        if (!found)
            return;
        std::string list;
        for (size_t i = 0; i < count; ++i) {
            if (*found == names[i]) {
                value = Enum(i);
                return;
            }
            list += (i ? ", " : "") + std::string(names[i]);
        }
        fail(name, "it can be " + list);
    }
    void finish() const {
        for (const auto& [name, value] : object_.items())
            if (!known_.contains(name))
                throw BadArgument(place_ + " has the unknown member \"" + harness::shortened(name) + "\".");
    }

private:
    [[noreturn]] void fail(const char* name, const std::string& choices) const {
        throw BadArgument(place_ + " has the member \"" + name + "\" with the value " +
                          harness::shortened(object_.at(name).dump()) + "; " + choices + ".");
    }

    const json& object_;
    std::string place_;
    std::set<std::string> known_;
};

void readPath(const json& object, CameraPath& path) {
    Reader reader(object, "The member \"path\" of the state");
    if (const json* cameras = reader.find("cameras")) {
        if (!cameras->is_array())
            throw BadArgument("The cameras of the path must be an array.");
        for (const json& camera : *cameras) {
            if (!camera.is_string())
                throw BadArgument("The cameras of the path must be texts, as --camera has them.");
            harness::parseCamera(camera.get<std::string>()); // for its sentence
            path.cameras.push_back(camera.get<std::string>());
        }
    }
    uint32_t position = uint32_t(path.position);
    reader.read("position", position, 0, uint32_t(path.cameras.size()));
    path.position = position;
    reader.read("playing", path.isPlaying);
    reader.read("loop", path.loops);
    reader.finish();
}

void readGoal(const json& object, Goal& goal) {
    Reader reader(object, "The member \"goal\" of the state");
    reader.read("on", goal.isOn);
    reader.read("maxError", goal.maxError, 0, 1);
    reader.read("maxMs", goal.maxMilliseconds, 0, 1e9);
    reader.read("maxBytes", goal.maxBytes, 0, 1e15);
    reader.read("preferError", goal.prefersError);
    reader.finish();
}

} // namespace

const char* nameOf(Mode mode) { return modeNames[int(mode)]; }

harness::ChooseArguments Goal::limits() const {
    harness::ChooseArguments limits;
    limits.maxError = float(maxError);
    limits.maxMs = float(maxMilliseconds);
    limits.maxBytes = uint64_t(maxBytes);
    limits.prefer = prefersError ? "error" : "time";
    return limits;
}

json ViewerState::toJson() const {
    return {
        {"viewerState", fileVersion},
        {"options", options.toJson()},
        {"otherOptions", other.toJson()},
        {"mode", modeNames[int(mode)]},
        {"compareWith", otherNames[int(compareWith)]},
        {"split", split},
        {"gain", gain},
        {"reference", accumulatesReference},
        {"referenceSamples", referenceSamples},
        {"frozen", isFrozen},
        {"magnifier", showsMagnifier},
        {"fly", flies},
        {"playFrames", playsFrames},
        {"followWindow", followsWindow},
        {"texelSize", texelSize},
        {"goal",
         {{"on", goal.isOn},
          {"maxError", goal.maxError},
          {"maxMs", goal.maxMilliseconds},
          {"maxBytes", goal.maxBytes},
          {"preferError", goal.prefersError}}},
        {"path",
         {{"cameras", path.cameras}, {"position", path.position}, {"playing", path.isPlaying}, {"loop", path.loops}}}};
}

ViewerState ViewerState::fromJson(const json& object) {
    Reader reader(object, "The state");
    const json* version = reader.find("viewerState");
    if (!version || *version != fileVersion)
        throw BadArgument("The state must have the member \"viewerState\" with the value " +
                          std::to_string(fileVersion) + ".");
    ViewerState state;
    if (const json* options = reader.find("options"))
        state.options = OptionSet::fromJson(*options);
    if (const json* options = reader.find("otherOptions"))
        state.other = OptionSet::fromJson(*options);
    reader.read("mode", state.mode, modeNames);
    reader.read("compareWith", state.compareWith, otherNames);
    reader.read("split", state.split, 0, 1);
    reader.read("gain", state.gain, 0, 1e6);
    reader.read("reference", state.accumulatesReference);
    reader.read("referenceSamples", state.referenceSamples, 2, 65536);
    reader.read("frozen", state.isFrozen);
    reader.read("magnifier", state.showsMagnifier);
    reader.read("fly", state.flies);
    reader.read("playFrames", state.playsFrames);
    state.followsWindow = !state.options.has("--size");
    reader.read("followWindow", state.followsWindow);
    reader.read("texelSize", state.texelSize, 1, 32);
    if (const json* goal = reader.find("goal"))
        readGoal(*goal, state.goal);
    if (const json* path = reader.find("path"))
        readPath(*path, state.path);
    reader.finish();
    return state;
}

ViewerState defaultState() {
    ViewerState state;
    state.options.setFlag("--no-validation", true); // validation makes frames several times as slow
    state.other.set("--technique", "ssaa");
    return state;
}

ViewerState readState(const std::filesystem::path& path) {
    std::ifstream file(path);
    if (!file)
        throw BadArgument("The state file \"" + path.string() + "\" cannot be read.");
    json object;
    try {
        object = json::parse(file);
    } catch (const json::exception& error) {
        throw BadArgument("The state file \"" + path.string() + "\" is not JSON (" + harness::shortened(error.what()) +
                          ").");
    }
    try {
        return ViewerState::fromJson(object);
    } catch (const BadArgument& error) {
        throw BadArgument("The state file \"" + path.string() + "\" cannot be used: " + error.what());
    }
}

void writeState(const std::filesystem::path& path, const ViewerState& state) {
    std::ofstream file(path, std::ios::trunc);
    file << state.toJson().dump(2) << '\n';
    file.close();
    if (!file)
        throw BadArgument("The state file \"" + path.string() + "\" cannot be written.");
}

} // namespace viewer

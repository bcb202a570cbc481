// A recorded way of the camera: one camera for each frame.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace viewer {

struct CameraPath {
    std::vector<std::string> cameras; // values of --camera
    size_t position = 0;              // of the frame that is shown
    bool isRecording = false;
    bool isPlaying = false;
    bool loops = false;

    bool operator==(const CameraPath&) const = default;

    // Begins a recording, which replaces the cameras, or ends it.
    void toggleRecording();
    // Begins to play, from the start if the path has ended, or stops.
    void togglePlaying();
    // Keeps the camera of a frame while recording, if it has moved.
    void record(const std::string& camera);
    // Returns the camera of the next frame, or nothing at the end of a path that does not loop, which stops playing.
    std::optional<std::string> next();
};

} // namespace viewer

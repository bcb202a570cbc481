#include "camera_path.h"

namespace viewer {

void CameraPath::toggleRecording() {
    isRecording = !isRecording;
    if (!isRecording)
        return;
    isPlaying = false;
    cameras.clear();
    position = 0;
}

void CameraPath::togglePlaying() {
    isPlaying = !isPlaying && !cameras.empty();
    if (!isPlaying)
        return;
    isRecording = false;
    if (position + 1 >= cameras.size())
        position = cameras.size(); // next() begins anew
}

void CameraPath::record(const std::string& camera) {
    if (!isRecording || (!cameras.empty() && cameras.back() == camera))
        return;
    cameras.push_back(camera);
    position = cameras.size() - 1;
}

std::optional<std::string> CameraPath::next() {
    if (cameras.empty()) {
        isPlaying = false;
        return std::nullopt;
    }
    if (position >= cameras.size() || (loops && position + 1 == cameras.size()))
        position = 0;
    else if (position + 1 < cameras.size())
        ++position;
    else {
        isPlaying = false;
        return std::nullopt;
    }
    return cameras[position];
}

} // namespace viewer

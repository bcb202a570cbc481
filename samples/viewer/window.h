// The window: GLFW with an OpenGL context of EGL, and Dear ImGui.
#pragma once

#include "image/image.h"

#include <glad/gl.h>

#include <string>
#include <utility>
#include <vector>

struct GLFWwindow;

namespace viewer {

struct KeyPress {
    int key = 0; // GLFW_KEY_…
    int modifiers = 0;
};

class Window {
public:
    // Throws std::runtime_error if there is no display or no OpenGL.
    Window(uint32_t width, uint32_t height);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    bool isClosed() const;
    void close();
    // Returns whether the window has pixels. A minimised window has none.
    bool hasPixels() const;
    bool isHeld(int key) const;
    // Waits for events, for a short time only while something moves, and begins a frame of the panels.
    void beginFrame(bool moves);
    // Draws the panels. The frame is shown by present().
    void endFrame();
    void present();
    // Reads what endFrame() has drawn, rows from top to bottom.
    std::vector<harness::Pixel> read(uint32_t& width, uint32_t& height) const;

    // Return the events since the last call.
    std::vector<KeyPress> takeKeys() { return std::exchange(keys_, {}); }
    std::vector<std::string> takeDroppedFiles() { return std::exchange(files_, {}); }

    const GladGLContext& gl() const { return gl_; }
    // Ends the waiting of beginFrame(). Other threads may call it.
    static void wake();

private:
    struct Release {
        int key, code, modifiers;
    };

    void setCallbacks();
    void onKey(int key, int code, int action, int modifiers);

    GLFWwindow* window_ = nullptr;
    GladGLContext gl_{};
    std::vector<KeyPress> keys_;
    bool isKeyPressed_ = false; // since the last frame
    std::vector<Release> releases_;
    std::vector<std::string> files_;
    int freshFrames_ = 3; // to draw without waiting: panels take some frames to settle
};

} // namespace viewer

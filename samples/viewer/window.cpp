#include "window.h"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace viewer {

namespace {

std::string& newestError() {
    static std::string text;
    return text;
}

void keepError(int, const char* text) { newestError() = text; }

[[noreturn]] void fail(const char* what) {
    const std::string reason = newestError().empty() ? "the cause is unknown" : newestError();
    glfwTerminate();
    throw std::runtime_error(std::string(what) + ": " + reason + (reason.ends_with('.') ? "" : "."));
}

} // namespace

Window::Window(uint32_t width, uint32_t height) {
    glfwSetErrorCallback(keepError);
    if (!glfwInit())
        fail("There is no display for a window");
    // The sample engine's context comes from EGL, too. Both are in one process.
    glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_EGL_CONTEXT_API);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    window_ = glfwCreateWindow(int(width), int(height), "AGAA viewer", nullptr, nullptr);
    if (!window_)
        fail("The window cannot be opened");
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
    if (!gladLoadGLContext(&gl_, glfwGetProcAddress))
        fail("The functions of OpenGL could not be loaded");
    glfwSetWindowUserPointer(window_, this);
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr; // the state file is the viewer's only memory
    ImGui::StyleColorsDark();
    ImGui_ImplGlfw_InitForOpenGL(window_, true);
    setCallbacks(); // after Dear ImGui's, which they replace or do not meet
    if (!ImGui_ImplOpenGL3_Init("#version 330"))
        fail("Dear ImGui cannot use OpenGL");
}

Window::~Window() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
    glfwDestroyWindow(window_);
    glfwTerminate();
}

// Dear ImGui reads once a frame which keys are down. Releases wait for the next frame if a key was pressed in this one,
// so that neither a key nor its modifier is lost while frames take long.
void Window::onKey(int key, int code, int action, int modifiers) {
    if (action != GLFW_RELEASE) {
        keys_.push_back({key, modifiers});
        isKeyPressed_ = true;
    } else if (isKeyPressed_) {
        releases_.push_back({key, code, modifiers});
        return;
    }
    ImGui_ImplGlfw_KeyCallback(window_, key, code, action, modifiers);
}

void Window::setCallbacks() {
    glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int code, int action, int modifiers) {
        static_cast<Window*>(glfwGetWindowUserPointer(window))->onKey(key, code, action, modifiers);
    });
    glfwSetDropCallback(window_, [](GLFWwindow* window, int count, const char** paths) {
        Window& self = *static_cast<Window*>(glfwGetWindowUserPointer(window));
        self.files_.insert(self.files_.end(), paths, paths + count);
    });
}

bool Window::isClosed() const { return glfwWindowShouldClose(window_); }

void Window::close() { glfwSetWindowShouldClose(window_, GLFW_TRUE); }

bool Window::hasPixels() const {
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    return width > 0 && height > 0 && !glfwGetWindowAttrib(window_, GLFW_ICONIFIED);
}

bool Window::isHeld(int key) const { return glfwGetKey(window_, key) == GLFW_PRESS; }

void Window::beginFrame(bool moves) {
    isKeyPressed_ = false;
    for (const Release& release : std::exchange(releases_, {}))
        ImGui_ImplGlfw_KeyCallback(window_, release.key, release.code, GLFW_RELEASE, release.modifiers);
    const double timeout = moves || freshFrames_ > 0 ? 1.0 / 60 : 0.25;
    const double start = glfwGetTime();
    glfwWaitEventsTimeout(timeout);
    freshFrames_ = glfwGetTime() - start < 0.9 * timeout ? 3 : std::max(0, freshFrames_ - 1);
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
}

void Window::endFrame() {
    ImGui::Render();
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    gl_.Viewport(0, 0, width, height);
    gl_.ClearColor(0.1f, 0.1f, 0.1f, 1);
    gl_.Clear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void Window::present() { glfwSwapBuffers(window_); }

std::vector<harness::Pixel> Window::read(uint32_t& width, uint32_t& height) const {
    int columns = 0, rows = 0;
    glfwGetFramebufferSize(window_, &columns, &rows);
    width = uint32_t(columns);
    height = uint32_t(rows);
    std::vector<harness::Pixel> pixels(size_t(width) * height);
    gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl_.ReadPixels(0, 0, columns, rows, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
    for (size_t row = 0; row < height / 2; ++row)
        std::swap_ranges(pixels.begin() + ptrdiff_t(row * width), pixels.begin() + ptrdiff_t((row + 1) * width),
                         pixels.begin() + ptrdiff_t((height - 1 - row) * width));
    return pixels;
}

void Window::wake() { glfwPostEmptyEvent(); }

} // namespace viewer

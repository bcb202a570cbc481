#include "gl_interposer.h"

#include "hosts/gl_device.h"

#include <algorithm>
#include <utility>

namespace agaa::conformance {

OpenGlInterposer* OpenGlInterposer::current = nullptr;

namespace {

bool failsNow(const char* function) { return OpenGlInterposer::current && OpenGlInterposer::current->fails(function); }
bool failsVisibly(const char* function) {
    return OpenGlInterposer::current && OpenGlInterposer::current->failsVisibly(function);
}
bool isLostNow() { return OpenGlInterposer::current && OpenGlInterposer::current->countsAsLost(); }
void countNow(const char* kind, int64_t difference) {
    if (OpenGlInterposer::current)
        OpenGlInterposer::current->count(kind, difference);
}

// A name as a template argument.
template <size_t n> struct Name {
    constexpr Name(const char (&from)[n]) { std::copy(from, from + n, text); }
    char text[n];
};

// ---- functions that allocate or compile -----------------------------------------------------------------------

template <Name name, class F> struct Allocating;
template <Name name, class R, class... Arguments> struct Allocating<name, R(APIENTRYP)(Arguments...)> {
    static inline R(APIENTRYP real)(Arguments...) = nullptr;
    static R APIENTRY call(Arguments... arguments) {
        return isLostNow() || failsNow(name.text) ? R() : real(arguments...);
    }
    static R APIENTRY visible(Arguments... arguments) {
        return isLostNow() || failsVisibly(name.text) ? R() : real(arguments...);
    }
    static R APIENTRY losable(Arguments... arguments) { return isLostNow() ? R() : real(arguments...); }
};

// ---- functions that create and delete objects ------------------------------------------------------

// A call that fails returns names of 0.
template <Name kind, Name create_> struct Objects {
    static inline void(APIENTRYP realCreate)(GLsizei, GLuint*) = nullptr;
    static inline void(APIENTRYP realCreateOf)(GLenum, GLsizei, GLuint*) = nullptr;
    static inline void(APIENTRYP realDelete)(GLsizei, const GLuint*) = nullptr;
    static bool fails(GLsizei number, GLuint* names) {
        if (isLostNow())
            return true; // the names stay
        const bool isFailing = number > 0 && failsVisibly(create_.text);
        if (isFailing)
            std::fill_n(names, number, 0u);
        else
            countNow(kind.text, number);
        return isFailing;
    }
    static void APIENTRY create(GLsizei number, GLuint* names) {
        if (!fails(number, names))
            realCreate(number, names);
    }
    static void APIENTRY createOf(GLenum target, GLsizei number, GLuint* names) {
        if (!fails(number, names))
            realCreateOf(target, number, names);
    }
    static void APIENTRY destroy(GLsizei number, const GLuint* names) {
        for (GLsizei i = 0; i < number; ++i)
            countNow(kind.text, names[i] ? -1 : 0);
        realDelete(number, names);
    }
};

template <Name kind, Name create_> struct Program {
    static inline GLuint(APIENTRYP realCreate)() = nullptr;
    static inline GLuint(APIENTRYP realCreateOf)(GLenum) = nullptr;
    static inline void(APIENTRYP realDelete)(GLuint) = nullptr;
    static GLuint APIENTRY create() {
        if (isLostNow() || failsVisibly(create_.text))
            return 0;
        countNow(kind.text, 1);
        return realCreate();
    }
    static GLuint APIENTRY createOf(GLenum type) {
        if (isLostNow() || failsVisibly(create_.text))
            return 0;
        countNow(kind.text, 1);
        return realCreateOf(type);
    }
    static void APIENTRY destroy(GLuint name) {
        countNow(kind.text, name ? -1 : 0);
        realDelete(name);
    }
};

// ---- what the context says of itself ---------------------------------------------------------------

PFNGLGETERRORPROC realError = nullptr;
PFNGLGETSTRINGPROC realString = nullptr;
PFNGLGETSTRINGIPROC realStringI = nullptr;
PFNGLGETINTEGERVPROC realInteger = nullptr;
PFNGLCHECKNAMEDFRAMEBUFFERSTATUSPROC realStatus = nullptr;

PFNGLGETGRAPHICSRESETSTATUSPROC realResetStatus = nullptr;

GLenum APIENTRY getResetStatus() {
    return OpenGlInterposer::current ? std::exchange(OpenGlInterposer::current->resetStatus, 0u) : realResetStatus();
}
GLenum APIENTRY getError() {
    if (isLostNow())
        return GL_CONTEXT_LOST;
    const uint32_t injected = OpenGlInterposer::current ? OpenGlInterposer::current->takeError() : GL_NO_ERROR;
    const GLenum real = realError();
    return injected ? injected : real; // OpenGL keeps the first error, so that later ones are lost
}
const GLubyte* APIENTRY getString(GLenum name) {
    if (isLostNow())
        return nullptr;
    if (name == GL_VERSION && OpenGlInterposer::current && !OpenGlInterposer::current->version.empty())
        return reinterpret_cast<const GLubyte*>(OpenGlInterposer::current->version.c_str());
    return realString(name);
}
const GLubyte* APIENTRY getStringI(GLenum name, GLuint index) {
    if (isLostNow())
        return nullptr;
    const GLubyte* text = realStringI(name, index);
    const bool isHidden = name == GL_EXTENSIONS && text && OpenGlInterposer::current &&
                          OpenGlInterposer::current->hiddenExtension == reinterpret_cast<const char*>(text);
    return isHidden ? reinterpret_cast<const GLubyte*>("GL_AGAA_hidden") : text;
}
void APIENTRY getInteger(GLenum name, GLint* values) {
    if (isLostNow())
        return;
    realInteger(name, values);
    if (name == GL_RESET_NOTIFICATION_STRATEGY && OpenGlInterposer::current && OpenGlInterposer::current->notifiesReset)
        *values = GL_LOSE_CONTEXT_ON_RESET;
    const bool isOther = OpenGlInterposer::current && OpenGlInterposer::current->version.size() > 2;
    if (isOther && name == GL_MAJOR_VERSION)
        *values = OpenGlInterposer::current->version[0] - '0';
    if (isOther && name == GL_MINOR_VERSION)
        *values = OpenGlInterposer::current->version[2] - '0';
}
GLenum APIENTRY checkStatus(GLuint framebuffer, GLenum target) {
    const GLenum status = isLostNow() ? 0 : realStatus(framebuffer, target);
    return OpenGlInterposer::current && !OpenGlInterposer::current->isComplete ? GL_FRAMEBUFFER_UNSUPPORTED : status;
}

// ---- by name ---------------------------------------------------------------------------------------

template <class F> AgaaGlFunction replace(F& real, AgaaGlFunction found, F replacement) {
    real = reinterpret_cast<F>(found);
    return reinterpret_cast<AgaaGlFunction>(replacement);
}

AgaaGlFunction interpose(const std::string& name, AgaaGlFunction found) {
#define AGAA_FAILING(function, Type, replacement)                                                                      \
    if (name == function) {                                                                                            \
        using A = Allocating<function, Type>;                                                                          \
        return replace(A::real, found, A::replacement);                                                                \
    }
#define AGAA_ALLOCATING(function, Type) AGAA_FAILING(function, Type, call)
#define AGAA_VISIBLE(function, Type) AGAA_FAILING(function, Type, visible)
    AGAA_ALLOCATING("glTextureStorage2D", PFNGLTEXTURESTORAGE2DPROC)
    AGAA_ALLOCATING("glTextureStorage3D", PFNGLTEXTURESTORAGE3DPROC)
    AGAA_ALLOCATING("glTextureStorage2DMultisample", PFNGLTEXTURESTORAGE2DMULTISAMPLEPROC)
    AGAA_ALLOCATING("glTexStorage2D", PFNGLTEXSTORAGE2DPROC)
    AGAA_ALLOCATING("glTexStorage3D", PFNGLTEXSTORAGE3DPROC)
    AGAA_ALLOCATING("glTexStorage2DMultisample", PFNGLTEXSTORAGE2DMULTISAMPLEPROC)
    AGAA_ALLOCATING("glNamedBufferData", PFNGLNAMEDBUFFERDATAPROC)
    AGAA_ALLOCATING("glNamedBufferStorage", PFNGLNAMEDBUFFERSTORAGEPROC)
    AGAA_ALLOCATING("glBufferData", PFNGLBUFFERDATAPROC)
    AGAA_ALLOCATING("glBufferStorage", PFNGLBUFFERSTORAGEPROC)
    AGAA_ALLOCATING("glNamedRenderbufferStorage", PFNGLNAMEDRENDERBUFFERSTORAGEPROC)
    AGAA_VISIBLE("glCompileShader", PFNGLCOMPILESHADERPROC)
    AGAA_VISIBLE("glLinkProgram", PFNGLLINKPROGRAMPROC)
    AGAA_VISIBLE("glMapBuffer", PFNGLMAPBUFFERPROC)
    AGAA_VISIBLE("glMapBufferRange", PFNGLMAPBUFFERRANGEPROC)
    AGAA_VISIBLE("glMapNamedBuffer", PFNGLMAPNAMEDBUFFERPROC)
    AGAA_VISIBLE("glMapNamedBufferRange", PFNGLMAPNAMEDBUFFERRANGEPROC)
    AGAA_VISIBLE("glFenceSync", PFNGLFENCESYNCPROC)
#undef AGAA_ALLOCATING
#undef AGAA_VISIBLE
#define AGAA_OBJECTS(kind, real, replacement)                                                                          \
    if (name == "glCreate" kind) {                                                                                     \
        using O = Objects<kind, "glCreate" kind>;                                                                      \
        return replace(O::real, found, O::replacement);                                                                \
    }                                                                                                                  \
    if (name == "glDelete" kind) {                                                                                     \
        using O = Objects<kind, "glCreate" kind>;                                                                      \
        return replace(O::realDelete, found, O::destroy);                                                              \
    }
    AGAA_OBJECTS("Textures", realCreateOf, createOf)
    AGAA_OBJECTS("Queries", realCreateOf, createOf)
    AGAA_OBJECTS("Buffers", realCreate, create)
    AGAA_OBJECTS("Framebuffers", realCreate, create)
    AGAA_OBJECTS("Renderbuffers", realCreate, create)
    AGAA_OBJECTS("Samplers", realCreate, create)
    AGAA_OBJECTS("VertexArrays", realCreate, create)
    AGAA_OBJECTS("ProgramPipelines", realCreate, create)
#undef AGAA_OBJECTS
    using Programs = Program<"Program", "glCreateProgram">;
    using Shaders = Program<"Shader", "glCreateShader">;
    if (name == "glCreateProgram")
        return replace(Programs::realCreate, found, Programs::create);
    if (name == "glDeleteProgram")
        return replace(Programs::realDelete, found, Programs::destroy);
    if (name == "glCreateShader")
        return replace(Shaders::realCreateOf, found, Shaders::createOf);
    if (name == "glDeleteShader")
        return replace(Shaders::realDelete, found, Shaders::destroy);
    if (name == "glGetError")
        return replace(realError, found, getError);
    if (name == "glGetGraphicsResetStatus")
        return replace(realResetStatus, found, getResetStatus);
    if (name == "glGetString")
        return replace(realString, found, getString);
    if (name == "glGetStringi")
        return replace(realStringI, found, getStringI);
    if (name == "glGetIntegerv")
        return replace(realInteger, found, getInteger);
    if (name == "glCheckNamedFramebufferStatus")
        return replace(realStatus, found, checkStatus);
#define AGAA_LOSABLE(function) AGAA_FAILING("gl" #function, decltype(&gl##function), losable)
#include "gl_interposer.inc"
#undef AGAA_LOSABLE
#undef AGAA_FAILING
    return found;
}

} // namespace

OpenGlInterposer::OpenGlInterposer() { current = this; }
OpenGlInterposer::~OpenGlInterposer() { current = nullptr; }

void OpenGlInterposer::chainTo(ContextDescription& description) {
    next_ = description.gl.getProcAddr;
    nextUser_ = description.gl.getProcUser;
    description.gl.getProcAddr = getProcAddr;
    description.gl.getProcUser = this;
}

AgaaGlFunction AGAA_CALL OpenGlInterposer::getProcAddr(void* user, const char* name) {
    const auto& self = *static_cast<const OpenGlInterposer*>(user);
    const AgaaGlFunction found = self.next_(self.nextUser_, name);
    return !found || self.missing == "*" || self.missing == name ? nullptr : interpose(name, found);
}

bool OpenGlInterposer::fails(const char* function) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const bool isFailing = (error_ != 0 || !remaining_) && mustFail(function);
    if (isFailing)
        pending_ = uint32_t(error_);
    return isFailing;
}

bool OpenGlInterposer::failsVisibly(const char* function) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const bool isFailing = mustFail(function);
    if (isFailing)
        pending_ = uint32_t(error_);
    return isFailing;
}

bool OpenGlInterposer::countsAsLost() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return findsLost();
}

uint32_t OpenGlInterposer::takeError() {
    const uint32_t error = pending_;
    pending_ = 0;
    return error;
}

} // namespace agaa::conformance

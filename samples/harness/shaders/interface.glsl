// Definitions that hide differences between the APIs.
#ifdef HARNESS_GL
#define CAMERA_AT binding = 1
#define MOTION_AT binding = 30
#define MATERIAL_AT(n) binding = n
#define CASTER_AT(n) binding = n
#define DRAW_BLOCK uniform struct
#define VERTEX_INDEX gl_VertexID
#define FETCH_UNIFORM_AT binding = 6
#define FETCH_TEXTURE_AT(n) binding = 20 + n
#define PULLED_VERTICES_AT binding = 28 // a literal, because older GLSL has no expressions here
#define PULLED_INDICES_AT binding = 29
#else
#define CAMERA_AT set = 0, binding = 0
#define MOTION_AT set = 0, binding = 1
#define MATERIAL_AT(n) set = 2, binding = n
#define CASTER_AT(n) set = 0, binding = n
#define DRAW_BLOCK layout(push_constant) uniform
#define VERTEX_INDEX gl_VertexIndex
#define FETCH_UNIFORM_AT set = 1, binding = 0
#define FETCH_TEXTURE_AT(n) set = 1, binding = 1 + n
#define PULLED_VERTICES_AT set = 3, binding = 0
#define PULLED_INDICES_AT set = 3, binding = 1
#endif
#define LOCATION(n) layout(location = n)
// Locations between the stages. Older GLSL matches by name.
#if __VERSION__ >= 410
#define VARYING(n) layout(location = n)
#else
#define VARYING(n)
#endif

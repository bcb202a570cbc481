#version 450
// All passes share the vertex shader, because their depths must be equal. Inputs that a fragment shader reads inside
// the primitive are passed twice: Mesa 22.3 displaces plain reads of such inputs, and interpolates them with another w,
// which a constant 1 measures.
layout(push_constant) uniform Draw { mat4 clipFromShading; mat3x4 model; };
layout(location = 0) in vec3 vertex;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv0;
layout(location = 0) out vec3 centrePosition; // shading space: the world's axes, the origin at the eye
layout(location = 1) out vec2 centreUv;
layout(location = 2) centroid out vec4 insidePosition; // w: 1
layout(location = 3) centroid out vec3 insideNormal;
layout(location = 4) centroid out vec2 insideUv;
invariant gl_Position;
void main() {
    centrePosition = vec4(vertex, 1.0) * model;
    insidePosition = vec4(centrePosition, 1.0);
    vec3 x = model[0].xyz, y = model[1].xyz, z = model[2].xyz; // cofactors: the inverse transpose times a factor
    insideNormal = vec3(dot(cross(y, z), normal), dot(cross(z, x), normal), dot(cross(x, y), normal));
    centreUv = insideUv = uv0;
    gl_Position = clipFromShading * vec4(centrePosition, 1.0);
}

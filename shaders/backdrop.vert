#version 330 core
// SPDX-License-Identifier: MIT
// One triangle over the whole picture, at the far end of the depth range.

uniform mat4 world_from_clip;
uniform vec3 eye;

out vec3 v_ray; // from the eye, any length

void main() {
    vec2 corner = vec2((gl_VertexID & 1) * 4 - 1, (gl_VertexID >> 1) * 4 - 1);
    vec4 far = world_from_clip * vec4(corner, 1.0, 1.0);
    v_ray = far.xyz / far.w - eye;
    gl_Position = vec4(corner, 1.0, 1.0);
}

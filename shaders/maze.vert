#version 330 core
// SPDX-License-Identifier: MIT
// The maze in the board frame, m.

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 grain;
layout(location = 3) in vec4 albedo;  // sRGB
layout(location = 4) in vec4 surface; // reflectance, roughness, grain, emission

uniform mat4 clip_from_board;

out vec3 v_position;
out vec3 v_normal;
out vec2 v_grain;
flat out vec3 v_albedo; // linear
flat out vec4 v_surface;

void main() {
    v_position = position;
    v_normal = normal;
    v_grain = grain;
    v_albedo = pow(albedo.rgb, vec3(2.2));
    v_surface = surface;
    gl_Position = clip_from_board * vec4(position, 1.0);
}

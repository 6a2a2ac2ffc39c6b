#version 330 core
// SPDX-License-Identifier: MIT
// A mesh of radius 1, turned, scaled and moved to the ball's place in the board frame.

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 3) in vec4 albedo;  // sRGB
layout(location = 4) in vec4 surface; // reflectance, roughness, grain, emission

uniform mat4 clip_from_board;
uniform mat4 orientation;
uniform vec4 ball; // centre and radius

out vec3 v_position;
out vec3 v_normal;
flat out vec3 v_albedo; // linear
flat out vec4 v_surface;

void main() {
    v_position = ball.xyz + ball.w * (orientation * vec4(position, 0.0)).xyz;
    v_normal = (orientation * vec4(normal, 0.0)).xyz;
    v_albedo = pow(albedo.rgb, vec3(2.2));
    v_surface = surface;
    gl_Position = clip_from_board * vec4(v_position, 1.0);
}

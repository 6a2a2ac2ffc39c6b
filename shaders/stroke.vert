#version 330 core
// SPDX-License-Identifier: MIT
// A line of constant width on the screen: one instance, four corners.

layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in vec4 from_colour;
layout(location = 3) in vec4 to_colour;
layout(location = 4) in vec2 width_and_ends; // logical pixels; 1: round ends

uniform mat4 clip_from_board;
uniform vec2 pixels; // size of the picture
uniform float pixel_ratio;

out vec4 v_colour;
noperspective out vec2 v_place; // pixels along from the start, and across from the middle
flat out float v_length;        // pixels
flat out float v_radius;
flat out float v_round;

void main() {
    vec4 start = clip_from_board * vec4(from, 1.0);
    vec4 end = clip_from_board * vec4(to, 1.0);
    // Clipped in front of the eye before the perspective division.
    const float near = 1e-4;
    if (start.w < near) start = mix(start, end, clamp((near - start.w) / max(end.w - start.w, 1e-9), 0.0, 1.0));
    if (end.w < near) end = mix(end, start, clamp((near - end.w) / max(start.w - end.w, 1e-9), 0.0, 1.0));

    vec2 start_pixel = 0.5 * pixels * start.xy / start.w;
    vec2 end_pixel = 0.5 * pixels * end.xy / end.w;
    vec2 run = end_pixel - start_pixel;
    v_length = length(run);
    vec2 along = v_length > 1e-3 ? run / v_length : vec2(1.0, 0.0);
    v_radius = 0.5 * width_and_ends.x * pixel_ratio;
    v_round = width_and_ends.y;

    bool is_end = (gl_VertexID >> 1) == 1;
    float side = float((gl_VertexID & 1) * 2 - 1);
    float reach = v_radius + 1.0; // a pixel more for the soft edge
    float beyond = v_round * reach * (is_end ? 1.0 : -1.0);
    vec2 offset = along * beyond + vec2(-along.y, along.x) * (side * reach);
    vec4 anchor = is_end ? end : start;
    v_place = vec2((is_end ? v_length : 0.0) + beyond, side * reach);
    v_colour = is_end ? to_colour : from_colour;
    // Depth bias, so that lines on a surface lie in front of it.
    gl_Position = vec4(anchor.xy + offset / (0.5 * pixels) * anchor.w, anchor.z - 2e-4 * anchor.w, anchor.w);
}

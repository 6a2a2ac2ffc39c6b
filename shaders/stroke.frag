#version 330 core
// SPDX-License-Identifier: MIT

in vec4 v_colour;
noperspective in vec2 v_place;
flat in float v_length;
flat in float v_radius;
flat in float v_round;

uniform float opacity;

out vec4 colour;

void main() {
    // Distance from the line, in pixels; without round ends only across.
    float beyond = v_round * (v_place.x - clamp(v_place.x, 0.0, v_length));
    float cover = clamp(v_radius + 0.5 - length(vec2(beyond, v_place.y)), 0.0, 1.0);
    colour = vec4(v_colour.rgb, v_colour.a * cover * opacity);
}

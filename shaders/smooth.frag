#version 330 core
// SPDX-License-Identifier: MIT
// Smooths the steps of edges in a finished picture (fast approximate anti-aliasing, after T. Lottes): where the
// brightness changes, colours are averaged along the edge.

uniform sampler2D picture; // sRGB, filtered linearly

out vec4 colour;

const vec3 kBrightness = vec3(0.299, 0.587, 0.114);
const float kLongest = 4.0; // pixels along an edge

float brightness(ivec2 place) { return dot(texelFetch(picture, place, 0).rgb, kBrightness); }

void main() {
    ivec2 place = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(picture, 0) - 1;
    ivec2 low = max(place - 1, ivec2(0));
    ivec2 high = min(place + 1, last);
    vec3 centre = texelFetch(picture, place, 0).rgb;
    float middle = dot(centre, kBrightness);
    float a = brightness(low);
    float b = brightness(ivec2(high.x, low.y));
    float c = brightness(ivec2(low.x, high.y));
    float d = brightness(high);
    float least = min(middle, min(min(a, b), min(c, d)));
    float most = max(middle, max(max(a, b), max(c, d)));

    // An edge runs across the gradient. The closer it is to an axis, the longer its steps, and the farther apart the samples.
    vec2 along = vec2((a + b) - (c + d), (b + d) - (a + c));
    float shorter = min(abs(along.x), abs(along.y)) + 0.03 * (a + b + c + d) + 0.008;
    along = clamp(along / shorter, -kLongest, kLongest) / vec2(last + 1);

    vec2 here = gl_FragCoord.xy / vec2(last + 1);
    vec3 near = 0.5 * (texture(picture, here - along / 6.0).rgb + texture(picture, here + along / 6.0).rgb);
    vec3 far = 0.5 * (texture(picture, here - along / 2.0).rgb + texture(picture, here + along / 2.0).rgb);
    vec3 both = 0.5 * (near + far);
    float reached = dot(both, kBrightness);
    // Brighter or darker than all neighbours: the far samples have left the edge.
    vec3 smoothed = reached < least || reached > most ? near : both;
    colour = vec4(most - least < max(0.03, 0.1 * most) ? centre : smoothed, 1.0);
}

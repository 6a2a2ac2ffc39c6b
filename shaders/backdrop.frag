#version 330 core
// SPDX-License-Identifier: MIT
// A table that runs into the horizon, with the soft shadow of the board on it. World frame, m.

in vec3 v_ray;

uniform vec3 eye;
uniform vec3 to_light;
uniform vec3 board_centre;
uniform vec3 board_half;
uniform float board_opacity; // 0: there is none
uniform mat4 world_to_board;
uniform float table_height;
uniform vec3 table_colour; // sRGB
uniform vec3 horizon_colour;

out vec4 colour;

// 1 well inside the board's outline, 0 well outside; `place` in the board frame.
float coverage(vec3 place, float softness) {
    vec2 inside = board_half.xy - abs(place.xy - board_centre.xy);
    vec2 covered = smoothstep(-softness, softness, inside);
    return covered.x * covered.y;
}

void main() {
    float reach = length(board_half.xy);
    vec3 surroundings = horizon_colour;
    if (v_ray.z < 0.0) {
        vec3 place = eye + v_ray * ((table_height - eye.z) / v_ray.z);
        // Along the light to the board's plane, and straight up for the sky that the board takes away.
        float clearance = board_centre.z - place.z;
        vec3 lit_from = place + to_light * (clearance / to_light.z);
        float shadow = coverage((world_to_board * vec4(lit_from, 1.0)).xyz, 0.30 * clearance);
        float shade = coverage((world_to_board * vec4(place + vec3(0.0, 0.0, clearance), 1.0)).xyz, 1.1 * clearance);
        float off_centre = length(place.xy - board_centre.xy) / reach;
        float pool = 1.04 - 0.10 * smoothstep(0.3, 3.0, off_centre);
        vec3 table = table_colour * pool * (1.0 - 0.32 * board_opacity * shadow) * (1.0 - 0.30 * board_opacity * shade);
        surroundings = mix(table, horizon_colour, smoothstep(1.5, 7.0, off_centre));
    }
    // Dithering by half a step of colour, against banding; the powers of the plastic number fill the plane evenly.
    float noise = fract(dot(gl_FragCoord.xy, vec2(0.7548776662, 0.5698402910)));
    colour = vec4(surroundings + (noise - 0.5) / 255.0, 1.0);
}

#version 330 core
// SPDX-License-Identifier: MIT
// What maze.frag and ball.frag share. Everything in the board frame; the light is fixed in the world, so that these
// vectors turn against the board when it tilts.

uniform vec3 to_light; // unit vectors
uniform vec3 world_up;
uniform vec3 sky_radiance;
uniform vec3 ground_radiance;
uniform mat4 shadow_from_board;
uniform float shadow_texel; // of the map's width
uniform sampler2DShadow shadow_map;
uniform sampler2D occlusion_map; // mean height around a place, 0..1 of the board's height
uniform vec3 board_minimum;
uniform vec3 board_size;

// 1 in the light, 0 in the maze's shadow.
float lightVisibility(vec3 position, vec3 normal) {
#if QUALITY == 0
    return 1.0;
#else
    // Offset along the normal, so that the surface doesn't shadow itself.
    vec3 place = (shadow_from_board * vec4(position + normal * 4e-4, 1.0)).xyz;
#if QUALITY == 1
    // Four bilinear samples, in a pattern rotated against the texels so that shadow edges don't show them.
    const int count = 4;
    const vec2 kernel[4] = vec2[](vec2(-0.45, -1.1), vec2(1.1, -0.45), vec2(0.45, 1.1), vec2(-1.1, 0.45));
    const float spread = 1.0;
#else
    const int count = 5;
    const vec2 kernel[5] = vec2[](vec2(0.0), vec2(-0.7, -1.7), vec2(1.7, -0.7), vec2(0.7, 1.7), vec2(-1.7, 0.7));
    const float spread = 1.5;
#endif
    float sum = 0.0;
    for (int i = 0; i < count; ++i)
        sum += texture(shadow_map, vec3(place.xy + kernel[i] * (spread * shadow_texel), place.z));
    return sum / float(count);
#endif
}

// 1 under the open sky, less beside walls.
float skyVisibility(vec3 position, vec3 normal) {
    const float reach = 0.006; // m
    vec3 place = (position + normal * (0.5 * reach) - board_minimum) / board_size;
    float above = max(texture(occlusion_map, place.xy).r - place.z, 0.0) * board_size.z;
    return reach / (reach + 2.6 * above);
}

// Light of the surroundings from a direction, or on a surface that faces it.
vec3 skyRadiance(vec3 direction) {
    return mix(ground_radiance, sky_radiance, 0.5 + 0.5 * dot(direction, world_up));
}

// The key light mirrored by a rough surface (GGX), without the Fresnel factor; times the cosine's light.
float highlight(vec3 normal, vec3 to_eye, float roughness) {
    vec3 middle = normalize(to_light + to_eye);
    float alpha = roughness * roughness;
    float alpha_squared = alpha * alpha;
    float normal_middle = max(dot(normal, middle), 0.0);
    float light_middle = max(dot(to_light, middle), 0.1);
    float lobe = normal_middle * normal_middle * (alpha_squared - 1.0) + 1.0;
    return alpha_squared / (4.0 * lobe * lobe * light_middle * light_middle * (roughness + 0.5));
}

// From linear light to sRGB. Tone mapping: 0.7 and more is compressed to below 1.
vec3 display(vec3 radiance) {
    vec3 excess = max(radiance - 0.7, 0.0);
    vec3 shown = min(radiance, 0.7) + 0.3 * excess / (0.3 + excess);
    return pow(shown, vec3(1.0 / 2.2));
}

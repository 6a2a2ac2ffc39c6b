#version 330 core
// SPDX-License-Identifier: MIT
// A lacquered ball: its colours under a clear coat that mirrors the room.

in vec3 v_position;
in vec3 v_normal;
flat in vec3 v_albedo;
flat in vec4 v_surface;

uniform vec3 to_light;
uniform vec3 world_up;
uniform vec3 eye;
uniform vec3 light_radiance;
uniform vec3 ground_radiance;
uniform vec4 tint; // sRGB of a ghost and its opacity; opacity 1: the ball itself

out vec4 colour;

// lighting.frag
float lightVisibility(vec3 position, vec3 normal);
float skyVisibility(vec3 position, vec3 normal);
vec3 skyRadiance(vec3 direction);
float highlight(vec3 normal, vec3 to_eye, float roughness);
vec3 display(vec3 radiance);

// What the coat reflects: floor below, sky above, and the window that the light comes from.
vec3 room(vec3 direction) {
    float height = dot(direction, world_up);
    vec3 surroundings = mix(ground_radiance * 0.8, skyRadiance(direction), smoothstep(-0.15, 0.25, height));
    float window = smoothstep(0.93, 0.955, dot(direction, to_light));
    return surroundings + 9.0 * window * light_radiance;
}

void main() {
    vec3 normal = normalize(v_normal);
    vec3 to_eye = normalize(eye - v_position);
    vec3 ghost = pow(tint.rgb, vec3(2.2));
    vec3 albedo = tint.a < 1.0 ? mix(v_albedo, ghost, 0.8) : v_albedo;

    float cosine = max(dot(normal, to_light), 0.0);
    float visible = lightVisibility(v_position, normal);
    // The lower half faces the floor, which hides the sky from it.
    float open = skyVisibility(v_position, normal) * (0.55 + 0.45 * normal.z);
    vec3 direct = light_radiance * (cosine * visible);
    vec3 ambient = skyRadiance(normal) * open;

    float grazing = 1.0 - max(dot(normal, to_eye), 0.0);
    float reflectance = max(v_surface.x, 0.055);
    float fresnel = reflectance + (1.0 - reflectance) * grazing * grazing * grazing * grazing * grazing;
    vec3 mirrored = room(reflect(-to_eye, normal)) * mix(0.25, 1.0, visible) * mix(open, 1.0, 0.3);
    vec3 radiance = albedo * (direct + ambient) * (1.0 - fresnel) + fresnel * mirrored;
    radiance += reflectance * direct * highlight(normal, to_eye, max(v_surface.y, 0.15));
    // A ghost is translucent in the middle and nearly opaque at its outline.
    colour = vec4(display(radiance), mix(tint.a, 1.0, 0.6 * grazing));
}

#version 330 core
// SPDX-License-Identifier: MIT
// Wood and paint under one key light and a sky.

in vec3 v_position;
in vec3 v_normal;
in vec2 v_grain;
flat in vec3 v_albedo;
flat in vec4 v_surface;

uniform vec4 ball; // centre and radius, board frame
uniform float ball_reach; // m; where its ambient occlusion ends
uniform float light_disc; // tangent of the half angle of the light source
uniform vec3 to_light;
uniform vec3 eye;
uniform vec3 light_radiance;
uniform sampler2D wood_grain;
uniform vec3 beacon;        // centre of the exit, which glows and lights its surroundings; board frame
uniform vec3 beacon_albedo; // sRGB; black: none

out vec4 colour;

// lighting.frag
float lightVisibility(vec3 position, vec3 normal);
float skyVisibility(vec3 position, vec3 normal);
vec3 skyRadiance(vec3 direction);
float highlight(vec3 normal, vec3 to_eye, float roughness);
vec3 display(vec3 radiance);

// 1 in the light, 0 in the ball's shadow, whose penumbra widens with the distance from the ball.
float ballLightVisibility(vec3 position) {
    vec3 to_ball = ball.xyz - position;
    float along = max(dot(to_ball, to_light), 0.0);
    float miss = length(to_ball - along * to_light);
    float blur = light_disc * along + 0.02 * ball.w;
    return along > 0.0 ? smoothstep(-blur, blur, miss - ball.w) : 1.0;
}

// Ambient occlusion by the ball: 1 less the solid angle of a sphere, weighted by the cosine. It fades out to exactly 1 at
// ball_reach, so that only the surroundings of the ball are redrawn when it moves.
float ballSkyVisibility(vec3 position, vec3 normal) {
    vec3 to_ball = ball.xyz - position;
    float distance_squared = max(dot(to_ball, to_ball), ball.w * ball.w);
    float cosine = max(dot(normal, to_ball) * inversesqrt(distance_squared), 0.0);
    float near = max(1.0 - distance_squared / (ball_reach * ball_reach), 0.0);
    return 1.0 - near * cosine * ball.w * ball.w / distance_squared;
}

// Light of the glowing exit on its surroundings.
vec3 beaconLight(vec3 position) {
    const float reach = 0.020; // m
    vec3 away = position - beacon;
    float share = reach * reach / (reach * reach + dot(away, away));
    return 1.5 * share * share * beacon_albedo * beacon_albedo;
}

void main() {
    vec3 normal = normalize(v_normal);
    vec3 to_eye = normalize(eye - v_position);
    float reflectance = v_surface.x;
    float roughness = v_surface.y;

    // One tile of the grain is 16 cm long and 5 cm wide.
    float fibre = texture(wood_grain, v_grain * vec2(6.25, 20.0)).r - 0.5;
    vec3 albedo = v_albedo * (1.0 + v_surface.z * fibre * vec3(0.75, 0.85, 0.95));

    float cosine = max(dot(normal, to_light), 0.0);
    float visible = cosine > 0.0 ? lightVisibility(v_position, normal) * ballLightVisibility(v_position) : 0.0;
    float open = skyVisibility(v_position, normal) * ballSkyVisibility(v_position, normal);
    vec3 direct = light_radiance * (cosine * visible);
    vec3 ambient = skyRadiance(normal) * open;

    float grazing = 1.0 - max(dot(normal, to_eye), 0.0);
    float fresnel = reflectance + (1.0 - roughness) * (1.0 - reflectance) * grazing * grazing * grazing * grazing * grazing;
    vec3 radiance = albedo * (direct + ambient + v_surface.w + beaconLight(v_position));
    radiance += reflectance * direct * highlight(normal, to_eye, roughness) + fresnel * ambient;
    colour = vec4(display(radiance), 1.0);
}

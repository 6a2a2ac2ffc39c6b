#version 330 core
// SPDX-License-Identifier: MIT

layout(location = 0) in vec3 position;

uniform mat4 clip_from_board;

void main() { gl_Position = clip_from_board * vec4(position, 1.0); }

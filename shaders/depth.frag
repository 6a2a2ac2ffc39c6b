#version 330 core
// SPDX-License-Identifier: MIT
// Depth only.

void main() {}

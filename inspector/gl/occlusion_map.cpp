// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/occlusion_map.h"

#include <algorithm>
#include <cstddef>

namespace inspector::gl {

namespace {

constexpr std::size_t kRow = OcclusionMap::kSize;

/// Running mean over 2 radius + 1 values with the given stride; values beyond the ends repeat the end values.
void blurLine(float *values, int count, std::ptrdiff_t stride, int radius, std::vector<float> &scratch) {
    const auto at = [&](int i) { return values[stride * std::clamp(i, 0, count - 1)]; };
    double sum = 0.0;
    for (int i = -radius; i <= radius; ++i) sum += at(i);
    for (int i = 0; i < count; ++i) {
        scratch[i] = static_cast<float>(sum / (2 * radius + 1));
        sum += at(i + radius + 1) - at(i - radius);
    }
    for (int i = 0; i < count; ++i) values[stride * i] = scratch[i];
}

} // namespace

OcclusionMap::OcclusionMap(QOpenGLFunctions_3_3_Core *gl)
    : m_gl(gl) {
    m_gl->glGenTextures(1, &m_texture);
    store(std::vector<float>(kRow * kSize, 0.0F));
    m_gl->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    m_gl->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    m_gl->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    m_gl->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

OcclusionMap::~OcclusionMap() { m_gl->glDeleteTextures(1, &m_texture); }

void OcclusionMap::upload(std::vector<float> heights, int radiusX, int radiusY) {
    std::vector<float> scratch(kSize);
    // Two box filters approximate a Gaussian.
    for (int pass = 0; pass < 2; ++pass) {
        for (int row = 0; row < kSize; ++row) blurLine(&heights[kRow * row], kSize, 1, radiusX, scratch);
        for (int column = 0; column < kSize; ++column) blurLine(&heights[column], kSize, kRow, radiusY, scratch);
    }
    store(heights);
}

void OcclusionMap::store(const std::vector<float> &heights) {
    m_gl->glBindTexture(GL_TEXTURE_2D, m_texture);
    m_gl->glTexImage2D(GL_TEXTURE_2D, 0, GL_R16, kSize, kSize, 0, GL_RED, GL_FLOAT, heights.data());
}

} // namespace inspector::gl

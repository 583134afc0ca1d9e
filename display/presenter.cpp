// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/presenter.h"

namespace povpreview {

namespace {

// The same curve as core/colour.h; the 8 bits of a screen do not show the difference in precision.
constexpr const char* fragment_shader = R"(
uniform sampler2D source;
uniform vec4 place;  // in the window: left, bottom, width, height
out vec4 result;

float encoded(float c) {
    if (!(c > 0.0)) return 0.0;  // not-a-number too
    return c >= 1.0 ? 1.0 : c <= 0.0031308 ? 12.92 * c : 1.055 * pow(c, 1.0 / 2.4) - 0.055;
}

void main() {
    vec2 size = vec2(textureSize(source, 0));
    vec2 texels = size / place.zw;  // for a pixel
    vec2 centre = vec2(gl_FragCoord.x - place.x, place.w - (gl_FragCoord.y - place.y)) * texels;
    vec2 footprint = max(texels, vec2(1.0));
    // Where texels and pixels coincide, rounding must not let a neighbour's weight in.
    vec2 low = centre - 0.5 * footprint + 1e-3, high = centre + 0.5 * footprint - 1e-3;
    ivec2 first = max(ivec2(floor(low)), ivec2(0));
    ivec2 last = min(ivec2(floor(high)), ivec2(size) - 1);
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    for (int y = first.y; y <= last.y; ++y) {
        float h = min(high.y, float(y + 1)) - max(low.y, float(y));
        for (int x = first.x; x <= last.x; ++x) {
            float w = min(high.x, float(x + 1)) - max(low.x, float(x));
            sum += w * h * texelFetch(source, ivec2(x, y), 0).rgb;
            weights += w * h;
        }
    }
    vec3 linear = sum / weights;
    result = vec4(encoded(linear.r), encoded(linear.g), encoded(linear.b), 1.0);
})";

}  // namespace

Presenter::Presenter(GlContext& context)
    : gl_(context.gl()),
      program_(gl_, whole_viewport_shader, fragment_shader),
      no_attributes_(gl_) {}

void Presenter::begin(int width, int height) const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl_.Viewport(0, 0, width, height);
    gl_.ClearColor(.12f, .12f, .125f, 1);
    gl_.Clear(GL_COLOR_BUFFER_BIT);
}

void Presenter::draw(GLuint texture, const Rectangle& place, int window_height) const {
    const int bottom = window_height - place.y - place.height;
    gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl_.Viewport(place.x, bottom, place.width, place.height);
    gl_.Disable(GL_BLEND);
    program_.use();
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(GL_TEXTURE_2D, texture);
    gl_.Uniform1i(program_.uniform("source"), 0);
    gl_.Uniform4f(program_.uniform("place"), static_cast<float>(place.x),
                  static_cast<float>(bottom), static_cast<float>(place.width),
                  static_cast<float>(place.height));
    gl_.BindVertexArray(no_attributes_.id());
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace povpreview

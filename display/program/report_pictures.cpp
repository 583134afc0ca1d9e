// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/report_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

#include "core/colour.h"
#include "core/error_meter.h"
#include "display/image_file.h"
#include "display/program/data_uri.h"
#include "display/program/plot.h"
#include "display/program/schedule.h"

namespace povpreview {
namespace {

constexpr int moments_shown = 3;
constexpr int widest_picture = 560, widest_map = 280;
/// A crop is an eighth of the picture wide and high, but not so small that it shows nothing.
constexpr int crop_share = 8, least_crop = 24;

Image decoded(Image encoded) {
    for (glm::vec3& c : encoded.pixels) c = {decode_srgb(c.x), decode_srgb(c.y), decode_srgb(c.z)};
    return encoded;
}

/// Divided by the least whole number that makes it at most `widest` pixels wide.
Image shrunk(const Image& image, int widest) {
    const int n = (image.width + widest - 1) / widest;
    Image small(std::max(1, image.width / n), std::max(1, image.height / n));
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x) {
            glm::vec3 sum(0);
            int count = 0;
            for (int j = y * n; j < std::min(image.height, y * n + n); ++j)
                for (int i = x * n; i < std::min(image.width, x * n + n); ++i, ++count)
                    sum += glm::clamp(image.at(i, j), 0.f, 1.f);
            small.at(x, y) = sum / float(count);
        }
    return small;
}

Image cut(const Image& image, const Rectangle& r) {
    Image part(r.width, r.height);
    for (int y = 0; y < r.height; ++y)
        std::copy_n(&image.at(r.x, r.y + y), r.width, &part.at(0, y));
    return part;
}

Image map_of(const std::vector<float>& errors, int width, int height) {
    Image map(width, height);
    std::transform(errors.begin(), errors.end(), map.pixels.begin(), error_colour);
    return map;
}

std::string img(const Image& image, FileFormat format, const std::string& what,
                const char* kind = "") {
    const char* type = format == FileFormat::jpeg ? "image/jpeg" : "image/png";
    return fmt::format("<img {} alt=\"{}\" src=\"{}\">", kind, html_escaped(what),
                       data_uri(type, encoded_image(image, format)));
}

/// What a method showed at a moment, if it showed anything yet.
struct Shown {
    const CurvePoint* point = nullptr;
    Image image;  // linear light
    std::vector<float> errors;
};

class Pictures {
   public:
    Pictures(const ReportContents& contents, const ReportScene& scene)
        : contents_(contents),
          scene_(scene),
          reference_(decoded(read_image(scene.folder / "reference.png"))),
          meter_(read_image(scene.folder / "reference.png").pixels, reference_.width,
                 reference_.height) {}

    std::string html() {
        const auto& methods = contents_.options.methods;
        const std::vector<int> moments = telling_moments(
            run_of(contents_.curves, scene_.name, methods.front(), 1), moments_shown);
        if (moments.empty()) return "<p>No pictures.</p>";
        choose_crops(moments[moments.size() / 2]);
        std::string text = reference_html();
        for (const int moment : moments) {
            text += fmt::format("<h4>After {:.3f} s</h4>\n<div class=\"grid\">\n",
                                GeometricSchedule::time(moment));
            for (const std::string& method : methods) text += cell(method, moment);
            text += "</div>\n";
        }
        return text;
    }

   private:
    Shown shown(const std::string& method, int moment) const {
        Shown result;
        for (const CurvePoint* point : run_of(contents_.curves, scene_.name, method, 1))
            if (point->moment <= moment && !point->picture.empty()) result.point = point;
        if (!result.point) return result;
        result.image = decoded(read_image(scene_.folder / result.point->picture));
        result.errors = meter_.error_map(result.image.pixels);
        return result;
    }

    /// Where the first method is worst, and where the others are worse than it.
    void choose_crops(int moment) {
        const auto& methods = contents_.options.methods;
        const Shown first = shown(methods.front(), moment);
        if (!first.point) return;
        const int width = reference_.width, height = reference_.height;
        const int w = std::min(width, std::max(least_crop, width / crop_share)),
                  h = std::min(height, std::max(1, w * height / width));
        crops_ = {heaviest_window(first.errors, width, height, w, h)};
        std::vector<float> lead(first.errors.size());
        for (std::size_t m = 1; m < methods.size(); ++m) {
            const Shown other = shown(methods[m], moment);
            for (std::size_t i = 0; other.point && i < lead.size(); ++i)
                lead[i] += other.errors[i] - first.errors[i];
        }
        if (methods.size() > 1) crops_.push_back(heaviest_window(lead, width, height, w, h));
    }

    std::string crops_html(const Image& image) const {
        std::string text;
        for (std::size_t i = 0; i < crops_.size(); ++i)
            text += img(cut(image, crops_[i]), FileFormat::png8, fmt::format("crop {}", i + 1),
                        "class=\"crop\"");
        return text;
    }

    std::string reference_html() const {
        std::string frames;
        for (std::size_t i = 0; i < crops_.size(); ++i)
            frames += fmt::format(
                "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/><text x=\"{}\" "
                "y=\"{}\">{}</text>",
                crops_[i].x, crops_[i].y, crops_[i].width, crops_[i].height, crops_[i].x + 3,
                crops_[i].y + crops_[i].height - 4, i + 1);
        return fmt::format(
            "<div class=\"grid\"><figure><figcaption><b>finished</b><br>{} x {} pixels; framed: "
            "crop "
            "1, where {} is worst, crop 2, where it leads most</figcaption><div class=\"framed\">{}"
            "<svg viewBox=\"0 0 {} {}\" style=\"--unit:{}px\">{}</svg></div><div "
            "class=\"crops\">{}</div></figure></div>\n",
            reference_.width, reference_.height, html_escaped(contents_.options.methods.front()),
            img(shrunk(reference_, widest_picture), FileFormat::jpeg, "finished picture"),
            reference_.width, reference_.height, std::max(1, reference_.width / 320), frames,
            crops_html(reference_));
    }

    std::string cell(const std::string& method, int moment) const {
        const Shown now = shown(method, moment);
        const std::string name = fmt::format("<b style=\"color:{}\">{}</b>", method_colour(method),
                                             html_escaped(method));
        if (!now.point)
            return fmt::format("<figure><figcaption>{}<br>nothing yet</figcaption></figure>\n",
                               name);
        const Standing& standing = now.point->standing;
        const double share =
            100. * double(standing.full) / (double(reference_.width) * reference_.height);
        const ImageErrors& errors = now.point->plain;
        return fmt::format(
            "<figure><figcaption>{}<br>{:.3f} s, {} samples ({:.2g} %)<br>L1 {:.4f}, FLIP {:.3f}, "
            "SSIM {:.3f}</figcaption>{}<div class=\"crops\">{}{}</div></figure>\n",
            name, standing.time_s, standing.full, share, errors.l1, errors.flip, errors.ssim,
            img(shrunk(now.image, widest_picture), FileFormat::jpeg, method), crops_html(now.image),
            img(shrunk(map_of(now.errors, reference_.width, reference_.height), widest_map),
                FileFormat::jpeg, "error map"));
    }

    const ReportContents& contents_;
    const ReportScene& scene_;
    Image reference_;
    ErrorMeter meter_;
    std::vector<Rectangle> crops_;
};

}  // namespace

std::string pictures_html(const ReportContents& contents, const ReportScene& scene) {
    return Pictures(contents, scene).html();
}

Rectangle heaviest_window(const std::vector<float>& weights, int width, int height,
                          int window_width, int window_height) {
    Rectangle best{0, 0, window_width, window_height};
    double most = -1e300;
    for (int y = 0; y + window_height <= height; y += std::max(1, window_height / 2))
        for (int x = 0; x + window_width <= width; x += std::max(1, window_width / 2)) {
            double sum = 0;
            for (int j = y; j < y + window_height; ++j)
                for (int i = x; i < x + window_width; ++i)
                    sum += weights[static_cast<std::size_t>(j) * width + i];
            if (sum > most) {
                most = sum;
                best.x = x;
                best.y = y;
            }
        }
    return best;
}

glm::vec3 error_colour(float error) {
    static constexpr std::array<glm::vec3, 8> stops{{{0, 0, 4},
                                                     {40, 11, 84},
                                                     {101, 21, 110},
                                                     {159, 42, 99},
                                                     {212, 72, 66},
                                                     {245, 125, 21},
                                                     {250, 193, 39},
                                                     {252, 255, 164}}};
    const float at = std::clamp(error, 0.f, 1.f) * float(stops.size() - 1);
    const std::size_t below = std::min(stops.size() - 2, static_cast<std::size_t>(at));
    const glm::vec3 encoded = glm::mix(stops[below], stops[below + 1], at - float(below)) / 255.f;
    return {decode_srgb(encoded.x), decode_srgb(encoded.y), decode_srgb(encoded.z)};
}

}  // namespace povpreview

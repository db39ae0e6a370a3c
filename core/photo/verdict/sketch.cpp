// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/photo/sketch.h"

#include "picture/opencv_picture.h"
#include "verdict/sketch_match.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/photo/metadata.h"
#include "spherewalk/photo/picture_file.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace spherewalk::photo {

namespace {

constexpr int kMostWidth = 2752;
constexpr int kBlack = 6;
constexpr int kBurnt = 250;

int denominatorFor(int width) {
    int denominator = 1;
    while (denominator < 8 && width > kMostWidth * denominator) {
        denominator *= 2;
    }
    return denominator;
}

/// As a level camera with the same heading would see it.
RgbImage levelled(const RgbImage& picture, const PhotoMetadata& metadata) {
    const Radians kHarmless = Degrees(1);
    const auto levelFromPhoto = photo::levelFromPhoto(metadata);
    if (!levelFromPhoto || Eigen::AngleAxisd(*levelFromPhoto).angle() < kHarmless.value()) {
        return resized(picture, kSketchWidth, kSketchHeight);
    }
    constexpr int kFiner = 4;
    const RgbImage source = resized(picture, kFiner * kSketchWidth, kFiner * kSketchHeight);
    const EquirectSize from{source.width(), source.height()};
    const EquirectSize to{kSketchWidth, kSketchHeight};
    const Eigen::Quaterniond photoFromLevel = levelFromPhoto->conjugate();
    RgbImage result(to.width, to.height);
    for (int v = 0; v < to.height; ++v) {
        for (int u = 0; u < to.width; ++u) {
            const Eigen::Vector2d at = pixel(from, photoFromLevel * direction(to, Eigen::Vector2d(u, v)));
            const int x = std::clamp(static_cast<int>(std::lround(at.x())), 0, from.width - 1);
            const int y = std::clamp(static_cast<int>(std::lround(at.y())), 0, from.height - 1);
            std::copy_n(source.at(x, y), RgbImage::kChannels, result.at(u, v));
        }
    }
    return result;
}

/// Means over the sphere of the small picture.
void measureLight(Sketch& sketch) {
    double area = 0;
    for (int v = 0; v < kSketchHeight; ++v) {
        const double weight = std::cos(std::numbers::pi / 2 - std::numbers::pi * (v + 0.5) / kSketchHeight);
        for (int u = 0; u < kSketchWidth; ++u) {
            const std::uint8_t* p = sketch.picture.at(u, v);
            const int most = std::max({p[0], p[1], p[2]});
            const int least = std::min({p[0], p[1], p[2]});
            area += weight;
            sketch.brightness += weight * static_cast<double>(brightness(p));
            sketch.blackPart += most <= kBlack ? weight : 0;
            sketch.burntPart += least >= kBurnt ? weight : 0;
        }
    }
    sketch.brightness /= area;
    sketch.blackPart /= area;
    sketch.burntPart /= area;
}

constexpr int kLeastContrast = 40; ///< Grey levels of an edge; noise and soft shadows have less.
constexpr int kLeastEdges = 150;
constexpr double kSharpestShare = 0.2; ///< most edges of a room are soft by themselves
constexpr int kBins = 400;
constexpr double kBinPx = 0.05;

/// Widths of the edges in lines of brightness: from each dark to bright stretch, or the reverse, its height
/// over its steepest step.
class EdgeHistogram {
  public:
    void add(const std::uint8_t* line, int count, std::ptrdiff_t stride) {
        int direction = 0;
        int contrast = 0;
        int steepest = 0;
        for (int i = 1; i < count; ++i) {
            const int step = line[i * stride] - line[(i - 1) * stride];
            const int sign = (step > 0) - (step < 0);
            if (sign != direction) {
                note(contrast, steepest);
                direction = sign;
                contrast = 0;
                steepest = 0;
            }
            contrast += std::abs(step);
            steepest = std::max(steepest, std::abs(step));
        }
        note(contrast, steepest);
    }

    /// The width that the sharpest edges do not exceed.
    std::optional<double> width() const {
        if (m_edges < kLeastEdges) {
            return std::nullopt;
        }
        int seen = 0;
        for (int bin = 0; bin < kBins; ++bin) {
            seen += m_bins[static_cast<std::size_t>(bin)];
            if (seen >= kSharpestShare * m_edges) {
                return (bin + 0.5) * kBinPx;
            }
        }
        return kBins * kBinPx;
    }

  private:
    void note(int contrast, int steepest) {
        if (contrast < kLeastContrast) {
            return;
        }
        const int bin = static_cast<int>(contrast / (kBinPx * steepest));
        ++m_bins[static_cast<std::size_t>(std::min(bin, kBins - 1))];
        ++m_edges;
    }

    std::array<int, kBins> m_bins{};
    int m_edges = 0;
};

/// Of a spherical picture between 40 degrees below and above the horizon, where its rows are hardly
/// stretched.
EdgeWidths edgeWidths(const RgbImage& picture) {
    return translated("measure a photo's sharpness", [&] {
        const int top = picture.height() * 50 / 180;
        const int rows = picture.height() * 80 / 180;
        cv::Mat grey;
        cv::cvtColor(matOver(picture)(cv::Rect(0, top, picture.width(), rows)), grey, cv::COLOR_RGB2GRAY);
        EdgeHistogram alongRows;
        for (int y = 0; y < grey.rows; ++y) {
            alongRows.add(grey.ptr<std::uint8_t>(y), grey.cols, 1);
        }
        EdgeHistogram alongColumns;
        for (int x = 0; x < grey.cols; ++x) {
            alongColumns.add(grey.ptr<std::uint8_t>(0) + x, grey.rows,
                             static_cast<std::ptrdiff_t>(grey.step));
        }
        return EdgeWidths{alongRows.width(), alongColumns.width()};
    });
}

/// The share of the sketch's pixels that show nothing, of those that the condition chooses.
template <class IsChosen>
double darkShare(const RgbImage& picture, const IsChosen& isChosen) {

    int dark = 0;
    int all = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            // From the middle of its half, in units of the half's half width.
            const double half = picture.height() / 2.0;
            const Eigen::Vector2d at((x % picture.height() + 0.5) / half - 1, (y + 0.5) / half - 1);
            if (isChosen(at)) {
                const std::uint8_t* rgb = picture.at(x, y);
                dark += std::max({rgb[0], rgb[1], rgb[2]}) <= kBlack ? 1 : 0;
                ++all;
            }
        }
    }
    return static_cast<double>(dark) / all;
}

} // namespace

Sketch sketch(ByteView jpeg, const PhotoMetadata& metadata, std::string_view source) {
    const jpeg::Info info = jpeg::readInfo(jpeg, source);
    if (info.width != 2 * info.height) {
        throw Error(ErrorKind::Corrupt, text("The photo ", source, " is not spherical: its ", info.width,
                                             " x ", info.height, " pixels are not twice as wide as high."));
    }
    const RgbImage picture = jpeg::decode(jpeg, source, denominatorFor(info.width));
    Sketch result;
    result.width = info.width;
    result.height = info.height;
    result.picture = levelled(picture, metadata);
    result.edges = edgeWidths(picture);
    measureLight(result);
    result.exposureStops = exposureStops(metadata);
    return result;
}

bool isDualFisheye(const Sketch& sketch) {
    const RgbImage& picture = sketch.picture;
    const double around = darkShare(picture, [](const auto& at) { return at.norm() > 1.15; });
    // The poles of a sphere are not black beside their middles alone.
    const double above =
        darkShare(picture, [](const auto& at) { return std::abs(at.x()) < 0.2 && std::abs(at.y()) > 0.85; });
    const double within = darkShare(picture, [](const auto& at) { return at.norm() < 0.8; });
    return around > 0.95 && above < 0.7 && within < 0.5;
}

} // namespace spherewalk::photo

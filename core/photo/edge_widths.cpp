// SPDX-License-Identifier: GPL-3.0-or-later
#include "edge_widths.h"

#include "opencv_picture.h"

#include <opencv2/imgproc.hpp>

#include <array>
#include <cstdlib>

namespace spherewalk::photo {

namespace {

constexpr int kLeastContrast = 40; ///< of an edge, grey levels: noise and soft shadows have less
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

} // namespace

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

} // namespace spherewalk::photo

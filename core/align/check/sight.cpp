// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/sight.h"

#include "spherewalk/geometry/equirect.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace spherewalk::align {

namespace {

constexpr int kHeight = kSightWidth / 2;
constexpr int kPatch = 5;
constexpr int kRim = kPatch / 2; ///< Columns that are repeated beyond the seam.
constexpr int kWide = kSightColumns + 2 * kRim;

const SoftPixel& pixelAt(const SoftPicture& picture, const Eigen::Vector3f& direction) {
    const SightPlace at = placeOf(direction, kSightWidth);
    const int x = static_cast<int>(at.u) & (kSightWidth - 1);
    const int y = std::clamp(static_cast<int>(at.v), 0, kHeight - 1);
    return picture[static_cast<std::size_t>(y) * kSightWidth + static_cast<std::size_t>(x)];
}

int channel(std::uint32_t pixel, int c) {
    return static_cast<int>((pixel >> (8 * c)) & 255U);
}

/// Of the channel that differs most, from what the other photo shows at that place or beside it.
/// Source: Birchfield and Tomasi, A pixel dissimilarity measure that is insensitive to image sampling, 1998.
std::uint8_t difference(const SoftPixel& own, const SoftPixel& other) {
    int most = 0;
    for (int c = 0; c < 3; ++c) {
        most = std::max({most, channel(other.least, c) - channel(own.top, c),
                         channel(own.middle, c) - channel(other.greatest, c)});
    }
    return static_cast<std::uint8_t>(most);
}

/// How much a patch varies by itself. What is full of detail never fits to the last grey level.
cv::Mat activityOf(const cv::Mat& own) {
    cv::Mat mean;
    cv::Mat detail;
    cv::blur(own, mean, {kPatch, kPatch});
    cv::absdiff(own, mean, detail);
    cv::blur(detail, detail, {kPatch, kPatch});
    std::vector<cv::Mat> planes;
    cv::split(detail, planes);
    cv::Mat most;
    cv::max(planes[0], planes[1], most);
    cv::max(most, planes[2], most);
    return most;
}

} // namespace

Eigen::Vector3f sightDirection(int row, int column) {
    const float azimuth = kSightPi - 2 * kSightPi * (static_cast<float>(column) + 0.5F) / kSightColumns;
    const float elevation =
        kSightPi / 2 - kSightPi * (static_cast<float>(row + kSightTop) + 0.5F) / kSightRowsOfSphere;
    return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
            std::sin(elevation)};
}

int sightCell(const Eigen::Vector3f& direction) {
    const SightPlace at = placeOf(direction, kSightColumns);
    const int row = static_cast<int>(std::floor(at.v)) - kSightTop;
    const int column = static_cast<int>(at.u) & (kSightColumns - 1);
    return row < 0 || row >= kSightRows ? -1 : row * kSightColumns + column;
}

namespace {

std::uint32_t packed(const cv::Vec3b& p) {
    return std::uint32_t{p[0]} | (std::uint32_t{p[1]} << 8) | (std::uint32_t{p[2]} << 16);
}

/// Where a channel is as bright as the camera can record, or a pixel beside it is.
cv::Mat burntOut(const cv::Mat& picture) {
    constexpr int kBurnt = 246; // Noise and JPEG lie a little below what was burnt out.
    std::vector<cv::Mat> planes;
    cv::split(picture, planes);
    cv::Mat most;
    cv::max(planes[0], planes[1], most);
    cv::max(most, planes[2], most);
    cv::Mat burnt = most >= kBurnt;
    cv::dilate(burnt, burnt, cv::Mat::ones(3, 3, CV_8U));
    return burnt;
}

cv::Mat multiplied(const cv::Mat& picture, const GainField& gains) {
    const EquirectSize size{picture.cols, picture.rows};
    cv::Mat product(picture.size(), CV_8UC3);
    for (int y = 0; y < picture.rows; ++y) {
        for (int x = 0; x < picture.cols; ++x) {
            const Eigen::Vector3f gain = gains.at(direction(size, Eigen::Vector2d(x, y)).cast<float>());
            for (int c = 0; c < 3; ++c) {
                product.at<cv::Vec3b>(y, x)[c] =
                    cv::saturate_cast<std::uint8_t>(gain[c] * picture.at<cv::Vec3b>(y, x)[c]);
            }
        }
    }
    return product;
}

SoftPicture softened(const RgbImage& picture, const GainField& gains) {
    const cv::Mat sharp(picture.height(), picture.width(), CV_8UC3,
                        const_cast<std::uint8_t*>(picture.values().data()));
    cv::Mat soft;
    cv::blur(multiplied(sharp, gains), soft, {3, 3});
    cv::Mat least;
    cv::Mat top = soft.clone();
    top.setTo(cv::Scalar::all(255), burntOut(sharp));
    cv::Mat greatest;
    cv::erode(soft, least, cv::Mat::ones(3, 3, CV_8U));
    cv::dilate(top, greatest, cv::Mat::ones(3, 3, CV_8U));
    SoftPicture result;
    result.reserve(std::size_t{kSightWidth} * kHeight);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kSightWidth; ++x) {
            result.push_back({packed(soft.at<cv::Vec3b>(y, x)), packed(top.at<cv::Vec3b>(y, x)),
                              packed(least.at<cv::Vec3b>(y, x)), packed(greatest.at<cv::Vec3b>(y, x))});
        }
    }
    return result;
}

} // namespace

std::vector<SoftPicture> softened(std::span<const SightPhoto> photos, std::span<const GainField> gains) {
    std::vector<SoftPicture> all(photos.size());
    for (std::size_t i = 0; i < photos.size(); ++i) {
        if (!photos[i].picture.empty()) {
            all[i] = softened(photos[i].picture, gains[i]);
        }
    }
    return all;
}

namespace {

constexpr double kUnlike = 12; ///< Mean difference of a patch's strongest channel, grey levels.
constexpr double kOfActivity = 0.6;
constexpr std::size_t kMostAgreeing = 3;
constexpr int kMoreThanBest = 5; ///< Distances that fit worse than the best by more are no candidates.

/// Compares one photo with its neighbours, level by level.
class Comparison {
  public:
    Comparison(const SightPhoto& photo, const SoftPicture& picture)
        : m_own(kSightRows, kWide, CV_8UC3), m_pixels(kSightRows * kWide) {
        m_rays.fill(std::vector<float>(kSightRows * kWide));
        const Eigen::Matrix3f roomFromPhoto = photo.roomFromPhoto->rotation.matrix().cast<float>();
        for (int row = 0; row < kSightRows; ++row) {
            for (int x = 0; x < kWide; ++x) {
                const int column = (x - kRim + kSightColumns) % kSightColumns;
                const Eigen::Vector3f ray = sightDirection(row, column);
                const auto at = static_cast<std::size_t>(row * kWide + x);
                const Eigen::Vector3f inRoom = roomFromPhoto * ray;
                for (std::size_t axis = 0; axis < m_rays.size(); ++axis) {
                    m_rays[axis][at] = inRoom[static_cast<Eigen::Index>(axis)];
                }
                m_pixels[at] = pixelAt(picture, ray);
                for (int c = 0; c < 3; ++c) {
                    m_own.at<cv::Vec3b>(row, x)[c] =
                        static_cast<std::uint8_t>(channel(m_pixels[at].middle, c));
                }
            }
        }
        activityOf(m_own).convertTo(m_limit, CV_8U, kOfActivity, kUnlike);
    }

    PhotoSight with(std::span<const int> neighbours, const Eigen::Vector3d& positionM,
                    std::span<const SightPhoto> photos, std::span<const SoftPicture> pictures) {
        // A surface lies where half of the neighbours agree: more than one, and fewer than those that it is
        // hidden from.
        const std::size_t rank = std::min(
            {neighbours.size(), std::max<std::size_t>(2, (neighbours.size() + 1) / 2), kMostAgreeing});
        std::vector<cv::Mat> agreed;
        for (int level = 0; level < kSightLevels; ++level) {
            std::array<cv::Mat, kMostAgreeing> least;
            for (cv::Mat& one : least) {
                one = cv::Mat(kSightRows, kWide, CV_8U, cv::Scalar(255));
            }
            for (const int other : neighbours) {
                const auto j = static_cast<std::size_t>(other);
                cv::Mat cost = costOf(*photos[j].roomFromPhoto, pictures[j], positionM, inverseOf(level));
                for (cv::Mat& one : least) {
                    cv::Mat worse;
                    cv::max(one, cost, worse);
                    cv::min(one, cost, one);
                    cost = worse;
                }
            }
            m_best.push_back(least[0]);
            m_next.push_back(least[1]);
            agreed.push_back(least[rank - 1]);
        }
        return sight(agreed);
    }

  private:
    cv::Mat costOf(const Rigid3& roomFromOther, const SoftPicture& picture, const Eigen::Vector3d& positionM,
                   double inverse) {
        const Eigen::Matrix3f otherFromRoom = roomFromOther.rotation.conjugate().matrix().cast<float>();
        const Eigen::Vector3f shift = (inverse * (positionM - roomFromOther.translation)).cast<float>();
        cv::Mat cost(kSightRows, kWide, CV_8U);
        std::array<int, kWide> index{};
        for (int row = 0; row < kSightRows; ++row) {
            pixelsOf(otherFromRoom, shift, row, index);
            std::uint8_t* to = cost.ptr<std::uint8_t>(row);
            for (int x = 0; x < kWide; ++x) {
                to[x] = difference(m_pixels[static_cast<std::size_t>(row * kWide + x)],
                                   picture[static_cast<std::size_t>(index[static_cast<std::size_t>(x)])]);
            }
        }
        cv::blur(cost, cost, {kPatch, kPatch});
        return cost;
    }

    /// Where the other photo shows the places of a row.
    void pixelsOf(const Eigen::Matrix3f& otherFromRoom, const Eigen::Vector3f& shift, int row,
                  std::array<int, kWide>& index) const {
        const Eigen::Matrix3f m = otherFromRoom;
        const Eigen::Vector3f t = otherFromRoom * shift;
        const float* rx = m_rays[0].data() + std::ptrdiff_t{row} * kWide;
        const float* ry = m_rays[1].data() + std::ptrdiff_t{row} * kWide;
        const float* rz = m_rays[2].data() + std::ptrdiff_t{row} * kWide;
        constexpr float kPerRadian = kSightWidth / (2 * kSightPi);
        for (int i = 0; i < kWide; ++i) {
            const float x = m(0, 0) * rx[i] + m(0, 1) * ry[i] + m(0, 2) * rz[i] + t.x();
            const float y = m(1, 0) * rx[i] + m(1, 1) * ry[i] + m(1, 2) * rz[i] + t.y();
            const float z = m(2, 0) * rx[i] + m(2, 1) * ry[i] + m(2, 2) * rz[i] + t.z();
            const float u = (kSightPi - quickAtan2(y, x)) * kPerRadian;
            const float v = (kSightPi / 2 - quickAtan2(z, std::sqrt(x * x + y * y))) * kPerRadian;
            const int line = std::min(static_cast<int>(v), kHeight - 1);
            index[static_cast<std::size_t>(i)] =
                line * kSightWidth + (static_cast<int>(u) & (kSightWidth - 1));
        }
    }

    PhotoSight sight(const std::vector<cv::Mat>& agreed) const {
        PhotoSight cells(kSightCells);
        for (int row = 0; row < kSightRows; ++row) {
            for (int column = 0; column < kSightColumns; ++column) {
                CellSight& cell = cells[static_cast<std::size_t>(row * kSightColumns + column)];
                const int x = column + kRim;
                const int limit = m_limit.at<std::uint8_t>(row, x);
                int least = 255;
                for (const cv::Mat& level : agreed) {
                    least = std::min<int>(least, level.at<std::uint8_t>(row, x));
                }
                for (int k = 0; k < kSightLevels; ++k) {
                    const auto level = static_cast<std::size_t>(k);
                    const std::uint64_t bit = std::uint64_t{1} << k;
                    cell.shown |= m_best[level].at<std::uint8_t>(row, x) <= limit ? bit : 0;
                    cell.shownTwice |= m_next[level].at<std::uint8_t>(row, x) <= limit ? bit : 0;
                    if (agreed[level].at<std::uint8_t>(row, x) <= std::min(limit, least + kMoreThanBest)) {
                        cell.nearest = cell.isKnown() ? cell.nearest : static_cast<float>(inverseOf(k));
                        cell.farthest = static_cast<float>(inverseOf(k));
                    }
                }
            }
        }
        return cells;
    }

    cv::Mat m_own;
    cv::Mat m_limit;
    SoftPicture m_pixels;
    std::array<std::vector<float>, 3> m_rays; ///< x, y and z in the room's frame.
    std::vector<cv::Mat> m_best;
    std::vector<cv::Mat> m_next;
};

} // namespace

PhotoSight sightOf(int photo, std::span<const SightPhoto> photos, std::span<const SoftPicture> pictures,
                   std::span<const int> neighbours) {
    const auto i = static_cast<std::size_t>(photo);
    if (neighbours.empty()) {
        return {};
    }
    return Comparison(photos[i], pictures[i])
        .with(neighbours, photos[i].roomFromPhoto->translation, photos, pictures);
}

} // namespace spherewalk::align

// SPDX-License-Identifier: GPL-3.0-or-later
#include "features/sphere_view.h"
#include "free/placing.h"

#include "spherewalk/base/parallel.h"
#include "spherewalk/geometry/equirect.h"

#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace spherewalk::align {

namespace {

constexpr int kPatchPx = 15; ///< Side of what is compared, in pixels of the photo that shows it smaller.
constexpr int kReachPx = 5;  ///< So far it is looked for on each side.
constexpr double kLeastLikeness = 0.9; ///< Correlation.
constexpr double kMostShiftPx = 3;
constexpr double kSigmaPx = 0.15;
constexpr double kMostTurnRad = 1;   ///< Between two rays that are compared.
constexpr double kMostOctaves = 2.5; ///< Between the sizes at which two photos see a thing.
constexpr int kWidth = 2048;         ///< Of the photos.
constexpr double kMostBytes = 1e9;   ///< Of all photos together.

/// A photo in several sizes, each half the one before.
class PhotoSizes {
  public:
    PhotoSizes(const RgbImage& photo, int width) {
        GreyImage full = grey(photo);
        const cv::Mat size(full.height(), full.width(), CV_8U, full.at(0, 0));
        cv::resize(size, m_sizes.front(), {std::min(width, full.width()), std::min(width, full.width()) / 2},
                   0, 0, cv::INTER_AREA);
        for (std::size_t i = 1; i < m_sizes.size(); ++i) {
            const cv::Mat& larger = m_sizes[i - 1];
            cv::resize(larger, m_sizes[i], {(larger.cols + 1) / 2, (larger.rows + 1) / 2}, 0, 0,
                       cv::INTER_AREA);
        }
    }

    double pixelRad() const { return 2 * std::numbers::pi / m_sizes.front().cols; }

    /// The size whose pixels are nearest to this one.
    const cv::Mat& sizeFor(double pitchRad) const {
        const double level = std::round(std::log2(pitchRad / pixelRad()));
        return m_sizes[static_cast<std::size_t>(
            std::clamp(level, 0., static_cast<double>(m_sizes.size() - 1)))];
    }

  private:
    std::array<cv::Mat, 4> m_sizes;
};

/// The picture's value in this direction, between its pixels. OpenCV's remap() would round places to a 32nd
/// of a pixel.
float sampled(const cv::Mat& picture, const Eigen::Vector3d& inPhoto) {
    const Eigen::Vector2d at = pixel({picture.cols, picture.rows}, inPhoto);
    const double left = std::floor(at.x());
    const double y = std::clamp(at.y(), 0., picture.rows - 1.);
    const int top = static_cast<int>(y);
    const int x0 = (static_cast<int>(left) + picture.cols) % picture.cols;
    const int x1 = (x0 + 1) % picture.cols;
    const auto* const upper = picture.ptr<std::uint8_t>(top);
    const auto* const lower = picture.ptr<std::uint8_t>(std::min(top + 1, picture.rows - 1));
    const double right = at.x() - left;
    const double down = y - top;
    return static_cast<float>((1 - down) * ((1 - right) * upper[x0] + right * upper[x1]) +
                              down * ((1 - right) * lower[x0] + right * lower[x1]));
}

/// A ray to a point, in the room.
struct Sight {
    const PhotoSizes* photo = nullptr;
    Eigen::Matrix3d roomFromPhoto;
    Eigen::Vector3d direction; ///< Unit vector.
    double distance = 0;       ///< Of the point.

    /// What a pixel of the photo spans at the point.
    double pixel() const { return distance * photo->pixelRad(); }
};

/// A square that stands at the point across the way from where it is seen.
struct Square {
    Eigen::Vector3d right; ///< To the next pixel.
    Eigen::Vector3d down;
    double pitch = 0; ///< Side of a pixel.
};

Square squareFor(const Sight& from, const Sight& to) {
    const Eigen::Vector3d ahead = (from.direction + to.direction).normalized();
    const Eigen::Vector3d right = ahead.unitOrthogonal();
    const double pitch = std::max(from.pixel(), to.pixel());
    return {pitch * right, pitch * ahead.cross(right), pitch};
}

/// The square as the photo shows it, side pixels wide, its middle where the ray hits it.
cv::Mat shown(const Sight& sight, const Square& square, int side) {
    const cv::Mat& picture = sight.photo->sizeFor(square.pitch / sight.distance);
    const Eigen::Matrix3d photoFromRoom = sight.roomFromPhoto.transpose();
    const Eigen::Vector3d middle = photoFromRoom * (sight.distance * sight.direction);
    const Eigen::Vector3d right = photoFromRoom * square.right;
    const Eigen::Vector3d down = photoFromRoom * square.down;
    const int half = side / 2;
    cv::Mat made(side, side, CV_32F);
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            made.at<float>(y, x) = sampled(picture, middle + (x - half) * right + (y - half) * down);
        }
    }
    return made;
}

/// The least, over all directions, of the summed squares of the picture's slope, and the summed squares of
/// its values about their mean.
struct Contrast {
    double slopes = 0;
    double values = 0;
};

Contrast contrastOf(const cv::Mat& picture) {
    Eigen::Matrix2d tensor = Eigen::Matrix2d::Zero();
    const double mean = cv::mean(picture)[0];
    Contrast contrast;
    for (int y = 1; y + 1 < picture.rows; ++y) {
        for (int x = 1; x + 1 < picture.cols; ++x) {
            const Eigen::Vector2d slope(picture.at<float>(y, x + 1) - picture.at<float>(y, x - 1),
                                        picture.at<float>(y + 1, x) - picture.at<float>(y - 1, x));
            tensor += 0.25 * slope * slope.transpose();
            contrast.values += std::pow(picture.at<float>(y, x) - mean, 2);
        }
    }
    const double half = 0.5 * tensor.trace();
    contrast.slopes = half - std::sqrt(std::max(half * half - tensor.determinant(), 0.));
    return contrast;
}

/// Where one photo shows what another shows.
struct Finding {
    Eigen::Vector3d direction; ///< A unit vector in the room.
    double sigmaPx = 0;        ///< Standard deviation along the worst axis, in pixels of the square.
};

/// The deviation of a shift by least squares: what does not fit, over the slope. An edge fits anywhere along
/// itself.
double shiftSigmaPx(const cv::Mat& sought, double likeness) {
    const Contrast contrast = contrastOf(sought);
    const double count = (kPatchPx - 2) * (kPatchPx - 2);
    const double misfit = (1 - likeness * likeness) * contrast.values / count;
    return std::hypot(kSigmaPx, std::sqrt(misfit / std::max(contrast.slopes, 1e-9)));
}

/// Empty if `to` does not show it.
std::optional<Finding> found(const Sight& from, const Sight& to, const Square& square) {
    const cv::Mat sought = shown(from, square, kPatchPx);
    const cv::Mat around = shown(to, square, kPatchPx + 2 * kReachPx);
    cv::Mat warp = (cv::Mat_<float>(2, 3) << 1, 0, kReachPx, 0, 1, kReachPx);
    double likeness = 0;
    try {
        const cv::TermCriteria end(cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 20, 1e-4);
        likeness = cv::findTransformECC(sought, around, warp, cv::MOTION_AFFINE, end, cv::noArray(), 3);
    } catch (const cv::Exception&) {
        return std::nullopt; // Nothing to compare: one colour, or a warp that leaves the picture.
    }
    constexpr float kMiddle = kPatchPx / 2;
    const cv::Matx<float, 2, 3> last = warp;
    const cv::Vec2f at =
        last * cv::Vec3f(kMiddle, kMiddle, 1) - cv::Vec2f(kMiddle + kReachPx, kMiddle + kReachPx);
    if (!(likeness > kLeastLikeness && cv::norm(at) < kMostShiftPx)) {
        return std::nullopt;
    }
    return Finding{(to.distance * to.direction + at[0] * square.right + at[1] * square.down).normalized(),
                   shiftSigmaPx(sought, likeness)};
}

/// How unlike two photos see a thing: infinite if they are not to be compared.
double unlikeness(const Sight& one, const Sight& other) {
    const double turn = std::acos(std::clamp(one.direction.dot(other.direction), -1., 1.));
    const double octaves = std::log2(one.distance / other.distance);
    if (!(turn < kMostTurnRad && std::abs(octaves) < kMostOctaves)) {
        return std::numeric_limits<double>::infinity();
    }
    constexpr double kStep = 0.1; ///< Each comparison errs a bit.
    constexpr double kTurnRad = 0.35;
    return kStep + (turn / kTurnRad) * (turn / kTurnRad) + octaves * octaves;
}

/// Finds what the nearest photo sees in all others, each by the way over photos that see it most alike.
class RaySearch {
  public:
    explicit RaySearch(std::vector<Sight> sights)
        : m_sights(std::move(sights)),
          m_ways(m_sights.size(), std::numeric_limits<double>::infinity()),
          m_from(m_sights.size(), 0),
          m_isDone(m_sights.size(), false),
          m_sigmas(m_sights.size(), 0) {
        const auto nearest = static_cast<std::size_t>(
            std::ranges::min_element(m_sights, {}, &Sight::distance) - m_sights.begin());
        m_ways[nearest] = 0;
        m_from[nearest] = nearest;
        while (const std::optional<std::size_t> next = nextOne()) {
            reach(*next);
        }
    }

    const Sight& sight(std::size_t i) const { return m_sights[i]; }

    /// Standard deviation of the direction; 0 where the thing was not found.
    double sigmaRad(std::size_t i) const { return m_sigmas[i]; }

    std::size_t count() const {
        return m_sights.size() - static_cast<std::size_t>(std::ranges::count(m_sigmas, 0));
    }

  private:
    std::optional<std::size_t> nextOne() const {
        std::optional<std::size_t> next;
        for (std::size_t i = 0; i < m_sights.size(); ++i) {
            if (!m_isDone[i] && std::isfinite(m_ways[i]) && (!next || m_ways[i] < m_ways[*next])) {
                next = i;
            }
        }
        return next;
    }

    void reach(std::size_t next) {
        m_isDone[next] = true;
        Sight& to = m_sights[next];
        double sigma = kSigmaPx * to.pixel();
        if (m_from[next] != next) {
            const Square square = squareFor(m_sights[m_from[next]], to);
            const auto finding = found(m_sights[m_from[next]], to, square);
            sigma = finding ? finding->sigmaPx * square.pitch : 0;
            if (!finding) {
                return;
            }
            to.direction = finding->direction;
        }
        m_sigmas[next] = sigma / to.distance;
        for (std::size_t i = 0; i < m_sights.size(); ++i) {
            const double way = m_ways[next] + unlikeness(m_sights[i], to);
            if (!m_isDone[i] && way < m_ways[i]) {
                m_ways[i] = way;
                m_from[i] = next;
            }
        }
    }

    std::vector<Sight> m_sights;
    std::vector<double> m_ways; ///< Summed unlikeness from the nearest photo on.
    std::vector<std::size_t> m_from;
    std::vector<bool> m_isDone;
    std::vector<double> m_sigmas;
};

void refine(const Bundle& bundle, std::span<const PhotoSizes> photos, SeenPoint& point) {
    std::vector<Sight> sights;
    for (const Ray& ray : point.rays) {
        const auto i = static_cast<std::size_t>(ray.photo);
        const Eigen::Matrix3d roomFromPhoto = bundle.photos[i].roomFromPhoto.toRotationMatrix();
        const double distance = std::max((point.at - bundle.lensOf(ray)).norm(), 1e-9);
        sights.push_back({&photos[i], roomFromPhoto, roomFromPhoto * ray.bearing, distance});
    }
    const auto isKnown = [](const Sight& sight) {
        return std::isfinite(sight.distance) && sight.direction.allFinite();
    };
    if (sights.size() < 2 || !std::ranges::all_of(sights, isKnown)) {
        return;
    }
    const RaySearch search(std::move(sights));
    for (std::size_t i = 0; i < point.rays.size() && search.count() > 1; ++i) {
        if (search.sigmaRad(i) > 0) {
            const Sight& sight = search.sight(i);
            point.rays[i].bearing = sight.roomFromPhoto.transpose() * sight.direction;
            point.rays[i].sigmaRad = search.sigmaRad(i);
        }
    }
}

void tell(ProgressSink& progress, std::size_t done, std::size_t all) {
    progress.progress(static_cast<double>(done) / static_cast<double>(all), "Comparing what photos show");
}

/// All photos at one width, so that they need no more than so much memory.
std::vector<PhotoSizes> sizesOf(std::size_t photos, const std::function<RgbImage(int, int)>& picture,
                                ProgressSink& progress, const std::stop_token& stop) {
    // Half as high as wide, and a third more for the smaller sizes.
    const double widest = std::sqrt(kMostBytes * 1.5 / static_cast<double>(photos));
    const int width = std::min(kWidth, static_cast<int>(widest) / 16 * 16);
    std::vector<PhotoSizes> sizes;
    for (std::size_t i = 0; i < photos; ++i) {
        throwIfStopped(stop);
        tell(progress, i, photos);
        sizes.emplace_back(picture(static_cast<int>(i), width), width);
    }
    return sizes;
}

} // namespace

void refineRays(Bundle& bundle, const std::function<RgbImage(int, int)>& picture, int threads,
                ProgressSink& progress, const std::stop_token& stop) {
    ProgressStep reading(progress, 0, 0.3);
    const std::vector<PhotoSizes> photos = sizesOf(bundle.photos.size(), picture, reading, stop);
    ProgressStep comparing(progress, 0.3, 1);
    constexpr std::size_t kBatch = 1024; // Between two reports.
    constexpr int kGrain = 16;
    const std::span<SeenPoint> points = bundle.points;
    for (std::size_t first = 0; first < points.size(); first += kBatch) {
        const auto batch = points.subspan(first, std::min(kBatch, points.size() - first));
        parallelFor(static_cast<int>(batch.size()), kGrain, threads, [&](int begin, int end) {
            for (int i = begin; i < end; ++i) {
                throwIfStopped(stop);
                refine(bundle, photos, batch[static_cast<std::size_t>(i)]);
            }
        });
        tell(comparing, first + batch.size(), points.size());
    }
}

} // namespace spherewalk::align

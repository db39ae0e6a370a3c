// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/photo/april_tag.h"

#include "picture/opencv_picture.h"

#include "spherewalk/geometry/equirect.h"
#include "spherewalk/photo/tag_fit.h"

#include <Eigen/Geometry>
#include <opencv2/core/version.hpp>
#include <opencv2/imgproc.hpp>

// OpenCV 4.7 moved the tags from its contributed modules to a core module, with another interface.
#if CV_VERSION_MAJOR > 4 || CV_VERSION_MINOR >= 7
#include <opencv2/objdetect/aruco_detector.hpp>
#define SPHEREWALK_ARUCO_DETECTOR 1
#else
#include <opencv2/aruco.hpp>
#define SPHEREWALK_ARUCO_DETECTOR 0
#endif

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace spherewalk::photo {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

/// A tag as OpenCV finds it, to about a pixel. Units: pixels; the centre of pixel (0, 0) is (0, 0).
struct DetectedTag {
    int number = 0;
    TagCorners<Vector2d> corners;
};

constexpr int kInner = kTagCells - 2;
constexpr double kLeastPerimeterPx = 64;

cv::aruco::Dictionary family() {
#if SPHEREWALK_ARUCO_DETECTOR
    return cv::aruco::getPredefinedDictionary(cv::aruco::DICT_APRILTAG_36h11);
#else
    return *cv::aruco::getPredefinedDictionary(cv::aruco::DICT_APRILTAG_36h11);
#endif
}

cv::aruco::DetectorParameters parameters(const cv::Mat& grey) {
    cv::aruco::DetectorParameters made;
    made.minMarkerPerimeterRate = kLeastPerimeterPx / std::max(grey.cols, grey.rows);
    made.adaptiveThreshWinSizeMax = 33;
    return made;
}

} // namespace

TagCells tagCells(int number) {
    if (number < 0 || number >= kTagNumbers) {
        throw Error(ErrorKind::InvalidInput,
                    text("There is no AprilTag ", number, ": the family 36h11 has the numbers 0 to ",
                         kTagNumbers - 1, "."));
    }
    return translated("make an AprilTag", [&] {
        const cv::Mat bits = cv::aruco::Dictionary::getBitsFromByteList(
            family().bytesList.rowRange(number, number + 1), kInner);
        TagCells cells;
        for (int row = 0; row < kInner; ++row) {
            for (int column = 0; column < kInner; ++column) {
                const int cell = (row + 1) * kTagCells + column + 1;
                cells[static_cast<std::size_t>(cell)] = bits.at<std::uint8_t>(row, column) != 0;
            }
        }
        return cells;
    });
}

namespace {

/// The tags in a grey picture, whose sides may be bent a little. Errors: Internal if OpenCV refuses.
std::vector<DetectedTag> detectedTags(const cv::Mat& grey) {
    std::vector<std::vector<cv::Point2f>> corners;
    std::vector<int> numbers;
    if (std::min(grey.cols, grey.rows) < kLeastPerimeterPx / 4) { // OpenCV refuses a few pixels.
        return {};
    }
    translated("look for AprilTags", [&] {
#if SPHEREWALK_ARUCO_DETECTOR
        cv::aruco::ArucoDetector(family(), parameters(grey)).detectMarkers(grey, corners, numbers);
#else
        cv::aruco::detectMarkers(grey, cv::makePtr<cv::aruco::Dictionary>(family()), corners, numbers,
                                 cv::makePtr<cv::aruco::DetectorParameters>(parameters(grey)));
#endif
        return true;
    });
    std::vector<DetectedTag> found;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        DetectedTag tag;
        tag.number = numbers[i];
        std::ranges::transform(corners[i], tag.corners.begin(),
                               [](const cv::Point2f& at) { return Vector2d(at.x, at.y); });
        found.push_back(tag);
    }
    return found;
}

constexpr double kLowest = -50; ///< Degrees of elevation.
constexpr double kHighest = 60;
constexpr double kSeam = 30; ///< Degrees of azimuth that a photo is continued by, to hold tags at its seam.
constexpr double kBeyond = 1.2 / kTagCells; ///< Of a tag's size, looked at around it.
constexpr double kSameTag = 0.3;            ///< Two tags so near, in sizes, are one.

cv::Mat greyOf(const RgbImage& picture) {
    cv::Mat grey;
    cv::cvtColor(matOver(picture), grey, cv::COLOR_RGB2GRAY);
    return grey;
}

/// A picture whose pixels have directions. down: what is down in the picture, about.
struct Lens {
    std::function<std::optional<Vector3d>(const Vector2d& pixel)> ray;
    Vector3d down;
};

/// The plane that touches the sphere of directions at one of them.
class TouchingPlane {
  public:
    TouchingPlane(const Vector3d& middle, const Vector3d& down) : m_middle(middle.normalized()) {
        m_right = down.cross(m_middle);
        if (m_right.norm() < 1e-3) {
            m_right = m_middle.unitOrthogonal();
        }
        m_right.normalize();
        m_down = m_middle.cross(m_right);
    }

    std::optional<Vector2d> at(const Vector3d& direction) const {
        const double along = direction.dot(m_middle);
        if (!(along > 0.2)) {
            return std::nullopt;
        }
        return Vector2d(direction.dot(m_right) / along, direction.dot(m_down) / along);
    }

    Vector3d direction(const Vector2d& at) const {
        return (m_middle + at.x() * m_right + at.y() * m_down).normalized();
    }

  private:
    Vector3d m_middle;
    Vector3d m_right;
    Vector3d m_down;
};

/// The smallest rectangle of pixels that holds the tag's corners.
struct PixelBox {
    Vector2d least;
    Vector2d most;
};

PixelBox boxOf(const DetectedTag& tag) {
    PixelBox box{tag.corners[0], tag.corners[0]};
    for (const Vector2d& corner : tag.corners) {
        box.least = box.least.cwiseMin(corner);
        box.most = box.most.cwiseMax(corner);
    }
    return box;
}

/// The pixels of the box, and of the tag's rim around it, on the plane.
std::vector<TagPixel> pixelsIn(const PixelBox& box, const cv::Mat& grey, const Lens& lens,
                               const TouchingPlane& plane) {
    const Vector2d beyond = kBeyond * (box.most - box.least) + Vector2d(2, 2);
    const Eigen::Vector2i from = (box.least - beyond).array().floor().cast<int>().max(0);
    const Eigen::Vector2i to =
        (box.most + beyond).array().ceil().cast<int>().min(Eigen::Array2i(grey.cols - 1, grey.rows - 1));
    std::vector<TagPixel> pixels;
    for (int y = from.y(); y <= to.y(); ++y) {
        for (int x = from.x(); x <= to.x(); ++x) {
            const auto ray = lens.ray({x, y});
            const auto at = ray ? plane.at(*ray) : std::nullopt;
            if (at) {
                pixels.push_back({*at, static_cast<double>(grey.at<std::uint8_t>(y, x))});
            }
        }
    }
    return pixels;
}

/// The angle between a pixel and the one below. Empty where the lens does not look.
std::optional<double> pitchAt(const Vector2d& pixel, const Lens& lens) {
    const auto here = lens.ray(pixel);
    const auto below = lens.ray(pixel + Vector2d(0, 1));
    return here && below ? std::optional((*here - *below).norm()) : std::nullopt;
}

/// The tag with its corners fitted; empty if it is none.
std::optional<SeenTag> fitted(const DetectedTag& tag, const cv::Mat& grey, const Lens& lens) {
    TagCorners<Vector3d> rays;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const auto ray = lens.ray(tag.corners[i]);
        if (!ray) {
            return std::nullopt;
        }
        rays[i] = *ray;
    }
    const TouchingPlane plane(rays[0] + rays[1] + rays[2] + rays[3], lens.down);
    TagCorners<Vector2d> about;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const auto at = plane.at(rays[i]);
        if (!at) {
            return std::nullopt;
        }
        about[i] = *at;
    }
    const PixelBox box = boxOf(tag);
    const auto pitch = pitchAt(0.5 * (box.least + box.most), lens);
    const auto fit = pitch ? fittedTag(tagCells(tag.number), pixelsIn(box, grey, lens, plane), *pitch, about)
                           : std::nullopt;
    if (!fit) {
        return std::nullopt;
    }
    SeenTag seen;
    seen.number = tag.number;
    std::ranges::transform(fit->corners, seen.directions.begin(),
                           [&](const Vector2d& at) { return plane.direction(at); });
    seen.sigmaRad = fit->sigma;
    return seen;
}

bool isSame(const SeenTag& a, const SeenTag& b) {
    const double size = (a.directions[0] - a.directions[2]).norm();
    return a.number == b.number && (a.directions[0] - b.directions[0]).norm() < kSameTag * size;
}

std::vector<SeenTag> tagsIn(const cv::Mat& grey, const Lens& lens) {
    std::vector<SeenTag> seen;
    for (const DetectedTag& tag : detectedTags(grey)) {
        const auto fit = fitted(tag, grey, lens);
        // What a photo continues by at its seam shows some tags twice.
        if (fit && std::ranges::none_of(seen, [&](const SeenTag& other) { return isSame(other, *fit); })) {
            seen.push_back(*fit);
        }
    }
    std::ranges::sort(seen, {}, [](const SeenTag& tag) {
        return std::pair(tag.number, -std::atan2(tag.directions[0].y(), tag.directions[0].x()));
    });
    return seen;
}

} // namespace

std::vector<SeenTag> seenTags(const RgbImage& photo) {
    const EquirectSize size{photo.width(), photo.height()};
    if (photo.empty() || photo.width() != 2 * photo.height()) {
        throw Error(ErrorKind::InvalidInput,
                    text("A photo of ", photo.width(), " x ", photo.height(),
                         " pixels is not twice as wide as high: no tags can be looked for in it."));
    }
    const int top = static_cast<int>((90 - kHighest) / 180 * size.height);
    const int bottom = static_cast<int>((90 - kLowest) / 180 * size.height);
    const int more = static_cast<int>(kSeam / 360 * size.width);
    cv::Mat grey;
    const cv::Mat band = greyOf(photo).rowRange(top, bottom);
    cv::hconcat(band, band.colRange(0, more), grey);
    const Lens lens{[&](const Vector2d& pixel) -> std::optional<Vector3d> {
                        return direction(size, pixel + Vector2d(0, top));
                    },
                    -Vector3d::UnitZ()};
    return tagsIn(grey, lens);
}

std::vector<SeenTag> seenTags(const RgbImage& picture, const CameraModel& camera) {
    if (picture.width() != camera.width() || picture.height() != camera.height()) {
        throw Error(ErrorKind::InvalidInput,
                    text("A picture of ", picture.width(), " x ", picture.height(),
                         " pixels is not of a camera with ", camera.width(), " x ", camera.height(), "."));
    }
    return tagsIn(greyOf(picture),
                  {[&](const Vector2d& pixel) { return camera.ray(pixel); }, Vector3d::UnitY()});
}

} // namespace spherewalk::photo

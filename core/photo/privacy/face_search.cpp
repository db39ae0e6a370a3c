// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/photo/face_search.h"

#include "picture/opencv_picture.h"

#include "spherewalk/base/parallel.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/geometry/equirect.h"

#include <Eigen/Geometry>
#include <opencv2/imgproc.hpp>
#include <opencv2/objdetect.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <numbers>
#include <tuple>

namespace spherewalk::photo {

namespace fs = std::filesystem;

using Eigen::Vector2d;
using Eigen::Vector3d;
using survey::PrivateRegion;

namespace {

constexpr double kPi = std::numbers::pi;

/// What a cascade was made to find.
enum class Aspect { Frontal, Profile, MirroredProfile };

/// The cascades of one thread: OpenCV lets no two threads share one.
struct Cascades {
    cv::CascadeClassifier frontal;
    cv::CascadeClassifier frontalToo; ///< It was trained in another way, and errs elsewhere.
    cv::CascadeClassifier profile;

    cv::CascadeClassifier& of(Aspect aspect) { return aspect == Aspect::Frontal ? frontal : profile; }
};

/// A camera that looks into the photo. Units: pixels.
struct FaceView {
    Vector3d forward;
    Vector3d right;
    Vector3d down;
    int side = 0; ///< Of the square picture.
    double perTangent = 0;

    FaceView(const SphericalDirection& towards, int sidePx, double focalPx)
        : forward(direction(towards)),
          right(sin(towards.azimuth), -cos(towards.azimuth), 0),
          down(forward.cross(right)),
          side(sidePx),
          perTangent(focalPx) {}

    Vector3d ray(const Vector2d& at) const {
        const Vector2d aside = (at - Vector2d::Constant((side - 1) / 2.0)) / perTangent;
        return (forward + aside.x() * right + aside.y() * down).normalized();
    }

    /// Where each pixel lies in a photo of this size.
    cv::Mat places(const EquirectSize& size) const {
        cv::Mat result(side, side, CV_32FC2);
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                const Vector2d at = pixel(size, ray({x, y}));
                result.at<cv::Vec2f>(y, x) = {static_cast<float>(at.x()), static_cast<float>(at.y())};
            }
        }
        return result;
    }
};

/// What a camera sees of the grey photo.
cv::Mat seenAt(const cv::Mat& places, const cv::Mat& grey) {
    cv::Mat seen;
    cv::remap(grey, seen, places, cv::noArray(), cv::INTER_LINEAR, cv::BORDER_WRAP);
    return seen;
}

/// Where a cascade has found something. size: the angle of its square.
struct Hit {
    Vector3d towards;
    double size = 0;
    Aspect aspect = Aspect::Frontal;
    int count = 0; ///< How many neighbouring squares the cascade took for a face.
};

constexpr double kViewField = 60 * kPi / 180;
constexpr double kRingElevation = 22 * kPi / 180;
constexpr int kViewsInRing = 8;
constexpr int kLeastFacePx = 24;
constexpr double kFrontalStep = 1.2; ///< Between the sizes of faces that are looked for.
constexpr double kProfileStep = 1.3;

/// A view of a ring, and its places in the photo.
struct RingView {
    FaceView camera;
    cv::Mat places;
};

/// The views of a ring see the same places, turned by some columns.
std::vector<RingView> viewsAround(const cv::Mat& grey) {
    const double focalPx = grey.cols / (2 * kPi);
    const int side = static_cast<int>(2 * focalPx * std::tan(kViewField / 2));
    std::vector<RingView> views;
    for (const double elevation : {kRingElevation, -kRingElevation}) {
        const FaceView ahead({Radians(0), Radians(elevation)}, side, focalPx);
        const cv::Mat places = ahead.places({grey.cols, grey.rows});
        for (int i = 0; i < kViewsInRing; ++i) {
            const double turns = (i + (elevation > 0 ? 0 : 0.5)) / kViewsInRing;
            views.push_back({FaceView({Radians(2 * kPi * turns), Radians(elevation)}, side, focalPx),
                             places - cv::Scalar(turns * grey.cols, 0)});
        }
    }
    return views;
}

/// The squares of a view in which a cascade sees something.
void addHits(const cv::Mat& seen, const FaceView& from, Aspect aspect, cv::CascadeClassifier& cascade,
             std::vector<Hit>& hits) {
    std::vector<cv::Rect> squares;
    std::vector<int> counts;
    cascade.detectMultiScale(seen, squares, counts, aspect == Aspect::Frontal ? kFrontalStep : kProfileStep,
                             1, 0, cv::Size(kLeastFacePx, kLeastFacePx),
                             cv::Size(from.side / 2, from.side / 2));
    for (std::size_t i = 0; i < squares.size(); ++i) {
        Vector2d middle(squares[i].x + (squares[i].width - 1) / 2.0,
                        squares[i].y + (squares[i].height - 1) / 2.0);
        if (aspect == Aspect::MirroredProfile) {
            middle.x() = from.side - 1 - middle.x();
        }
        const Vector3d towards = from.ray(middle);
        hits.push_back(
            {towards, squares[i].width / from.perTangent * towards.dot(from.forward), aspect, counts[i]});
    }
}

cv::Mat mirrored(const cv::Mat& picture) {
    cv::Mat result;
    cv::flip(picture, result, 1);
    return result;
}

std::vector<Hit> hitsIn(const cv::Mat& grey, const RingView& from, Cascades& cascades) {
    const cv::Mat seen = seenAt(from.places, grey);
    std::vector<Hit> hits;
    addHits(seen, from.camera, Aspect::Frontal, cascades.frontal, hits);
    addHits(seen, from.camera, Aspect::Profile, cascades.profile, hits);
    addHits(mirrored(seen), from.camera, Aspect::MirroredProfile, cascades.profile, hits);
    return hits;
}

/// Whether both are of one face: near each other, and of a similar size.
bool isSameFace(const Hit& a, const Hit& b) {
    constexpr double kSimilar = 2;
    const double apart = std::acos(std::clamp(a.towards.dot(b.towards), -1.0, 1.0));
    return apart < 0.5 * std::max(a.size, b.size) && a.size < kSimilar * b.size && b.size < kSimilar * a.size;
}

/// One hit a face and aspect, in an order that does not depend on threads.
std::vector<Hit> merged(std::vector<Hit> hits) {
    std::ranges::sort(hits, [](const Hit& a, const Hit& b) {
        const auto key = [](const Hit& hit) {
            return std::tuple(-hit.count, hit.aspect, hit.towards.x(), hit.towards.y(), hit.towards.z());
        };
        return key(a) < key(b);
    });
    std::vector<Hit> result;
    for (const Hit& hit : hits) {
        if (std::ranges::none_of(result, [&](const Hit& other) {
                return other.aspect == hit.aspect && isSameFace(other, hit);
            })) {
            result.push_back(hit);
        }
    }
    return result;
}

constexpr std::array kCloseUpsPx{36.0, 44.0, 54.0}; ///< Sizes of the face in close-ups.
constexpr std::array kRollsDeg{-6.0, 0.0, 6.0};
constexpr int kCloseUps = static_cast<int>(kCloseUpsPx.size() * kRollsDeg.size());
/// Of kCloseUps times two cascades. Faces reach 14 and more, other things 12: see resources/docs/figures.md.
constexpr int kLeastFrontal = 14;
constexpr int kLeastProfile = 8; ///< Of kCloseUps, with one cascade.

/// Whether the cascade sees a face in the middle of a close-up.
bool confirms(const cv::Mat& closeUp, double facePx, cv::CascadeClassifier& cascade) {
    std::vector<cv::Rect> squares;
    const auto side = [](double px) { return cv::Size(static_cast<int>(px), static_cast<int>(px)); };
    cascade.detectMultiScale(closeUp, squares, 1.1, 1, 0, side(0.65 * facePx), side(1.6 * facePx));
    return std::ranges::any_of(squares, [&](const cv::Rect& square) {
        const double x = square.x + (square.width - closeUp.cols) / 2.0;
        const double y = square.y + (square.height - closeUp.rows) / 2.0;
        return std::hypot(x, y) < 0.4 * facePx;
    });
}

/// Looks at what was found again: closer, farther, aside and leaning. A face stays one. What a cascade takes
/// for a face by chance does not.
bool isFace(const Hit& hit, const cv::Mat& grey, Cascades& cascades) {
    constexpr double kAround = 2.2;
    constexpr double kAside = 0.04;
    const SphericalDirection middle = sphericalDirection(hit.towards);
    const bool isFrontal = hit.aspect == Aspect::Frontal;
    int doubts = isFrontal ? 2 * kCloseUps - kLeastFrontal : kCloseUps - kLeastProfile; // that may be left
    for (int i = 0; i < kCloseUps && doubts >= 0; ++i) {
        const auto row = static_cast<std::size_t>(i / static_cast<int>(kRollsDeg.size()));
        const auto column = static_cast<std::size_t>(i % static_cast<int>(kRollsDeg.size()));
        const double facePx = kCloseUpsPx[row];
        const auto aside = [&](std::size_t index) {
            return (static_cast<double>(index) - 1) * kAside * hit.size;
        };
        const int side = static_cast<int>(kAround * facePx);
        FaceView from({middle.azimuth + Radians(aside(column)), middle.elevation + Radians(aside(row))}, side,
                      facePx / hit.size);
        const Eigen::AngleAxisd roll(Degrees(kRollsDeg[column]).value() * kPi / 180, from.forward);
        from.right = roll * from.right;
        from.down = roll * from.down;
        const cv::Mat ahead = seenAt(from.places({grey.cols, grey.rows}), grey);
        const cv::Mat closeUp = hit.aspect == Aspect::MirroredProfile ? mirrored(ahead) : ahead;
        doubts -= confirms(closeUp, facePx, cascades.of(hit.aspect)) ? 0 : 1;
        doubts -= !isFrontal || confirms(closeUp, facePx, cascades.frontalToo) ? 0 : 1;
    }
    return doubts >= 0;
}

/// The cascades' squares leave hair, ears and chin out.
PrivateRegion regionOf(const Hit& hit) {
    constexpr double kWider = 1.35;
    constexpr double kHigher = 1.6;
    constexpr double kMost = 1.2; // radians
    return survey::regionAround(hit.towards, Radians(std::min(kWider * hit.size, kMost)),
                                Radians(std::min(kHigher * hit.size, kMost)));
}

fs::path installedCascades() {
    for (const char* folder : {"/usr/share/opencv4/haarcascades", "/usr/local/share/opencv4/haarcascades"}) {
        if (fs::is_directory(folder)) {
            return folder;
        }
    }
    return "/usr/share/opencv4/haarcascades";
}

cv::CascadeClassifier cascadeIn(const fs::path& folder, const char* name) {
    const fs::path file = folder / name;
    if (!fs::is_regular_file(file)) {
        throw Error(ErrorKind::NotFound,
                    text("Faces cannot be looked for: there is no file ", file.string(),
                         ". Install the package opencv-data, or mark the regions yourself."));
    }
    cv::CascadeClassifier cascade;
    bool isRead = false;
    try {
        isRead = cascade.load(file.string());
    } catch (const cv::Exception& error) {
        throw Error(ErrorKind::Corrupt, text("The file ", file.string(), " is no cascade."), error.what());
    }
    if (!isRead) {
        throw Error(ErrorKind::Corrupt, text("The file ", file.string(), " is no cascade."));
    }
    return cascade;
}

} // namespace

struct FaceSearch::Parts {
    fs::path folder;
    std::mutex mutex;
    std::vector<std::unique_ptr<Cascades>> free;

    std::unique_ptr<Cascades> read() const {
        return std::make_unique<Cascades>(Cascades{cascadeIn(folder, "haarcascade_frontalface_alt2.xml"),
                                                   cascadeIn(folder, "haarcascade_frontalface_default.xml"),
                                                   cascadeIn(folder, "haarcascade_profileface.xml")});
    }

    /// Calls use(cascades) with cascades that no other thread uses.
    template <class Use>
    auto with(const Use& use) {
        std::unique_ptr<Cascades> own;
        {
            const std::scoped_lock lock(mutex);
            if (!free.empty()) {
                own = std::move(free.back());
                free.pop_back();
            }
        }
        if (!own) {
            own = read();
        }
        auto result = translated("look for faces", [&] { return use(*own); });
        const std::scoped_lock lock(mutex);
        free.push_back(std::move(own));
        return result;
    }
};

FaceSearch::FaceSearch(const fs::path& folder) : m_parts(std::make_unique<Parts>()) {
    m_parts->folder = folder.empty() ? installedCascades() : folder;
    m_parts->free.push_back(m_parts->read());
}

FaceSearch::~FaceSearch() = default;
FaceSearch::FaceSearch(FaceSearch&&) noexcept = default;
FaceSearch& FaceSearch::operator=(FaceSearch&&) noexcept = default;

std::vector<PrivateRegion> FaceSearch::faces(const RgbImage& photo, int threads,
                                             const std::stop_token& stop) const {
    if (photo.empty() || photo.width() != 2 * photo.height()) {
        throw Error(ErrorKind::InvalidInput,
                    text("A photo of ", photo.width(), " x ", photo.height(),
                         " pixels is not twice as wide as high: no faces can be looked for in it."));
    }
    cv::Mat grey;
    cv::cvtColor(matOver(photo), grey, cv::COLOR_RGB2GRAY);
    cv::Mat coarse = grey;
    if (grey.cols > kFaceSearchWidth) {
        cv::resize(grey, coarse, cv::Size(kFaceSearchWidth, kFaceSearchWidth / 2), 0, 0, cv::INTER_AREA);
    }
    const std::vector<RingView> views = viewsAround(coarse);
    std::vector<std::vector<Hit>> seen(views.size());
    parallelFor(static_cast<int>(views.size()), 1, threads, [&](int i, int /*end*/) {
        throwIfStopped(stop);
        const auto k = static_cast<std::size_t>(i);
        seen[k] = m_parts->with([&](Cascades& cascades) { return hitsIn(coarse, views[k], cascades); });
    });
    std::vector<Hit> all;
    for (const std::vector<Hit>& hits : seen) {
        all.insert(all.end(), hits.begin(), hits.end());
    }
    const std::vector<Hit> hits = merged(std::move(all));
    std::vector<std::uint8_t> areFaces(hits.size());
    parallelFor(static_cast<int>(hits.size()), 1, threads, [&](int i, int /*end*/) {
        throwIfStopped(stop);
        const auto k = static_cast<std::size_t>(i);
        areFaces[k] =
            m_parts->with([&](Cascades& cascades) { return isFace(hits[k], grey, cascades) ? 1 : 0; }) != 0
                ? 1
                : 0;
    });
    std::vector<PrivateRegion> regions;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const PrivateRegion region = regionOf(hits[i]);
        if (areFaces[i] != 0 && !survey::isAmong(region, regions)) {
            regions.push_back(region);
        }
    }
    return regions;
}

} // namespace spherewalk::photo

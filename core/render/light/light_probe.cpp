// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/render/light_probe.h"

#include "dataset/depth_steps.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/render/colour_correction.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>

namespace spherewalk::render {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr int kLeastWidth = 16;
constexpr int kMostWidth = 8192;
constexpr int kRim = 2;       ///< Pixels of a face beyond its quarter turn, for the interpolation.
constexpr int kClipped = 250; ///< A JPEG's white is rarely 255 throughout.
constexpr std::size_t kMostDarker = 8;
constexpr double kDarker = 1.02; ///< The least ratio of gains of a photo that may show more.
constexpr double kSameSurface = 0.06;

/// Faces look along the room's axes; the columns are the camera's x, y and z.
Eigen::Quaterniond faceRotation(int face) {
    const double sign = face % 2 == 0 ? 1 : -1;
    const Vector3d ahead = sign * Vector3d::Unit(face / 2);
    const Vector3d down = face / 2 == 2 ? Vector3d(sign * Vector3d::UnitX()) : Vector3d(-Vector3d::UnitZ());
    Eigen::Matrix3d columns;
    columns << down.cross(ahead), down, ahead;
    return Eigen::Quaterniond(columns);
}

/// One of six views that together show all directions.
struct Face {
    Rigid3 roomFromCamera;
    View view;
    RadianceImage light;
    MaskImage clipped; ///< 255 where no photo has shown all of the light yet.
    MaskImage recovered;
};

/// A darker photo, with the gain that makes it as bright as the views.
struct DarkerPhoto {
    std::size_t photo;
    RgbImage picture;
    Vector3d gain;
    std::shared_ptr<const DepthSteps> depth; ///< Null if the photo has none.
};

bool isClipped(const std::uint8_t* rgb) {
    return std::max({rgb[0], rgb[1], rgb[2]}) >= kClipped;
}

Vector3d storedColour(const std::uint8_t* rgb) {
    return Vector3d(rgb[0], rgb[1], rgb[2]) / 255;
}

Vector3d gainOf(const DatasetInfo& info, std::size_t photo) {
    return info.photos[photo].exposureGain.value_or(Vector3d::Ones());
}

template <class Picture>
auto nearestPixel(const Picture& picture, const Vector3d& towards) {
    const Vector2d at = pixel({picture.width(), picture.height()}, towards);
    const int x = (static_cast<int>(std::lround(at.x())) + picture.width()) % picture.width();
    return std::pair(x, std::clamp(static_cast<int>(std::lround(at.y())), 0, picture.height() - 1));
}

/// Whether a photo shows the point itself rather than something before it.
bool showsPoint(const DarkerPhoto& darker, const Vector3d& pInPhoto) {
    if (darker.depth == nullptr) {
        return true;
    }
    const auto [x, y] = nearestPixel(*darker.depth, pInPhoto);
    const double inverseM = DepthSteps::inverseM(darker.depth->row(y)[x]);
    return inverseM * pInPhoto.norm() <= 1 + kSameSurface;
}

/// Looks up what is clipped in a face in a darker photo.
void recover(const DarkerPhoto& darker, const Rigid3& photoFromRoom, const CameraModel& camera, Face& face) {
    for (int y = 0; y < face.light.height(); ++y) {
        for (int x = 0; x < face.light.width(); ++x) {
            if (*face.clipped.at(x, y) == 0) {
                continue;
            }
            const Vector3d ray = *camera.ray(Vector2d(x, y));
            const float z = face.view.depth.empty() ? 0 : *face.view.depth.at(x, y);
            const bool isNear = z > 0 && std::isfinite(z);
            const Vector3d towards =
                isNear ? Vector3d(photoFromRoom * (face.roomFromCamera * (ray * (z / ray.z()))))
                       : Vector3d(photoFromRoom.rotation * (face.roomFromCamera.rotation * ray));
            if (isNear && !showsPoint(darker, towards)) {
                continue;
            }
            const auto [u, v] = nearestPixel(darker.picture, towards);
            const std::uint8_t* rgb = darker.picture.at(u, v);
            const Vector3d stored = storedColour(rgb).cwiseProduct(darker.gain);
            if (stored.maxCoeff() * 255 < kClipped) {
                continue; // it shows something else, or the light was off
            }
            const bool isWhole = !isClipped(rgb);
            for (int c = 0; c < 3; ++c) {
                const auto light = static_cast<float>(linearLight(stored[c]));
                float& own = face.light.at(x, y)[c];
                own = isWhole ? light : std::max(own, light);
            }
            *face.clipped.at(x, y) = isWhole ? 0 : 255;
            *face.recovered.at(x, y) = isWhole ? 255 : 0;
        }
    }
}

/// Photos that were taken darker than this one and see the place, the nearest first.
std::vector<DarkerPhoto> darkerPhotos(const Dataset& dataset, std::size_t than, const Vector3d& pInRoom,
                                      int width) {
    const DatasetInfo& info = dataset.info();
    const Vector3d own = gainOf(info, than);
    PhotoQuery query;
    query.most = kMostDarker;
    query.isUsable = [&](std::size_t photo) { return gainOf(info, photo).mean() > kDarker * own.mean(); };
    const NearPhotos near = dataset.photosNear(pInRoom, query);
    std::vector<DarkerPhoto> darker;
    for (std::size_t i = 0; near.seesPlace && i < near.photos.size(); ++i) {
        const DatasetPhoto& photo = info.photos[near.photos[i]];
        DarkerPhoto& made = darker.emplace_back();
        made.photo = near.photos[i];
        made.picture = jpeg::decodeAtLeast(dataset.readPhoto(made.photo), photo.file, 2 * width);
        made.gain = gainOf(info, made.photo).cwiseQuotient(own);
        made.depth = photo.depth.empty() ? nullptr : dataset.depth(made.photo);
    }
    return darker;
}

void correct(const ColourCorrection& colour, RadianceImage& light) {
    for (std::size_t i = 0; i < light.values().size(); i += 3) {
        const std::span<float> rgb = light.values().subspan(i, 3);
        // What is brighter than white keeps the colour that white of its hue gets.
        const double scale = std::max(1.0F, *std::max_element(rgb.begin(), rgb.end()));
        const Vector3d stored = (Vector3d(rgb[0], rgb[1], rgb[2]) / scale).unaryExpr(&storedValue);
        const Vector3d corrected = scale * colour.corrected(stored).unaryExpr(&linearLight);
        for (int c = 0; c < 3; ++c) {
            rgb[static_cast<std::size_t>(c)] = static_cast<float>(corrected[c]);
        }
    }
}

/// The number of the face that shows the direction.
int faceOf(const Vector3d& towards) {
    int axis = 0;
    towards.cwiseAbs().maxCoeff(&axis);
    return 2 * axis + (towards[axis] < 0 ? 1 : 0);
}

/// Adds what the faces show in a direction to a probe's pixel, and counts what is clipped or recovered.
void addSample(const std::array<Face, 6>& faces, const CameraModel& camera, const Vector3d& towards,
               Vector3d& light, int& clipped, int& recovered) {
    const Face& face = faces[static_cast<std::size_t>(faceOf(towards))];
    const Vector2d at = *camera.project(face.roomFromCamera.rotation.conjugate() * towards);
    const int x = std::clamp(static_cast<int>(at.x()), 0, camera.width() - 2);
    const int y = std::clamp(static_cast<int>(at.y()), 0, camera.height() - 2);
    const double right = at.x() - x;
    const double below = at.y() - y;
    for (const auto& [i, j] : {std::pair{0, 0}, {1, 0}, {0, 1}, {1, 1}}) {
        const double weight = (i == 1 ? right : 1 - right) * (j == 1 ? below : 1 - below);
        const float* rgb = face.light.at(x + i, y + j);
        light += weight * Vector3d(rgb[0], rgb[1], rgb[2]);
    }
    clipped += *face.clipped.at(x + (right > 0.5 ? 1 : 0), y + (below > 0.5 ? 1 : 0)) == 0 ? 0 : 1;
    recovered += *face.recovered.at(x + (right > 0.5 ? 1 : 0), y + (below > 0.5 ? 1 : 0)) == 0 ? 0 : 1;
}

void gather(const std::array<Face, 6>& faces, const CameraModel& camera, LightProbe& probe, int width) {
    constexpr int kSide = 2; // samples of a pixel along each axis
    const EquirectSize size{width, width / 2};
    probe.radiance = RadianceImage(size.width, size.height);
    probe.clipped = MaskImage(size.width, size.height);
    double clippedSum = 0;
    double recoveredSum = 0;
    double sum = 0;
    for (int v = 0; v < size.height; ++v) {
        const double angle = std::cos(std::numbers::pi * (0.5 - (v + 0.5) / size.height));
        for (int u = 0; u < size.width; ++u) {
            Vector3d light = Vector3d::Zero();
            int clipped = 0;
            int recovered = 0;
            for (int j = 0; j < kSide; ++j) {
                for (int i = 0; i < kSide; ++i) {
                    const Vector2d inside((i + 0.5) / kSide - 0.5, (j + 0.5) / kSide - 0.5);
                    addSample(faces, camera, direction(size, Vector2d(u, v) + inside), light, clipped,
                              recovered);
                }
            }
            for (int c = 0; c < 3; ++c) {
                probe.radiance.at(u, v)[c] = static_cast<float>(light[c] / (kSide * kSide));
            }
            *probe.clipped.at(u, v) = clipped > 0 ? 255 : 0;
            clippedSum += angle * clipped;
            recoveredSum += angle * recovered;
            sum += angle * kSide * kSide;
        }
    }
    probe.clippedShare = clippedSum / sum;
    probe.recoveredShare = recoveredSum / sum;
}

void lightOf(Face& face) {
    const RgbImage& picture = face.view.picture;
    face.light = RadianceImage(picture.width(), picture.height());
    face.clipped = MaskImage(picture.width(), picture.height());
    face.recovered = face.clipped;
    std::array<float, 256> light;
    for (std::size_t value = 0; value < light.size(); ++value) {
        light[value] = static_cast<float>(linearLight(static_cast<double>(value) / 255));
    }
    std::transform(picture.values().begin(), picture.values().end(), face.light.values().begin(),
                   [&](std::uint8_t value) { return light[value]; });
    for (std::size_t i = 0; i < face.clipped.values().size(); ++i) {
        face.clipped.values()[i] = isClipped(&picture.values()[3 * i]) ? 255 : 0;
    }
}

} // namespace

void ProbeOptions::validate() const {
    if (width < kLeastWidth || width > kMostWidth || width % 2 != 0) {
        throw Error(ErrorKind::InvalidInput,
                    text("A light probe cannot be ", width, " pixels wide; give an even number from ",
                         kLeastWidth, " to ", kMostWidth, "."));
    }
}

LightProbe lightProbe(const Renderer& renderer, const Vector3d& pInRoom, const ProbeOptions& options) {
    options.validate();
    const int side = options.width + 2 * kRim;
    const double middle = (side - 1) / 2.0;
    const double focal = options.width / 2.0; // 90 degrees without the rim
    const CameraModel camera(
        CameraIntrinsics{side, side, focal, focal, middle, middle, LensModel::Pinhole, {}});
    ViewOptions view;
    view.scene = options.scene;
    view.threads = options.threads;
    view.wantsDepth = true;
    view.correctsColour = false; // what is clipped is so in the photos' own colours
    std::array<Face, 6> faces;
    for (int i = 0; i < 6; ++i) {
        Face& face = faces[static_cast<std::size_t>(i)];
        face.roomFromCamera = {faceRotation(i), pInRoom};
        renderer.render(camera, face.roomFromCamera, view, face.view);
        lightOf(face);
    }
    const Dataset& dataset = renderer.dataset();
    const auto isAnyClipped = [](const Face& face) {
        return std::any_of(face.clipped.values().begin(), face.clipped.values().end(),
                           [](std::uint8_t value) { return value != 0; });
    };
    LightProbe probe;
    probe.report = faces[0].view.report;
    if (std::any_of(faces.begin(), faces.end(), isAnyClipped)) {
        for (const DarkerPhoto& darker : darkerPhotos(dataset, probe.report.photo, pInRoom, options.width)) {
            const Rigid3 photoFromRoom = dataset.info().photos[darker.photo].roomFromPhoto.inverse();
            for (Face& face : faces) {
                recover(darker, photoFromRoom, camera, face);
            }
        }
    }
    if (options.correctsColour && dataset.info().colour) {
        for (Face& face : faces) {
            correct(*dataset.info().colour, face.light);
        }
    }
    gather(faces, camera, probe, options.width);
    return probe;
}

Bytes radianceFile(const RadianceImage& picture) {
    if (picture.empty()) {
        throw Error(ErrorKind::InvalidInput, "A light probe without pixels cannot be written.");
    }
    const std::string header =
        text("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y ", picture.height(), " +X ", picture.width(), "\n");
    const ByteView head = bytesOf(header);
    Bytes file(head.begin(), head.end());
    // Pixels follow each other without run lengths. None looks like the begin of a run: the greatest of its
    // three numbers is at least 128.
    for (std::size_t i = 0; i < picture.values().size(); i += 3) {
        const std::span<const float> rgb = picture.values().subspan(i, 3);
        const float greatest = *std::max_element(rgb.begin(), rgb.end());
        int exponent = 0;
        const float fraction = std::frexp(greatest, &exponent);
        constexpr float kLeast = 1e-32F;
        if (!(greatest > kLeast)) {
            file.insert(file.end(), 4, static_cast<Bytes::value_type>(0));
            continue;
        }
        for (const float value : rgb) {
            const float scaled = std::max(0.0F, value) * (fraction * 256 / greatest) + 0.5F;
            file.push_back(static_cast<Bytes::value_type>(std::min(255, static_cast<int>(scaled))));
        }
        file.push_back(static_cast<Bytes::value_type>(exponent + 128));
    }
    return file;
}

} // namespace spherewalk::render

// SPDX-License-Identifier: GPL-3.0-or-later
#include "photo/exposure.h"

#include "spherewalk/base/clock.h"
#include "spherewalk/base/digest.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/fixed_random.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/practice/theta_jpeg.h"

#include <algorithm>

namespace spherewalk::practice {

namespace {

constexpr std::uint64_t kMaxGivenBytes = 256ULL << 20;
constexpr int kPreviewQuality = 80;
constexpr int kPreviewReduction = 4; ///< of a photo that is shown as a preview
constexpr std::uint64_t kPersonStream = 0xa54ff53a5f1d36f1ULL;
constexpr double kPoseNoiseDeg = 0.3; ///< of the accelerometer behind GPano's pitch and roll

/// GPano's signs: pitch > 0 looks up, which is our pitch below zero; roll is ours.
void describePose(ThetaTags& tags, const YawPitchRoll& angles, bool levelled, FixedRandom& random) {
    const double pitch = -Degrees(angles.pitch).value() + random.normal(kPoseNoiseDeg);
    const double roll = Degrees(angles.roll).value() + random.normal(kPoseNoiseDeg);
    tags.levelled = levelled;
    tags.inclinationPitchDeg = pitch;
    tags.inclinationRollDeg = roll;
    tags.posePitchDeg = levelled ? 0 : pitch;
    tags.poseRollDeg = levelled ? 0 : roll;
}

/// The nearest pixels, which is good enough to see where a camera stands.
RgbImage sampled(const RgbImage& picture, const EquirectSize& size) {
    RgbImage result(size.width, size.height);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const std::uint8_t* pixel =
                picture.at(x * picture.width() / size.width, y * picture.height() / size.height);
            std::copy_n(pixel, RgbImage::kChannels, result.at(x, y));
        }
    }
    return result;
}

/// Stripes as wide as the shot's number says, and a pattern: no two of a survey's photos are alike.
RgbImage plain(const EquirectSize& size, int shot) {
    RgbImage picture(size.width, size.height);
    const int period = 8 + shot % 97;
    for (int y = 0; y < size.height; ++y) {
        const int shade = 60 + 40 * (y / period % 2) + shot / 97 % 60;
        for (int x = 0; x < size.width; ++x) {
            std::fill_n(picture.at(x, y), RgbImage::kChannels,
                        static_cast<std::uint8_t>(shade + (x ^ y) % 16));
        }
    }
    return picture;
}

} // namespace

void PhotoErrors::validate() const {
    const double tiltDeg = Degrees(tiltSigma).value();
    if (!(tiltDeg >= 0 && tiltDeg <= 30)) {
        throw Error(
            ErrorKind::InvalidInput,
            text("The practice camera's tilt error must be between 0 and 30 degrees, not ", tiltDeg, "."));
    }
    if (!(positionSigmaM >= 0 && positionSigmaM <= 1)) {
        throw Error(ErrorKind::InvalidInput,
                    text("The practice camera's position error must be between 0 and 1 m, not ",
                         positionSigmaM, "."));
    }
}

Rigid3 PhotoErrors::truePose(const Eigen::Vector3d& nominalPositionM, int shot) const {
    FixedRandom random(seed, static_cast<std::uint64_t>(shot));
    const double yaw = random.uniform(-std::numbers::pi, std::numbers::pi);
    const double pitch = random.normal(tiltSigma.value());
    const double roll = random.normal(tiltSigma.value());
    Rigid3 pose;
    pose.rotation = rotation({Radians(anyYaw ? yaw : 0), Radians(pitch), Radians(roll)});
    pose.translation = nominalPositionM;
    for (int i = 0; i < 3; ++i) {
        pose.translation[i] += random.normal(positionSigmaM);
    }
    return pose;
}

Exposer::Exposer(const PracticeCameraOptions& options) : m_options(options) {
    if (options.photoFolder.empty()) {
        m_room.emplace(options.room);
        return;
    }
    for (const PlacedPhoto& photo : options.photos) {
        if (!std::filesystem::exists(options.photoFolder / photo.file)) {
            throw Error(ErrorKind::NotFound, text("Could not start the practice camera: there is no photo ",
                                                  (options.photoFolder / photo.file).string(),
                                                  ", which the list of positions names."));
        }
    }
}

ExposedPhoto Exposer::expose(const ExposureSettings& settings, const std::stop_token& stop) const {
    ExposedPhoto photo = m_room ? drawn(settings, stop) : taken(settings);
    photo.truth.shot = settings.shot;
    photo.truth.nominalPositionM = settings.nominalPositionM;
    photo.truth.time = isoUtc(settings.time.utc);
    photo.truth.options = settings.options;
    if (settings.defect == PhotoDefect::Empty) {
        photo.jpeg.clear();
    }
    photo.truth.sha256 = sha256Hex(photo.jpeg);
    return photo;
}

/// How the picture is turned: by the zenith correction, if that is on.
Rigid3 Exposer::poseOf(const ExposureSettings& settings) const {
    Rigid3 pose = m_options.errors.truePose(settings.nominalPositionM, settings.standing);
    if (settings.levelled) {
        pose.rotation = yawRotation(yawPitchRoll(pose.rotation).yaw);
    }
    return pose;
}

/// The room of this shot if a person is in it.
std::optional<PracticeRoom> Exposer::roomWithPerson(const Rigid3& pose, int shot) const {
    FixedRandom random(m_options.flaws.seed ^ kPersonStream, static_cast<std::uint64_t>(shot));
    if (random.uniform(0, 1) >= m_options.flaws.personShare) {
        return std::nullopt;
    }
    const double direction = random.uniform(-std::numbers::pi, std::numbers::pi);
    const double away = random.uniform(0.8, 2.0);
    PracticeRoomOptions room = m_options.room;
    Eigen::Vector3d at =
        pose.translation + away * Eigen::Vector3d(std::cos(direction), std::sin(direction), 0);
    const Eigen::Vector3d inside = room.originM + Eigen::Vector3d(0.3, 0.3, 0);
    at = at.cwiseMax(inside).cwiseMin(room.originM + room.sizeM - Eigen::Vector3d(0.3, 0.3, 0));
    at.z() = room.originM.z() + 0.75;
    const Radians yaw(direction);
    room.objects.push_back({PracticeObject::Shape::Box, at, {0.14, 0.23, 0.73}, yaw, {52, 60, 92}});
    at.z() = room.originM.z() + 1.62;
    room.objects.push_back({PracticeObject::Shape::Sphere, at, {0.12, 0.12, 0.12}, yaw, {205, 160, 130}});
    return PracticeRoom(room);
}

RgbImage Exposer::draw(const Rigid3& pose, int shot, const EquirectSize& size,
                       const std::stop_token& stop) const {
    const PhotoFlaws& flaws = m_options.flaws;
    const std::optional<PracticeRoom> peopled = roomWithPerson(pose, shot);
    const PracticeRoom& room = peopled ? *peopled : *m_room;
    const auto seenFrom = [&](double forwardM) {
        Rigid3 lens = pose;
        lens.translation += pose.rotation * Eigen::Vector3d(forwardM, 0, 0);
        return room.spherical(lens, size, {Content::RoomAndObjects, m_options.threads}, noProgress(), stop);
    };
    RgbImage picture = flaws.lensOffsetM > 0
                           ? stitched(seenFrom(flaws.lensOffsetM), seenFrom(-flaws.lensOffsetM))
                           : seenFrom(0);
    addFlaws(picture, flaws, shot);
    throwIfStopped(stop);
    return picture;
}

Bytes Exposer::preview(const ExposureSettings& settings, const EquirectSize& size,
                       const std::stop_token& stop) const {
    if (m_room) {
        return jpeg::encode(draw(poseOf(settings), settings.shot, size, stop), kPreviewQuality);
    }
    const auto file = m_options.photoFolder / nearestPhoto(settings.nominalPositionM).file;
    const RgbImage photo = jpeg::decode(readFile(file, kMaxGivenBytes), file.string(), kPreviewReduction);
    return jpeg::encode(sampled(photo, size), kPreviewQuality);
}

ExposedPhoto Exposer::drawn(const ExposureSettings& settings, const std::stop_token& stop) const {
    const YawPitchRoll bodyAngles =
        yawPitchRoll(m_options.errors.truePose(settings.nominalPositionM, settings.standing).rotation);
    const Rigid3 pose = poseOf(settings);
    ThetaTags tags;
    FixedRandom random(m_options.errors.seed ^ 0x6a09e667f3bcc908ULL,
                       static_cast<std::uint64_t>(settings.shot));
    describePose(tags, bodyAngles, settings.levelled, random);
    tags.time = settings.time.utc;
    tags.timeZone = settings.time.zone;
    tags.exposureProgram = settings.program == 9 ? 2 : settings.program;
    tags.exposureTimeS =
        settings.exposureTimeS > 0 ? settings.exposureTimeS : lightOf(m_options.flaws, settings.shot) / 60;
    tags.isoSpeed = settings.isoSpeed > 0 ? settings.isoSpeed : 200;
    tags.exposureBias = settings.exposureBias;
    tags.hasFixedWhiteBalance = settings.hasFixedWhiteBalance;
    tags.withMakerNote = settings.defect != PhotoDefect::NoMakerNote;
    tags.withHostileMakerNote = settings.defect == PhotoDefect::HostileMakerNote;
    const EquirectSize size{m_options.width, m_options.width / 2};
    const RgbImage picture =
        m_options.isPlain ? plain(size, settings.shot) : draw(pose, settings.shot, size, stop);
    ExposedPhoto photo;
    photo.jpeg = settings.defect == PhotoDefect::Small
                     ? jpeg::encode(plain({640, 360}, settings.shot), m_options.jpegQuality)
                     : thetaJpeg(picture, tags, m_options.jpegQuality);
    photo.truth.positionM = pose.translation;
    photo.truth.roomFromPhoto = pose.rotation;
    return photo;
}

const PlacedPhoto& Exposer::nearestPhoto(const Eigen::Vector3d& positionM) const {
    const auto distance = [&](const PlacedPhoto& photo) {
        return (photo.positionM - positionM).squaredNorm();
    };
    return *std::min_element(
        m_options.photos.begin(), m_options.photos.end(),
        [&](const PlacedPhoto& a, const PlacedPhoto& b) { return distance(a) < distance(b); });
}

std::vector<Eigen::Vector3d> Exposer::walk() const {
    constexpr double kStepM = 0.5;
    if (m_room) {
        return walkThrough(*m_room, kStepM, m_options.positionM.z());
    }
    std::vector<Eigen::Vector3d> places;
    for (const PlacedPhoto& photo : m_options.photos) {
        places.push_back(photo.positionM);
    }
    return places;
}

ExposedPhoto Exposer::taken(const ExposureSettings& settings) const {
    const PlacedPhoto& nearest = nearestPhoto(settings.nominalPositionM);
    ExposedPhoto photo;
    photo.jpeg = readFile(m_options.photoFolder / nearest.file, kMaxGivenBytes);
    photo.truth.positionM = nearest.positionM;
    photo.truth.roomFromPhoto = nearest.roomFromPhoto;
    return photo;
}

} // namespace spherewalk::practice

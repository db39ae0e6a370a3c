// SPDX-License-Identifier: GPL-3.0-or-later
#include "exposure.h"

#include "prng.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/sha256.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/practice/theta_jpeg.h"

#include <algorithm>

namespace spherewalk::practice {

namespace {

constexpr std::uint64_t kMaxPhotoBytes = 256ULL << 20;
constexpr double kPoseNoiseDeg = 0.3; ///< of the accelerometer behind GPano's pitch and roll

/// GPano's signs: pitch > 0 looks up, which is our pitch below zero; roll is ours.
void describePose(ThetaTags& tags, const YawPitchRoll& angles, bool levelled, Prng& random) {
    const double pitch = -Degrees(angles.pitch).value() + random.normal(kPoseNoiseDeg);
    const double roll = Degrees(angles.roll).value() + random.normal(kPoseNoiseDeg);
    tags.levelled = levelled;
    tags.inclinationPitchDeg = pitch;
    tags.inclinationRollDeg = roll;
    tags.posePitchDeg = levelled ? 0 : pitch;
    tags.poseRollDeg = levelled ? 0 : roll;
}

} // namespace

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
    photo.truth.sha256 = sha256Hex(photo.jpeg);
    return photo;
}

ExposedPhoto Exposer::drawn(const ExposureSettings& settings, const std::stop_token& stop) const {
    Rigid3 pose = m_options.errors.truePose(settings.nominalPositionM, settings.shot);
    const YawPitchRoll bodyAngles = yawPitchRoll(pose.rotation);
    if (settings.levelled) {
        pose.rotation = yawRotation(bodyAngles.yaw);
    }
    ThetaTags tags;
    Prng random(m_options.errors.seed ^ 0x6a09e667f3bcc908ULL, static_cast<std::uint64_t>(settings.shot));
    describePose(tags, bodyAngles, settings.levelled, random);
    tags.time = settings.time.utc;
    tags.timeZone = settings.time.zone;
    tags.exposureProgram = settings.program == 9 ? 2 : settings.program;
    tags.exposureTimeS = settings.exposureTimeS > 0 ? settings.exposureTimeS : 1.0 / 60;
    tags.isoSpeed = settings.isoSpeed > 0 ? settings.isoSpeed : 200;
    tags.exposureBias = settings.exposureBias;
    const RgbImage picture =
        m_room->spherical(pose, {m_options.width, m_options.width / 2},
                          {Content::RoomAndObjects, m_options.threads}, noProgress(), stop);
    throwIfStopped(stop);
    ExposedPhoto photo;
    photo.jpeg = thetaJpeg(picture, tags, m_options.jpegQuality);
    photo.truth.positionM = pose.translation;
    photo.truth.roomFromPhoto = pose.rotation;
    return photo;
}

ExposedPhoto Exposer::taken(const ExposureSettings& settings) const {
    const auto distance = [&](const PlacedPhoto& photo) {
        return (photo.positionM - settings.nominalPositionM).squaredNorm();
    };
    const PlacedPhoto& nearest = *std::min_element(
        m_options.photos.begin(), m_options.photos.end(),
        [&](const PlacedPhoto& a, const PlacedPhoto& b) { return distance(a) < distance(b); });
    ExposedPhoto photo;
    photo.jpeg = readFile(m_options.photoFolder / nearest.file, kMaxPhotoBytes);
    photo.truth.positionM = nearest.positionM;
    photo.truth.roomFromPhoto = nearest.roomFromPhoto;
    return photo;
}

} // namespace spherewalk::practice

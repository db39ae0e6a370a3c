// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/error.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jobs/align_trade.h"
#include "spherewalk/jobs/positions_csv.h"
#include "spherewalk/practice/truth.h"
#include "spherewalk/store/survey_store.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace spherewalk::jobs {

using Eigen::Vector3d;

namespace {

TruePoses fromPracticeCamera(const store::SurveyStore& store, const std::filesystem::path& file) {
    std::map<std::string, Rigid3> byHash;
    for (const practice::Truth& truth : practice::readTruth(file)) {
        if (truth.roomFromPhoto) {
            byHash[truth.sha256] = {*truth.roomFromPhoto, truth.positionM};
        }
    }
    TruePoses poses;
    for (const store::PhotoRecord& photo : store.photos()) {
        const auto found = byHash.find(photo.cameraSha256);
        if (found != byHash.end()) {
            poses.emplace(photo.id, found->second);
        }
    }
    return poses;
}

TruePoses fromPositions(const store::SurveyStore& store, const std::filesystem::path& file) {
    std::map<std::string, Rigid3> byName;
    for (const PhotoPosition& photo : readPositions(file)) {
        if (photo.roomFromPhoto) {
            byName[std::filesystem::path(photo.file).filename()] = {*photo.roomFromPhoto, photo.positionM};
        }
    }
    TruePoses poses;
    for (const store::PhotoRecord& photo : store.photos()) {
        const auto found = byName.find(photo.cameraFileName);
        if (found != byName.end()) {
            poses.emplace(photo.id, found->second);
        }
    }
    return poses;
}

double rootMeanSquare(double sum, int count) {
    return count > 0 ? std::sqrt(sum / count) : 0;
}

double degrees(double radians) {
    return Degrees(Radians(radians)).value();
}

/// The angle of the turn about z, which is the yaw error also where it is large.
double turnAboutZ(const Eigen::Quaterniond& q) {
    return wrapped(Radians(2 * std::atan2(q.z(), q.w()))).value();
}

} // namespace

TruePoses readTruePoses(const store::SurveyStore& store, const std::filesystem::path& file) {
    TruePoses poses =
        file.extension() == ".jsonl" ? fromPracticeCamera(store, file) : fromPositions(store, file);
    if (poses.empty()) {
        throw Error(ErrorKind::NotFound,
                    text("The file ", printable(file.string()),
                         " states the rotation of none of the survey's photos; give the truth of a practice "
                         "camera (.jsonl) or a positions file with rotations of these photos."));
    }
    return poses;
}

AlignmentError alignmentError(const AlignReport& report, const TruePoses& truth) {
    std::vector<Eigen::Quaterniond> turns; // of the solution against the truth, in the room frame
    std::vector<const align::SolvedPose*> solved;
    Vector3d offset = Vector3d::Zero();
    std::vector<Vector3d> offsets;
    double sines = 0;
    double cosines = 0;
    for (const AlignedPhoto& photo : report.photos) {
        const auto found = truth.find(photo.photo);
        if (!photo.pose.isSolved || found == truth.end()) {
            continue;
        }
        const Rigid3& pose = photo.pose.roomFromPhoto;
        turns.push_back(pose.rotation * found->second.rotation.conjugate());
        solved.push_back(&photo.pose);
        offsets.emplace_back(pose.translation - found->second.translation);
        offset += offsets.back();
        sines += std::sin(turnAboutZ(turns.back()));
        cosines += std::cos(turnAboutZ(turns.back()));
    }
    AlignmentError error;
    error.photos = static_cast<int>(turns.size());
    if (turns.empty()) {
        return error;
    }
    offset /= error.photos;
    const double common = std::atan2(sines, cosines);
    error.commonYawDeg = degrees(common);
    double yaws = 0;
    double tilts = 0;
    Eigen::Vector2d lean = Eigen::Vector2d::Zero();
    double squares = 0;
    double positions = 0;
    double yawRatios = 0;
    double tiltRatios = 0;
    int within = 0;
    for (std::size_t i = 0; i < turns.size(); ++i) {
        const Eigen::Quaterniond own = yawRotation(Radians(-common)) * turns[i];
        const Eigen::AngleAxisd turn(own.w() < 0 ? Eigen::Quaterniond(-own.coeffs()) : own);
        const Vector3d inRoom = turn.angle() * turn.axis();
        // Pitch and roll turn about the photo's own level axes.
        const Vector3d inPhoto = yawRotation(-yawPitchRoll(solved[i]->roomFromPhoto.rotation).yaw) * inRoom;
        const double tilt = inPhoto.head<2>().norm();
        lean += inRoom.head<2>() / error.photos;
        squares += inRoom.head<2>().squaredNorm() / 2;
        yaws += inRoom.z() * inRoom.z();
        tilts += tilt * tilt / 2;
        positions += (offsets[i] - offset).squaredNorm() / 3;
        error.yawWorstDeg = std::max(error.yawWorstDeg, degrees(std::abs(inRoom.z())));
        error.tiltWorstDeg = std::max(error.tiltWorstDeg, degrees(tilt));
        const auto ratio = [&](double value, Radians sigma) {
            const double over = std::abs(value) / std::max(sigma.value(), 1e-12);
            within += over <= 3 ? 1 : 0;
            return over * over;
        };
        yawRatios += ratio(inRoom.z(), solved[i]->sigmaYaw);
        tiltRatios +=
            (ratio(inPhoto.x(), solved[i]->sigmaRoll) + ratio(inPhoto.y(), solved[i]->sigmaPitch)) / 2;
    }
    error.yawRmsDeg = degrees(rootMeanSquare(yaws, error.photos));
    error.tiltRmsDeg = degrees(rootMeanSquare(tilts, error.photos));
    error.commonLeanDeg = degrees(lean.norm());
    error.ownTiltRmsDeg = degrees(std::sqrt(std::max(0.0, squares / error.photos - lean.squaredNorm() / 2)));
    error.positionRmsM = rootMeanSquare(positions, error.photos);
    error.yawOverSigma = rootMeanSquare(yawRatios, error.photos);
    error.tiltOverSigma = rootMeanSquare(tiltRatios, error.photos);
    error.within3Sigma = within / (3.0 * error.photos);
    return error;
}

Json toJson(const AlignmentError& error) {
    return {{"photos", error.photos},
            {"yaw_rms_deg", error.yawRmsDeg},
            {"yaw_worst_deg", error.yawWorstDeg},
            {"common_yaw_deg", error.commonYawDeg},
            {"tilt_rms_deg", error.tiltRmsDeg},
            {"tilt_worst_deg", error.tiltWorstDeg},
            {"common_lean_deg", error.commonLeanDeg},
            {"own_tilt_rms_deg", error.ownTiltRmsDeg},
            {"position_rms_m", error.positionRmsM},
            {"yaw_over_sigma", error.yawOverSigma},
            {"tilt_over_sigma", error.tiltOverSigma},
            {"within_3_sigma", error.within3Sigma}};
}

} // namespace spherewalk::jobs

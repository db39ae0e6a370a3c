// SPDX-License-Identifier: GPL-3.0-or-later
#include "parts/csv.h"
#include "parts/report_parts.h"

#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jobs/compare_robot.h"
#include "spherewalk/report/document.h"

#include <cmath>

namespace spherewalk::jobs {

using report::Document;
using report::Paragraph;

namespace {

std::string change(const std::optional<double>& before, const std::optional<double>& after, int digits) {
    return text(orDash(before, digits), " > ", orDash(after, digits));
}

double turnedDeg(const ComparedPicture& picture) {
    return Degrees(angleBetween(picture.given.rotation, picture.used().rotation)).value();
}

double movedM(const ComparedPicture& picture) {
    return (picture.used().translation - picture.given.translation).norm();
}

const std::vector<std::string> kTitles{"picture", "agree",     "moved mm", "+-",       "turned deg",
                                       "+-",      "median px", "95 % px",  "missed %", "PSNR dB",
                                       "SSIM",    "false %",   "lost %",   "colour"};

std::vector<std::string> poseCells(const ComparedPicture& picture) {
    if (!picture.refined) {
        return {"-", "-", "-", "-", "-"};
    }
    const compare::PoseFit& fit = *picture.refined;
    if (!fit.isFitted) {
        return {text(fit.inliers, " of ", fit.points), "refused", "-", "-", "-"};
    }
    return {text(fit.inliers, " of ", fit.points), fixed(1000 * movedM(picture), 1),
            fixed(1000 * fit.sigmaPositionM, 1), fixed(turnedDeg(picture), 2),
            fixed(Degrees(fit.sigmaRotation).value(), 3)};
}

double missedShareOf(const PictureLikeness& likeness) {
    const std::size_t places = likeness.matches + likeness.missed;
    return places == 0 ? 0 : static_cast<double>(likeness.missed) / static_cast<double>(places);
}

double missedShareOf(const CompareSummary& summary) {
    return summary.missedShare;
}

const Looks& looksIn(const PictureLikeness& likeness) {
    return likeness.looks;
}

const Looks& looksIn(const CompareSummary& summary) {
    return summary.looks.mean;
}

template <class Likeness>
std::vector<std::string> likenessCells(const Likeness& before, const Likeness& after) {
    const Looks& was = looksIn(before);
    const Looks& is = looksIn(after);
    return {change(before.medianPx, after.medianPx, 2),
            change(before.p95Px, after.p95Px, 1),
            change(100 * missedShareOf(before), 100 * missedShareOf(after), 0),
            change(was.psnrDb, is.psnrDb, 1),
            change(was.ssim, is.ssim, 3),
            change(100 * was.falseEdges, 100 * is.falseEdges, 1),
            change(100 * was.missedEdges, 100 * is.missedEdges, 1),
            change(before.colourError, after.colourError, 1)};
}

std::vector<std::string> joined(std::vector<std::string> first, const std::vector<std::string>& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

template <class Likeness>
Json likenessJson(const Likeness& likeness) {
    Json json = toJson(looksIn(likeness));
    json["median_px"] = orNull(likeness.medianPx);
    json["p95_px"] = orNull(likeness.p95Px);
    json["missed_share"] = missedShareOf(likeness);
    json["colour_error"] = orNull(likeness.colourError);
    return json;
}

Json poseJson(const Rigid3& pose) {
    const Eigen::Vector3d& at = pose.translation;
    const Eigen::Quaterniond& q = pose.rotation;
    return {{"position_m", {at.x(), at.y(), at.z()}},
            {"room_from_camera", {{"w", q.w()}, {"x", q.x()}, {"y", q.y()}, {"z", q.z()}}}};
}

Json refinementJson(const compare::PoseFit& fit) {
    return {{"refined", fit.isFitted},
            {"why", fit.isFitted ? Json() : Json(fit.why)},
            {"matches", fit.points},
            {"inliers", fit.inliers},
            {"residual_px", fit.residualPx},
            {"sigma_position_m", fit.isFitted ? Json(fit.sigmaPositionM) : Json()},
            {"sigma_rotation_deg", fit.isFitted ? Json(Degrees(fit.sigmaRotation).value()) : Json()}};
}

Json steadinessJson(const compare::Steadiness& steadiness) {
    return {{"median_px", orNull(steadiness.medianPx)},
            {"p95_px", orNull(steadiness.p95Px)},
            {"things", steadiness.things}};
}

Json pictureJson(const ComparedPicture& picture) {
    return {{"picture", picture.file.filename().string()},
            {"photo", picture.photo},
            {"given", poseJson(picture.given)},
            {"pose", poseJson(picture.used())},
            {"refinement", picture.refined ? refinementJson(*picture.refined) : Json()},
            {"before", likenessJson(picture.before)},
            {"after", likenessJson(picture.after)},
            {"steadiness", picture.steadiness ? steadinessJson(*picture.steadiness) : Json()}};
}

Json registeredJson(const TagRegistered& picture) {
    const bool hasPose = picture.why.empty();
    return {{"picture", picture.file.filename().string()},
            {"why", hasPose ? Json() : Json(picture.why)},
            {"tags", picture.pose.numbers},
            {"moved_tags", picture.pose.moved},
            {"pose", hasPose ? poseJson(picture.pose.roomFromCamera) : Json()},
            {"sigma_position_m", hasPose ? Json(picture.pose.sigmaM) : Json()},
            {"sigma_rotation_deg", hasPose ? Json(Degrees(picture.pose.sigmaRotation).value()) : Json()}};
}

Json fitJson(const CompareReport& report) {
    if (!report.fit) {
        return {};
    }
    return {{"fitted", report.fit->correction.has_value()},
            {"why", report.fit->correction ? Json() : Json(report.fit->why)},
            {"spots", report.fit->samples},
            {"hue_spread", report.fit->hueSpread},
            {"error_before", report.fit->errorBefore},
            {"error_after", report.fit->correction ? Json(report.fit->errorAfter) : Json()},
            {"error_held_out", orNull(report.heldOutColourError)}};
}

Json sensorJson(const CompareReport& report) {
    if (!report.sensor) {
        return {};
    }
    const compare::SensorFit& fit = *report.sensor;
    const render::SensorModel& sensor = fit.sensor;
    return {{"gain_db", fit.hasExposure ? Json(sensor.exposure.gainDb) : Json()},
            {"white_balance_gains", fit.hasExposure ? Json(sensor.whiteBalance.gains) : Json()},
            {"full_well_e", fit.hasNoise ? Json(sensor.noise.fullWellE) : Json()},
            {"read_e", fit.hasNoise ? Json(sensor.noise.readE) : Json()},
            {"colour_spots", fit.colourSpots},
            {"noise_spots", fit.noiseSpots},
            {"why", fit.why}};
}

report::Table compareTable(const CompareReport& report) {
    report::Table table{kTitles, {}, 1};
    for (const ComparedPicture& picture : report.pictures) {
        table.rows.push_back(joined(joined({picture.file.filename().string()}, poseCells(picture)),
                                    likenessCells(picture.before, picture.after)));
    }
    table.rows.push_back(joined({"mean", "", "", "", "", ""}, likenessCells(report.before, report.after)));
    return table;
}

void addRegisteredSentences(const TagRegistered& picture, std::vector<std::string>& sentences) {
    const std::string file = picture.file.filename().string();
    if (!picture.why.empty()) {
        sentences.push_back(text(file, " has no pose and was not compared: ", picture.why));
        return;
    }
    const compare::TagPose& pose = picture.pose;
    sentences.push_back(
        text(file, " was registered by ", counted(static_cast<int>(pose.numbers.size()), "tag", "tags"),
             " to ", fixed(1000 * pose.sigmaM, 0), " mm and ", fixed(Degrees(pose.sigmaRotation).value(), 2),
             " deg (one standard deviation)."));
    for (const int number : pose.moved) {
        sentences.push_back(text("In ", file, " AprilTag ", number,
                                 " hangs elsewhere than in the dataset, and was not used."));
    }
}

void addSensorSentences(const compare::SensorFit& fit, std::vector<std::string>& sentences) {
    const render::SensorModel& sensor = fit.sensor;
    if (fit.hasExposure) {
        const auto& gains = sensor.whiteBalance.gains;
        sentences.push_back(text("The robot's camera is ", fixed(std::abs(sensor.exposure.gainDb), 1), " dB ",
                                 sensor.exposure.gainDb < 0 ? "darker" : "brighter",
                                 " than the views; red is ", fixed(gains[0], 2), " and blue ",
                                 fixed(gains[2], 2), " times as bright beside green (", fit.colourSpots,
                                 " spots)."));
    }
    if (fit.hasNoise) {
        sentences.push_back(text("Its noise is that of ", fixed(sensor.noise.fullWellE, 0),
                                 " electrons at white, with a read noise of ", fixed(sensor.noise.readE, 1),
                                 " (", fit.noiseSpots, " spots)."));
    }
    sentences.insert(sentences.end(), fit.why.begin(), fit.why.end());
}

std::vector<std::string> compareSentences(const CompareReport& report) {
    std::vector<std::string> result;
    for (const TagRegistered& picture : report.registered) {
        addRegisteredSentences(picture, result);
    }
    for (const ComparedPicture& picture : report.pictures) {
        if (picture.refined && !picture.refined->isFitted) {
            result.push_back(text(picture.file.filename().string(),
                                  " keeps the pose that was given: ", picture.refined->why));
        }
    }
    if (report.steadyMedianPx) {
        result.push_back(text("From one picture to the next, a view's displacements change by ",
                              fixed(*report.steadyMedianPx, 2), " px at the median and ",
                              fixed(*report.steadyP95Px, 1),
                              " px in 95 of 100 places; that is what trembles beside the camera's motion."));
    }
    if (report.fit && report.fit->correction) {
        result.push_back(text("The colour correction takes the spots' mean error from ",
                              fixed(report.fit->errorBefore, 1), " to ", fixed(report.fit->errorAfter, 1),
                              " grey levels (", report.fit->samples, " spots",
                              report.heldOutColourError ? text("; ", fixed(*report.heldOutColourError, 1),
                                                               " on pictures that it was not made from")
                                                        : "",
                              ")."));
    } else if (report.fit) {
        result.push_back(report.fit->why);
    }
    if (report.sensor) {
        addSensorSentences(*report.sensor, result);
    }
    return result;
}

Document comparisonDocument(const CompareReport& report) {
    Document document{"Views and the robot's pictures", {}};
    document.blocks.emplace_back(Paragraph{text(
        report.pictures.size(), " pictures",
        report.refined > 0 ? text(", ", report.refined, " with refined poses") : "",
        ". Pairs are before and after: from the given pose in the photos' colours, and from the refined "
        "pose in "
        "corrected colours. Features that the view does not show are missed, and median and 95 % are of "
        "all features. False edges are edge pixels of the view that the picture does not have within 2 "
        "px; lost ones are the picture's that the view does not have. Colour is the mean distance of even "
        "spots' colours, in grey levels.")});
    document.blocks.emplace_back(compareTable(report));
    for (const std::string& sentence : compareSentences(report)) {
        document.blocks.emplace_back(Paragraph{sentence});
    }
    for (const ShownPicture& shown : report.shown) {
        document.blocks.emplace_back(
            report::PictureRow{{shown.picture, shown.before, shown.after, shown.difference},
                               {shown.name, "view before", "view after", "difference x 4"}});
    }
    return document;
}

} // namespace

std::string compareText(const CompareReport& report) {
    std::string result = compareTable(report).text();
    for (const std::string& sentence : compareSentences(report)) {
        result += sentence + "\n";
    }
    return result;
}

Json toJson(const CompareReport& report) {
    Json pictures = Json::array();
    for (const ComparedPicture& picture : report.pictures) {
        pictures.push_back(pictureJson(picture));
    }
    Json registered = Json::array();
    for (const TagRegistered& picture : report.registered) {
        registered.push_back(registeredJson(picture));
    }
    return {{"pictures", pictures},
            {"registered", registered},
            {"refined", report.refined},
            {"before", likenessJson(report.before)},
            {"after", likenessJson(report.after)},
            {"steadiness",
             {{"median_px", orNull(report.steadyMedianPx)}, {"p95_px", orNull(report.steadyP95Px)}}},
            {"colour_fit", fitJson(report)},
            {"sensor_fit", sensorJson(report)},
            {"colour_correction", report.colour ? toJson(*report.colour) : Json()},
            {"seconds", report.seconds}};
}

void writePoses(const CompareReport& report, const std::filesystem::path& file) {
    std::string csv = "file,x_m,y_m,z_m,qw,qx,qy,qz\n";
    for (const ComparedPicture& picture : report.pictures) {
        const Rigid3 pose = picture.used();
        const Eigen::Vector3d& at = pose.translation;
        const Eigen::Quaterniond& q = pose.rotation;
        const auto name = std::filesystem::absolute(picture.file)
                              .lexically_relative(std::filesystem::absolute(file).parent_path());
        csv += csvField(name.string());
        for (const double number : {at.x(), at.y(), at.z(), q.w(), q.x(), q.y(), q.z()}) {
            csv += text(",", number);
        }
        csv += "\n";
    }
    writeFile(file, bytesOf(csv));
}

void writeComparison(const CompareReport& report, const std::filesystem::path& folder) {
    report::writeReportFolder(comparisonDocument(report), toJson(report), folder);
}

} // namespace spherewalk::jobs

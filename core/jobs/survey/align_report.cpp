// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/enum_names.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/align_survey.h"
#include "spherewalk/store/records.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace spherewalk::jobs {

namespace {

constexpr EnumNames<Cure, 4> kCures{
    {{Cure::None, "none"}, {Cure::Retag, "retag"}, {Cure::Retake, "retake"}, {Cure::Mask, "mask"}}};

Json sigmaJson(const align::SolvedPose& pose) {
    return {{"yaw", Degrees(pose.sigmaYaw).value()},
            {"pitch", Degrees(pose.sigmaPitch).value()},
            {"roll", Degrees(pose.sigmaRoll).value()}};
}

Json scaleJson(const std::optional<align::Scale>& scale) {
    return scale ? Json{{"value", scale->value}, {"sigma", scale->sigma}} : Json();
}

Json toJson(const AlignedPhoto& photo) {
    Json json = {{"photo", photo.photo},          {"file", photo.file},      {"station", photo.station},
                 {"status", name(photo.quality)}, {"roomFromPhoto", Json()}, {"position_m", Json()},
                 {"sigma_deg", Json()},           {"flags", photo.flags},    {"cure", name(photo.cure)}};
    if (photo.pose.isSolved) {
        const Eigen::Quaterniond& q = photo.pose.roomFromPhoto.rotation;
        const Eigen::Vector3d& p = photo.pose.roomFromPhoto.translation;
        json["roomFromPhoto"] = {{"w", q.w()}, {"x", q.x()}, {"y", q.y()}, {"z", q.z()}};
        json["position_m"] = {p.x(), p.y(), p.z()};
        json["sigma_deg"] = photo.pose.hasSigmas() ? sigmaJson(photo.pose) : Json();
        json["sigma_position_m"] = photo.pose.sigmaPositionM;
        json["sigma_own"] = photo.pose.hasSigmas() ? Json{{"turn_deg", Degrees(photo.pose.sigmaOwn).value()},
                                                          {"position_m", photo.pose.sigmaOwnPositionM}}
                                                   : Json();
        json["lens_ahead_m"] = photo.pose.lenses.aheadM;
        json["lens_ahead_sigma_m"] =
            std::isfinite(photo.pose.lensSigmaM) ? Json(photo.pose.lensSigmaM) : Json();
        json["neighbours"] = photo.pose.constraints;
        json["residual_deg"] = Degrees(Radians(photo.pose.residualRad)).value();
    }
    if (!photo.fits.empty()) {
        json["fits_station"] = photo.fits;
    }
    return json;
}

Json trialsJson(const align::Alignment& alignment) {
    Json trials = Json::array();
    for (const align::ModelTrial& trial : alignment.trials) {
        trials.push_back({{"model", name(trial.model)},
                          {"held_out_deg", Degrees(Radians(trial.heldOutRad)).value()},
                          {"seconds", trial.seconds},
                          {"is_supported", trial.isSupported}});
    }
    return trials;
}

std::ptrdiff_t countOf(survey::Quality quality, const AlignReport& report) {
    return std::ranges::count(report.photos, quality, &AlignedPhoto::quality);
}

/// Of the photos that are handed on with one; nothing if none is.
std::optional<Radians> worstSigma(const AlignReport& report) {
    std::optional<Radians> worst;
    for (const AlignedPhoto& photo : report.photos) {
        if (photo.isHandedOn() && photo.pose.hasSigmas()) {
            worst = std::max(worst.value_or(Radians(0)), photo.pose.sigmaYaw);
        }
    }
    return worst;
}

std::string secondsText(double seconds) {
    return text(fixed(seconds, 1), " s");
}

/// Beyond this a standard deviation says that nothing is known.
constexpr Radians kUnknownSigma = Degrees(60);

std::string sigmaText(Radians sigma) {
    return sigma > kUnknownSigma ? "not known" : text("known to ", fixed(Degrees(sigma).value(), 3), " deg");
}

Json sigmaDegrees(Radians sigma, bool isKnown) {
    return isKnown ? Json(Degrees(sigma).value()) : Json();
}

/// What is known of the rotations, as sentences.
std::string knownText(const AlignReport& report) {
    const std::optional<Radians> worst = worstSigma(report);
    if (!worst) {
        return "How the photos are turned is not known.";
    }
    return text("Yaw is ", sigmaText(*worst),
                " at worst (one standard deviation); the heading of the whole is ",
                sigmaText(report.alignment.sigmaCommonYaw), ", its lean is ",
                sigmaText(report.alignment.sigmaCommonLean), ".");
}

} // namespace

namespace {

std::string_view scaleName(align::ScaleBy by) {
    constexpr EnumNames<align::ScaleBy, 5> kNames{{{align::ScaleBy::Nothing, "nothing"},
                                                   {align::ScaleBy::Guess, "guess"},
                                                   {align::ScaleBy::Floor, "floor"},
                                                   {align::ScaleBy::Distance, "distance"},
                                                   {align::ScaleBy::Tags, "tags"}}};
    return nameOf(kNames, by);
}

Json placesJson(const align::FreePlaces& places) {
    Json outline = Json::array();
    for (const Eigen::Vector2d& corner : places.outline) {
        outline.push_back({corner.x(), corner.y()});
    }
    return {{"parts", places.parts},
            {"scale_by", scaleName(places.scaleBy)},
            {"scale_sigma", places.scaleSigma},
            {"lens_height_m", places.lensHeightM},
            {"is_level_by_floor", places.isLevelByFloor},
            {"points", places.pointsM.size()},
            {"outline", outline},
            {"ceiling_m", places.ceilingM}};
}

std::string shareText(double share) {
    return text(fixed(100 * share, 1), " % (one standard deviation)");
}

/// What is said of photos, a line a sentence: before it stand all photos of which it is said.
std::string flagsText(const AlignReport& report) {
    struct Said {
        std::string_view flag;
        std::string photos = {};
        int count = 0;
    };

    std::vector<Said> all;
    std::map<std::string_view, std::size_t> places;
    for (const AlignedPhoto& photo : report.photos) {
        for (const std::string& flag : photo.flags) {
            const auto [place, isNew] = places.emplace(flag, all.size());
            Said& said = isNew ? all.emplace_back(Said{.flag = flag}) : all[place->second];
            said.photos +=
                text(said.count++ == 0 ? "" : ", ", store::photoAtStation(photo.file, photo.station));
        }
    }
    std::string words;
    for (const Said& said : all) {
        words += text("\n", said.photos, said.count > 1 ? ", each: " : ": ", said.flag);
    }
    return words;
}

} // namespace

std::string_view name(Cure cure) {
    return nameOf(kCures, cure);
}

Cure cureNamed(std::string_view name) {
    return valueOf(kCures, "The cure", name);
}

std::string scaleText(const align::FreePlaces& places) {
    const std::string sigma = shareText(places.scaleSigma);
    switch (places.scaleBy) {
    case align::ScaleBy::Guess:
        return text("A guessed height of the lens over the solved floor, ", fixed(places.lensHeightM, 2),
                    " m, gives the scale, to ", sigma, ".");
    case align::ScaleBy::Floor:
        return text("The height of the lens over the solved floor, ", fixed(places.lensHeightM, 2),
                    " m, gives the scale, to ", sigma, ".");
    case align::ScaleBy::Distance:
        return text("The given distance gives the scale, to ", sigma, ".");
    case align::ScaleBy::Tags:
        return places.join
                   ? text(counted(static_cast<int>(places.join->numbers.size()),
                                  "AprilTag of the other survey gives", "AprilTags of the other survey give"),
                          " frame and scale, to ", sigma, "; they fit within ",
                          fixed(1000 * places.join->misfitM, 1), " mm.")
                   : text("The printed size of the tags gives the scale, to ", sigma, ".");
    case align::ScaleBy::Nothing:
        break;
    }
    return "Nothing gives the scale.";
}

std::string FrameSigma::text() const {
    return spherewalk::text("The position tags are rough, so the places were solved from the pictures. The "
                            "scale is known to ",
                            shareText(scale), ".");
}

Json toJson(const AlignReport& report) {
    Json photos = Json::array();
    for (const AlignedPhoto& photo : report.photos) {
        photos.push_back(toJson(photo));
    }
    const align::Alignment& alignment = report.alignment;
    const bool isKnown = worstSigma(report).has_value();
    return {{"places", report.places ? placesJson(*report.places) : Json()},
            {"model", name(alignment.model)},
            {"reason", alignment.reason},
            {"effort", name(report.effort)},
            {"position_sigma_m", report.positionSigmaM},
            {"scale_sigma", report.scaleSigma},
            {"seconds", report.seconds},
            {"feature_seconds", report.featureSeconds},
            {"match_seconds", report.matchSeconds},
            {"solve_seconds", report.solveSeconds},
            {"features", report.features},
            {"photos_from_cache", report.fromCache},
            {"pairs", report.pairs},
            {"holding_pairs", report.holdingPairs},
            {"pairs_tried_again", report.pairsTriedAgain},
            {"photos_not_searched", report.notSearched},
            {"components", alignment.components},
            {"residual_deg", Degrees(Radians(alignment.residualRad)).value()},
            {"cycle_error_deg", Degrees(Radians(alignment.cycleErrorRad)).value()},
            {"sigma_common_yaw_deg", sigmaDegrees(alignment.sigmaCommonYaw, isKnown)},
            {"sigma_common_lean_deg", sigmaDegrees(alignment.sigmaCommonLean, isKnown)},
            {"tags_mirrored", report.tagFrame.isMirrored},
            {"tags_y_over_x", scaleJson(report.tagFrame.yOverX)},
            {"tags_scale", scaleJson(report.scale)},
            {"tag_warnings", report.tagWarnings},
            {"april_tags", aprilTagsJson(report.aprilTags)},
            {"april_tags_scale", scaleJson(report.aprilTags.scale)},
            {"trials", trialsJson(alignment)},
            {"warnings", alignment.warnings},
            {"photos", photos}};
}

std::string alignText(const AlignReport& report) {
    const auto good = countOf(survey::Quality::Good, report);
    const auto doubtful = countOf(survey::Quality::Doubtful, report);
    std::string words =
        text("Aligned ", good + doubtful, " of ", report.photos.size(), " photos in ",
             secondsText(report.seconds), " (features ", secondsText(report.featureSeconds), ", matching ",
             secondsText(report.matchSeconds), ", solving ", secondsText(report.solveSeconds), "): ", good,
             " good, ", doubtful, " doubtful, ", countOf(survey::Quality::Failed, report), " failed.\n");
    if (good + doubtful > 0) {
        words += text("Model ", name(report.alignment.model), ". ", report.alignment.reason, "\n");
    }
    words += knownText(report);
    for (const std::string& warning : report.alignment.warnings) {
        words += "\n" + warning;
    }
    if (report.notSearched > 0) {
        words += text("\nPersons were not looked for in ", report.notSearched, " of ", report.photos.size(),
                      " photos: no other photo with a well-known pose stands between 8 cm and 3 m away.");
    }
    return words + flagsText(report);
}

} // namespace spherewalk::jobs

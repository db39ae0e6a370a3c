// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/photo/verdict.h"

#include "verdict/sketch_match.h"

#include "spherewalk/base/enum_names.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/statistics.h"
#include "spherewalk/base/text.h"
#include "spherewalk/photo/integrity.h"
#include "spherewalk/photo/metadata.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numbers>
#include <vector>

namespace spherewalk::photo {

namespace {

constexpr EnumNames<Flaw, 14> kFlaws{{{Flaw::Damaged, "damaged"},
                                      {Flaw::Size, "size"},
                                      {Flaw::Kind, "kind"},
                                      {Flaw::Settings, "settings"},
                                      {Flaw::Brightness, "brightness"},
                                      {Flaw::Colour, "colour"},
                                      {Flaw::Blur, "blur"},
                                      {Flaw::Black, "black"},
                                      {Flaw::Burnt, "burnt"},
                                      {Flaw::Foreign, "foreign"},
                                      {Flaw::UpsideDown, "upside-down"},
                                      {Flaw::Turned, "turned"},
                                      {Flaw::Elsewhere, "elsewhere"},
                                      {Flaw::Unmoved, "unmoved"}}};

using Findings = std::vector<Finding>;

constexpr int kEquirectangular = 1; ///< image type of the maker note

void addSize(Findings& findings, const Sketch& photo, const ExpectedSettings& expected) {
    if (expected.width && *expected.width != photo.width) {
        findings.push_back({Flaw::Size, survey::Quality::Failed,
                            text("It is ", photo.width, " pixels wide instead of ", *expected.width,
                                 "; set the camera's size and take it again.")});
    }
}

/// What an orientation of Exif asks for.
std::string_view turnOf(int orientation) {
    switch (orientation) {
    case 3:
        return "turned by 180 degrees";
    case 6:
        return "turned by 90 degrees to the right";
    case 8:
        return "turned by 90 degrees to the left";
    default:
        return "mirrored";
    }
}

void addKind(Findings& findings, const Sketch& photo, const PhotoMetadata& metadata) {
    const auto& panorama = metadata.panorama;
    const bool isOther =
        (metadata.theta && metadata.theta->imageType.value_or(kEquirectangular) != kEquirectangular) ||
        (panorama && !panorama->projection.empty() && panorama->projection != "equirectangular");
    const bool isCropped = panorama && panorama->fullWidth && panorama->croppedWidth &&
                           *panorama->fullWidth != *panorama->croppedWidth;
    if (isOther || isCropped) {
        findings.push_back({Flaw::Kind, survey::Quality::Failed,
                            "It says that it is no whole stitched sphere; switch stitching on in the camera "
                            "and take it again."});
    } else if (isDualFisheye(photo)) {
        findings.push_back({Flaw::Kind, survey::Quality::Failed,
                            "It shows two fisheye pictures beside each other and no stitched sphere; switch "
                            "stitching on in the camera, or stitch it with the maker's program."});
    }
    if (metadata.orientation != 1) {
        findings.push_back({Flaw::Kind, survey::Quality::Doubtful,
                            text("It asks to be ", turnOf(metadata.orientation),
                                 " (Exif Orientation), and it is used as its pixels lie; turn the picture "
                                 "itself, or take the mark away.")});
    }
    const auto level = levelFromPhoto(metadata);
    if (!level) {
        return;
    }
    const double tilt = std::acos(std::clamp((*level * Eigen::Vector3d::UnitZ()).z(), -1.0, 1.0));
    constexpr Radians kUpsideDown = Degrees(90);
    constexpr Radians kLeaning = Degrees(15);
    if (tilt > kUpsideDown.value()) {
        findings.push_back({Flaw::UpsideDown, survey::Quality::Failed,
                            "It says that the camera hung upside down; put it upright and take it again."});
    } else if (tilt > kLeaning.value()) {
        findings.push_back({Flaw::UpsideDown, survey::Quality::Doubtful,
                            text("The camera leaned by ", fixed(Degrees(Radians(tilt)).value(), 0),
                                 " degrees; check its mount.")});
    }
}

/// Cameras write rounded times: 1/60 as 0.0166 or 0.017.
bool isSameExposure(double a, double b) {
    constexpr double kStops = 0.15;
    return std::abs(std::log2(a / b)) <= kStops;
}

void addSettings(Findings& findings, const PhotoMetadata& metadata, const ExpectedSettings& expected) {
    if (expected.exposureS && metadata.exposureS &&
        !isSameExposure(*metadata.exposureS, *expected.exposureS)) {
        findings.push_back({Flaw::Settings, survey::Quality::Failed,
                            text("It was exposed for ", fixed(*metadata.exposureS, 4), " s instead of ",
                                 fixed(*expected.exposureS, 4), " s; take it again.")});
    }
    if (expected.iso && metadata.iso && *metadata.iso != *expected.iso) {
        findings.push_back(
            {Flaw::Settings, survey::Quality::Failed,
             text("It was taken at ISO ", *metadata.iso, " instead of ", *expected.iso, "; take it again.")});
    }
    if (expected.hasFixedWhiteBalance && metadata.hasFixedWhiteBalance &&
        *metadata.hasFixedWhiteBalance != *expected.hasFixedWhiteBalance) {
        // Its colours say more: where they differ from the neighbours', that is found.
        findings.push_back(
            {Flaw::Settings, survey::Quality::Doubtful,
             text("It was taken with ", *metadata.hasFixedWhiteBalance ? "a fixed" : "automatic",
                  " white balance, against the survey's settings; take it again if its colours "
                  "differ.")});
    }
}

/// Size, kind and settings, by the photo's own words.
void addWhatItSays(Findings& findings, const Sketch& photo, const PhotoMetadata& metadata,
                   const ExpectedSettings& expected) {
    addSize(findings, photo, expected);
    addKind(findings, photo, metadata);
    addSettings(findings, metadata, expected);
}

constexpr double kAlike = 0.3; ///< correlation of photos that show the same room from places near each other
constexpr double kAlikeByChance = 0.5; ///< Photos of other rooms reach it, at some turn or upside down.
/// Beside furniture, photos farther apart may look like different rooms.
constexpr double kLookingAlikeM = 0.5;

std::vector<double> each(std::span<const MatchedSketch> neighbours,
                         const std::function<double(const MatchedSketch&)>& value) {
    std::vector<double> values;
    std::ranges::transform(neighbours, std::back_inserter(values), value);
    return values;
}

std::string percent(double part) {
    return text(fixed(100 * part, part < 0.1 ? 1 : 0), " %");
}

/// How serious a value is that should be small.
std::optional<survey::Quality> graded(double value, double doubtful, double failed) {
    if (value < doubtful) {
        return std::nullopt;
    }
    return value < failed ? survey::Quality::Doubtful : survey::Quality::Failed;
}

constexpr double kDark = 40;
constexpr double kBright = 215;

/// Those that tell how light and colours should be: they are neither dark nor burnt, and show the same.
Others forLight(Others others) {
    const auto tellsNothing = [](const MatchedSketch& one) {
        return one.sketch->brightness < kDark || one.sketch->brightness > kBright ||
               one.match.likeness < kAlike;
    };
    std::erase_if(others.near, tellsNothing);
    others.around = [=, around = std::move(others.around)] {
        std::vector<MatchedSketch> all = around();
        std::erase_if(all, tellsNothing);
        return all;
    };
    return others;
}

constexpr std::string_view kWhichIsOpen =
    ", and too few photos tell which of the two is wrong; look at both, and take the wrong one again.";

/// From this on a photo differs too much from its neighbours, in stops.
double leastStops(const ExpectedSettings& expected) {
    // A camera that chooses its own exposure chooses another one at each place.
    return expected.exposureS ? 0.4 : 1.6;
}

void addBrightness(Findings& findings, const Sketch& photo, const ExpectedSettings& expected,
                   const Others& others) {
    constexpr double kVeryDark = 18;
    constexpr double kVeryBright = 238;
    const double b = photo.brightness;
    if (b < kDark || b > kBright) {
        findings.push_back(
            {Flaw::Brightness,
             b < kVeryDark || b > kVeryBright ? survey::Quality::Failed : survey::Quality::Doubtful,
             b < kDark ? "It is too dark; check the lens and the exposure."
                       : "It is too bright; check the exposure."});
        return;
    }
    const StandsApart apart = standsApart(
        others, leastStops(expected), [&](const MatchedSketch& one) { return unexplainedStops(photo, one); });
    const auto quality = graded(std::abs(apart.by), leastStops(expected), expected.exposureS ? 1.2 : 3);
    if (!quality) {
        return;
    }
    const std::string stops = text("It is ", fixed(std::abs(apart.by), 1), " stops ",
                                   apart.by < 0 ? "darker" : "brighter", " than ");
    if (apart.isCertain) {
        findings.push_back(
            {Flaw::Brightness, *quality, stops + "its neighbours; check the exposure and the lamps."});
    } else {
        findings.push_back({Flaw::Brightness, survey::Quality::Doubtful,
                            text(stops, others.near[apart.other].name, kWhichIsOpen)});
    }
}

void addColour(Findings& findings, const ExpectedSettings& expected, const Others& others) {
    const double limit = expected.hasFixedWhiteBalance.value_or(false) ? 0.07 : 0.17;
    const auto inChannel = [&](std::size_t channel) {
        return standsApart(others, limit, [channel](const MatchedSketch& one) {
            return std::log(one.match.gains[channel] / one.match.gains[1]);
        });
    };
    const StandsApart red = inChannel(0);
    const StandsApart blue = inChannel(2);
    const StandsApart& most = std::abs(red.by) > std::abs(blue.by) ? red : blue;
    const auto quality = graded(std::abs(most.by), limit, 0.35);
    if (!quality) {
        return;
    }
    const std::string colours =
        text("Its colours differ by ", percent(std::exp(std::abs(most.by)) - 1), " from ");
    if (most.isCertain) {
        findings.push_back({Flaw::Colour, *quality,
                            colours + "its neighbours'; fix the white balance, and check the lamps."});
    } else {
        findings.push_back({Flaw::Colour, survey::Quality::Doubtful,
                            text(colours, "those of ", others.near[most.other].name, kWhichIsOpen)});
    }
}

/// More of it than the neighbours have.
void addPart(Findings& findings, Flaw flaw, double part,
             const std::function<double(const MatchedSketch&)>& theirs,
             std::span<const MatchedSketch> neighbours, double allowance, std::string_view words) {
    const double usual = neighbours.empty() ? 0 : median(each(neighbours, theirs));
    // Alone, a window or a dark floor counts as much as a fault.
    const double doubtful = neighbours.empty() ? 0.12 : 0.02 + allowance;
    const double failed = neighbours.empty() ? 0.45 : 0.15 + allowance;
    if (const auto quality = graded(part - usual, doubtful, failed)) {
        findings.push_back({flaw, *quality, text(percent(part), words)});
    }
}

/// Those that are near and alike enough to tell a person from what furniture hides; empty if too few.
std::vector<MatchedSketch> forContent(std::span<const MatchedSketch> neighbours) {
    constexpr std::size_t kEnough = 3;
    std::vector<MatchedSketch> alike(neighbours.begin(), neighbours.end());
    std::erase_if(alike, [](const MatchedSketch& one) {
        return one.match.likeness < kAlike || one.distanceM > kContentNeighbourhoodM;
    });
    return alike.size() < kEnough ? std::vector<MatchedSketch>() : alike;
}

void addForeign(Findings& findings, const Sketch& photo, std::span<const MatchedSketch> neighbours) {
    constexpr double kDoubtful = 0.004; // Of the sphere. What only one photo shows between chairs is smaller.
    const std::vector<MatchedSketch> alike = forContent(neighbours);
    if (alike.empty()) {
        return;
    }
    const ForeignArea area = foreignArea(photo, alike);
    if (area.part < kDoubtful) {
        return;
    }
    const double degrees = Degrees(area.azimuth).value();
    findings.push_back(
        {Flaw::Foreign, survey::Quality::Doubtful,
         text("Something is in view that its neighbours do not show, ", fixed(std::abs(degrees), 0),
              " degrees to the ", degrees < 0 ? "right" : "left", " of the picture's middle (",
              percent(area.part), " of the sphere); if it is a person, step aside and take it again.")});
}

/// Photos that were all taken with the camera's front the same way tell when one is not.
void addTurn(Findings& findings, std::span<const MatchedSketch> neighbours) {
    constexpr std::size_t kEnough = 3;
    constexpr Radians kSteady = Degrees(20);
    constexpr Radians kTurned = Degrees(45);
    if (neighbours.size() < kEnough) {
        return;
    }
    const double first = neighbours.front().match.turn.value();
    for (const MatchedSketch& one : neighbours) {
        const bool isSteady =
            std::abs(std::remainder(one.match.turn.value() - first, 2 * std::numbers::pi)) <= kSteady.value();
        if (one.match.likeness < kAlike || !isSteady) {
            return;
        }
    }
    if (std::abs(first) > kTurned.value()) {
        findings.push_back(
            {Flaw::Turned, survey::Quality::Doubtful,
             text("The camera was turned by ", fixed(Degrees(Radians(std::abs(first))).value(), 0),
                  " degrees against its neighbours, which all look one way; check its mount.")});
    }
}

/// Brightness, colour, black and burnt areas.
void addLight(Findings& findings, const Sketch& photo, const ExpectedSettings& expected,
              const Others& others) {
    constexpr double kBurntPerStop = 0.5; // Where walls are white, half a stop burns out a quarter of them.
    const Others telling = forLight(others);
    addBrightness(findings, photo, expected, telling);
    addColour(findings, expected, telling);
    std::vector<MatchedSketch> alike = others.near;
    std::erase_if(alike, [](const MatchedSketch& one) { // it may be of another room
        return one.distanceM > kContentNeighbourhoodM && one.match.likeness < kAlikeByChance;
    });
    addPart(
        findings, Flaw::Black, photo.blackPart,
        [](const MatchedSketch& one) { return one.sketch->blackPart; }, alike, 0,
        " of it is black; check that nothing covers a lens.");
    // A neighbour that has lost its light hides what burns in it.
    std::vector<MatchedSketch> lit = std::move(alike);
    std::erase_if(lit, [&](const MatchedSketch& one) {
        return one.sketch->brightness < kDark || unexplainedStops(photo, one) >= leastStops(expected);
    });
    const double brighter =
        median(each(lit, [](const MatchedSketch& one) { return stopsBrighter(one.match); }));
    const double burntByItself = expected.exposureS ? 0 : kBurntPerStop * std::max(0.0, brighter);
    addPart(
        findings, Flaw::Burnt, photo.burntPart,
        [](const MatchedSketch& one) { return one.sketch->burntPart; }, lit, burntByItself,
        " of it is burnt out; shorten the exposure, or keep the light out.");
}

void addBlur(Findings& findings, const Sketch& photo, std::span<const MatchedSketch> neighbours) {
    const auto worst = [&](const std::optional<double> EdgeWidths::*along) -> double {
        if (!(photo.edges.*along)) {
            return 0;
        }
        std::vector<double> theirs;
        for (const MatchedSketch& one : neighbours) {
            if (one.sketch->width == photo.width && one.sketch->edges.*along) {
                theirs.push_back(*(one.sketch->edges.*along));
            }
        }
        constexpr double kUsualPx = 2.2; // of a camera's own sharpness, where nothing tells
        return *(photo.edges.*along) / (theirs.empty() ? kUsualPx : median(theirs));
    };
    const double wider = std::max(worst(&EdgeWidths::alongRows), worst(&EdgeWidths::alongColumns));
    if (const auto quality = graded(wider, 1.35, 2.5)) {
        findings.push_back(
            {Flaw::Blur, *quality,
             text("It is blurred: its edges are ", fixed(wider, 1),
                  " times as wide as they should be; let the camera come to rest and take it again.")});
    }
}

/// Whether the photo shows what its neighbours show, the same way up and turned like them.
void addPlace(Findings& findings, const Sketch& photo, std::span<const MatchedSketch> neighbours) {
    if (neighbours.empty()) {
        return;
    }
    constexpr double kClearly = 0.15;
    constexpr std::ptrdiff_t kWitnesses = 2; // One alone may look like anything.
    const auto isUpsideDown = [&](const MatchedSketch& one) {
        return one.match.upsideDownLikeness > std::max(kAlikeByChance, one.match.likeness + kClearly);
    };
    const auto witnesses = std::ranges::count_if(neighbours, isUpsideDown);
    // Beside furniture most neighbours look like nothing much: the one that is most alike counts, too.
    const auto bestOf = [&](const auto& value) { return std::ranges::max(each(neighbours, value)); };
    const double best = bestOf([](const MatchedSketch& one) { return one.match.likeness; });
    const double over = bestOf([](const MatchedSketch& one) { return one.match.upsideDownLikeness; });
    if (witnesses >= kWitnesses && 2 * witnesses > std::ssize(neighbours) && over > best + kClearly) {
        findings.push_back(
            {Flaw::UpsideDown, survey::Quality::Failed,
             "It is upside down against its neighbours; put the camera upright and take it again."});
        return;
    }
    const bool isNextTo = std::ranges::any_of(
        neighbours, [](const MatchedSketch& one) { return one.distanceM <= kLookingAlikeM; });
    if (best < kAlike && isNextTo) {
        findings.push_back({Flaw::Elsewhere, survey::Quality::Doubtful,
                            "It does not look like its neighbours, however it is turned; check that the "
                            "camera stood at this station."});
        return;
    }
    addForeign(findings, photo, neighbours);
    addTurn(findings, neighbours);
}

} // namespace

std::string_view name(Flaw flaw) {
    return nameOf(kFlaws, flaw);
}

Flaw flawNamed(std::string_view name) {
    return valueOf(kFlaws, "The flaw", name);
}

std::string Verdict::sentence() const {
    std::string all;
    for (const Finding& finding : findings) {
        all += (all.empty() ? "" : " ") + finding.sentence;
    }
    return all;
}

Verdict judge(const Sketch& photo, const PhotoMetadata& metadata, const ExpectedSettings& expected,
              std::span<const Neighbour> neighbours) {
    const Others others = matched(photo, neighbours);
    const std::vector<MatchedSketch>& near = others.near;
    Verdict verdict;
    verdict.isCompared = !near.empty();
    verdict.isContentCompared = !forContent(near).empty();
    addWhatItSays(verdict.findings, photo, metadata, expected);
    addLight(verdict.findings, photo, expected, others);
    addBlur(verdict.findings, photo, near);
    addPlace(verdict.findings, photo, near);
    std::ranges::stable_sort(verdict.findings,
                             [](const Finding& a, const Finding& b) { return a.quality > b.quality; });
    return verdict;
}

JudgedPhoto judgeJpeg(ByteView jpeg, std::string_view source, const ExpectedSettings& expected,
                      std::span<const Neighbour> neighbours) {
    JudgedPhoto result;
    try {
        checkPhoto(jpeg, source);
        const PhotoMetadata metadata = readMetadata(jpeg, source);
        result.sketch = sketch(jpeg, metadata, source);
        result.band = viewBand(jpeg, source);
        result.verdict = judge(*result.sketch, metadata, expected, neighbours);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::Corrupt && error.kind() != ErrorKind::Unsupported) {
            throw;
        }
        result.verdict.findings = {{Flaw::Damaged, survey::Quality::Failed, error.sentence()}};
    }
    return result;
}

} // namespace spherewalk::photo

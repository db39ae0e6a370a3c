// SPDX-License-Identifier: GPL-3.0-or-later
#include "verdict_rules.h"

#include "spherewalk/base/median.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numbers>

namespace spherewalk::photo {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kAlike = 0.3; ///< correlation of photos that show the same room from places near each other

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
std::optional<Quality> graded(double value, double doubtful, double failed) {
    if (value < doubtful) {
        return std::nullopt;
    }
    return value < failed ? Quality::Doubtful : Quality::Failed;
}

void addBrightness(Findings& findings, const Sketch& photo, std::span<const MatchedSketch> neighbours) {
    constexpr double kDark = 40;
    constexpr double kVeryDark = 18;
    constexpr double kBright = 215;
    constexpr double kVeryBright = 238;
    const double b = photo.brightness;
    if (b < kDark || b > kBright) {
        findings.push_back({Flaw::Brightness,
                            b < kVeryDark || b > kVeryBright ? Quality::Failed : Quality::Doubtful,
                            b < kDark ? "It is too dark; check the lens and the exposure."
                                      : "It is too bright; check the exposure."});
        return;
    }
    if (neighbours.empty()) {
        return;
    }
    const double gain = median(each(neighbours, [](const MatchedSketch& one) {
        return (one.match.gains[0] + one.match.gains[1] + one.match.gains[2]) / 3;
    }));
    constexpr double kStopsPerOctave = 2.2; // pictures store about the 2.2th root of light
    const double stops = kStopsPerOctave * std::log2(gain);
    if (const auto quality = graded(std::abs(stops), 0.4, 1.2)) {
        findings.push_back(
            {Flaw::Brightness, *quality,
             text("It is ", fixed(std::abs(stops), 1), " stops ", stops < 0 ? "darker" : "brighter",
                  " than its neighbours; check the exposure and the lamps.")});
    }
}

void addColour(Findings& findings, std::span<const MatchedSketch> neighbours) {
    if (neighbours.empty()) {
        return;
    }
    const double red = median(each(neighbours, [](const MatchedSketch& one) {
        return std::log(one.match.gains[0] / one.match.gains[1]);
    }));
    const double blue = median(each(neighbours, [](const MatchedSketch& one) {
        return std::log(one.match.gains[2] / one.match.gains[1]);
    }));
    const double most = std::max(std::abs(red), std::abs(blue));
    if (const auto quality = graded(most, 0.07, 0.35)) {
        findings.push_back({Flaw::Colour, *quality,
                            text("Its colours differ by ", percent(std::exp(most) - 1),
                                 " from its neighbours'; fix the white balance, and check the lamps.")});
    }
}

/// More of it than the neighbours have.
void addPart(Findings& findings, Flaw flaw, double part,
             const std::function<double(const MatchedSketch&)>& theirs,
             std::span<const MatchedSketch> neighbours, std::string_view words) {
    const double usual = neighbours.empty() ? 0 : median(each(neighbours, theirs));
    // Alone, a window or a dark floor counts as much as a fault.
    const double doubtful = neighbours.empty() ? 0.12 : 0.02;
    const double failed = neighbours.empty() ? 0.45 : 0.15;
    if (const auto quality = graded(part - usual, doubtful, failed)) {
        findings.push_back({flaw, *quality, text(percent(part), words)});
    }
}

void addForeign(Findings& findings, const Sketch& photo, std::span<const MatchedSketch> neighbours) {
    std::vector<MatchedSketch> alike(neighbours.begin(), neighbours.end());
    std::erase_if(alike, [](const MatchedSketch& one) { return one.match.likeness < kAlike; });
    if (alike.empty()) {
        return;
    }
    const ForeignArea area = foreignArea(photo, alike);
    // A single neighbour does not show what furniture hides from it.
    const double doubtful = alike.size() == 1 ? 0.005 : 0.0018;
    if (area.part < doubtful) {
        return;
    }
    const double degrees = Degrees(area.azimuth).value();
    findings.push_back(
        {Flaw::Foreign, Quality::Doubtful,
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
            std::abs(std::remainder(one.match.turn.value() - first, 2 * kPi)) <= kSteady.value();
        if (one.match.likeness < kAlike || !isSteady) {
            return;
        }
    }
    if (std::abs(first) > kTurned.value()) {
        findings.push_back(
            {Flaw::Turned, Quality::Doubtful,
             text("The camera was turned by ", fixed(Degrees(Radians(std::abs(first))).value(), 0),
                  " degrees against its neighbours, which all look one way; check its mount.")});
    }
}

} // namespace

void addLight(Findings& findings, const Sketch& photo, std::span<const MatchedSketch> neighbours) {
    addBrightness(findings, photo, neighbours);
    addColour(findings, neighbours);
    addPart(
        findings, Flaw::Black, photo.blackPart,
        [](const MatchedSketch& one) { return one.sketch->blackPart; }, neighbours,
        " of it is black; check that nothing covers a lens.");
    addPart(
        findings, Flaw::Burnt, photo.burntPart,
        [](const MatchedSketch& one) { return one.sketch->burntPart; }, neighbours,
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

void addPlace(Findings& findings, const Sketch& photo, std::span<const MatchedSketch> neighbours) {
    if (neighbours.empty()) {
        return;
    }
    constexpr double kClearly = 0.1;
    const double upright =
        median(each(neighbours, [](const MatchedSketch& one) { return one.match.likeness; }));
    const double upsideDown =
        median(each(neighbours, [](const MatchedSketch& one) { return one.match.upsideDownLikeness; }));
    if (upsideDown > upright + kClearly && upsideDown >= kAlike) {
        findings.push_back(
            {Flaw::UpsideDown, Quality::Failed,
             "It is upside down against its neighbours; put the camera upright and take it again."});
        return;
    }
    const double best =
        std::ranges::max(each(neighbours, [](const MatchedSketch& one) { return one.match.likeness; }));
    if (best < kAlike) {
        findings.push_back({Flaw::Elsewhere, Quality::Doubtful,
                            "It does not look like its neighbours, however it is turned; check that the "
                            "camera stood at this station."});
        return;
    }
    addForeign(findings, photo, neighbours);
    addTurn(findings, neighbours);
}

} // namespace spherewalk::photo

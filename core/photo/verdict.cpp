// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/photo/verdict.h"

#include "verdict_rules.h"

#include "spherewalk/base/enum_names.h"
#include "spherewalk/base/error.h"
#include "spherewalk/photo/integrity.h"

#include <algorithm>

namespace spherewalk::photo {

namespace {

constexpr EnumNames<Quality, 3> kQualities{
    {{Quality::Good, "good"}, {Quality::Doubtful, "doubtful"}, {Quality::Failed, "failed"}}};
constexpr EnumNames<Flaw, 13> kFlaws{{{Flaw::Damaged, "damaged"},
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
                                      {Flaw::Elsewhere, "elsewhere"}}};

std::vector<MatchedSketch> matched(const Sketch& photo, std::span<const Neighbour> neighbours) {
    std::vector<Neighbour> near(neighbours.begin(), neighbours.end());
    std::erase_if(near, [](const Neighbour& one) { return !(one.distanceM <= kNeighbourhoodM); });
    std::ranges::stable_sort(near, {}, &Neighbour::distanceM);
    near.resize(std::min(near.size(), kMostNeighbours));
    std::vector<MatchedSketch> result;
    for (const Neighbour& one : near) {
        result.push_back({one.sketch, match(photo, *one.sketch), one.distanceM});
    }
    return result;
}

} // namespace

std::string_view name(Quality quality) {
    return nameOf(kQualities, quality);
}

Quality qualityNamed(std::string_view name) {
    return valueOf(kQualities, "The verdict", name);
}

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
    const std::vector<MatchedSketch> near = matched(photo, neighbours);
    Verdict verdict;
    addWhatItSays(verdict.findings, photo, metadata, expected);
    addLight(verdict.findings, photo, near);
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
        result.verdict = judge(*result.sketch, metadata, expected, neighbours);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::Corrupt && error.kind() != ErrorKind::Unsupported) {
            throw;
        }
        result.verdict.findings = {{Flaw::Damaged, Quality::Failed, error.sentence()}};
    }
    return result;
}

} // namespace spherewalk::photo

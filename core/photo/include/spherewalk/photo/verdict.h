// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/photo/metadata.h"
#include "spherewalk/photo/sketch.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk::photo {

/// What the checks say of a photo, from good to bad.
enum class Quality { Good, Doubtful, Failed };

/// "good", "doubtful", "failed".
std::string_view name(Quality quality);
/// Errors: InvalidInput, listing the names.
Quality qualityNamed(std::string_view name);

/// What can be wrong with a photo.
enum class Flaw {
    Damaged,    ///< the file is not a whole spherical JPEG
    Size,       ///< not as many pixels as asked for, or as its neighbours
    Kind,       ///< not a stitched sphere, by its own words
    Settings,   ///< not exposed as the survey's profile says
    Brightness, ///< too dark or bright, or unlike its neighbours
    Colour,     ///< of another white balance than its neighbours
    Blur,
    Black,   ///< an area without anything to be seen
    Burnt,   ///< an area as bright as the camera can tell
    Foreign, ///< something that its neighbours do not show: the operator, as a rule
    UpsideDown,
    Turned,    ///< when its neighbours all look one way
    Elsewhere, ///< it looks like none of its neighbours
};

/// "damaged", "upside-down", ...: as reports and the survey spell it.
std::string_view name(Flaw flaw);
/// Errors: InvalidInput, listing the names.
Flaw flawNamed(std::string_view name);

struct Finding {
    Flaw flaw = Flaw::Damaged;
    Quality quality = Quality::Doubtful; ///< what the photo is because of it
    std::string sentence;                ///< what, and what to do

    bool operator==(const Finding&) const = default;
};

struct Verdict {
    std::vector<Finding> findings; ///< the worst first; none: good

    Quality quality() const { return findings.empty() ? Quality::Good : findings.front().quality; }

    /// All sentences, one after the other; empty if there are none.
    std::string sentence() const;

    bool operator==(const Verdict&) const = default;
};

/// How the camera was told to take the photo; what has no value is the camera's to choose.
struct ExpectedSettings {
    std::optional<int> iso = {};
    std::optional<double> exposureS = {};
    std::optional<int> width = {};
    std::optional<bool> hasFixedWhiteBalance = {};
};

/// A photo that was taken near the one that is judged.
struct Neighbour {
    const Sketch* sketch = nullptr; ///< Owner: the caller
    double distanceM = 0;           ///< between the two positions
};

/// So far at most is worth looking for neighbours, and so many of them are used: the nearest.
inline constexpr double kNeighbourhoodM = 0.75;
inline constexpr std::size_t kMostNeighbours = 4;

/// Judges a whole photo. The same input gives the same verdict. Neighbours beyond kNeighbourhoodM, and more
/// than the nearest kMostNeighbours, are left out; without any, only what the photo shows and says by itself
/// counts. Threads: any. Cost: up to a fifth of a second.
Verdict judge(const Sketch& photo, const PhotoMetadata& metadata, const ExpectedSettings& expected,
              std::span<const Neighbour> neighbours);

/// A verdict, and what neighbours of the photo will be compared with; nothing of a damaged one.
struct JudgedPhoto {
    Verdict verdict;
    std::optional<Sketch> sketch;
};

/// The same from the file's bytes: a damaged file is a verdict, not an error. source: the photo's name, for
/// sentences. Cost: up to a third of a second for 5376 x 2688 pixels.
JudgedPhoto judgeJpeg(ByteView jpeg, std::string_view source, const ExpectedSettings& expected,
                      std::span<const Neighbour> neighbours);

} // namespace spherewalk::photo

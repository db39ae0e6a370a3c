// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/photo/metadata.h"
#include "spherewalk/photo/sketch.h"
#include "spherewalk/photo/view_band.h"
#include "spherewalk/survey/shot.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk::photo {

/// What can be wrong with a photo.
enum class Flaw {
    Damaged,    ///< The file is no whole spherical JPEG.
    Size,       ///< The photo has not the width that was asked for.
    Kind,       ///< The photo says that it is no stitched sphere.
    Settings,   ///< The exposure differs from the survey's profile.
    Brightness, ///< The photo is too dark or too bright, or differs from its neighbours.
    Colour,     ///< The white balance differs from the neighbours'.
    Blur,       ///< Edges are wider than they should be.
    Black,      ///< An area is black.
    Burnt,      ///< An area is as bright as the camera can record.
    Foreign,    ///< Something is in view that the neighbours do not show, often the operator.
    UpsideDown, ///< The photo is upside down, or the camera leaned.
    Turned,     ///< The camera was turned against its neighbours, which all look one way.
    Elsewhere,  ///< The photo looks like none of its neighbours.
    Unmoved,    ///< The camera still stood where the photo before was taken, at another station.
};

/// "damaged", "upside-down", ..., as reports and the survey spell the flaw.
std::string_view name(Flaw flaw);
/// Errors: InvalidInput for an unknown name; the sentence lists all names.
Flaw flawNamed(std::string_view name);

/// One flaw of a photo.
struct Finding {
    Flaw flaw = Flaw::Damaged;
    survey::Quality quality = survey::Quality::Doubtful; ///< Grade of a photo that has this flaw.
    std::string sentence;                                ///< What is wrong, and what to do about it.

    bool operator==(const Finding&) const = default;
};

/// The judgement on one photo, with its reasons.
struct Verdict {
    std::vector<Finding> findings; ///< The flaws, the worst first; a good photo has none.
    /// Whether neighbours stood near enough to compare light, colour and sharpness with. Records do not keep
    /// it.
    bool isCompared = false;
    /// Whether enough of them stood so near that a person could be told from what furniture hides. Records do
    /// not keep it.
    bool isContentCompared = false;

    survey::Quality quality() const {
        return findings.empty() ? survey::Quality::Good : findings.front().quality;
    }

    /// The sentences of all findings in one text; "" for a good photo.
    std::string sentence() const;

    bool operator==(const Verdict& other) const { return findings == other.findings; }
};

/// How the camera was told to take the photo. The camera chose each setting that has no value.
struct ExpectedSettings {
    std::optional<int> iso = {};
    std::optional<double> exposureS = {}; ///< If it is absent, brightness may differ by more.
    std::optional<int> width = {};
    std::optional<bool> hasFixedWhiteBalance = {}; ///< Unless it is fixed, colours may differ by more.
};

/// A photo that was taken near the one that is judged.
struct Neighbour {
    const Sketch* sketch = nullptr; ///< Owner: the caller
    double distanceM = 0;           ///< Distance between the positions of the two photos.
    std::string name = {};          ///< The photo's name for sentences.
};

/// Photos that are farther away are no neighbours.
inline constexpr double kNeighbourhoodM = 0.75;
/// Something foreign is looked for if at least three alike neighbours are this near, as on a grid of 25 cm.
/// With longer steps, furniture hides as much from the neighbours as a person would; the alignment looks
/// then.
inline constexpr double kContentNeighbourhoodM = 0.36;
/// Only so many of the nearest neighbours are used.
inline constexpr std::size_t kMostNeighbours = 4;
/// So many photos that stand next, at any distance, help to tell whether the photo or a neighbour stands
/// apart in light and colour.
inline constexpr std::size_t kMostAround = 8;

/// Judges a whole photo. The same input gives the same verdict. Neighbours beyond kNeighbourhoodM,
/// and more than the nearest kMostNeighbours, are left out, but for the kMostAround nearest of them. Without
/// neighbours only the photo itself and its metadata count. Threads: any. Cost: up to a fifth of a second.
Verdict judge(const Sketch& photo, const PhotoMetadata& metadata, const ExpectedSettings& expected,
              std::span<const Neighbour> neighbours);

/// A verdict with the digests of the photo. A damaged photo has none.
struct JudgedPhoto {
    Verdict verdict;
    std::optional<Sketch> sketch;
    std::optional<ViewBand> band;
};

/// Judges the bytes of a file. A damaged file gives a verdict, not an error. source: the photo's name for
/// sentences. Cost: up to a third of a second for 5376 x 2688 pixels.
JudgedPhoto judgeJpeg(ByteView jpeg, std::string_view source, const ExpectedSettings& expected,
                      std::span<const Neighbour> neighbours);

} // namespace spherewalk::photo

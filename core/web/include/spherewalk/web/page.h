// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/bytes.h"
#include "spherewalk/base/json_fwd.h"
#include "spherewalk/geometry/angle.h"
#include "spherewalk/geometry/lens_pair.h"
#include "spherewalk/geometry/polygon.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/survey/room.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk::web {

/// The standard deviation of a distance r that a photo shows: leastM + perM r^2. Units: metres, 1/m.
struct DepthSigma {
    double leastM = 0;
    double perM = 0;
};

/// A photo on the page.
struct Photo {
    std::string station;
    Rigid3 roomFromPhoto;
    LensPair lenses;
    bool isHeadingKnown = true;
    std::optional<DepthSigma> depth; ///< Nothing for a photo without a depth.
    double sigmaPositionM = 0;       ///< 0 where it is not known.
    Radians sigmaTurn;               ///< 0 where it is not known.
    std::string state = "unjudged";  ///< "good", "doubtful", "failed" or "unjudged".
    std::string decision = "open";   ///< As store::name() spells it.
    std::string note;
    std::vector<std::string> findings;   ///< Sentences.
    std::optional<double> errorPx;       ///< Measured error of views that replace the photo.
    std::vector<std::size_t> neighbours; ///< Photos that a person can walk to from here.
};

/// A station that no photo on the page stands for. why: "missing", "rejected" or "notPlaced".
struct EmptyStation {
    std::string station;
    Eigen::Vector2d at = Eigen::Vector2d::Zero();
    std::string why = "missing";
};

/// A run of cells of the floor in one row, [begin, end), to which one photo is the nearest.
struct FloorRun {
    int row = 0;
    int begin = 0;
    int end = 0;
    std::size_t photo = 0; ///< In a map with a floor of its own: which of the map's colours.
};

/// The floor within reach of photos, as square cells from a corner with least x and y.
struct Floor {
    Eigen::Vector2d origin = Eigen::Vector2d::Zero();
    double cellM = 0;
    std::vector<FloorRun> runs;
};

struct LegendEntry {
    std::string colour; ///< As CSS takes it.
    std::string words;
    std::optional<double> value = {}; ///< What stands for "%1" in the words.
};

/// Colours of the floor by the nearest photo, or of a floor of its own. Words are English;
/// PageWords::translated translates them.
struct FloorMap {
    std::string name;
    std::string about;
    std::vector<std::string> colours; ///< One for each photo, or those that the runs of `floor` name.
    std::vector<LegendEntry> legend;
    std::optional<Floor> floor = {};
};

/// What a page shows. Frames: room.
struct Page {
    std::string name;
    std::string madeBy;
    std::string createdUtc;
    survey::Room room; ///< The outline is empty where it is not known.
    double floorM = 0;
    double stepM = 0;      ///< Step of the planned grid; 0 without a grid.
    double scaleSigma = 0; ///< Of all lengths, as a share; 0 where it is not known.
    double radiusM = 3;    ///< How far away things are taken to be in photos without a depth.
    bool hasReview = false;
    std::size_t begin = 0; ///< The photo that is shown first.
    std::vector<Photo> photos;
    std::vector<EmptyStation> without;
    Floor floor;
    std::vector<FloorMap> maps;
};

/// The words of the page and of core's sentences in a person's language.
struct PageWords {
    std::string language = "en"; ///< BCP 47.
    /// The translation of an English word or sentence; empty: English.
    std::function<std::string(const std::string&)> translated = {};

    std::string operator()(const std::string& english) const {
        return translated ? translated(english) : english;
    }
};

/// The English word of resources/web/words.json. "%1" and so on stand for values. Range: a key of the file.
std::string word(std::string_view key);

/// All words of resources/web/words.json by their keys, translated.
Json allWords(const PageWords& words);

/// Writes the page into a folder that exists: index.html and all that it needs, but for the photos. The page
/// opens from a disk, and loads nothing from a network. What the survey says is text there and never code.
/// Errors: Io, Full; InvalidInput for a page without photos.
void writePage(const Page& page, const PageWords& words, const std::filesystem::path& folder);

/// The name of the file of a photo, relative to the page's folder.
std::string scriptName(std::size_t photo);

/// The content of that file. jpeg: the photo; what cameras and programs wrote into it beside the picture is
/// left out. depthFile: a file as render::DepthMap has it, or empty; the page gets at most 512 pixels of its
/// width. A pixel of the page is sure where all its pixels are, and differ by no more than one surface does.
/// Errors: Corrupt.
std::string photoScript(std::size_t photo, ByteView jpeg, const std::filesystem::path& depthFile);

} // namespace spherewalk::web

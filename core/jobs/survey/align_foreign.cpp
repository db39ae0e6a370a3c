// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/jobs/align_survey.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/photo/picture_file.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::jobs {

MaskImage readMask(const std::filesystem::path& file) {
    if (file.empty()) {
        return {};
    }
    const RgbImage picture = photo::readPicture(file);
    if (picture.width() != 2 * picture.height()) {
        throw Error(ErrorKind::InvalidInput,
                    text("The mask ", printable(file.string()), " has ", picture.width(), " x ",
                         picture.height(), " pixels; it must be twice as wide as high, as the photos are."));
    }
    MaskImage mask(picture.width(), picture.height());
    for (int y = 0; y < mask.height(); ++y) {
        for (int x = 0; x < mask.width(); ++x) {
            *mask.at(x, y) = picture.at(x, y)[1] >= 128 ? 255 : 0;
        }
    }
    return mask;
}

namespace {

/// With a worse pose the photo would contradict its neighbours everywhere.
constexpr Radians kKnownTurn = Degrees(0.5);
constexpr double kKnownPlaceM = 0.05;

bool isKnown(const align::SolvedPose& pose) {
    return pose.isSolved && pose.hasSigmas() && pose.component == 0 && pose.sigmaOwn <= kKnownTurn &&
           pose.sigmaOwnPositionM <= kKnownPlaceM;
}

/// Empty if the photo cannot be read, which its own flag tells.
RgbImage smallPicture(const std::filesystem::path& file) {
    try {
        return photo::resized(jpeg::decodeAtLeast(readFile(file), file.string(), align::kSightWidth),
                              align::kSightWidth, align::kSightWidth / 2);
    } catch (const Error&) {
        return {};
    }
}

std::string foreignSentence(const align::ForeignThing& thing) {
    const SphericalDirection at = sphericalDirection(thing.directionInPhoto);
    const double azimuth = Degrees(at.azimuth).value();
    const double elevation = Degrees(at.elevation).value();
    return text("Something stands where other photos look through: ", fixed(std::abs(azimuth), 0),
                " degrees to the ", azimuth < 0 ? "right" : "left", " of the picture's middle, ",
                fixed(std::abs(elevation), 0), " degrees ", elevation < 0 ? "below" : "above",
                " the horizon (", fixed(100 * thing.part, 1),
                " % of the sphere). If it is a person, step aside and take it again.");
}

} // namespace

void tellForeignThings(const std::filesystem::path& folder, const align::ForeignCheckOptions& options,
                       AlignReport& report, ProgressSink& progress, const std::stop_token& stop) {
    std::vector<align::SightPhoto> photos(report.photos.size());
    parallelFor(static_cast<int>(photos.size()), 1, options.threads, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            throwIfStopped(stop);
            const auto at = static_cast<std::size_t>(i);
            const align::SolvedPose& pose = report.alignment.photos[at];
            if (isKnown(pose)) {
                photos[at] = {smallPicture(folder / report.photos[at].file), pose.roomFromPhoto};
            }
        }
    });
    const align::ForeignCheck check = align::foreignThings(photos, options, progress, stop);
    std::vector<int> told(photos.size(), 0);
    for (const align::ForeignThing& thing : check.things) {
        const auto at = static_cast<std::size_t>(thing.photo);
        constexpr int kMostTold = 2; // A person who is cut in two by furniture.
        if (++told[at] <= kMostTold) {
            report.photos[at].flags.push_back(foreignSentence(thing));
            propose(Cure::Retake, report.photos[at]);
        }
    }
    for (std::size_t i = 0; i < photos.size(); ++i) {
        report.notSearched += report.alignment.photos[i].isSolved && !check.isJudged[i] ? 1 : 0;
    }
}

} // namespace spherewalk::jobs

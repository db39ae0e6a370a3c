// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/check_places.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jobs/solution_findings.h"
#include "spherewalk/photo/position_tag.h"
#include "spherewalk/render/dataset.h"
#include "spherewalk/store/survey_store.h"

#include <optional>

namespace spherewalk::jobs {

namespace {

constexpr double kTagPlaceM = 1e-6; ///< Tags are written with as many digits.
constexpr double kTagRotationRad = 1e-6;

std::string placeInWords(const Eigen::Vector3d& p) {
    return text("(", fixed(p.x(), 3), ", ", fixed(p.y(), 3), ", ", fixed(p.z(), 3), ")");
}

/// What a file and a record say of one photo.
struct Said {
    std::string station;
    Eigen::Vector3d positionM;
};

/// Nothing if both say the same.
std::optional<std::string> difference(const std::string& photo, const Said& tag, const Said& record,
                                      std::string_view where) {
    if (tag.station == record.station && (tag.positionM - record.positionM).norm() <= kTagPlaceM) {
        return std::nullopt;
    }
    return text("The photo ", printable(photo), " says in its tag that it is of ", printable(tag.station),
                " at ", placeInWords(tag.positionM), "; the ", where, " says ", printable(record.station),
                " at ", placeInWords(record.positionM), ".");
}

std::optional<Bytes> readable(const std::filesystem::path& file) {
    try {
        return readFile(file);
    } catch (const Error&) { // SurveyStore::check() tells of it
        return std::nullopt;
    }
}

std::optional<photo::PositionTag> tagIn(ByteView jpeg, const std::string& source) {
    try {
        return photo::readPositionTag(jpeg, source);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::Corrupt) {
            throw;
        }
        return std::nullopt;
    }
}

/// Nothing if all is well.
std::optional<std::string> findingOn(const store::SurveyStore& store, const store::PhotoRecord& photo,
                                     const std::string& surveyId) {
    const auto jpeg = readable(store.photoFolder() / photo.fileName);
    if (!jpeg) {
        return std::nullopt;
    }
    const auto tag = tagIn(*jpeg, photo.fileName);
    if (!tag && !store.station(photo.station).isPlaceKnown) {
        return std::nullopt; // Nobody has said yet where it was taken.
    }
    if (!tag || tag->surveyId != surveyId) {
        return text("The photo ", printable(photo.fileName),
                    tag ? " has the position tag of another survey." : " has no position tag.");
    }
    return difference(photo.fileName, {tag->stationName, tag->positionM},
                      {store.station(photo.station).name, photo.positionM}, "survey");
}

} // namespace

std::vector<std::string> checkPlaces(const store::SurveyStore& store, ProgressSink& progress,
                                     const std::stop_token& stop) {
    std::vector<std::string> sentences;
    const std::string surveyId = store.info().uuid;
    const std::vector<store::PhotoRecord> photos = store.photos();
    for (std::size_t i = 0; i < photos.size(); ++i) {
        throwIfStopped(stop);
        progress.progress(static_cast<double>(i) / static_cast<double>(photos.size()),
                          text("Looking at the place of ", photos[i].fileName));
        if (auto sentence = findingOn(store, photos[i], surveyId)) {
            sentences.push_back(*std::move(sentence));
        }
    }
    if (std::string elsewhere = placesInDoubt(store); !elsewhere.empty()) {
        sentences.push_back(std::move(elsewhere));
    }
    progress.progress(1, "Looked at all places");
    return sentences;
}

std::vector<std::string> checkPlaces(const render::Dataset& dataset, ProgressSink& progress,
                                     const std::stop_token& stop) {
    std::vector<std::string> sentences;
    const std::vector<render::DatasetPhoto>& photos = dataset.info().photos;
    for (std::size_t i = 0; i < photos.size(); ++i) {
        throwIfStopped(stop);
        const render::DatasetPhoto& photo = photos[i];
        progress.progress(static_cast<double>(i) / static_cast<double>(photos.size()),
                          text("Looking at the place of ", photo.file));
        const auto tag = tagIn(dataset.readPhoto(i), photo.file);
        if (!tag) {
            continue;
        }
        if (auto sentence = difference(photo.file, {tag->stationName, tag->positionM},
                                       {photo.station, photo.roomFromPhoto.translation}, "dataset")) {
            sentences.push_back(*std::move(sentence));
        } else if (tag->roomFromPhoto &&
                   angleBetween(*tag->roomFromPhoto, photo.roomFromPhoto.rotation).value() >
                       kTagRotationRad) {
            sentences.push_back(text("The photo ", printable(photo.file),
                                     " says in its tag that it is turned otherwise than the dataset says."));
        }
    }
    progress.progress(1, "Looked at all places");
    return sentences;
}

} // namespace spherewalk::jobs

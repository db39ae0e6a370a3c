// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/retag_photos.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/sha256.h"
#include "spherewalk/base/text.h"
#include "spherewalk/photo/position_tag.h"

#include <set>

namespace spherewalk::jobs {

namespace fs = std::filesystem;

namespace {

/// Files that are removed again unless the survey came to name them.
class FilesInDoubt {
  public:
    FilesInDoubt() = default;
    FilesInDoubt(const FilesInDoubt&) = delete;
    FilesInDoubt& operator=(const FilesInDoubt&) = delete;

    ~FilesInDoubt() {
        for (const fs::path& file : m_files) {
            std::error_code ignored; // a file that belongs to no photo does no harm
            fs::remove(file, ignored);
        }
    }

    void add(const fs::path& file) { m_files.push_back(file); }

    void replaceBy(std::vector<fs::path> files) { m_files = std::move(files); }

  private:
    std::vector<fs::path> m_files;
};

/// Errors: NotFound; InvalidInput for a photo that is named twice.
std::vector<PhotoPlace> placesAround(const store::SurveyStore& store, const std::vector<PhotoPlace>& places) {
    std::set<std::int64_t> photos;
    std::set<std::int64_t> stations;
    for (const PhotoPlace& place : places) {
        const store::PhotoRecord photo = store.photo(place.photo);
        if (!photos.insert(place.photo).second) {
            throw Error(ErrorKind::InvalidInput,
                        text("The photo ", photo.fileName, " cannot be at two stations; name it once."));
        }
        stations.insert({photo.station, store.station(place.station).id});
    }
    std::vector<PhotoPlace> result;
    for (const std::int64_t station : stations) {
        for (const store::PhotoRecord& photo : store.photosAt(station)) {
            result.push_back({photo.id, station, photo.positionM, photo.choose});
        }
    }
    return result;
}

/// The row of the photo at its place, its file written if it has to be another one.
store::MovedPhoto placed(const store::SurveyStore& store, const std::string& surveyId,
                         const PhotoPlace& place) {
    const store::PhotoRecord photo = store.photo(place.photo);
    const store::StationRecord station = store.station(place.station);
    const Eigen::Vector3d positionM = place.positionM.value_or(station.station.positionM);
    const fs::path file = store.photoFolder() / photo.fileName;
    const Bytes old = readFile(file);
    // The rotation that came with the photo stays true: it is the photo that was named wrongly, not turned.
    const auto oldTag = photo::readPositionTag(old, file.string());
    const Bytes tagged = photo::withPositionTag(
        old, {surveyId, station.id, station.name, positionM, oldTag ? oldTag->roomFromPhoto : std::nullopt},
        file.string());
    store::MovedPhoto moved{photo.id,          station.id,    positionM,   photo.fileName,
                            sha256Hex(tagged), tagged.size(), place.choose};
    if (moved.fileSha256 != photo.fileSha256) {
        moved.fileName = store.freePhotoName(photo.cameraFileName, moved.fileSha256);
        writeFile(store.photoFolder() / moved.fileName, tagged);
    }
    return moved;
}

} // namespace

std::vector<PhotoPlace> retagPhotos(store::SurveyStore& store, const std::vector<PhotoPlace>& places,
                                    ProgressSink& progress, const std::stop_token& stop) {
    std::vector<PhotoPlace> before = placesAround(store, places);
    const std::string surveyId = store.info().uuid;
    FilesInDoubt files;
    std::vector<fs::path> replaced;
    std::vector<store::MovedPhoto> moved;
    for (const PhotoPlace& place : places) {
        throwIfStopped(stop);
        const std::string oldName = store.photo(place.photo).fileName;
        moved.push_back(placed(store, surveyId, place));
        if (moved.back().fileName != oldName) {
            files.add(store.photoFolder() / moved.back().fileName);
            replaced.push_back(store.photoFolder() / oldName);
        }
        progress.progress(static_cast<double>(moved.size()) / static_cast<double>(places.size() + 1),
                          "Writing the photos' position tags");
    }
    throwIfStopped(stop);
    store.movePhotos(moved);
    files.replaceBy(std::move(replaced));
    progress.progress(1, "Retagged");
    return before;
}

} // namespace spherewalk::jobs

// SPDX-License-Identifier: GPL-3.0-or-later
#include "walk_path.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/statistics.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace spherewalk::bench {

using Eigen::Vector3d;
namespace fs = std::filesystem;

namespace {

using Places = std::vector<Vector3d>;

/// The usual distance between neighbours; 0 if there are none. A few hundred places tell it.
double spacing(const Places& places) {
    const std::size_t every = places.size() / 256 + 1;
    std::vector<double> nearest;
    for (std::size_t i = 0; i < places.size(); i += every) {
        double least = std::numeric_limits<double>::infinity();
        for (const Vector3d& other : places) {
            const double distance = (places[i] - other).norm();
            least = distance > 0 ? std::min(least, distance) : least;
        }
        nearest.push_back(std::isfinite(least) ? least : 0);
    }
    return quantile(nearest, 0.5);
}

/// Groups along one axis, in ascending order: each holds what lies within `reach` of its first place.
std::vector<Places> groups(Places places, int axis, double reach) {
    std::stable_sort(places.begin(), places.end(),
                     [=](const Vector3d& a, const Vector3d& b) { return a[axis] < b[axis]; });
    std::vector<Places> result;
    for (const Vector3d& place : places) {
        if (result.empty() || place[axis] > result.back().front()[axis] + reach) {
            result.emplace_back();
        }
        result.back().push_back(place);
    }
    return result;
}

/// name: relative, "" for what the photo does not have.
void copyOne(const fs::path& from, const std::string& name, const fs::path& to, std::string& newName,
             int number) {
    if (name.empty()) {
        return;
    }
    const fs::path old = name;
    newName = (*old.begin() / text(number, old.extension().string())).string();
    fs::copy_file(from / name, to / newName);
}

} // namespace

Places serpentine(const render::DatasetInfo& info) {
    Places places;
    for (const render::DatasetPhoto& photo : info.photos) {
        places.push_back(photo.roomFromPhoto.translation);
    }
    const auto isBefore = [](const Vector3d& a, const Vector3d& b) {
        return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
    };
    std::sort(places.begin(), places.end(), isBefore);
    places.erase(std::unique(places.begin(), places.end()), places.end());
    const double reach = spacing(places) / 2;
    Places result;
    bool isForth = true;
    for (const Places& layer : groups(places, 2, reach)) {
        for (Places row : groups(layer, 1, reach)) {
            std::stable_sort(row.begin(), row.end(), [=](const Vector3d& a, const Vector3d& b) {
                return isForth ? a.x() < b.x() : b.x() < a.x();
            });
            result.insert(result.end(), row.begin(), row.end());
            isForth = !isForth;
        }
    }
    return result;
}

StationPath::StationPath(Places places) : m_places(std::move(places)) {
    double reached = 0;
    for (std::size_t i = 0; i < m_places.size(); ++i) {
        reached += i == 0 ? 0 : (m_places[i] - m_places[i - 1]).norm();
        m_reachedM.push_back(reached);
    }
}

Vector3d StationPath::at(double walkedM) const {
    if (lengthM() == 0) {
        return m_places.front();
    }
    const double round = std::fmod(walkedM, 2 * lengthM());
    const double along = round <= lengthM() ? round : 2 * lengthM() - round;
    const auto next = std::upper_bound(m_reachedM.begin(), m_reachedM.end(), along);
    if (next == m_reachedM.end()) {
        return m_places.back();
    }
    const auto i = static_cast<std::size_t>(next - m_reachedM.begin());
    const double share = (along - m_reachedM[i - 1]) / (m_reachedM[i] - m_reachedM[i - 1]);
    return m_places[i - 1] + share * (m_places[i] - m_places[i - 1]);
}

PhotoRow::PhotoRow(const render::Dataset& dataset, int copies, ProgressSink& progress,
                   const std::stop_token& stop) {
    try {
        copy(dataset, copies, progress, stop);
    } catch (const fs::filesystem_error& failure) {
        const bool isFull = failure.code() == std::errc::no_space_on_device;
        throw Error(isFull ? ErrorKind::Full : ErrorKind::Io,
                    text("Could not copy the photo ", copies, " times into ", m_folder.path().string(), ": ",
                         failure.code().message(), "; set TMPDIR to a folder with room."));
    }
    m_dataset = std::make_shared<const render::Dataset>(render::Dataset::open(m_folder.path()));
}

void PhotoRow::checkRoom(std::uint64_t neededBytes) const {
    const std::uint64_t free = fs::space(m_folder.path()).available;
    if (free < neededBytes) {
        throw Error(ErrorKind::Full,
                    text("The copies of the photo take ", humanBytes(neededBytes), ", and the folder ",
                         m_folder.path().parent_path().string(), " has only ", humanBytes(free),
                         " left; set TMPDIR to a folder with room, or ask for fewer."));
    }
}

void PhotoRow::copy(const render::Dataset& dataset, int copies, ProgressSink& progress,
                    const std::stop_token& stop) {
    render::DatasetInfo info = dataset.info();
    render::DatasetPhoto original = info.photos.front();
    original.depth.clear(); // the row is for loading photos
    info.roomShape.reset();
    info.photos.clear();
    info.outline.clear();
    info.obstacles.clear();
    info.stepM = kStepM;
    checkRoom(static_cast<std::uint64_t>(copies) * (original.sizeBytes + (1 << 20)));
    for (const std::string& name : {original.file, original.restartIndex, original.thumbnail}) {
        if (!name.empty()) {
            fs::create_directories(m_folder.path() / *fs::path(name).begin());
        }
    }
    for (int i = 0; i < copies; ++i) {
        throwIfStopped(stop);
        render::DatasetPhoto photo = original;
        copyOne(dataset.folder(), original.file, m_folder.path(), photo.file, i);
        copyOne(dataset.folder(), original.restartIndex, m_folder.path(), photo.restartIndex, i);
        copyOne(dataset.folder(), original.thumbnail, m_folder.path(), photo.thumbnail, i);
        photo.station = text("copy ", i + 1);
        photo.roomFromPhoto.translation.x() += kStepM * i;
        info.photos.push_back(photo);
        progress.progress(static_cast<double>(i + 1) / copies, "Copying the photo");
    }
    writeFile(m_folder.path() / render::kDatasetFile, bytesOf(render::toJson(info).dump(1)));
}

} // namespace spherewalk::bench

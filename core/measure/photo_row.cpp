// SPDX-License-Identifier: GPL-3.0-or-later
#include "photo_row.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"

namespace spherewalk::measure {

namespace fs = std::filesystem;

namespace {

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

} // namespace spherewalk::measure

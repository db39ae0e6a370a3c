// SPDX-License-Identifier: GPL-3.0-or-later
#include "subset_dataset.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"

namespace spherewalk::jobs {

namespace fs = std::filesystem;

namespace {

/// The same file under another name where the file system can, else a copy.
void place(const fs::path& from, const fs::path& to) {
    std::error_code failure;
    fs::create_directories(to.parent_path(), failure);
    fs::create_hard_link(from, to, failure);
    if (failure) {
        failure.clear();
        fs::copy_file(from, to, failure);
    }
    if (failure) {
        throw Error(
            failure == std::errc::no_space_on_device ? ErrorKind::Full : ErrorKind::Io,
            text("Could not copy ", from.string(), " to ", to.string(), ": ", failure.message(), "."));
    }
}

} // namespace

SubsetDataset::SubsetDataset(const render::Dataset& whole, std::span<const std::size_t> photos,
                             const SurveyDepth* depth) {
    render::DatasetInfo info = whole.info();
    info.choice.reset();
    info.measuredErrorPx.clear();
    info.photos.clear();
    if (depth != nullptr) {
        info.sphereRadiusM = depth->radiusM ? depth->radiusM : info.sphereRadiusM;
        info.roomShape = depth->room;
    }
    for (std::size_t i = 0; i < photos.size(); ++i) {
        render::DatasetPhoto photo = whole.info().photos[photos[i]];
        photo.scene.reset();
        photo.depth.clear();
        if (depth != nullptr && !depth->files[i].empty()) {
            photo.depth = text("depth/", depth->files[i].filename().string()); // says what it depends on
            place(depth->files[i], m_folder.path() / photo.depth);
        }
        for (const std::string& name : {photo.file, photo.restartIndex, photo.thumbnail}) {
            if (!name.empty()) {
                place(whole.folder() / name, m_folder.path() / name);
            }
        }
        info.photos.push_back(std::move(photo));
    }
    writeFile(m_folder.path() / render::kDatasetFile, bytesOf(render::toJson(info).dump()));
    m_renderer.emplace(std::make_shared<const render::Dataset>(render::Dataset::open(m_folder.path())));
}

} // namespace spherewalk::jobs

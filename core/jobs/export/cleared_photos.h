// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/recently_used.h"
#include "spherewalk/dataset/writer.h"
#include "spherewalk/jobs/export_dataset.h"
#include "spherewalk/scene/carried.h"
#include "spherewalk/survey/room.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace spherewalk::jobs {

/// A dataset's photos, as their depths are estimated from. Errors: those of reading the files.
std::vector<DepthInput> depthInputs(std::span<const dataset::SourcePhoto> photos);

/// Photos of a survey without what the camera carries along: floor and walls stand in its place, as other
/// photos show them. Their files are made when they are asked for, and kept for later runs. Threads: one at a
/// time.
class ClearedPhotos {
  public:
    /// Looks for what is carried along, if it shall. photos: those of the survey. cacheFolder: it keeps the
    /// files. Errors: those of reading and decoding the photos. Stop: Stopped.
    ClearedPhotos(std::vector<DepthInput> photos, survey::Room room, std::filesystem::path cacheFolder,
                  bool looks, const std::stop_token& stop);

    const scene::CarriedThings& carried() const { return m_carried; }

    /// The photos as depths are estimated from. Where something is carried along, the files may not be there
    /// yet, and the hashes name what they will be made of.
    const std::vector<DepthInput>& inputs() const { return m_inputs; }

    /// Makes a photo's file if it is not there. A grey photo stays as it is. Errors: those of reading and
    /// writing. Stop: Stopped.
    void make(std::size_t photo, const std::stop_token& stop);

  private:
    std::string keyOfPhoto(std::size_t photo) const;
    scene::FilledPicture filled(std::size_t photo, const RgbImage& picture);

    std::vector<DepthInput> m_photos;
    survey::Room m_room;
    scene::CarriedThings m_carried;
    std::vector<std::vector<std::size_t>> m_helpers; ///< The photos that show a photo's surroundings.
    std::vector<DepthInput> m_inputs;
    RecentlyUsed<std::size_t, RgbImage> m_pictures;
};

} // namespace spherewalk::jobs

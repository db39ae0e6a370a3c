// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/progress.h"
#include "spherewalk/dataset/pose_formats.h"
#include "spherewalk/store/survey_store.h"

#include <filesystem>
#include <span>
#include <stop_token>

namespace spherewalk::jobs {

struct ForeignOptions {
    dataset::PoseFormat format = dataset::PoseFormat::Nerfstudio;
    /// The six faces of a cube, pinhole pictures of 90 degrees a quarter of the photo wide, instead of the
    /// photo. COLMAP gets them in any case.
    bool withFaces = false;
};

struct ForeignReport {
    std::size_t photos = 0;
    std::size_t pictures = 0;
};

/// Writes the files of a format into a folder.
void writePoseFiles(dataset::PoseFormat format, const dataset::FrameCamera& camera,
                    std::span<const dataset::PosedFrame> frames, const std::filesystem::path& folder);

/// Exports the photos that exportDataset() would for programs that read other formats: pictures in images/,
/// and the format's files beside it. Photos have no times in these; they are a second apart, in their order.
/// Errors: those of exportDataset() and dataset::poseFiles(); Unsupported for photos of different sizes, of
/// which a format describes one. After an error nothing is left.
ForeignReport exportForeign(const store::SurveyStore& store, const std::filesystem::path& folder,
                            const ForeignOptions& options, ProgressSink& progress,
                            const std::stop_token& stop);

} // namespace spherewalk::jobs

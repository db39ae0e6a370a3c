// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/align/features.h"

#include <filesystem>
#include <optional>
#include <string>

namespace spherewalk::align {

/// Features kept on disk, a file a photo, so that an alignment that was stopped goes on where it was. A file
/// counts only if it is whole and of exactly this photo, these options and this mask.
class FeatureCache {
  public:
    /// folder: made when the first features are kept.
    FeatureCache(std::filesystem::path folder, const FeatureOptions& options, const MaskImage& mask = {});

    /// photoSha256: of the photo's file. Nothing for a file that is not there, damaged, or of something else.
    /// Errors: Io for a file that is there and cannot be read.
    std::optional<Features> find(const std::string& photoSha256) const;
    /// Durably, in place of what was there. Errors: those of writeFile().
    void keep(const std::string& photoSha256, const Features& features) const;

    std::filesystem::path fileOf(const std::string& photoSha256) const;

  private:
    std::string keyOf(const std::string& photoSha256) const;

    std::filesystem::path m_folder;
    std::string m_settings; ///< what features depend on besides the photo
    FeatureOptions m_options;
};

} // namespace spherewalk::align

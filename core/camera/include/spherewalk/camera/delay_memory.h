// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json.h"

#include <array>
#include <filesystem>
#include <string_view>

namespace spherewalk::camera {

/// The options that say when a camera sleeps and switches itself off.
inline constexpr std::array kDelayNames{"sleepDelay", "offDelay"};

/// Where a camera's own delays are kept while it is told to stay awake, so that they outlive a program that
/// is killed: a small file for each camera.
class DelayMemory {
  public:
    DelayMemory(const std::filesystem::path& folder, std::string_view serialNumber);

    /// What has been written and not forgotten; null if there is nothing usable.
    Json read() const;
    /// Durably. Errors: Io, Full.
    void write(const Json& delays) const;
    void forget() const;

  private:
    std::filesystem::path m_file;
};

} // namespace spherewalk::camera

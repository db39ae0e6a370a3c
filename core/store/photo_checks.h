// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <filesystem>
#include <string>

namespace spherewalk::store {

/// Errors: InvalidInput for what cannot be a photo's file name, SHA-256, or position.
void checkPhotoName(const std::string& fileName, const std::string& sha256, const Eigen::Vector3d& positionM);

/// Errors: NotFound; Corrupt for a file of another size.
void checkPhotoFile(const std::filesystem::path& file, std::uint64_t sizeBytes);

} // namespace spherewalk::store

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/survey/private_region.h"

#include <filesystem>
#include <memory>
#include <stop_token>
#include <vector>

namespace spherewalk::photo {

/// Looks for faces in equirectangular photos. OpenCV's cascades look at views all around, of people who stand
/// upright within 60 degrees of the photo's middle row. Threads: const functions may run on any number at a
/// time. Source: Viola and Jones 2001; the cascades are those of Debian's package opencv-data.
class FaceSearch {
  public:
    /// Reads the cascades. folder: it holds them; empty for where the system has them. Errors: NotFound if
    /// they are not there, with the name of the package; Corrupt.
    explicit FaceSearch(const std::filesystem::path& folder = {});
    ~FaceSearch();
    FaceSearch(FaceSearch&&) noexcept;
    FaceSearch& operator=(FaceSearch&&) noexcept;

    /// One region a face, with hair and chin, the most certain first. threads: 0 for all that the machine
    /// has; the result does not depend on it. Errors: InvalidInput for a picture that is not twice as wide as
    /// high. Stop: Stopped, within a view. Cost: see resources/docs/figures.md.
    std::vector<survey::PrivateRegion> faces(const RgbImage& photo, int threads,
                                             const std::stop_token& stop) const;

  private:
    struct Parts;
    std::unique_ptr<Parts> m_parts;
};

/// The width that photos are reduced to before faces are looked for; a wider one takes longer and finds no
/// more.
inline constexpr int kFaceSearchWidth = 2688;

} // namespace spherewalk::photo

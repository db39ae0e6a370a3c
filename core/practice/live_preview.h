// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "exposure.h"

#include <cstdint>
#include <memory>
#include <mutex>

namespace spherewalk::practice {

/// What the camera shows before a photo is taken: the next photo, small. There is one client at a time; a new
/// one ends the preview before it. Threads: any.
class LivePreview {
  public:
    explicit LivePreview(const Exposer& exposer) : m_exposer(exposer) {}

    /// The number by which the new preview is asked for.
    std::uint64_t begin();

    void end() { begin(); }

    bool isCurrent(std::uint64_t preview) const;

    /// The JPEG; drawn anew only if it shows something else than the one before. Stop: Error{Stopped}.
    std::shared_ptr<const Bytes> picture(const ExposureSettings& settings, const EquirectSize& size,
                                         const std::stop_token& stop);

  private:
    const Exposer& m_exposer;
    mutable std::mutex m_mutex; ///< guards all below
    std::uint64_t m_current = 0;
    ExposureSettings m_shownSettings;
    EquirectSize m_shownSize;
    std::shared_ptr<const Bytes> m_shown;
};

/// The boundary that separates the pictures, as the camera announces it.
inline constexpr const char* kPreviewType = "multipart/x-mixed-replace; boundary=\"---osclivepreview---\"";

/// One picture in the endless answer, framed as the camera does: the boundary lacks the two dashes that MIME
/// asks for.
struct PreviewPart {
    bool hasBoundary = true;
    std::uint64_t statedBytes = 0; ///< Content-Length
};

Bytes framed(ByteView jpeg, const PreviewPart& part);

} // namespace spherewalk::practice

// SPDX-License-Identifier: GPL-3.0-or-later
#include "live_preview.h"

#include "spherewalk/base/text.h"

namespace spherewalk::practice {

namespace {

/// Whether both settings give the same picture.
bool showTheSame(const ExposureSettings& a, const ExposureSettings& b) {
    return a.shot == b.shot && a.levelled == b.levelled && a.nominalPositionM == b.nominalPositionM;
}

} // namespace

std::uint64_t LivePreview::begin() {
    const std::scoped_lock lock(m_mutex);
    return ++m_current;
}

bool LivePreview::isCurrent(std::uint64_t preview) const {
    const std::scoped_lock lock(m_mutex);
    return preview == m_current;
}

std::shared_ptr<const Bytes> LivePreview::picture(const ExposureSettings& settings, const EquirectSize& size,
                                                  const std::stop_token& stop) {
    {
        const std::scoped_lock lock(m_mutex);
        const bool isSameSize = m_shownSize.width == size.width && m_shownSize.height == size.height;
        if (m_shown && isSameSize && showTheSame(m_shownSettings, settings)) {
            return m_shown;
        }
    }
    auto drawn = std::make_shared<const Bytes>(m_exposer.preview(settings, size, stop));
    const std::scoped_lock lock(m_mutex);
    m_shownSettings = settings;
    m_shownSize = size;
    m_shown = drawn;
    return drawn;
}

Bytes framed(ByteView jpeg, const PreviewPart& part) {
    const std::string head =
        text(part.hasBoundary ? "---osclivepreview---\r\n" : "",
             "Content-type: image/jpeg\r\nContent-Length: ", part.statedBytes, "\r\n\r\n");
    Bytes bytes(head.begin(), head.end());
    bytes.insert(bytes.end(), jpeg.begin(), jpeg.end());
    for (const char c : std::string_view("\r\n\r\n")) {
        bytes.push_back(static_cast<std::uint8_t>(c));
    }
    return bytes;
}

} // namespace spherewalk::practice

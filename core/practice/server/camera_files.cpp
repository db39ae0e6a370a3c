// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures over the wire: files, and the live preview.
#include "server/camera_server.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jpeg/jpeg.h"

#include <algorithm>

namespace spherewalk::practice {

namespace {

constexpr std::size_t kChunk = 64 * 1024;
constexpr double kDownloadBytesPerSecond = 1e6; ///< 2.4 GHz
constexpr std::uint64_t kMaxServedBytes = 256ULL << 20;
constexpr const char* kPreviewCommand = "camera.getLivePreview";

/// The boundary that separates the pictures, as the camera announces it.
constexpr const char* kPreviewType = "multipart/x-mixed-replace; boundary=\"---osclivepreview---\"";

/// One picture in the endless answer, framed as the camera does: the boundary lacks the two dashes that MIME
/// asks for.
struct PreviewPart {
    bool hasBoundary = true;
    std::uint64_t statedBytes = 0; ///< Content-Length
};

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

} // namespace

void CameraServer::servePreview(HttpConnection& connection) {
    if (isRefused(kPreviewCommand, connection)) {
        return;
    }
    const auto preview = m_device.beginPreview();
    if (!preview) {
        return reply(connection, refusal(kPreviewCommand, OscCode::DisabledCommand));
    }
    constexpr double kFirstPicture = 0.5;
    m_device.pause(kFirstPicture);
    connection.beginChunks(kPreviewType);
    while (sendPicture(*preview, connection)) {
    }
}

/// Sends the next picture of the preview. Returns false at the end of the preview or of the connection.
bool CameraServer::sendPicture(std::uint64_t preview, HttpConnection& connection) {
    std::shared_ptr<const Bytes> picture;
    try {
        picture = m_device.nextPreviewPicture(preview);
    } catch (const Error&) { // stopped, or the photo that was to be shown cannot be read
        connection.drop();
        return false;
    }
    if (!picture) {
        connection.sendChunk({});
        return false;
    }
    if (m_faults.take(FaultKind::PreviewStall, kPreviewCommand)) {
        constexpr std::chrono::milliseconds kGlance(20);
        while (m_device.isPreviewing(preview) && connection.isOpen()) {
            std::this_thread::sleep_for(kGlance);
        }
        connection.drop();
        return false;
    }
    PreviewPart part{true, picture->size()};
    part.hasBoundary = !m_faults.take(FaultKind::PreviewWithoutBoundary, kPreviewCommand);
    if (const auto wrong = m_faults.take(FaultKind::PreviewWrongLength, kPreviewCommand)) {
        part.statedBytes = wrong->byte;
    }
    return connection.sendChunk(framed(*picture, part));
}

void CameraServer::serveFile(const std::optional<std::filesystem::path>& path, bool isThumb,
                             HttpConnection& connection) {
    if (isRefused("/files", connection)) {
        return;
    }
    if (!path || m_faults.take(FaultKind::MissingFile, "/files")) {
        reply(connection, refusal("unknown", OscCode::NotFound));
        return;
    }
    Bytes bytes;
    try {
        bytes = readFile(*path, kMaxServedBytes);
        if (isThumb) {
            bytes = jpeg::encode(jpeg::decode(bytes, path->string(), 8), 80);
        }
    } catch (const Error&) { // deleted meanwhile, or not decodable: the camera has no such file
        reply(connection, refusal("unknown", OscCode::NotFound));
        return;
    }
    if (bytes.empty()) {
        return connection.answer({200, "image/jpeg", ""});
    }
    sendFile(std::move(bytes), connection);
}

void CameraServer::sendFile(Bytes bytes, HttpConnection& connection) {
    if (const auto fault = m_faults.take(FaultKind::CorruptDownload, "/files")) {
        constexpr std::size_t kDamaged = 64;
        const std::size_t begin = std::min<std::size_t>(fault->byte, bytes.size());
        const std::size_t end = std::min(begin + kDamaged, bytes.size());
        std::fill(bytes.begin() + static_cast<std::ptrdiff_t>(begin),
                  bytes.begin() + static_cast<std::ptrdiff_t>(end), std::uint8_t{0xff});
    }
    const auto cut = m_faults.take({FaultKind::CutDownload, FaultKind::StallDownload}, "/files");
    const std::size_t end = cut ? std::min<std::size_t>(cut->byte, bytes.size()) : bytes.size();
    connection.beginAnswer("image/jpeg", bytes.size());
    for (std::size_t sent = 0; sent < end && connection.isOpen();) {
        const std::size_t piece = std::min(kChunk, end - sent);
        m_device.pause(static_cast<double>(piece) / kDownloadBytesPerSecond);
        connection.send({reinterpret_cast<const char*>(bytes.data()) + sent, piece});
        sent += piece;
    }
    if (cut && cut->kind == FaultKind::StallDownload) {
        connection.awaitLeaving();
    }
    if (cut) {
        connection.drop();
    }
}

} // namespace spherewalk::practice

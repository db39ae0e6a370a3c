// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures over the wire: files, and the live preview.
#include "camera_server.h"
#include "camera_socket.h"
#include "reply.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/jpeg/jpeg.h"

#include <algorithm>

namespace spherewalk::practice {

namespace {

constexpr std::size_t kChunk = 64 * 1024;
constexpr double kDownloadBytesPerSecond = 1e6; ///< 2.4 GHz
constexpr std::uint64_t kMaxPhotoBytes = 256ULL << 20;
constexpr const char* kPreviewCommand = "camera.getLivePreview";

} // namespace

void CameraServer::servePreview(httplib::Response& response) {
    if (isRefused(kPreviewCommand, response)) {
        return;
    }
    const auto preview = m_device.beginPreview();
    if (!preview) {
        return reply(response, refusal(kPreviewCommand, OscCode::DisabledCommand));
    }
    constexpr double kFirstPicture = 0.5;
    m_device.pause(kFirstPicture);
    response.set_header("X-Content-Type-Options", "nosniff");
    response.set_chunked_content_provider(
        kPreviewType, [this, preview = *preview](std::size_t /*sent*/, httplib::DataSink& sink) {
            return sendPicture(preview, sink);
        });
}

/// The next picture of the preview, or the end of it. False closes the connection.
bool CameraServer::sendPicture(std::uint64_t preview, httplib::DataSink& sink) {
    std::shared_ptr<const Bytes> picture;
    try {
        picture = m_device.nextPreviewPicture(preview);
    } catch (const Error&) { // stopped, or the photo that was to be shown cannot be read
        return false;
    }
    if (!picture) {
        sink.done();
        return true;
    }
    if (m_faults.take(FaultKind::PreviewStall, kPreviewCommand)) {
        constexpr std::chrono::milliseconds kGlance(20);
        while (m_device.isPreviewing(preview)) {
            std::this_thread::sleep_for(kGlance);
        }
        return false;
    }
    PreviewPart part{true, picture->size()};
    part.hasBoundary = !m_faults.take(FaultKind::PreviewWithoutBoundary, kPreviewCommand);
    if (const auto wrong = m_faults.take(FaultKind::PreviewWrongLength, kPreviewCommand)) {
        part.statedBytes = wrong->byte;
    }
    const Bytes bytes = framed(*picture, part);
    return sink.write(reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

void CameraServer::serveFile(const std::optional<std::filesystem::path>& path, bool isThumb,
                             httplib::Response& response) {
    if (isRefused("/files", response)) {
        return;
    }
    if (!path || m_faults.take(FaultKind::MissingFile, "/files")) {
        reply(response, refusal("unknown", OscCode::NotFound));
        return;
    }
    auto bytes = std::make_shared<Bytes>();
    try {
        *bytes = readFile(*path, kMaxPhotoBytes);
        if (isThumb) {
            *bytes = jpeg::encode(jpeg::decode(*bytes, path->string(), 8), 80);
        }
    } catch (const Error&) { // deleted meanwhile, or not decodable: the camera has no such file
        reply(response, refusal("unknown", OscCode::NotFound));
        return;
    }
    if (bytes->empty()) {
        response.set_content("", "image/jpeg");
        return;
    }
    sendFile(std::move(bytes), response);
}

void CameraServer::sendFile(std::shared_ptr<Bytes> bytes, httplib::Response& response) {
    if (const auto fault = m_faults.take(FaultKind::CorruptDownload, "/files")) {
        constexpr std::size_t kDamaged = 64;
        const std::size_t begin = std::min<std::size_t>(fault->byte, bytes->size());
        const std::size_t end = std::min(begin + kDamaged, bytes->size());
        std::fill(bytes->begin() + static_cast<std::ptrdiff_t>(begin),
                  bytes->begin() + static_cast<std::ptrdiff_t>(end), std::uint8_t{0xff});
    }
    const auto cut = m_faults.take({FaultKind::CutDownload, FaultKind::StallDownload}, "/files");
    const bool isStall = cut && cut->kind == FaultKind::StallDownload;
    const std::size_t end = cut ? std::min<std::size_t>(cut->byte, bytes->size()) : SIZE_MAX;
    response.set_header("X-Content-Type-Options", "nosniff");
    const std::size_t size = bytes->size();
    response.set_content_provider(size, "image/jpeg",
                                  [this, bytes = std::move(bytes), end, isStall](size_t offset, size_t length,
                                                                                 httplib::DataSink& sink) {
                                      if (offset >= end && isStall) {
                                          CameraSocket::current().awaitLeaving();
                                      }
                                      if (offset >= end || m_stopping) {
                                          return false; // closes the connection
                                      }
                                      const std::size_t piece = std::min({kChunk, length, end - offset});
                                      m_device.pause(static_cast<double>(piece) / kDownloadBytesPerSecond);
                                      return sink.write(reinterpret_cast<const char*>(bytes->data()) + offset,
                                                        piece);
                                  });
}

} // namespace spherewalk::practice

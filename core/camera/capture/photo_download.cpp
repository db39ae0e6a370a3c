// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/camera/photo_download.h"

#include "spherewalk/base/digest.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/base/text.h"
#include "spherewalk/camera/shot_settler.h"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

namespace spherewalk::camera {

namespace {

/// Watches a stream for the markers that frame a JPEG. Zeros after the end are padding.
class JpegFrame {
  public:
    void add(ByteView bytes) {
        for (const std::uint8_t byte : bytes.first(std::min<std::size_t>(bytes.size(), 2 - m_started))) {
            m_start[m_started++] = byte;
        }
        const auto lastContent = std::find_if(bytes.rbegin(), bytes.rend(), [](auto byte) { return byte; });
        if (lastContent != bytes.rend()) {
            const auto index = static_cast<std::size_t>(bytes.rend() - lastContent) - 1;
            m_end = {index > 0 ? bytes[index - 1] : m_last, bytes[index]};
        }
        m_last = bytes.empty() ? m_last : bytes.back();
    }

    bool startsRight() const { return m_started == 2 && m_start[0] == 0xff && m_start[1] == 0xd8; }

    bool endsRight() const { return m_end[0] == 0xff && m_end[1] == 0xd9; }

  private:
    std::array<std::uint8_t, 2> m_start{};
    std::size_t m_started = 0;
    std::array<std::uint8_t, 2> m_end{};
    std::uint8_t m_last = 0;
};

/// A download that is worth starting again is told by Network or Timeout.
Error incomplete(const std::string& name, const std::string& what) {
    return {ErrorKind::Network, text("The photo ", name, " did not arrive whole (", what,
                                     "); it is still on the camera: move closer to it and try again.")};
}

void requireLength(const std::string& name, std::uint64_t received, std::optional<std::uint64_t> expected,
                   std::string_view source) {
    if (expected && *expected != received) {
        throw incomplete(name, text(received, " bytes instead of the ", *expected, " of ", source));
    }
}

void requireSpherical(const std::string& name, const PhotoFacts& facts, const DownloadOptions& options) {
    if (facts.width != 2 * facts.height || facts.width < options.minWidth) {
        throw Error(ErrorKind::Corrupt,
                    text("The photo ", name, " has ", facts.width, " x ", facts.height,
                         " pixels, but a spherical photo is twice as wide as high and at least ",
                         options.minWidth, " wide; set the camera to full-size stitched photos."));
    }
}

/// The error with the photo's name on the camera, in place of a file that is gone when a person reads it.
Error named(const Error& error, const std::string& temporaryName, const std::string& name) {
    std::string sentence = error.sentence();
    if (const std::size_t at = sentence.find(temporaryName); at != std::string::npos) {
        sentence.replace(at, temporaryName.size(), name);
    }
    return {error.kind(), sentence, error.context()};
}

/// A folder of this computer that is not there must not look like a photo that the camera does not have.
std::unique_ptr<DurableFile> create(const std::filesystem::path& target) {
    try {
        return std::make_unique<DurableFile>(target);
    } catch (const Error& error) {
        throw Error(error.kind() == ErrorKind::NotFound ? ErrorKind::Io : error.kind(), error.sentence(),
                    error.context());
    }
}

/// damaged: the hash of a photo that came whole but cannot be decoded: if it comes so again, it is so on the
/// camera.
DownloadedPhoto attempt(OscClient& client, std::string_view fileUrl, const std::filesystem::path& target,
                        const DownloadOptions& options, std::string& damaged, const std::stop_token& stop) {
    const std::string name = fileNameOfUrl(fileUrl);
    const auto listed = client.findFile(fileUrl, stop); // a list may be late, and the file be there
    if (listed && !isFile(fileUrl, *listed)) {
        throw Error(ErrorKind::NotFound, text("The camera has given the name ", name,
                                              " to another photo, so that this one is gone; take it again."));
    }
    const std::unique_ptr<DurableFile> output = create(target);
    DurableFile& file = *output;
    Sha256 hash;
    JpegFrame frame;
    const HttpResponse response = client.download(
        fileUrl, options.maxBytes,
        [&](ByteView bytes) {
            file.write(bytes);
            hash.update(bytes);
            frame.add(bytes);
        },
        stop);
    if (response.contentType.starts_with("text/html")) {
        throw notACamera(client.endpoint().name(), "it sent a web page instead of a photo");
    }
    requireLength(name, file.sizeBytes(), response.declaredBytes, "the answer's header");
    requireLength(name, file.sizeBytes(), listed ? listed->sizeBytes : std::nullopt, "the camera's list");
    if (!frame.startsRight()) {
        throw Error(ErrorKind::Corrupt,
                    text("The photo ", name, " is not a JPEG; set the camera to JPEG and take it again."));
    }
    if (!frame.endsRight()) {
        throw incomplete(name, "its end is missing");
    }
    const std::string sha256 = hash.hex();
    const PhotoFacts facts = [&] {
        try {
            return options.check(file.temporaryName());
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::Corrupt || std::exchange(damaged, sha256) == sha256) {
                throw named(error, file.temporaryName().string(), name);
            }
            throw incomplete(name, "it is damaged");
        }
    }();
    requireSpherical(name, facts, options);
    DownloadedPhoto photo;
    photo.temporaryFile = target;
    photo.fileUrl = fileUrl.substr(0, fileUrl.find('#'));
    photo.cameraFileName = name;
    photo.cameraSha256 = sha256;
    photo.sizeBytes = file.sizeBytes();
    photo.width = facts.width;
    photo.height = facts.height;
    file.commit(DurableFile::Overwrite::Yes);
    return photo;
}

bool isWorthRestarting(ErrorKind kind) {
    // Not found: the camera may not have finished writing what it announced.
    return kind == ErrorKind::Network || kind == ErrorKind::Timeout || kind == ErrorKind::NotFound ||
           kind == ErrorKind::Busy;
}

} // namespace

void DownloadOptions::validate() const {
    if (!check) {
        throw Error(ErrorKind::InvalidInput, "The download option check must be given.");
    }
    if (restarts < 0 || restarts > 100) {
        throw Error(ErrorKind::InvalidInput, "The download option restarts must lie between 0 and 100.");
    }
    if (restartPause < std::chrono::milliseconds(0) || restartPause > std::chrono::minutes(10)) {
        throw Error(ErrorKind::InvalidInput,
                    "The download option restartPause must lie between 0 and 10 min.");
    }
    if (maxBytes < 1024 || minWidth < 2) {
        throw Error(ErrorKind::InvalidInput, "The download options maxBytes and minWidth must be at least "
                                             "1024 bytes and 2 pixels.");
    }
}

DownloadedPhoto downloadPhoto(OscClient& client, Clock& clock, std::string_view fileUrl,
                              const std::filesystem::path& target, const DownloadOptions& options,
                              const std::stop_token& stop) {
    options.validate();
    std::string damaged;
    for (int restarts = 0;; ++restarts) {
        try {
            return attempt(client, fileUrl, target, options, damaged, stop);
        } catch (const Error& error) {
            if (!isWorthRestarting(error.kind()) || restarts >= options.restarts) {
                throw;
            }
        }
        clock.sleep(options.restartPause, stop);
        throwIfStopped(stop);
    }
}

} // namespace spherewalk::camera

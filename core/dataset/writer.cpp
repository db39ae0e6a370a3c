// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/dataset/writer.h"

#include "spherewalk/base/digest.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/folder.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/jpeg/region.h"
#include "spherewalk/jpeg/restart.h"
#include "spherewalk/photo/blurred_photo.h"
#include "spherewalk/photo/picture_file.h"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <set>

namespace spherewalk::dataset {

namespace fs = std::filesystem;

namespace {

std::uint64_t writeNew(const fs::path& file, ByteView bytes) {
    writeFile(file, bytes, DurableFile::Overwrite::No);
    return bytes.size();
}

/// The photo as it may be given away: everything that a dataset holds of it is made of these bytes.
Bytes sourceBytes(const SourcePhoto& photo, std::size_t& sizeBefore) {
    const Bytes bytes = readFile(photo.file);
    sizeBefore = bytes.size();
    if (sha256Hex(bytes) != photo.sha256) {
        throw Error(ErrorKind::Corrupt,
                    text("Could not export ", photo.file.string(),
                         ": the file was changed since it was recorded; run check, or retake the photo."));
    }
    return photo::blurredPhoto(bytes, photo.regions, photo.file.string());
}

/// The equirectangular picture as a JPEG of this width, or of its own width if that is less. Each pixel is
/// the mean of the area that it covers.
Bytes thumbnail(ByteView jpegBytes, std::string_view source, int width) {
    constexpr int kQuality = 85;
    const jpeg::Info info = jpeg::readInfo(jpegBytes, source);
    int denominator = 8;
    while (denominator > 1 && info.width / denominator < width) {
        denominator /= 2;
    }
    const RgbImage picture = jpeg::decode(jpegBytes, source, denominator);
    if (picture.width() <= width) {
        return jpeg::encode(picture, kQuality);
    }
    return jpeg::encode(photo::resized(picture, width, width / 2), kQuality);
}

/// The JPEG without the index of further pictures behind it (CIPA DC-007, MPF), which are not exported.
Bytes withoutFurtherPictures(const Bytes& source, std::string_view sourceName) {
    constexpr std::uint8_t kApp2 = 0xE2;
    constexpr std::string_view kSignature("MPF\0", 4);
    Bytes result;
    std::size_t kept = 0;
    for (const jpeg::Segment& segment : jpeg::segments(source, sourceName)) {
        const std::string_view begin = textOf(
            segment.content(source).first(std::min(kSignature.size(), segment.content(source).size())));
        if (segment.marker == kApp2 && begin == kSignature) {
            result.insert(result.end(), source.begin() + static_cast<std::ptrdiff_t>(kept),
                          source.begin() + static_cast<std::ptrdiff_t>(segment.offset));
            kept = segment.offset + segment.size;
        }
    }
    result.insert(result.end(), source.begin() + static_cast<std::ptrdiff_t>(kept), source.end());
    return result;
}

/// Writes one photo with its index and thumbnail and completes its entry. Returns the bytes written besides
/// the photo.
std::uint64_t writePhoto(const Bytes& source, const fs::path& folder, const std::string& stem,
                         const std::string& sourceName, const WriteOptions& options,
                         render::DatasetPhoto& entry) {
    const jpeg::Info info = jpeg::readInfo(source, sourceName);
    const Bytes marked = jpeg::withRestartMarkers(
        withoutFurtherPictures(source, sourceName),
        jpeg::dividingInterval(info.width, info.mcuWidth, options.mcusPerInterval), sourceName);
    const jpeg::RestartIndex index = jpeg::indexRestarts(marked, sourceName);
    entry.file = text("photos/", stem, ".jpg");
    entry.restartIndex = text("index/", stem, ".swri");
    entry.thumbnail = text("thumbnails/", stem, ".jpg");
    entry.sha256 = sha256Hex(marked);
    entry.sizeBytes = marked.size();
    entry.width = index.width;
    entry.height = index.height;
    if (entry.width != 2 * entry.height) {
        throw Error(ErrorKind::Corrupt,
                    text("Could not export ", sourceName, ": it has ", entry.width, " x ", entry.height,
                         " pixels, and an equirectangular picture is twice as wide as high."));
    }
    writeNew(folder / entry.file, marked);
    return writeNew(folder / entry.restartIndex, jpeg::serialised(index)) +
           writeNew(folder / entry.thumbnail, thumbnail(marked, sourceName, options.thumbnailWidth));
}

/// One name a photo, as the file had it, made unique.
std::vector<std::string> stems(const std::vector<SourcePhoto>& photos) {
    std::set<std::string> taken;
    std::vector<std::string> result;
    for (const SourcePhoto& photo : photos) {
        const std::string stem = photo.file.stem().string();
        std::string unique = stem;
        for (int number = 2; !taken.insert(unique).second; ++number) {
            unique = text(stem, "_", number);
        }
        result.push_back(unique);
    }
    return result;
}

void write(const Contents& contents, const fs::path& folder, const WriteOptions& options,
           ProgressSink& progress, const std::stop_token& stop, WriteReport& report) {
    render::DatasetInfo info = contents.info;
    for (const char* name : {"photos", "index", "thumbnails", "depth"}) {
        fs::create_directories(folder / name);
    }
    const std::vector<std::string> names = stems(contents.photos);
    const int count = static_cast<int>(contents.photos.size());
    info.photos.resize(contents.photos.size());
    std::mutex mutex;
    parallelFor(count, 1, options.threads, [&](int i, int /*end*/) {
        throwIfStopped(stop);
        const auto k = static_cast<std::size_t>(i);
        const SourcePhoto& photo = contents.photos[k];
        std::size_t sourceSize = 0;
        Bytes source = sourceBytes(photo, sourceSize);
        if (photo.tag) {
            source = photo::withPositionTag(source, *photo.tag, photo.file.string());
        }
        render::DatasetPhoto entry = photo.entry;
        entry.blurredRegions = static_cast<std::int64_t>(photo.regions.size());
        std::uint64_t others = writePhoto(source, folder, names[k], photo.file.string(), options, entry);
        if (!photo.depthFile.empty()) {
            entry.depth = text("depth/", names[k], ".pgm");
            others += writeNew(folder / entry.depth, readFile(photo.depthFile));
        }
        const std::scoped_lock lock(mutex);
        info.photos[k] = entry;
        ++report.photos;
        report.blurredPhotos += photo.regions.empty() ? 0 : 1;
        report.blurredRegions += photo.regions.size();
        report.sourceBytes += sourceSize;
        report.photoBytes += entry.sizeBytes;
        report.totalBytes += entry.sizeBytes + others;
        progress.progress(static_cast<double>(report.photos) / count,
                          text("Writing photo ", report.photos, " of ", count));
    });
    report.totalBytes +=
        writeNew(folder / render::kDatasetFile, bytesOf(render::toJson(info).dump(1) + "\n"));
    throwIfStopped(stop);
}

} // namespace

void WriteOptions::validate() const {
    if (mcusPerInterval < 1 || mcusPerInterval > 65535 || thumbnailWidth < 16 || thumbnailWidth > 4096) {
        throw Error(ErrorKind::InvalidInput,
                    "Could not write the dataset: 1 to 65535 MCUs may stand between restart "
                    "markers, and a thumbnail may be 16 to 4096 pixels wide.");
    }
}

WriteReport writeDataset(const Contents& contents, const fs::path& folder, const WriteOptions& options,
                         ProgressSink& progress, const std::stop_token& stop) {
    options.validate();
    if (contents.photos.empty()) {
        throw Error(ErrorKind::InvalidInput, "There is nothing to export: no station has a photo yet.");
    }
    const auto begin = std::chrono::steady_clock::now();
    WriteReport report;
    makeFolder(folder, "the dataset", [&](const fs::path& unfinished) {
        write(contents, unfinished, options, progress, stop, report);
    });
    report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return report;
}

} // namespace spherewalk::dataset

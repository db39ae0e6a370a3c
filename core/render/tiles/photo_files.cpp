// SPDX-License-Identifier: Apache-2.0
#include "tiles/photo_files.h"

#include "spherewalk/base/digest.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jpeg/jpeg.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace spherewalk::render {

namespace {

/// Each open photo holds a file descriptor and an index of some ten kilobytes.
constexpr std::size_t kMostOpen = 128;
/// A decoded thumbnail has half a megabyte.
constexpr std::size_t kMostDecoded = 32;
constexpr std::uint64_t kLargestThumbnail = 16ULL << 20;
constexpr std::uint64_t kLargestIndex = 256ULL << 20;

} // namespace

/// A photo's open file. Hash and pixels come from the same descriptor.
struct PhotoFiles::Open {
    std::size_t photo = 0;
    std::shared_ptr<const FileSource> file;
    std::optional<jpeg::RegionDecoder> parts;
};

PhotoFiles::PhotoFiles(std::shared_ptr<const Dataset> dataset, VerifyPhotos verify)
    : m_dataset(std::move(dataset)), m_verify(verify), m_hashes(m_dataset->info().photos.size()) {
    for (auto& hash : m_hashes) {
        hash = verify == VerifyPhotos::AtOpen ? PhotoHash::Verified : PhotoHash::Unverified;
    }
}

PhotoFiles::~PhotoFiles() = default;

EquirectSize PhotoFiles::size(const PhotoLevel& level) const {
    const DatasetPhoto& photo = m_dataset->info().photos.at(level.photo);
    const auto reduced = [&](int length) { return (length + level.denominator - 1) / level.denominator; };
    return {reduced(photo.width), reduced(photo.height)};
}

PhotoHash PhotoFiles::hash(std::size_t photo) const {
    return m_hashes.at(photo);
}

void PhotoFiles::refuseDamaged(std::size_t photo) const {
    throw Error(ErrorKind::Corrupt,
                text("Could not use the dataset ", m_dataset->folder().string(), ": its photo ",
                     m_dataset->info().photos[photo].file,
                     " was changed after the export (its size, its SHA-256 or its picture's size is "
                     "another); copy or export the dataset again."));
}

void PhotoFiles::check(std::size_t photo) const {
    if (m_hashes.at(photo) == PhotoHash::Damaged) {
        refuseDamaged(photo);
    }
}

std::shared_ptr<const PhotoFiles::Open> PhotoFiles::opened(std::size_t photo) {
    check(photo);
    const DatasetPhoto& entry = m_dataset->info().photos[photo];
    const std::scoped_lock lock(m_mutex);
    const auto found =
        std::find_if(m_open.begin(), m_open.end(), [&](const auto& open) { return open->photo == photo; });
    if (found != m_open.end()) {
        m_open.splice(m_open.begin(), m_open, found);
        return m_open.front();
    }
    auto open = std::make_shared<Open>();
    open->photo = photo;
    open->file = std::make_shared<FileSource>(m_dataset->folder() / entry.file);
    if (open->file->sizeBytes() != entry.sizeBytes) {
        refuseDamaged(photo);
    }
    open->file->fetchAhead();
    if (!entry.restartIndex.empty()) {
        const auto indexFile = m_dataset->folder() / entry.restartIndex;
        open->parts.emplace(open->file,
                            jpeg::parseRestartIndex(readFile(indexFile, kLargestIndex), indexFile.string()));
        if (open->parts->width() != entry.width || open->parts->height() != entry.height) {
            refuseDamaged(photo);
        }
    }
    if (m_hashes[photo] == PhotoHash::Unverified) {
        if (m_verify == VerifyPhotos::BeforeUse) {
            verify(*open, {});
            if (m_hashes[photo] == PhotoHash::Damaged) {
                refuseDamaged(photo);
            }
        } else if (std::find(m_unverified.begin(), m_unverified.end(), photo) == m_unverified.end()) {
            m_unverified.push_back(photo);
        }
    }
    m_open.push_front(open);
    if (m_open.size() > kMostOpen) {
        m_open.pop_back();
    }
    return open;
}

bool PhotoFiles::decodesParts(std::size_t photo) {
    return opened(photo)->parts.has_value();
}

void PhotoFiles::decode(const PhotoLevel& level, const jpeg::PixelRect& region, const jpeg::RowSink& sink) {
    const std::shared_ptr<const Open> open = opened(level.photo);
    if (open->parts) {
        open->parts->decode(region, {.denominator = level.denominator, .threads = 1, .stop = {}}, sink);
        return;
    }
    Bytes bytes(open->file->sizeBytes());
    open->file->read(0, bytes);
    const RgbImage picture = jpeg::decode(bytes, open->file->name(), level.denominator);
    if (EquirectSize{picture.width(), picture.height()} != size(level)) {
        refuseDamaged(level.photo);
    }
    for (int y = region.y; y < region.y + region.height; ++y) {
        sink(y, picture.at(region.x, y));
    }
}

void PhotoFiles::verify(const Open& open, const std::stop_token& stop) {
    Sha256 hash;
    Bytes piece(1 << 18);
    const std::uint64_t size = open.file->sizeBytes();
    for (std::uint64_t offset = 0; offset < size; offset += piece.size()) {
        throwIfStopped(stop);
        piece.resize(static_cast<std::size_t>(std::min<std::uint64_t>(piece.size(), size - offset)));
        open.file->read(offset, piece);
        hash.update(piece);
    }
    const bool isRight = hash.hex() == m_dataset->info().photos[open.photo].sha256;
    m_hashes[open.photo] = isRight ? PhotoHash::Verified : PhotoHash::Damaged;
}

bool PhotoFiles::verifyNext(const std::stop_token& stop) {
    std::size_t photo = 0;
    {
        const std::scoped_lock lock(m_mutex);
        if (m_unverified.empty()) {
            return false;
        }
        photo = m_unverified.front();
    }
    try {
        verify(*opened(photo), stop);
    } catch (const Error& error) {
        if (error.kind() == ErrorKind::Stopped) {
            throw;
        }
        m_hashes[photo] = PhotoHash::Damaged; // it cannot be read any more: the next use says why
    }
    const std::scoped_lock lock(m_mutex);
    std::erase(m_unverified, photo);
    return true;
}

Thumbnails::Thumbnails(std::shared_ptr<const Dataset> dataset)
    : m_dataset(std::move(dataset)), m_files(m_dataset->info().photos.size()) {
}

std::shared_ptr<const PhotoPlane> Thumbnails::get(std::size_t photo) {
    const std::string& name = m_dataset->info().photos.at(photo).thumbnail;
    if (name.empty()) {
        return nullptr;
    }
    const std::scoped_lock lock(m_mutex);
    const auto found = std::find_if(m_decoded.begin(), m_decoded.end(),
                                    [&](const Entry& entry) { return entry.photo == photo; });
    if (found != m_decoded.end()) {
        m_decoded.splice(m_decoded.begin(), m_decoded, found);
        return m_decoded.front().picture;
    }
    const auto file = m_dataset->folder() / name;
    if (m_files[photo].empty()) {
        m_files[photo] = readFile(file, kLargestThumbnail);
    }
    m_decoded.push_front(
        {photo, std::make_shared<const PhotoPlane>(jpeg::decode(m_files[photo], file.string()))});
    if (m_decoded.size() > kMostDecoded) {
        m_decoded.pop_back();
    }
    return m_decoded.front().picture;
}

} // namespace spherewalk::render

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panorama/photo_pictures.h"

#include "ui/look/core_words.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/photo/blurred_photo.h"

#include <QDir>
#include <QSaveFile>
#include <QStandardPaths>

#include <algorithm>

namespace spherewalk::ui {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMostKept = 4; ///< A photo of 5376 x 2688 pixels takes 43 MB.
constexpr int kQuickReduction = 4;
constexpr int kQuickWidth = 2048; ///< Narrower photos are decoded in full at once.

/// Returns the reduction of the first, quick picture; its width stays twice its height.
int quickDenominator(const jpeg::Info& info) {
    const bool isEven = info.width % kQuickReduction == 0 && info.height % kQuickReduction == 0;
    return info.width > kQuickWidth && isEven ? kQuickReduction : 1;
}

constexpr int kMostBytesKept = 96 << 20;
constexpr int kQuality = 85;
constexpr int kReduction = 8; ///< The decoder reduces photos by this factor.

/// Reads a kept picture; null without a usable one.
QImage fromDisk(const fs::path& file) {
    std::error_code none;
    if (!fs::exists(file, none)) {
        return {};
    }
    try {
        return qtImage(jpeg::decode(readFile(file), file.string()));
    } catch (const Error&) { // cut short by a full disk; it is made again
        return {};
    }
}

/// Makes the picture of a photo; null if the photo cannot be read.
QImage fromPhoto(const fs::path& photo) {
    try {
        const QImage picture = qtImage(jpeg::decode(readFile(photo), photo.string(), kReduction));
        return picture.scaled(ThumbnailCache::kWidth, ThumbnailCache::kHeight, Qt::IgnoreAspectRatio,
                              Qt::SmoothTransformation);
    } catch (const Error&) { // what is wrong with it, the viewer and the check say
        return {};
    }
}

void toDisk(const fs::path& file, const QImage& picture) {
    const QImage rgb = picture.convertToFormat(QImage::Format_RGB888);
    RgbImage pixels(rgb.width(), rgb.height());
    for (int y = 0; y < rgb.height(); ++y) {
        std::copy_n(rgb.constScanLine(y), pixels.row(y).size(), pixels.row(y).begin());
    }
    const Bytes bytes = jpeg::encode(pixels, kQuality);
    QSaveFile saved(QString::fromStdString(file.string()));
    if (QDir().mkpath(QString::fromStdString(file.parent_path().string())) &&
        saved.open(QIODevice::WriteOnly)) { // otherwise it is made again the next time
        saved.write(reinterpret_cast<const char*>(bytes.data()), static_cast<qint64>(bytes.size()));
        saved.commit();
    }
}

QImage made(const fs::path& photo, const fs::path& kept) {
    QImage picture = fromDisk(kept);
    if (picture.isNull()) {
        picture = fromPhoto(photo);
        if (!picture.isNull()) {
            toDisk(kept, picture);
        }
    }
    return picture;
}

} // namespace

PhotoDecoder::PhotoDecoder(QObject* parent) : QObject(parent) {
}

void PhotoDecoder::want(const std::vector<File>& files) {
    m_wanted = files;
    m_worker.dropWaiting();
    for (auto file = files.rbegin(); file != files.rend(); ++file) { // the first one is to be done first
        const Entry& found = entryOf(*file);
        if (found.sentence.isEmpty() && (!found.decoded || found.decoded->denominator > 1)) {
            decode(*file, found.decoded ? 1 : 0);
        }
    }
    while (m_entries.size() > std::max(kMostKept, files.size())) {
        m_entries.pop_back();
    }
}

std::optional<PhotoDecoder::Decoded> PhotoDecoder::find(const File& file) const {
    const Entry* found = entry(file);
    return found != nullptr ? found->decoded : std::nullopt;
}

QString PhotoDecoder::sentence(const File& file) const {
    const Entry* found = entry(file);
    return found != nullptr ? found->sentence : QString();
}

bool PhotoDecoder::isWanted(const File& file) const {
    return std::find(m_wanted.begin(), m_wanted.end(), file) != m_wanted.end();
}

PhotoDecoder::Entry& PhotoDecoder::entryOf(const File& file) {
    const auto found = std::find_if(m_entries.begin(), m_entries.end(),
                                    [&](const Entry& entry) { return entry.file == file; });
    if (found != m_entries.end()) {
        m_entries.splice(m_entries.begin(), m_entries, found);
    } else {
        m_entries.push_front({file, std::nullopt, {}});
    }
    return m_entries.front();
}

const PhotoDecoder::Entry* PhotoDecoder::entry(const File& file) const {
    const auto found = std::find_if(m_entries.begin(), m_entries.end(),
                                    [&](const Entry& entry) { return entry.file == file; });
    return found != m_entries.end() ? &*found : nullptr;
}

/// denominator: reduction of the picture; 0 chooses the quick one.
void PhotoDecoder::decode(const File& file, int denominator) {
    m_worker.post(
        QString::fromStdString(file.path.string()), [this, file, denominator]() -> BackgroundWorker::Deliver {
            try {
                const std::string name = file.path.string();
                const Bytes bytes = readFile(file.path);
                const int by = denominator > 0 ? denominator : quickDenominator(jpeg::readInfo(bytes, name));
                RgbImage picture = jpeg::decode(bytes, name, by);
                photo::blurRegions(picture, file.blurred);
                const Decoded decoded{render::Panorama(picture), by};
                return [this, file, decoded] { keep(file, decoded, {}); };
            } catch (const Error& error) {
                const QString sentence = coreWords(error.sentence());
                return [this, file, sentence] { keep(file, std::nullopt, sentence); };
            }
        });
}

void PhotoDecoder::keep(const File& file, std::optional<Decoded> decoded, const QString& sentence) {
    if (!isWanted(file)) {
        return;
    }
    Entry& entry = entryOf(file);
    entry.decoded = std::move(decoded);
    entry.sentence = sentence;
    if (entry.decoded && entry.decoded->denominator > 1) {
        decode(file, 1);
    }
    emit this->decoded();
}

ThumbnailCache::ThumbnailCache(fs::path folder, QObject* parent)
    : QObject(parent), m_folder(std::move(folder)), m_pictures(kMostBytesKept) {
}

fs::path ThumbnailCache::usualFolder() {
    const QString cache = QStandardPaths::writableLocation(QStandardPaths::CacheLocation);
    return fs::path(cache.toStdString()) / "thumbnails";
}

QImage ThumbnailCache::find(const fs::path& photo, const QString& sha256) {
    if (const QImage* picture = m_pictures.object(sha256)) {
        return *picture;
    }
    if (m_asked.contains(sha256)) {
        m_worker.hurry(sha256); // what is looked at now comes before what was scrolled past
        return {};
    }
    if (m_unreadable.contains(sha256)) {
        return {};
    }
    m_asked.insert(sha256);
    const fs::path kept = m_folder / (sha256.toStdString() + ".jpg");
    m_worker.post(sha256, [this, photo, kept, sha256] {
        const QImage picture = made(photo, kept);
        return [this, sha256, picture] { keep(sha256, picture); };
    });
    return {};
}

void ThumbnailCache::forgetRequests() {
    m_worker.dropWaiting();
    m_asked.clear();
}

void ThumbnailCache::keep(const QString& sha256, const QImage& picture) {
    m_asked.remove(sha256);
    if (picture.isNull()) {
        m_unreadable.insert(sha256);
    } else {
        m_pictures.insert(sha256, new QImage(picture), picture.sizeInBytes());
    }
    emit ready(sha256);
}

} // namespace spherewalk::ui

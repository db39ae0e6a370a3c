// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panorama/thumbnail_cache.h"

#include "ui/panorama/picture.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/jpeg/jpeg.h"

#include <QDir>
#include <QSaveFile>
#include <QStandardPaths>

namespace spherewalk::ui {

namespace fs = std::filesystem;

namespace {

constexpr int kMostBytesKept = 96 << 20;
constexpr int kQuality = 85;
constexpr int kReduction = 8; ///< while decoding

/// Null if there is none that can be used.
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

/// Null if the photo cannot be read.
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

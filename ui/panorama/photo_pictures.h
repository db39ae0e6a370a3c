// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tasks/background_worker.h"

#include "spherewalk/base/image.h"
#include "spherewalk/render/panorama.h"
#include "spherewalk/survey/private_region.h"

#include <QCache>
#include <QImage>
#include <QSet>
#include <QStringList>

#include <filesystem>
#include <list>
#include <optional>
#include <utility>
#include <vector>

namespace spherewalk::ui {

/// Copies a picture into a Qt image.
inline QImage qtImage(const RgbImage& picture) {
    return QImage(picture.values().data(), picture.width(), picture.height(), qsizetype{3} * picture.width(),
                  QImage::Format_RGB888)
        .convertToFormat(QImage::Format_RGB32);
}

/// Decodes whole photos in the background for the viewer: first small for a quick view, then in full. The
/// photos that were shown last stay in memory.
class PhotoDecoder : public QObject {
    Q_OBJECT

  public:
    /// A photo, and the regions of it that are to be blurred as exports blur them.
    struct File {
        File(std::filesystem::path photo, std::vector<survey::PrivateRegion> regions = {})
            : path(std::move(photo)), blurred(std::move(regions)) {}

        std::filesystem::path path;
        std::vector<survey::PrivateRegion> blurred;

        bool operator==(const File&) const = default;
    };

    struct Decoded {
        render::Panorama panorama;
        int denominator = 1; ///< The photo is reduced by this factor.
    };

    explicit PhotoDecoder(QObject* parent = nullptr);

    /// Asks for these photos in place of earlier requests. Decoded photos are not decoded again.
    void want(const std::vector<File>& files);
    /// Returns the photo as far as it is decoded; nothing before that.
    std::optional<Decoded> find(const File& file) const;
    /// Says why the photo cannot be decoded; empty otherwise.
    QString sentence(const File& file) const;

  signals:
    /// find() or sentence() of a wanted photo has changed.
    void decoded();

  private:
    struct Entry {
        File file;
        std::optional<Decoded> decoded;
        QString sentence;
    };

    bool isWanted(const File& file) const;
    Entry& entryOf(const File& file);
    const Entry* entry(const File& file) const;
    void decode(const File& file, int denominator);
    void keep(const File& file, std::optional<Decoded> decoded, const QString& sentence);

    std::vector<File> m_wanted;
    std::list<Entry> m_entries; ///< The latest photo is at the front.
    BackgroundWorker m_worker;  ///< The last member, as its results use the others.
};

/// Small pictures of photos, which a background thread makes. They are kept in memory and on the disk by the
/// SHA-256 of the photos, so that a survey shows its pictures at once the second time.
class ThumbnailCache : public QObject {
    Q_OBJECT

  public:
    static constexpr int kWidth = 200;
    static constexpr int kHeight = kWidth / 2;

    /// folder: it is made with the first picture. Where it cannot be written, pictures are made anew each
    /// time.
    explicit ThumbnailCache(std::filesystem::path folder, QObject* parent = nullptr);

    /// Returns the folder of the system for files that programs can make again.
    static std::filesystem::path usualFolder();

    /// Returns the picture if it is in memory. Otherwise it returns a null image and begins to make the
    /// picture; ready() follows, also for a photo that cannot be read.
    QImage find(const std::filesystem::path& photo, const QString& sha256);

    /// Whether an attempt to read the photo failed.
    bool isUnreadable(const QString& sha256) const { return m_unreadable.contains(sha256); }

    /// Drops requests that wait.
    void forgetRequests();

  signals:
    void ready(const QString& sha256);

  private:
    void keep(const QString& sha256, const QImage& picture);

    std::filesystem::path m_folder;
    QCache<QString, QImage> m_pictures;
    QSet<QString> m_asked;
    QSet<QString> m_unreadable;
    BackgroundWorker m_worker; ///< The last member, as its results use the others.
};

} // namespace spherewalk::ui

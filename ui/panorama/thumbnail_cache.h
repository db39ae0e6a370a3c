// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tasks/background_worker.h"

#include <QCache>
#include <QImage>
#include <QSet>

#include <filesystem>

namespace spherewalk::ui {

/// Small pictures of photos, made in the background, kept in memory and on the disk by the photos' SHA-256,
/// so that a survey that was looked at once is there at once.
class ThumbnailCache : public QObject {
    Q_OBJECT

  public:
    static constexpr int kWidth = 200;
    static constexpr int kHeight = kWidth / 2;

    /// folder: made when the first picture is kept; what cannot be kept there is made anew each time.
    explicit ThumbnailCache(std::filesystem::path folder, QObject* parent = nullptr);

    /// Where the system keeps what programs can make again.
    static std::filesystem::path usualFolder();

    /// The picture if it is in memory. Otherwise a null image; it is then fetched or made, and ready() says
    /// when it is there, or that the photo cannot be read.
    QImage find(const std::filesystem::path& photo, const QString& sha256);

    /// Whether the photo could not be read.
    bool isUnreadable(const QString& sha256) const { return m_unreadable.contains(sha256); }

    /// Drops what was asked for and is not there yet.
    void forgetRequests();

  signals:
    void ready(const QString& sha256);

  private:
    void keep(const QString& sha256, const QImage& picture);

    std::filesystem::path m_folder;
    QCache<QString, QImage> m_pictures;
    QSet<QString> m_asked;
    QSet<QString> m_unreadable;
    BackgroundWorker m_worker; ///< last: what it delivers uses the rest
};

} // namespace spherewalk::ui

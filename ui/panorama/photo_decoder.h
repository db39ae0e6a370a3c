// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tasks/background_worker.h"

#include "spherewalk/render/panorama.h"

#include <QStringList>

#include <filesystem>
#include <list>
#include <optional>

namespace spherewalk::ui {

/// Decodes whole photos in the background for the viewer: first small, to have something to show, then in
/// full. The photos looked at last stay in memory.
class PhotoDecoder : public QObject {
    Q_OBJECT

  public:
    using File = std::filesystem::path;

    struct Decoded {
        render::Panorama panorama;
        int denominator = 1; ///< 1: all pixels
    };

    explicit PhotoDecoder(QObject* parent = nullptr);

    /// Asks for these photos and no others; what is there already is not decoded again.
    void want(const std::vector<File>& files);
    std::optional<Decoded> find(const File& file) const;
    /// Why the photo cannot be shown; empty otherwise.
    QString sentence(const File& file) const;

  signals:
    /// There is more of a wanted photo, or it is known that it cannot be decoded.
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
    std::list<Entry> m_entries; ///< the latest at the front
    BackgroundWorker m_worker;  ///< last: what it delivers uses the rest
};

} // namespace spherewalk::ui

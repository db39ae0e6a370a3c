// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/dropped_files.h"

#include <QDir>
#include <QFileInfo>

namespace spherewalk::ui {

namespace {

bool isFloorPicture(const QFileInfo& file) {
    static const QStringList kKinds{"png", "jpg", "jpeg", "svg", "bmp", "pgm", "pdf", "yaml", "yml"};
    return file.isFile() && kKinds.contains(file.suffix().toLower());
}

/// Returns the only list of positions in a folder; empty without one.
QString positionsIn(const QDir& folder) {
    const QStringList lists = folder.entryList({"*.csv"}, QDir::Files);
    return lists.size() == 1 ? folder.filePath(lists.first()) : QString();
}

bool hasPhotos(const QDir& folder) {
    return !folder.entryList({"*.jpg", "*.jpeg"}, QDir::Files).isEmpty(); // in any case of letters
}

} // namespace

Dropped droppedAs(const QStringList& paths) {
    using Kind = Dropped::Kind;
    for (const QString& path : paths) {
        const QFileInfo file(path);
        const QDir folder(file.isDir() ? path : file.path());
        if (folder.exists("survey.sqlite")) {
            return {Kind::Survey, folder.path(), {}};
        }
        if (folder.exists("dataset.json")) {
            return {Kind::Dataset, folder.path(), {}};
        }
        if (file.suffix().toLower() == "csv") {
            return {Kind::Positions, path, folder.path()};
        }
        if (const QString list = file.isDir() ? positionsIn(folder) : QString(); !list.isEmpty()) {
            return {Kind::Positions, list, folder.path()};
        }
        if (file.isDir() && hasPhotos(folder)) {
            return {Kind::Photos, {}, folder.path()};
        }
    }
    return paths.size() == 1 && isFloorPicture(QFileInfo(paths.first()))
               ? Dropped{Kind::FloorPicture, paths.first(), {}}
               : Dropped{};
}

} // namespace spherewalk::ui

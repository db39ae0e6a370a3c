// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

namespace spherewalk::ui {

/// What files or folders are that somebody drops onto the window.
struct Dropped {
    enum class Kind { Nothing, Survey, Dataset, Positions, Photos, FloorPicture };

    Kind kind = Kind::Nothing;
    QString path;   ///< Of the survey, the dataset, the list of positions or the picture.
    QString photos; ///< Folder of the photos, which the list names if there is one.
};

/// Tells what was dropped: a survey or a dataset (their folder or a file in it), photos with their list of
/// positions (the CSV file, or a folder that has one), a folder of photos without a list, or a picture of a
/// floor plan.
Dropped droppedAs(const QStringList& paths);

} // namespace spherewalk::ui

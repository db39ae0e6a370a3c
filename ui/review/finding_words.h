// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/panorama/panorama_presenter.h"

#include "spherewalk/photo/verdict.h"
#include "spherewalk/store/survey_store.h"

#include <QString>
#include <QStringList>

#include <cstdint>
#include <optional>

namespace spherewalk::ui {

/// Returns a name of the finding that a row of a list has room for: "blurred", "foreign, 4.7 %".
QString shortText(const photo::Finding& finding);
/// Does the same for a sentence of the alignment; a sentence without a short name is returned whole.
QString shortText(const QString& sentence);

/// Returns the area of the photo that the sentence of a finding tells; nothing if it tells none. Surveys keep
/// the place of a finding in its sentence only.
std::optional<PhotoArea> areaOf(const QString& sentence);

/// Tells what became of a photo, a sentence each: taken, stored, moved to another station, judged, solved,
/// decided on. Errors: those of the store.
QStringList storyOf(const store::SurveyStore& store, std::int64_t photo);

} // namespace spherewalk::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/panorama/panorama_presenter.h"

#include "spherewalk/photo/verdict.h"

#include <QString>

#include <optional>

namespace spherewalk::ui {

/// Returns a name of the finding that a row of a list has room for: "blurred", "foreign, 4.7 %".
QString shortText(const photo::Finding& finding);
/// Does the same for a sentence of the alignment; a sentence without a short name is returned whole.
QString shortText(const QString& sentence);

/// Returns the area of the photo that the sentence of a finding tells; nothing if it tells none. Surveys keep
/// the place of a finding in its sentence only.
std::optional<PhotoArea> areaOf(const QString& sentence);

} // namespace spherewalk::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <functional>
#include <string>

namespace spherewalk::ui {

/// Gets each sentence that coreWords() knew, as the core spells it, with "%1" and so on for values.
using KnownSentence = std::function<void(const char* sentence)>;

/// Returns in the user's language what the core says of photos, alignments and datasets. A text of several
/// sentences is translated sentence by sentence. A sentence that is not known is returned as it is. Numbers
/// get the language's decimal point.
QString coreWords(const QString& text, const KnownSentence& told = {});
QString coreWords(const std::string& text);

} // namespace spherewalk::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <functional>
#include <span>
#include <string>

namespace spherewalk::ui {

/// Gets each sentence that coreWords() knew, as the core spells it, with "%1" and so on for values.
using KnownSentence = std::function<void(const char* sentence)>;

/// Returns in the user's language what the core says of photos, alignments and datasets. A text of several
/// sentences is translated sentence by sentence. A sentence that is not known is returned as it is. Numbers
/// get the language's decimal point.
QString coreWords(const QString& text, const KnownSentence& told = {});
QString coreWords(const std::string& text);

/// The sentences of errors and warnings that people meet in the window, and the parts that such sentences are
/// made of. "%1" and so on stand for values. Sources: core/base, core/camera, core/photo/picture, core/store,
/// core/survey, core/jobs. tests/lint compares them with these.
std::span<const char* const> coreErrors();

/// The sentences that alignments say of photos, tags and parts of a survey. "%1" and so on stand for values.
/// Sources: core/align, core/jobs/survey. tests/lint compares them with these.
std::span<const char* const> alignmentSentences();

} // namespace spherewalk::ui

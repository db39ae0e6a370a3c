// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure_words.h"

#include "spherewalk/base/text.h"

namespace spherewalk::jobs {

namespace {

std::string choicesText(const MeasureReport& report) {
    return text("What to render with, by tolerance", choiceBasis(report), ":\n",
                tableText(choiceTable(report)));
}

} // namespace

std::string measureText(const MeasureReport& report) {
    std::string result = text(subjectWords(report), ":\n", tableText(sceneTable(report)), "\n",
                              choicesText(report), "\n", report.choice.reason);
    if (!report.predictions.empty()) {
        result += "\n";
        for (const std::string& sentence : predictionWords(report)) {
            result += "\n" + sentence;
        }
    }
    return result;
}

} // namespace spherewalk::jobs

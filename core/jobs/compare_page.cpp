// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare_words.h"
#include "report_folder.h"

#include "spherewalk/base/text.h"
#include "spherewalk/sheet/document.h"

namespace spherewalk::jobs {

using sheet::Document;
using sheet::Paragraph;

namespace {

Document documentOf(const CompareReport& report) {
    Document document{"Views and the robot's pictures", {}};
    document.blocks.emplace_back(Paragraph{
        text(report.pictures.size(), " pictures",
             report.refined > 0 ? text(", ", report.refined, " with refined poses") : "",
             ". Pairs are before and after: from the given pose in the photos' colours, and from the refined "
             "pose in "
             "corrected colours. Colour is the mean distance of even spots' colours, in grey levels.")});
    document.blocks.emplace_back(compareTable(report));
    for (const std::string& sentence : compareSentences(report)) {
        document.blocks.emplace_back(Paragraph{sentence});
    }
    for (const ShownPicture& shown : report.shown) {
        document.blocks.emplace_back(
            sheet::PictureRow{{shown.picture, shown.before, shown.after, shown.difference},
                              {shown.name, "view before", "view after", "difference x 4"}});
    }
    return document;
}

} // namespace

void writeComparison(const CompareReport& report, const std::filesystem::path& folder) {
    writeReportFolder(documentOf(report), toJson(report), folder);
}

} // namespace spherewalk::jobs

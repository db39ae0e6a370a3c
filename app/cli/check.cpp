// SPDX-License-Identifier: GPL-3.0-or-later
#include "command.h"

#include "spherewalk/base/text.h"
#include "spherewalk/render/dataset.h"
#include "spherewalk/store/survey_store.h"

#include <memory>

namespace spherewalk::cli {

namespace {

Result checkDataset(const std::string& path, Context& context) {
    const render::Dataset dataset =
        render::Dataset::open(path, render::Verify::Hashes, context.progress, context.stop);
    const std::size_t photos = dataset.info().photos.size();
    return {{{"kind", "dataset"}, {"photos", photos}, {"sound", true}},
            text("The dataset ", path, " is sound: ", photos, " photos with the right hashes.")};
}

Result checkSurvey(const std::string& path, Context& context) {
    const auto store = store::SurveyStore::open(path, store::Access::Read);
    const store::SurveyCheck check = store.check(context.progress, context.stop);
    Json findings = Json::array();
    std::string words = text("Checked ", check.photosChecked, " photos and the database of ", path, ": ");
    words += check.isSound() ? "all is as it was recorded."
                             : text(check.photos.size() + check.database.size(), " findings.");
    const auto add = [&](const std::string& sentence) {
        findings.push_back(sentence);
        words += text("\n  ", sentence);
    };
    for (const store::PhotoFinding& finding : check.photos) {
        add(finding.sentence);
    }
    for (const std::string& sentence : check.database) {
        add(sentence);
    }
    for (const std::string& file : check.filesWithoutPhoto) {
        words += text("\n  photos/", file, " belongs to no photo of the survey (harmless)");
    }
    return {{{"kind", "survey"},
             {"photos", check.photosChecked},
             {"sound", check.isSound()},
             {"findings", findings},
             {"files_without_photo", check.filesWithoutPhoto}},
            words,
            check.isSound()};
}

Result check(const std::string& path, Context& context) {
    const bool isDataset = std::filesystem::exists(std::filesystem::path(path) / render::kDatasetFile);
    return isDataset ? checkDataset(path, context) : checkSurvey(path, context);
}

} // namespace

void addCheck(Commands& commands) {
    const auto path = std::make_shared<std::string>();
    CLI::App& command = commands.add("check", "Check every file of a survey or a dataset",
                                     [path](Context& context) { return check(*path, context); });
    command.add_option("path", *path, "Folder of the survey or dataset")->required();
}

} // namespace spherewalk::cli

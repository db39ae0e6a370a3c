// SPDX-License-Identifier: GPL-3.0-or-later
// Linked into a test program, it asks of every survey and dataset that a test leaves: do tags, records,
// solution and dataset say one place of each photo? Nothing calls it; TemporaryFolder does before it goes.
#include "temporary_folder.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/jobs/check_places.h"
#include "spherewalk/render/dataset.h"
#include "spherewalk/store/survey_store.h"

#include <gtest/gtest.h>

namespace spherewalk::test {

namespace {

namespace fs = std::filesystem;

constexpr int kDeepest = 2; ///< folders below the temporary one

std::vector<std::string> findingsOn(const fs::path& file) {
    if (file.filename() == render::kDatasetFile) {
        return jobs::checkPlaces(render::Dataset::open(file.parent_path()), noProgress(), {});
    }
    if (file.filename() != "survey.sqlite") {
        return {};
    }
    const auto store = store::SurveyStore::open(file.parent_path(), store::Access::Read);
    const store::SurveyCheck check = store.check(noProgress(), {});
    std::vector<std::string> findings = check.database;
    for (const store::PhotoFinding& photo : check.photos) {
        findings.push_back(photo.sentence);
    }
    return findings.empty() ? jobs::checkPlaces(store, noProgress(), {}) : findings;
}

void expectOnePlaceOfEachPhoto(const fs::path& folder) {
    std::error_code ended; // a folder that cannot be read is none of ours
    fs::recursive_directory_iterator entry(folder, ended);
    for (; !ended && entry != fs::recursive_directory_iterator(); entry.increment(ended)) {
        if (entry.depth() >= kDeepest) {
            entry.disable_recursion_pending();
        }
        try {
            for (const std::string& finding : findingsOn(entry->path())) {
                ADD_FAILURE() << entry->path() << ": " << finding;
            }
        } catch (const Error& error) {
            ADD_FAILURE() << entry->path() << ": " << error.sentence();
        }
    }
}

const bool isAsked = [] {
    TemporaryFolder::beforeRemoval = expectOnePlaceOfEachPhoto;
    return true;
}();

} // namespace

} // namespace spherewalk::test

// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/demo.h"
#include "spherewalk/practice/truth.h"

#include <map>

namespace spherewalk::jobs {

int solveFromTruth(store::SurveyStore& store, const std::filesystem::path& truthFile) {
    std::map<std::string, practice::Truth> truthOf; // by the photo's hash
    for (practice::Truth& truth : practice::readTruth(truthFile)) {
        const std::string sha256 = truth.sha256;
        truthOf.insert_or_assign(sha256, std::move(truth));
    }
    store::NewSolution solution;
    solution.source = "practice";
    solution.model = "truth";
    for (const store::PhotoRecord& photo : store.photos()) {
        const auto found = truthOf.find(photo.cameraSha256);
        if (found == truthOf.end() || !found->second.roomFromPhoto) {
            continue;
        }
        store::SolvedPhoto solved;
        solved.photo = photo.id;
        solved.roomFromPhoto = *found->second.roomFromPhoto;
        solved.positionM = found->second.positionM;
        solved.status = "good";
        solution.photos.push_back(solved);
    }
    store.addSolution(solution, true);
    return static_cast<int>(solution.photos.size());
}

} // namespace spherewalk::jobs

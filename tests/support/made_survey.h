// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/store/survey_store.h"

#include <filesystem>

namespace spherewalk::test {

/// A survey of a room of 4 x 3 m with a table, planned at this step, without photos.
inline std::filesystem::path makeSurvey(const std::filesystem::path& folder, double stepM = 0.5) {
    survey::Room room;
    room.outline = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
    room.obstacles = {{{1, 1}, {1.5, 1}, {1.5, 1.5}, {1, 1.5}}};
    room.ceilingM = 2.5;
    survey::PlanOptions options;
    options.stepM = stepM;
    store::SurveyStore::create(folder, folder.stem().string(), room, options, survey::plan(room, options));
    return folder;
}

} // namespace spherewalk::test

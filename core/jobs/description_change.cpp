// SPDX-License-Identifier: GPL-3.0-or-later
#include "description_change.h"

#include "spherewalk/base/file.h"
#include "spherewalk/render/dataset_format.h"

namespace spherewalk::jobs {

void changeDescription(const std::filesystem::path& dataset, const std::function<void(Json&)>& change) {
    const std::filesystem::path file = dataset / render::kDatasetFile;
    Json description = parseJson(readTextFile(file), file.string());
    render::parseDatasetInfo(description, file.string());
    change(description);
    render::parseDatasetInfo(description, file.string());
    writeFile(file, bytesOf(description.dump(1) + "\n"));
}

} // namespace spherewalk::jobs

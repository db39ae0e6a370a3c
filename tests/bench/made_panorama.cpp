// SPDX-License-Identifier: GPL-3.0-or-later
// spherewalk_made_panorama FOLDER: writes a dataset of one made-up photo with details down to a pixel, for
// spherewalk-cli bench. The tables of resources/docs/render.md call it the made-up picture.
#include "pictures.h"
#include "temporary_folder.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/sha256.h"
#include "spherewalk/dataset/writer.h"
#include "spherewalk/jpeg/jpeg.h"

#include <iostream>

namespace {

void writeMadeUpDataset(const std::filesystem::path& folder) {
    using namespace spherewalk;
    const test::TemporaryFolder temporary;
    const auto file = temporary / "made-up.jpg";
    const Bytes bytes = jpeg::encode(bench::detailedPanorama(), 98);
    writeFile(file, bytes);
    dataset::Contents contents;
    contents.info.id = contents.info.surveyId = "00000000-0000-4000-8000-000000000000";
    contents.info.name = "made up";
    contents.info.createdUtc = "2026-01-01T00:00:00.000Z";
    contents.info.madeBy = "spherewalk_made_panorama";
    contents.info.sphereRadiusM = 2.5;
    contents.photos.push_back({file, sha256Hex(bytes), {}});
    contents.photos.front().entry.rotationSource = "imported";
    dataset::writeDataset(contents, folder, {}, noProgress(), {});
}

} // namespace

int main(int count, char** values) {
    if (count != 2) {
        std::cerr << "spherewalk_made_panorama FOLDER\n";
        return 2;
    }
    try {
        writeMadeUpDataset(values[1]);
        return 0;
    } catch (const spherewalk::Error& error) {
        std::cerr << error.sentence() << "\n";
        return 1;
    }
}

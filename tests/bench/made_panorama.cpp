// SPDX-License-Identifier: GPL-3.0-or-later
// spherewalk_made_panorama FOLDER [COUNT]: writes a dataset of one made-up photo with details down to a
// pixel, for spherewalk-cli bench. The tables of resources/docs/render.md call it the made-up picture. With a
// count, so many copies stand every 20 cm along x, for cameras that move.
#include "pictures.h"
#include "temporary_folder.h"

#include "spherewalk/base/digest.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/dataset/writer.h"
#include "spherewalk/jpeg/jpeg.h"

#include <iostream>
#include <string>

namespace {

void writeMadeUpDataset(const std::filesystem::path& folder, int count) {
    using namespace spherewalk;
    const test::TemporaryFolder temporary;
    const Bytes bytes = jpeg::encode(bench::detailedPanorama(), 98);
    dataset::Contents contents;
    contents.info.id = contents.info.surveyId = "00000000-0000-4000-8000-000000000000";
    contents.info.name = "made up";
    contents.info.createdUtc = "2026-01-01T00:00:00.000Z";
    contents.info.madeBy = "spherewalk_made_panorama";
    contents.info.sphereRadiusM = 2.5;
    for (int i = 0; i < count; ++i) {
        const auto file = temporary / (i == 0 ? "made-up.jpg" : text("made-up-", i, ".jpg"));
        writeFile(file, bytes);
        contents.photos.push_back({file, sha256Hex(bytes), {}});
        contents.photos.back().entry.rotationSource = "imported";
        contents.photos.back().entry.roomFromPhoto.translation.x() = 0.2 * i;
    }
    dataset::writeDataset(contents, folder, {}, noProgress(), {});
}

} // namespace

int main(int count, char** values) {
    if (count != 2 && count != 3) {
        std::cerr << "spherewalk_made_panorama FOLDER [COUNT]\n";
        return 2;
    }
    try {
        writeMadeUpDataset(values[1], count == 3 ? std::stoi(values[2]) : 1);
        return 0;
    } catch (const spherewalk::Error& error) {
        std::cerr << error.sentence() << "\n";
        return 1;
    }
}

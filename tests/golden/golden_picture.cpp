// SPDX-License-Identifier: GPL-3.0-or-later
#include "golden_picture.h"

#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/photo/picture_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace spherewalk::test {

GoldenDifference goldenDifference(const RgbImage& picture, const RgbImage& golden, int threshold) {
    GoldenDifference result;
    result.picture = RgbImage(golden.width(), golden.height());
    int past = 0;
    for (int y = 0; y < golden.height(); ++y) {
        for (int x = 0; x < golden.width(); ++x) {
            int worst = 0;
            for (int c = 0; c < 3; ++c) {
                const int difference = std::abs(int{picture.at(x, y)[c]} - int{golden.at(x, y)[c]});
                result.picture.at(x, y)[c] = static_cast<std::uint8_t>(std::min(255, 8 * difference));
                worst = std::max(worst, difference);
            }
            past += worst > threshold ? 1 : 0;
            result.worst = std::max(result.worst, worst);
        }
    }
    result.share = static_cast<double>(past) / std::max(1, golden.width() * golden.height());
    return result;
}

void expectGolden(const RgbImage& picture, const std::string& name, const GoldenLimits& limits) {
    const std::filesystem::path file =
        std::filesystem::path(SPHEREWALK_TEST_DATA) / "golden" / (name + ".png");
    const char* renew = std::getenv("SPHEREWALK_RENEW_GOLDEN");
    if (renew != nullptr && std::string_view(renew) == "1") {
        photo::writePng(file, picture);
        GTEST_SKIP() << "Renewed " << file.string() << "; look at it before you commit it.";
    }
    const RgbImage golden = photo::readPicture(file);
    ASSERT_EQ(picture.width(), golden.width()) << file;
    ASSERT_EQ(picture.height(), golden.height()) << file;
    const GoldenDifference difference = goldenDifference(picture, golden, limits.threshold);
    if (difference.isWithin(limits)) {
        return;
    }
    const std::filesystem::path left = SPHEREWALK_TEST_PICTURES;
    ensureFolder(left);
    photo::writePng(left / (name + ".png"), picture);
    photo::writePng(left / (name + "_difference.png"), difference.picture);
    ADD_FAILURE() << text("The view differs from ", file.string(), ": ", fixed(100 * difference.share, 2),
                          " % of its pixels by more than ", limits.threshold, " grey levels (",
                          fixed(100 * limits.share, 2), " % may), the worst by ", difference.worst, " (",
                          limits.hardLimit, " may). Look at ", (left / (name + ".png")).string(), " and ",
                          (left / (name + "_difference.png")).string(),
                          ". If the view is meant to look so, run the test with SPHEREWALK_RENEW_GOLDEN=1.");
}

} // namespace spherewalk::test

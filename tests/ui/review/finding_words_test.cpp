// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/finding_words.h"

#include "spherewalk/geometry/equirect.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/photo/sketch.h"

#include <gtest/gtest.h>

#include <cmath>

namespace spherewalk::ui {

namespace {

/// A panorama with soft patches everywhere, and a white box around this azimuth where one is wanted.
photo::Sketch sketchWithBox(std::optional<Radians> azimuth) {
    const EquirectSize size{1024, 512};
    RgbImage picture(size.width, size.height);
    for (int v = 0; v < size.height; ++v) {
        for (int u = 0; u < size.width; ++u) {
            const Eigen::Vector3d d = direction(size, Eigen::Vector2d(u, v));
            const SphericalDirection at = sphericalDirection(d);
            const bool isBox = azimuth && std::abs(wrapped(at.azimuth - *azimuth).value()) < 0.3 &&
                               std::abs(at.elevation.value()) < 0.4;
            for (int c = 0; c < 3; ++c) {
                const double wave = std::sin(7 * d.x() + c) + std::sin(9 * d.y()) + std::sin(8 * d.z() + 1);
                picture.at(u, v)[c] = isBox ? 250 : static_cast<std::uint8_t>(100 + 25 * wave);
            }
        }
    }
    return photo::sketch(jpeg::encode(picture, 90), {}, "picture");
}

/// What the checks find in a photo with a box, of which its neighbours have none.
photo::Finding foreignAt(Radians azimuth) {
    const photo::Sketch empty = sketchWithBox(std::nullopt);
    const std::vector<photo::Neighbour> neighbours(3, {&empty, 0.2});
    const photo::Verdict verdict = photo::judge(sketchWithBox(azimuth), {}, {}, neighbours);
    for (const photo::Finding& finding : verdict.findings) {
        if (finding.flaw == photo::Flaw::Foreign) {
            return finding;
        }
    }
    ADD_FAILURE() << verdict.sentence();
    return {};
}

} // namespace

TEST(FindingWords, TellWhereTheChecksFoundSomething) {
    for (const Degrees azimuth : {Degrees(60.0), Degrees(-110.0)}) {
        const photo::Finding finding = foreignAt(azimuth);
        const auto area = areaOf(QString::fromStdString(finding.sentence));
        ASSERT_TRUE(area) << finding.sentence;
        EXPECT_NEAR(Degrees(area->azimuth).value(), azimuth.value(), 6);
        EXPECT_TRUE(shortText(finding).startsWith("foreign, ")) << shortText(finding).toStdString();
        EXPECT_TRUE(shortText(finding).endsWith(" %"));
    }
}

TEST(FindingWords, TellHowHighTheAlignmentFoundSomething) {
    const QString sentence =
        "Something stands where other photos look through: 54 degrees to the left of the picture's middle, "
        "20 "
        "degrees below the horizon (1.2 % of the sphere). If it is a person, step aside and take it again.";
    const auto area = areaOf(sentence);
    ASSERT_TRUE(area);
    EXPECT_NEAR(Degrees(area->azimuth).value(), 54, 1e-9);
    EXPECT_NEAR(Degrees(area->elevation).value(), -20, 1e-9);
    EXPECT_EQ(shortText(sentence), "foreign, 1.2 %");
}

TEST(FindingWords, AreShortForEveryFlaw) {
    for (int flaw = 0; flaw <= static_cast<int>(photo::Flaw::Elsewhere); ++flaw) {
        const QString words = shortText({static_cast<photo::Flaw>(flaw), survey::Quality::Doubtful, ""});
        EXPECT_FALSE(words.isEmpty()) << flaw;
        EXPECT_LE(words.size(), 20) << words.toStdString();
    }
    EXPECT_FALSE(areaOf("It is blurred; take it again."));
}

} // namespace spherewalk::ui

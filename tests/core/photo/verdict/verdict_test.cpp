// SPDX-License-Identifier: GPL-3.0-or-later
#include "verdict/labelled_photos.h"

#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/photo/verdict.h"
#include "spherewalk/practice/practice_room.h"
#include "spherewalk/practice/theta_jpeg.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <utility>

namespace spherewalk::photo {

using test::PlacedPicture;
using test::Random;

namespace {

constexpr int kWidth = 512;

/// Photos of the practice room on a lattice, judged one after the other with all others as neighbours.
class VerdictsOf : public testing::Test {
  protected:
    struct Photo {
        PlacedPicture clean;
        Sketch sketch;
    };

    VerdictsOf() {
        SCOPED_TRACE(m_random.seed());
        for (PlacedPicture& clean : test::practicePhotos(4, 4, 0.25, kWidth, true, m_random)) {
            Sketch kept = sketch(jpegOf(clean.picture), {}, "a neighbour");
            m_photos.push_back({std::move(clean), std::move(kept)});
        }
    }

    Bytes jpegOf(const RgbImage& picture) { return jpeg::encode(picture, m_random.integer(85, 95)); }

    std::vector<Neighbour> neighboursOf(const Photo& photo) const {
        std::vector<Neighbour> result;
        for (const Photo& other : m_photos) {
            if (&other != &photo) {
                result.push_back(
                    {&other.sketch, (other.clean.positionM - photo.clean.positionM).norm(), "other.JPG"});
            }
        }
        return result;
    }

    /// Of a survey with a fixed exposure and white balance.
    Verdict verdictOf(const Photo& photo, const Bytes& jpeg) const {
        const ExpectedSettings fixed{.exposureS = 1.0 / 60, .hasFixedWhiteBalance = true};
        return judgeJpeg(jpeg, "R0010001.JPG", fixed, neighboursOf(photo)).verdict;
    }

    /// The share of photos, each changed so many times, that get a verdict with this flaw. Those that do not
    /// are printed.
    double shareFound(Flaw flaw, int times, const std::function<Bytes(const RgbImage&)>& spoilt) {
        int found = 0;
        int count = 0;
        for (const Photo& photo : m_photos) {
            for (int i = 0; i < times; ++i) {
                const Verdict verdict = verdictOf(photo, spoilt(photo.clean.picture));
                ++count;
                found += std::ranges::count(verdict.findings, flaw, &Finding::flaw) > 0 ? 1 : 0;
            }
        }
        std::printf("%s: %d of %d found\n", std::string(name(flaw)).c_str(), found, count);
        return static_cast<double>(found) / count;
    }

    Random m_random{20261122};
    std::vector<Photo> m_photos;
};

constexpr double kFound = 0.95;

} // namespace

TEST_F(VerdictsOf, CleanPhotosAreHardlyEverAlarms) {
    int alarms = 0;
    int count = 0;
    for (const Photo& photo : m_photos) {
        for (int i = 0; i < 5; ++i) {
            const Verdict verdict = verdictOf(photo, jpegOf(test::ordinary(photo.clean.picture, m_random)));
            ++count;
            alarms += verdict.quality() == survey::Quality::Good ? 0 : 1;
            EXPECT_NE(verdict.quality(), survey::Quality::Failed) << verdict.sentence();
        }
    }
    std::printf("clean: %d of %d are false alarms\n", alarms, count);
    EXPECT_LE(alarms, 0.02 * count);
}

TEST_F(VerdictsOf, PhotosWithAPersonTellOfIt) {
    EXPECT_GE(shareFound(Flaw::Foreign, 3,
                         [&](const RgbImage& picture) {
                             return jpegOf(test::withPerson(picture, m_random.uniform(0.8, 2.2), m_random));
                         }),
              kFound);
}

TEST_F(VerdictsOf, PhotosWithoutNearNeighboursSayThatPersonsWereNotLookedFor) {
    const Photo& photo = m_photos[5];
    const Bytes person = jpegOf(test::withPerson(photo.clean.picture, 1, m_random));
    std::vector<Neighbour> neighbours = neighboursOf(photo);
    const Verdict near = judgeJpeg(person, "a.JPG", {}, neighbours).verdict;
    EXPECT_TRUE(near.isCompared);
    EXPECT_TRUE(near.isContentCompared);
    for (Neighbour& neighbour : neighbours) {
        neighbour.distanceM += 0.2; // As with longer steps: furniture may hide as much as a person.
    }
    const Verdict far = judgeJpeg(person, "a.JPG", {}, neighbours).verdict;
    EXPECT_TRUE(far.isCompared);
    EXPECT_FALSE(far.isContentCompared);
    EXPECT_EQ(far.quality(), survey::Quality::Good) << far.sentence();
    EXPECT_FALSE(judgeJpeg(person, "a.JPG", {}, {}).verdict.isCompared);
}

TEST_F(VerdictsOf, ACameraThatChoosesItsExposureMayDifferByAStop) {
    int alarms = 0;
    for (const Photo& photo : m_photos) {
        const double stops = m_random.uniform(-0.9, 0.9);
        const RgbImage tinted = test::tinted(photo.clean.picture, m_random.uniform(0.95, 1.05), 1);
        const Verdict verdict =
            judgeJpeg(jpegOf(test::exposed(tinted, stops)), "a.JPG", {}, neighboursOf(photo)).verdict;
        alarms += verdict.quality() == survey::Quality::Good ? 0 : 1;
    }
    EXPECT_EQ(alarms, 0);
}

TEST_F(VerdictsOf, BlurredPhotosTellOfIt) {
    EXPECT_GE(shareFound(Flaw::Blur, 2,
                         [&](const RgbImage& picture) {
                             return jpegOf(test::blurred(picture, m_random.uniform(0.8, 2),
                                                         m_random.integer(0, 1) == 0));
                         }),
              kFound);
}

TEST_F(VerdictsOf, WrongExposuresAndWhiteBalancesAreTold) {
    EXPECT_GE(shareFound(Flaw::Brightness, 2,
                         [&](const RgbImage& picture) {
                             const double stops = m_random.uniform(0.6, 2);
                             return jpegOf(
                                 test::exposed(picture, m_random.integer(0, 1) == 0 ? stops : -stops));
                         }),
              kFound);
    EXPECT_GE(shareFound(Flaw::Colour, 1,
                         [&](const RgbImage& picture) {
                             return jpegOf(test::tinted(picture, m_random.uniform(0.7, 0.9), 1.1));
                         }),
              kFound);
}

TEST_F(VerdictsOf, APhotoWithoutItsLightIsNotHeldAgainstItsOnlyNeighbour) {
    RgbImage unlit = m_photos[4].clean.picture;
    for (std::uint8_t& value : unlit.values()) {
        value /= 12;
    }
    const Sketch black = sketch(jpegOf(unlit), {}, "unlit.JPG");
    const std::vector<Neighbour> neighbours{{&black, 0.25, "unlit.JPG"}};
    for (const ExpectedSettings& expected : {ExpectedSettings{}, ExpectedSettings{.exposureS = 1.0 / 60}}) {
        const Verdict verdict = judge(m_photos[5].sketch, {}, expected, neighbours);
        EXPECT_EQ(verdict.quality(), survey::Quality::Good) << verdict.sentence();
    }
}

TEST_F(VerdictsOf, OfTwoPhotosThatDifferNeitherIsBlamedUntilOthersTell) {
    const ExpectedSettings fixed{.exposureS = 1.0 / 60, .hasFixedWhiteBalance = true};
    const Photo& bright = m_photos[5];
    const RgbImage dim = test::tinted(test::exposed(m_photos[4].clean.picture, -1.3), 0.8, 1);
    m_photos[4].sketch = sketch(jpegOf(dim), {}, "dim.JPG");
    const Photo& dark = m_photos[4];
    const auto sentence = [&](const Photo& photo, const std::vector<Neighbour>& neighbours) {
        const Verdict verdict = judge(photo.sketch, {}, fixed, neighbours);
        EXPECT_NE(verdict.quality(),
                  neighbours.size() == 1 ? survey::Quality::Failed : survey::Quality::Doubtful)
            << verdict.sentence();
        return verdict.sentence();
    };
    const std::string open = "and too few photos tell which of the two is wrong";
    EXPECT_THAT(sentence(bright, {{&dark.sketch, 0.25, "dim.JPG"}}),
                testing::AllOf(testing::HasSubstr("stops brighter than dim.JPG, " + open),
                               testing::HasSubstr("from those of dim.JPG, " + open)));
    EXPECT_THAT(sentence(dark, {{&bright.sketch, 0.25, "bright.JPG"}}),
                testing::AllOf(testing::HasSubstr("stops darker than bright.JPG, " + open),
                               testing::HasSubstr("from those of bright.JPG, " + open)));
    // All others stand too far off to be neighbours.
    std::vector<Neighbour> ofBright = neighboursOf(bright);
    std::vector<Neighbour> ofDark = neighboursOf(dark);
    for (std::vector<Neighbour>* all : {&ofBright, &ofDark}) {
        for (Neighbour& one : *all) {
            one.distanceM += one.sketch == &bright.sketch || one.sketch == &dark.sketch ? 0 : kNeighbourhoodM;
        }
    }
    EXPECT_EQ(sentence(bright, ofBright), "");
    EXPECT_THAT(sentence(dark, ofDark),
                testing::AllOf(testing::HasSubstr("stops darker than its neighbours;"),
                               testing::HasSubstr("from its neighbours';")));
}

TEST_F(VerdictsOf, NobodyIsBlamedWhereHalfOfTheSurveyIsDarker) {
    const double middle = (m_photos.front().clean.positionM.x() + m_photos.back().clean.positionM.x()) / 2;
    const auto isInTheDark = [&](const Photo& photo) { return photo.clean.positionM.x() > middle; };
    for (Photo& photo : m_photos) {
        if (isInTheDark(photo)) {
            photo.clean.picture = test::exposed(photo.clean.picture, -1.5);
            photo.sketch = sketch(jpegOf(photo.clean.picture), {}, "a neighbour");
        }
    }
    ASSERT_EQ(std::ranges::count_if(m_photos, isInTheDark), 8);
    for (const Photo& photo : m_photos) {
        const Verdict verdict = verdictOf(photo, jpegOf(photo.clean.picture));
        EXPECT_EQ(verdict.quality(), survey::Quality::Good) << verdict.sentence();
    }
}

TEST_F(VerdictsOf, AnExposureThatThePhotosStateIsNoFaultOfTheLight) {
    PhotoMetadata metadata;
    metadata.fNumber = 2;
    metadata.iso = 100;
    metadata.exposureS = 1.0 / 60;
    const Photo& photo = m_photos[5];
    for (Photo& other : m_photos) {
        other.sketch = sketch(jpegOf(other.clean.picture), metadata, "a neighbour");
    }
    const Bytes dim = jpegOf(test::exposed(photo.clean.picture, -2));
    for (const auto& [iso, flaws] : {std::pair{100, 1}, std::pair{25, 0}}) {
        metadata.iso = iso;
        const Sketch own = sketch(dim, metadata, "a.JPG");
        const Verdict verdict = judge(own, metadata, {}, neighboursOf(photo));
        EXPECT_EQ(std::ranges::count(verdict.findings, Flaw::Brightness, &Finding::flaw), flaws)
            << iso << " " << verdict.sentence();
    }
}

TEST_F(VerdictsOf, BlackAndBurntAreasAreTold) {
    EXPECT_GE(
        shareFound(Flaw::Black, 1, [&](const RgbImage& picture) { return jpegOf(test::halfBlack(picture)); }),
        kFound);
    EXPECT_GE(
        shareFound(Flaw::Burnt, 1, [&](const RgbImage& picture) { return jpegOf(test::halfBurnt(picture)); }),
        kFound);
}

TEST_F(VerdictsOf, PhotosThatAreUpsideDownFail) {
    EXPECT_GE(shareFound(Flaw::UpsideDown, 1,
                         [&](const RgbImage& picture) { return jpegOf(test::upsideDown(picture)); }),
              kFound);
}

TEST_F(VerdictsOf, TruncatedPhotosFail) {
    EXPECT_GE(shareFound(Flaw::Damaged, 3,
                         [&](const RgbImage& picture) {
                             Bytes jpeg = jpegOf(picture);
                             jpeg.resize(static_cast<std::size_t>(
                                 m_random.integer(0, static_cast<int>(jpeg.size()) - 1)));
                             return jpeg;
                         }),
              1.0);
}

TEST_F(VerdictsOf, APhotoOfAnotherPlaceLooksLikeNoneOfItsNeighbours) {
    const RgbImage grey = [] {
        RgbImage picture(kWidth, kWidth / 2);
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                std::fill_n(picture.at(x, y), 3,
                            static_cast<std::uint8_t>((x / 9 + y / 7) % 2 == 0 ? 120 : 160));
            }
        }
        return picture;
    }();
    const Verdict verdict = verdictOf(m_photos.front(), jpegOf(grey));
    EXPECT_EQ(std::ranges::count(verdict.findings, Flaw::Elsewhere, &Finding::flaw), 1) << verdict.sentence();
}

namespace {

/// Patches of any brightness, and those of a second sketch upside down with this weight.
Sketch patches(Random& random, const Sketch* other = nullptr, double weight = 0) {
    constexpr int kPatch = 6;
    Sketch made;
    made.width = kWidth;
    made.height = kWidth / 2;
    made.brightness = 125;
    made.picture = RgbImage(kSketchWidth, kSketchHeight);
    for (int top = 0; top < kSketchHeight; top += kPatch) {
        for (int left = 0; left < kSketchWidth; left += kPatch) {
            const double own = random.uniform(60, 190);
            for (int y = top; y < std::min(top + kPatch, kSketchHeight); ++y) {
                for (int x = left; x < std::min(left + kPatch, kSketchWidth); ++x) {
                    const double theirs =
                        other != nullptr ? *other->picture.at(kSketchWidth - 1 - x, kSketchHeight - 1 - y)
                                         : own;
                    std::fill_n(made.picture.at(x, y), 3,
                                static_cast<std::uint8_t>(weight * theirs + (1 - weight) * own));
                }
            }
        }
    }
    return made;
}

} // namespace

// Real photos of other rooms are like each other upside down with up to 0.5.
TEST(Verdict, CallsNoPhotoUpsideDownThatLooksLittleLikeItsNeighboursEitherWay) {
    Random random(5);
    const Sketch photo = patches(random);
    for (const auto& [weight, isTold] : {std::pair{0.3, false}, std::pair{0.7, true}}) {
        const Sketch before = patches(random, &photo, weight);
        const Sketch after = patches(random, &photo, weight);
        const std::vector<Neighbour> neighbours{{&before, 0.6, "before.JPG"}, {&after, 0.6, "after.JPG"}};
        const std::string sentence = judge(photo, {}, {}, neighbours).sentence();
        EXPECT_EQ(sentence.find("upside down against") != std::string::npos, isTold) << weight << sentence;
    }
}

// A black curtain, or a window, in a room that the photos before and after do not show.
TEST(Verdict, AsksNoPhotosOfOtherRoomsHowMuchIsBlackOrBurnt) {
    Random random(6);
    Sketch photo = patches(random);
    photo.blackPart = 0.03;
    photo.burntPart = 0.08;
    const Sketch before = patches(random);
    const Sketch after = patches(random);
    for (const auto& [distanceM, flaws] : {std::pair{0.6, 0}, std::pair{0.25, 2}}) {
        const std::vector<Neighbour> others{{&before, distanceM, "b.JPG"}, {&after, distanceM, "a.JPG"}};
        const Verdict verdict = judge(photo, {}, {}, others);
        EXPECT_EQ(std::ranges::count_if(verdict.findings,
                                        [](const Finding& finding) {
                                            return finding.flaw == Flaw::Black || finding.flaw == Flaw::Burnt;
                                        }),
                  flaws)
            << distanceM << verdict.sentence();
    }
}

// 72 cm apart, photos beside furniture may look like other rooms, or like rooms upside down.
TEST(Verdict, CallsNoPhotoOfAFlatWrongBesideFurniture) {
    Random random(3);
    practice::PracticeRoomOptions options;
    options.sizeM = {8, 6, 2.6};
    options.style = practice::RoomStyle::Flat;
    const practice::PracticeRoom flat(options);
    std::vector<std::pair<Eigen::Vector3d, Sketch>> photos;
    for (int i = 0; i < 44; ++i) {
        const Eigen::Vector3d at(0.4 + 0.72 * (i % 11), 0.4 + 0.72 * (i / 11), 1.2);
        const Rigid3 pose{rotation({Radians(random.uniform(-3, 3)), Radians(0), Radians(0)}), at};
        const RgbImage picture = flat.spherical(pose, {kWidth, kWidth / 2});
        photos.emplace_back(at, sketch(jpeg::encode(picture, 90), {}, "a photo"));
    }
    for (const auto& [at, own] : photos) {
        std::vector<Neighbour> neighbours;
        for (const auto& [there, other] : photos) {
            if (&own != &other) {
                neighbours.push_back({&other, (there - at).norm(), "other.JPG"});
            }
        }
        EXPECT_THAT(judge(own, {}, {}, neighbours).sentence(),
                    testing::Not(testing::AnyOf(testing::HasSubstr("upside down"),
                                                testing::HasSubstr("does not look like"))))
            << at.transpose();
    }
}

TEST(Verdict, TellsWhenSettingsAndSizeAreNotTheProfiles) {
    Random random(1);
    const RgbImage picture = test::practicePhotos(1, 1, 1, kWidth, false, random).front().picture;
    practice::ThetaTags tags;
    tags.isoSpeed = 400;
    tags.exposureTimeS = 1.0 / 30;
    const Bytes jpeg = practice::thetaJpeg(picture, tags);
    const ExpectedSettings expected{
        .iso = 400, .exposureS = 1.0 / 30, .width = kWidth, .hasFixedWhiteBalance = false};
    EXPECT_EQ(judgeJpeg(jpeg, "a.JPG", expected, {}).verdict.quality(), survey::Quality::Good);
    for (const ExpectedSettings& other :
         {ExpectedSettings{.iso = 200}, ExpectedSettings{.exposureS = 1.0 / 60}}) {
        const Verdict verdict = judgeJpeg(jpeg, "a.JPG", other, {}).verdict;
        ASSERT_EQ(verdict.findings.size(), 1U);
        EXPECT_EQ(verdict.findings[0].flaw, Flaw::Settings);
        EXPECT_EQ(verdict.quality(), survey::Quality::Failed);
    }
    EXPECT_EQ(judgeJpeg(jpeg, "a.JPG", {.width = 5376}, {}).verdict.findings[0].flaw, Flaw::Size);
    const Verdict balance = judgeJpeg(jpeg, "a.JPG", {.hasFixedWhiteBalance = true}, {}).verdict;
    ASSERT_EQ(balance.findings.size(), 1U);
    EXPECT_EQ(balance.findings[0].flaw, Flaw::Settings);
    EXPECT_EQ(balance.quality(), survey::Quality::Doubtful);
}

TEST(Verdict, NamesAnUnstitchedDualFisheyeAndNoSphere) {
    Random random(5);
    const std::vector<PlacedPicture> photos = test::practicePhotos(2, 2, 1, kWidth, false, random);
    for (const PlacedPicture& photo : photos) {
        RgbImage discs = photo.picture;
        RgbImage caps = photo.picture; // a tripod's plate, and a hand over the lens
        for (int y = 0; y < discs.height(); ++y) {
            for (int x = 0; x < kWidth; ++x) {
                const double half = kWidth / 4.0;
                const double across = (x % (kWidth / 2) + 0.5) / half - 1;
                if (std::hypot(across, (y + 0.5) / half - 1) > 0.97) {
                    std::fill_n(discs.at(x, y), 3, std::uint8_t{0});
                }
                if (y < kWidth / 16 || y >= kWidth * 7 / 16) {
                    std::fill_n(caps.at(x, y), 3, std::uint8_t{0});
                }
            }
        }
        const auto findings = [](const RgbImage& picture) {
            return judgeJpeg(jpeg::encode(picture, 90), "a.JPG", {}, {}).verdict;
        };
        EXPECT_THAT(findings(discs).sentence(), testing::HasSubstr("two fisheye pictures"));
        EXPECT_EQ(findings(discs).quality(), survey::Quality::Failed);
        for (const RgbImage& sphere : {photo.picture, caps}) {
            EXPECT_EQ(std::ranges::count(findings(sphere).findings, Flaw::Kind, &Finding::flaw), 0);
        }
    }
}

TEST(Verdict, NamesAPictureThatAsksToBeTurned) {
    Random random(6);
    const RgbImage picture = test::practicePhotos(1, 1, 1, kWidth, false, random).front().picture;
    const Sketch plain = sketch(jpeg::encode(picture, 90), {}, "a.JPG");
    PhotoMetadata metadata;
    EXPECT_EQ(judge(plain, metadata, {}, {}).quality(), survey::Quality::Good);
    metadata.orientation = 3;
    const Verdict verdict = judge(plain, metadata, {}, {});
    EXPECT_EQ(verdict.quality(), survey::Quality::Doubtful);
    EXPECT_THAT(verdict.sentence(), testing::HasSubstr("turned by 180 degrees (Exif Orientation)"));
}

TEST(Verdict, TellsOfACameraThatWasTurnedAmongSteadyOnes) {
    Random random(3);
    std::vector<Sketch> sketches;
    const std::vector<PlacedPicture> photos = test::practicePhotos(2, 2, 0.25, kWidth, false, random);
    for (const PlacedPicture& photo : photos) {
        sketches.push_back(sketch(jpeg::encode(photo.picture, 90), {}, "a neighbour"));
    }
    const std::vector<Neighbour> others{{&sketches[1], 0.25}, {&sketches[2], 0.25}, {&sketches[3], 0.36}};
    RgbImage turned(kWidth, kWidth / 2);
    for (int y = 0; y < turned.height(); ++y) {
        for (int x = 0; x < kWidth; ++x) {
            std::copy_n(photos[0].picture.at((x + kWidth / 4) % kWidth, y), 3, turned.at(x, y));
        }
    }
    EXPECT_EQ(judgeJpeg(jpeg::encode(photos[0].picture, 90), "a.JPG", {}, others).verdict.quality(),
              survey::Quality::Good);
    const Verdict verdict = judgeJpeg(jpeg::encode(turned, 90), "a.JPG", {}, others).verdict;
    ASSERT_EQ(verdict.findings.size(), 1U) << verdict.sentence();
    EXPECT_EQ(verdict.findings[0].flaw, Flaw::Turned);
    EXPECT_THAT(verdict.sentence(), testing::HasSubstr("turned by 9"));
}

TEST(Verdict, NamesReadBackAsWhatTheyName) {
    for (const survey::Quality quality :
         {survey::Quality::Good, survey::Quality::Doubtful, survey::Quality::Failed}) {
        EXPECT_EQ(survey::qualityNamed(name(quality)), quality);
    }
    for (int flaw = 0; flaw <= static_cast<int>(Flaw::Elsewhere); ++flaw) {
        EXPECT_EQ(flawNamed(name(static_cast<Flaw>(flaw))), static_cast<Flaw>(flaw));
    }
}

} // namespace spherewalk::photo

// SPDX-License-Identifier: GPL-3.0-or-later
#include "random.h"

#include "spherewalk/compare/colour_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace spherewalk::compare {

namespace {

using Eigen::Vector3d;

/// What another camera makes of a colour: a cast of its light, and a gamma.
Vector3d cast(const Vector3d& stored) {
    Eigen::Matrix3d mix;
    mix << 0.75, 0.12, 0.03, 0.05, 0.85, 0.06, 0.02, 0.1, 1.05;
    const Vector3d light = mix * stored.unaryExpr(&render::linearLight);
    return light.unaryExpr(
        [](double v) { return std::pow(std::clamp(render::storedValue(v), 0.0, 1.0), 1.2); });
}

/// Spots of these views, as the other camera has them, off by a grey level or so.
template <class Make>
ColourSamples samples(int count, const Make& view, double sigma = 1.0 / 255) {
    test::Random random(21);
    ColourSamples result;
    for (int i = 0; i < count; ++i) {
        const Vector3d colour = view(random);
        result.samples.push_back({colour, cast(colour) + random.vector(sigma)});
    }
    return result;
}

Vector3d anyColour(test::Random& random) {
    return {random.uniform(0.05, 0.95), random.uniform(0.05, 0.95), random.uniform(0.05, 0.95)};
}

/// As rooms have them: mostly brownish grey.
Vector3d dullColour(test::Random& random) {
    const double grey = random.uniform(0.1, 0.9);
    return grey * Vector3d(1, 0.95, 0.85) +
           0.06 * Vector3d(random.normal(), random.normal(), random.normal()) * grey;
}

double errorOf(const render::ColourCorrection& correction, Vector3d (*colour)(test::Random&)) {
    test::Random random(22);
    double sum = 0;
    for (int i = 0; i < 500; ++i) {
        const Vector3d stored = colour(random);
        sum += 255 * (correction.corrected(stored) - cast(stored)).norm() / 500;
    }
    return sum;
}

} // namespace

TEST(ColourFit, UndoesACastAndAGamma) {
    const ColourFit fit = fittedColour(samples(3000, anyColour));
    ASSERT_TRUE(fit.correction) << fit.why;
    EXPECT_GT(fit.errorBefore, 30);
    EXPECT_LT(errorOf(*fit.correction, anyColour), 1);
}

TEST(ColourFit, UndoesThemOnTheColoursOfRooms) {
    const ColourFit fit = fittedColour(samples(1000, dullColour));
    ASSERT_TRUE(fit.correction) << fit.why;
    EXPECT_LT(errorOf(*fit.correction, dullColour), 1);
    EXPECT_LT(errorOf(*fit.correction, anyColour), 25); // held to the identity where nothing tells
}

TEST(ColourFit, IsNotLedAstrayByWrongSpots) {
    ColourSamples seen = samples(3000, anyColour);
    test::Random random(23);
    for (std::size_t i = 0; i < seen.samples.size(); i += 8) {
        seen.samples[i].picture = anyColour(random);
    }
    const ColourFit fit = fittedColour(seen);
    ASSERT_TRUE(fit.correction) << fit.why;
    EXPECT_LT(errorOf(*fit.correction, anyColour), 2);
}

TEST(ColourFit, GivesCurvesThatNeverFall) {
    const ColourFit fit = fittedColour(samples(400, anyColour, 20.0 / 255));
    ASSERT_TRUE(fit.correction) << fit.why;
    for (const auto& curve : fit.correction->curves) {
        EXPECT_TRUE(std::is_sorted(curve.begin(), curve.end()));
    }
    EXPECT_NO_THROW(fit.correction->validate());
}

TEST(ColourFit, GivesTheSameForTheSameSpots) {
    const ColourSamples seen = samples(500, anyColour);
    EXPECT_EQ(fittedColour(seen).correction, fittedColour(seen).correction);
}

TEST(ColourFit, RefusesGreyViews) {
    const ColourFit fit = fittedColour(samples(1000, [](test::Random& random) {
        return Vector3d(Vector3d::Constant(random.uniform(0.1, 0.9)) + random.vector(0.002));
    }));
    EXPECT_FALSE(fit.correction);
    EXPECT_NE(fit.why.find("only grey"), std::string::npos) << fit.why;
}

TEST(ColourFit, RefusesTheGreyPicturesOfAGreyCamera) {
    ColourSamples seen = samples(1000, anyColour);
    for (ColourSample& sample : seen.samples) {
        sample.picture = Vector3d::Constant(sample.picture.mean());
    }
    const ColourFit fit = fittedColour(seen);
    EXPECT_FALSE(fit.correction);
    EXPECT_NE(fit.why.find("robot's pictures show only grey"), std::string::npos) << fit.why;
}

TEST(ColourFit, RefusesASingleColour) {
    const ColourFit fit = fittedColour(samples(
        1000, [](test::Random& random) { return Vector3d(Vector3d(0.7, 0.3, 0.2) + random.vector(0.003)); }));
    EXPECT_FALSE(fit.correction);
    EXPECT_NE(fit.why.find("only one colour"), std::string::npos) << fit.why;
}

TEST(ColourFit, RefusesColoursThatAreAllAsBright) {
    const ColourFit fit = fittedColour(samples(1000, [](test::Random& random) {
        const Vector3d colour = anyColour(random);
        return Vector3d(colour + Vector3d::Constant(0.5 - colour.mean()));
    }));
    EXPECT_FALSE(fit.correction);
    EXPECT_NE(fit.why.find("about as bright"), std::string::npos) << fit.why;
}

TEST(ColourFit, RefusesTooFewSpots) {
    const ColourFit fit = fittedColour(samples(100, anyColour));
    EXPECT_FALSE(fit.correction);
    EXPECT_NE(fit.why.find("Only 100 spots"), std::string::npos) << fit.why;
    EXPECT_FALSE(fittedColour({}).correction);
}

TEST(ColourFit, SaysThatPicturesAreTooDarkOrTooBright) {
    ColourSamples seen = samples(100, anyColour);
    seen.clipped = 5000;
    EXPECT_NE(fittedColour(seen).why.find("exposure"), std::string::npos);
}

TEST(ColourFit, RefusesWhatNoCorrectionBringsNearer) {
    ColourSamples seen = samples(1000, anyColour);
    for (ColourSample& sample : seen.samples) {
        sample.picture = sample.view;
    }
    const ColourFit fit = fittedColour(seen);
    EXPECT_FALSE(fit.correction);
    EXPECT_NE(fit.why.find("none is needed"), std::string::npos) << fit.why;
}

class ColourSpots : public testing::Test {
  protected:
    ColourSpots() : m_view(64, 48), m_picture(64, 48) {
        std::fill(m_view.values().begin(), m_view.values().end(), std::uint8_t{100});
        std::fill(m_picture.values().begin(), m_picture.values().end(), std::uint8_t{120});
        m_trust.errorPx = Image<float, 1>(64, 48);
        m_trust.flags = MaskImage(64, 48);
    }

    ColourSamples spots() const { return colourSamples(m_view, m_trust, m_picture); }

    RgbImage m_view;
    RgbImage m_picture;
    render::PixelTrust m_trust;
};

TEST_F(ColourSpots, HaveTheMeanColoursOfBoth) {
    const ColourSamples all = spots();
    ASSERT_FALSE(all.samples.empty());
    EXPECT_NEAR(255 * all.samples[0].view.x(), 100, 1e-9);
    EXPECT_NEAR(255 * all.samples[0].picture.y(), 120, 1e-9);
    EXPECT_NEAR(colourError(all.samples).value(), 20 * std::sqrt(3), 1e-9);
}

TEST_F(ColourSpots, LeaveOutWhatIsNotEven) {
    const std::size_t all = spots().samples.size();
    *m_picture.at(20, 20) = 200;
    EXPECT_LT(spots().samples.size(), all);
    EXPECT_GE(spots().samples.size(), all - 4);
}

TEST_F(ColourSpots, LeaveOutWhatIsNotTrusted) {
    const std::size_t all = spots().samples.size();
    *m_trust.errorPx.at(20, 20) = 30;
    EXPECT_LT(spots().samples.size(), all);
    std::fill(m_trust.flags.values().begin(), m_trust.flags.values().end(),
              static_cast<std::uint8_t>(render::PixelFlag::Unseen));
    EXPECT_TRUE(spots().samples.empty());
}

TEST_F(ColourSpots, CountWhatIsTooBright) {
    std::fill(m_picture.values().begin(), m_picture.values().end(), std::uint8_t{255});
    EXPECT_TRUE(spots().samples.empty());
    EXPECT_GT(spots().clipped, 0U);
}

} // namespace spherewalk::compare

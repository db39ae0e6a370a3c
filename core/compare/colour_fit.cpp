// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/compare/colour_fit.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <Eigen/Eigenvalues>
#include <ceres/ceres.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace spherewalk::compare {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using render::ColourCorrection;

namespace {

constexpr int kSpot = 8;          ///< pixels
constexpr int kAround = 2;        ///< of a spot, even too: what lies beside it may slip in
constexpr int kEven = 24;         ///< grey levels from the darkest to the brightest
constexpr float kMostErrorPx = 4; ///< of a trusted pixel
constexpr double kDarkest = 4;    ///< grey levels that are no colour any more
constexpr double kBrightest = 250;

struct Spot {
    Vector3d mean = Vector3d::Zero(); ///< grey levels
    bool isEven = false;
};

Spot spotOf(const RgbImage& picture, int left, int top) {
    std::array<std::uint8_t, 3> least{255, 255, 255};
    std::array<std::uint8_t, 3> most{};
    Spot spot;
    for (int y = top - kAround; y < top + kSpot + kAround; ++y) {
        for (int x = left - kAround; x < left + kSpot + kAround; ++x) {
            const std::uint8_t* rgb = picture.at(x, y);
            const bool isInside = x >= left && x < left + kSpot && y >= top && y < top + kSpot;
            for (std::size_t c = 0; c < 3; ++c) {
                least[c] = std::min(least[c], rgb[c]);
                most[c] = std::max(most[c], rgb[c]);
                spot.mean[static_cast<Eigen::Index>(c)] += isInside ? rgb[c] : 0;
            }
        }
    }
    spot.mean /= kSpot * kSpot;
    spot.isEven = most[0] - least[0] <= kEven && most[1] - least[1] <= kEven && most[2] - least[2] <= kEven;
    return spot;
}

bool isTrusted(const render::PixelTrust& trust, int left, int top) {
    const auto doubts = static_cast<std::uint8_t>(render::PixelFlag::Unseen) |
                        static_cast<std::uint8_t>(render::PixelFlag::Pole) |
                        static_cast<std::uint8_t>(render::PixelFlag::Overlay);
    for (int y = top - kAround; y < top + kSpot + kAround; ++y) {
        for (int x = left - kAround; x < left + kSpot + kAround; ++x) {
            if (!(*trust.errorPx.at(x, y) <= kMostErrorPx) || (*trust.flags.at(x, y) & doubts) != 0) {
                return false;
            }
        }
    }
    return true;
}

bool isClipped(const Spot& spot) {
    return spot.mean.minCoeff() < kDarkest || spot.mean.maxCoeff() > kBrightest;
}

template <class Correct>
std::optional<double> meanError(std::span<const ColourSample> samples, const Correct& correct) {
    if (samples.empty()) {
        return std::nullopt;
    }
    double sum = 0;
    for (const ColourSample& sample : samples) {
        sum += (correct(sample.view) - sample.picture).norm();
    }
    return 255 * sum / static_cast<double>(samples.size());
}

constexpr std::size_t kFewest = 150;
constexpr std::size_t kMost = 20000;
constexpr int kKnots = ColourCorrection::kKnots;
constexpr double kSigma = 2.0 / 255; ///< of a spot's colour
constexpr double kLoss = 3;          ///< in sigmas, of the robust loss

// Priors, as if every sample said so too with this standard deviation: they decide where colours do not.
constexpr double kMatrixSigma = 1;
constexpr double kBendSigma = 0.1; ///< of second differences of a curve's knots
constexpr double kStraightSigma = 0.5;

constexpr double kLeastSpread = 0.03; ///< of hues, for a matrix to be told
constexpr double kLeastShade = 0.03;  ///< of brightness, likewise for curves
constexpr double kGrey = 0.03;        ///< from grey, of hues that are grey

/// Of one channel: a row of the matrix, and the curve as its first value and what each knot adds, so that
/// "never falls" is a bound.
struct Channel {
    std::array<double, 3> row{};
    std::array<double, kKnots> steps{};
};

/// Where on a curve, and how much of each of its two knots.
struct Place {
    int knot = 0;
    double share = 0;
};

Place placeOf(double value) { // beyond the ends the first and the last piece go on
    const double at = value * (kKnots - 1);
    const int knot = std::clamp(static_cast<int>(std::floor(at)), 0, kKnots - 2);
    return {knot, at - knot};
}

double slopeOfStored(double linear) {
    constexpr double kStep = 1e-5;
    return (render::storedValue(linear + kStep) - render::storedValue(linear - kStep)) / (2 * kStep);
}

class SampleCost : public ceres::SizedCostFunction<1, 3, kKnots> {
  public:
    SampleCost(const ColourSample& sample, int channel)
        : m_light(sample.view.unaryExpr(&render::linearLight)), m_wanted(sample.picture[channel]) {}

    bool Evaluate(const double* const* parameters, double* residuals, double** jacobians) const override {
        const double linear = Eigen::Map<const Vector3d>(parameters[0]).dot(m_light);
        const double* steps = parameters[1];
        const Place place = placeOf(render::storedValue(linear));
        double value = steps[0];
        for (int i = 1; i <= place.knot; ++i) {
            value += steps[i];
        }
        value += place.share * steps[place.knot + 1];
        residuals[0] = (value - m_wanted) / kSigma;
        if (jacobians != nullptr && jacobians[0] != nullptr) {
            const double slope = steps[place.knot + 1] * (kKnots - 1) * slopeOfStored(linear) / kSigma;
            Eigen::Map<Vector3d> byRow(jacobians[0]);
            byRow = slope * m_light;
        }
        if (jacobians != nullptr && jacobians[1] != nullptr) {
            for (int i = 0; i < kKnots; ++i) {
                jacobians[1][i] = (i <= place.knot ? 1 : i == place.knot + 1 ? place.share : 0) / kSigma;
            }
        }
        return true;
    }

  private:
    Vector3d m_light;
    double m_wanted;
};

/// A row of the matrix is near that of the identity.
class RowPrior : public ceres::SizedCostFunction<3, 3> {
  public:
    RowPrior(int channel, double weight) : m_channel(channel), m_weight(weight) {}

    bool Evaluate(const double* const* parameters, double* residuals, double** jacobians) const override {
        for (int i = 0; i < 3; ++i) {
            residuals[i] = m_weight * (parameters[0][i] - (i == m_channel ? 1 : 0));
        }
        if (jacobians != nullptr && jacobians[0] != nullptr) {
            Eigen::Map<Matrix3d> by(jacobians[0]);
            by = m_weight * Matrix3d::Identity();
        }
        return true;
    }

  private:
    int m_channel;
    double m_weight;
};

/// A curve is near the straight one, and bends little.
class CurvePrior : public ceres::SizedCostFunction<2 * kKnots - 2, kKnots> {
  public:
    CurvePrior(double straight, double bend) {
        for (int knot = 0; knot < kKnots; ++knot) {
            m_by.row(knot).head(knot + 1).setConstant(straight);
            m_at[knot] = -straight * knot / (kKnots - 1.0);
        }
        for (int i = 1; i + 1 < kKnots; ++i) { // the difference of two steps
            m_by(kKnots + i - 1, i) = -bend;
            m_by(kKnots + i - 1, i + 1) = bend;
        }
    }

    bool Evaluate(const double* const* parameters, double* residuals, double** jacobians) const override {
        const Eigen::Map<const Eigen::Matrix<double, kKnots, 1>> steps(parameters[0]);
        Eigen::Map<Rows> values(residuals);
        values = m_by * steps + m_at;
        if (jacobians != nullptr && jacobians[0] != nullptr) {
            Eigen::Map<By> by(jacobians[0]);
            by = m_by;
        }
        return true;
    }

  private:
    using Rows = Eigen::Matrix<double, 2 * kKnots - 2, 1>;
    using By = Eigen::Matrix<double, 2 * kKnots - 2, kKnots, Eigen::RowMajor>;
    By m_by = By::Zero();
    Rows m_at = Rows::Zero();
};

Channel fittedChannel(const std::vector<ColourSample>& samples, int channel) {
    Channel fit;
    fit.row[static_cast<std::size_t>(channel)] = 1;
    std::fill(fit.steps.begin() + 1, fit.steps.end(), 1 / (kKnots - 1.0));
    ceres::Problem problem;
    for (const ColourSample& sample : samples) {
        problem.AddResidualBlock(new SampleCost(sample, channel), new ceres::CauchyLoss(kLoss),
                                 fit.row.data(), fit.steps.data());
    }
    const auto count = static_cast<double>(samples.size());
    const double ofKnots = std::sqrt(count / kKnots);
    problem.AddResidualBlock(new RowPrior(channel, std::sqrt(count) / kMatrixSigma), nullptr, fit.row.data());
    problem.AddResidualBlock(new CurvePrior(ofKnots / kStraightSigma, ofKnots / kBendSigma), nullptr,
                             fit.steps.data());
    for (int i = 1; i < kKnots; ++i) {
        problem.SetParameterLowerBound(fit.steps.data(), i, 0);
    }
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
    options.max_num_iterations = 60;
    options.function_tolerance = 1e-8;
    options.num_threads = 1; // sums in one order give one result
    options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    return fit;
}

ColourCorrection fittedTo(const std::vector<ColourSample>& samples) {
    ColourCorrection correction;
    for (int c = 0; c < 3; ++c) {
        const Channel channel = fittedChannel(samples, c);
        for (int i = 0; i < 3; ++i) {
            correction.matrix(c, i) =
                std::clamp(channel.row[static_cast<std::size_t>(i)], -ColourCorrection::kMostMatrix,
                           ColourCorrection::kMostMatrix);
        }
        double value = 0;
        for (int i = 0; i < kKnots; ++i) {
            value += channel.steps[static_cast<std::size_t>(i)];
            correction.curves[static_cast<std::size_t>(c)][static_cast<std::size_t>(i)] =
                std::clamp(value, -1.0, 2.0);
        }
    }
    return correction;
}

/// What colours there are among some.
struct Palette {
    double hueSpread = 0; ///< standard deviation of light's hue along the direction in which it differs most
    double fromGrey = 0;  ///< of the mean hue
    double shades = 0;    ///< standard deviation of brightness as stored
};

template <class Get>
Palette paletteOf(const std::vector<ColourSample>& samples, const Get& colour) {
    const auto count = static_cast<double>(samples.size());
    Vector3d meanHue = Vector3d::Zero();
    Matrix3d squares = Matrix3d::Zero();
    double mean = 0;
    double square = 0;
    for (const ColourSample& sample : samples) {
        const Vector3d hue = colour(sample).unaryExpr(&render::linearLight).normalized();
        meanHue += hue / count;
        squares += hue * hue.transpose() / count;
        const double shade = colour(sample).mean();
        mean += shade / count;
        square += shade * shade / count;
    }
    const Matrix3d covariance = squares - meanHue * meanHue.transpose();
    Palette palette;
    palette.hueSpread = std::sqrt(
        std::max(0.0, Eigen::SelfAdjointEigenSolver<Matrix3d>(covariance).eigenvalues().maxCoeff()));
    palette.fromGrey = meanHue.normalized().cross(Vector3d::Ones().normalized()).norm();
    palette.shades = std::sqrt(std::max(0.0, square - mean * mean));
    return palette;
}

std::string refusal(const Palette& palette, std::string_view whose) {
    if (palette.hueSpread >= kLeastSpread) {
        return {};
    }
    return palette.fromGrey < kGrey
               ? text("The ", whose,
                      " show only grey: a colour correction cannot be told from them. Take pictures "
                      "of coloured things, with a colour camera.")
               : text("The ", whose,
                      " show only one colour: a colour correction cannot be told from them. Take "
                      "pictures of differently coloured things.");
}

std::string refusal(const ColourSamples& all, const Palette& views, const Palette& pictures) {
    if (all.samples.size() < kFewest) {
        return all.clipped > all.samples.size()
                   ? std::string("The pictures are too dark or too bright: most of what could be compared is "
                                 "as dark or "
                                 "as bright as a picture can be. Take them with another exposure.")
                   : text("Only ", all.samples.size(), " spots could be compared, and at least ", kFewest,
                          " are needed. Take more pictures, of things with even colours, and refine their "
                          "poses.");
    }
    for (const auto& [palette, whose] :
         {std::pair(views, "views"), std::pair(pictures, "robot's pictures")}) {
        if (std::string why = refusal(palette, whose); !why.empty()) {
            return why;
        }
        if (palette.shades < kLeastShade) {
            return text("The ", whose,
                        " are all about as bright: a colour correction cannot be told from them. "
                        "Take pictures of light and dark things.");
        }
    }
    return {};
}

} // namespace

void ColourSamples::add(const ColourSamples& other) {
    samples.insert(samples.end(), other.samples.begin(), other.samples.end());
    clipped += other.clipped;
}

ColourSamples colourSamples(const RgbImage& view, const render::PixelTrust& trust, const RgbImage& picture) {
    const auto fits = [&](const auto& other) {
        return other.width() == view.width() && other.height() == view.height();
    };
    if (!fits(picture) || !fits(trust.errorPx) || !fits(trust.flags)) {
        throw Error(ErrorKind::InvalidInput, "Colours of pictures of different sizes cannot be compared.");
    }
    ColourSamples result;
    for (int y = kAround; y + kSpot + kAround <= view.height(); y += kSpot) {
        for (int x = kAround; x + kSpot + kAround <= view.width(); x += kSpot) {
            if (!isTrusted(trust, x, y)) {
                continue;
            }
            const Spot seen = spotOf(view, x, y);
            const Spot taken = spotOf(picture, x, y);
            if (!seen.isEven || !taken.isEven) {
                continue;
            }
            if (isClipped(seen) || isClipped(taken)) {
                ++result.clipped;
            } else {
                result.samples.push_back({seen.mean / 255, taken.mean / 255});
            }
        }
    }
    return result;
}

std::optional<double> colourError(std::span<const ColourSample> samples) {
    return meanError(samples, [](const Vector3d& view) { return view; });
}

std::optional<double> colourError(std::span<const ColourSample> samples,
                                  const render::ColourCorrection& correction) {
    return meanError(samples, [&](const Vector3d& view) { return correction.corrected(view); });
}

ColourFit fittedColour(const ColourSamples& all) {
    std::vector<ColourSample> samples;
    const std::size_t every = (all.samples.size() + kMost - 1) / kMost;
    for (std::size_t i = 0; i < all.samples.size(); i += every) {
        samples.push_back(all.samples[i]);
    }
    const auto ofView = [](const ColourSample& sample) { return sample.view; };
    const auto ofPicture = [](const ColourSample& sample) { return sample.picture; };
    const Palette views = paletteOf(samples, ofView);
    const Palette pictures = paletteOf(samples, ofPicture);
    ColourFit fit;
    fit.samples = samples.size();
    fit.hueSpread = std::min(views.hueSpread, pictures.hueSpread);
    fit.errorBefore = colourError(samples).value_or(0);
    fit.why = refusal(all, views, pictures);
    if (!fit.why.empty()) {
        return fit;
    }
    const ColourCorrection correction = fittedTo(samples);
    fit.errorAfter = *colourError(samples, correction);
    if (!(fit.errorAfter < fit.errorBefore)) {
        fit.why = text("No correction brings the views' colours nearer to the pictures' than they are (",
                       fixed(fit.errorBefore, 1), " grey levels): none is needed.");
        return fit;
    }
    fit.correction = correction;
    return fit;
}

} // namespace spherewalk::compare

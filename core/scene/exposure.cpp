// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/scene/exposure.h"

#include "spherewalk/base/statistics.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/photo/picture_file.h"
#include "spherewalk/render/colour_correction.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace spherewalk::scene {

namespace {

constexpr int kWidth = 64; ///< Parallax hardly shows at this width.
constexpr int kDarkest = 8;
constexpr int kBrightest = 245;
constexpr std::size_t kFewest = 100;
constexpr double kMostLog = 2.5;          ///< The logarithm of the greatest gain.
constexpr double kPatches = 40;           ///< About so many of the directions tell something of their own.
constexpr double kPatchesOfPlaces = 1000; ///< The same of places whose distance is known.
constexpr double kSigmas = 3;
constexpr int kBright = 120; ///< Few cameras compress darker values.
constexpr std::size_t kFewestOfBin = 30;
constexpr double kMostError = 30; ///< What is farther off is not the same thing.

bool isWithin(int value) {
    return value > kDarkest && value < kBrightest;
}

/// What places tell of a factor.
struct Factor {
    double log = 0;
    double spread = 0; ///< Of the places' logarithms, one standard deviation.
    bool isKnown = false;
};

using Factors = std::array<Factor, 3>; ///< Of red, green and blue.

Factors factorsOf(const std::array<std::vector<double>, 3>& logs) {
    Factors factors;
    for (std::size_t c = 0; c < 3; ++c) {
        if (logs[c].size() >= kFewest) {
            const auto [middle, spread] = medianAndSpread(logs[c]);
            factors[c] = {std::clamp(middle, -kMostLog, kMostLog), spread, true};
        }
    }
    return factors;
}

Gains gainsOf(const Factors& factors, double patches) {
    Gains gains{1, 1, 1};
    for (std::size_t c = 0; c < 3; ++c) {
        const double sigma = factors[c].spread / std::sqrt(patches);
        if (factors[c].isKnown && std::abs(factors[c].log) >= kSigmas * sigma) {
            gains[c] = static_cast<float>(std::exp(factors[c].log));
        }
    }
    return gains;
}

/// How far off a factor is, one standard deviation of its logarithm. Where places differ, most distances are
/// wrong.
double sigmaOf(const Factor& factor) {
    constexpr double kLeast = 0.02;
    constexpr double kGrowth = 8; ///< From a spread of 0.4 on, factors are off by as much as that.
    return kLeast + kGrowth * std::pow(factor.spread, 4);
}

bool areTold(const PosedPicture& photo, const PosedPicture& other) {
    return photo.gains && other.gains;
}

/// What the camera's settings tell. Range: areTold().
Gains toldGains(const PosedPicture& photo, const PosedPicture& other) {
    Gains gains;
    for (std::size_t c = 0; c < 3; ++c) {
        gains[c] = (*other.gains)[c] / (*photo.gains)[c];
    }
    return gains;
}

/// A factor of green by places, and by the camera's settings.
struct ToldFactor {
    Factor byPlaces;
    float told = 1;
};

/// How far off the settings are, one standard deviation of the logarithm: half of the photos are no farther
/// off, by their weight.
double sigmaOfTold(std::span<const ToldFactor> factors) {
    constexpr double kLeast = 0.15; ///< Cameras round what they state, and find the tone by the picture.
    constexpr double kSigmaPerMedian = 1.5;
    std::vector<std::pair<double, double>> errors; // and their weights
    double all = 0;
    for (const auto& [byPlaces, told] : factors) {
        if (byPlaces.isKnown) {
            errors.emplace_back(std::abs(byPlaces.log - std::log(static_cast<double>(told))),
                                1 / (sigmaOf(byPlaces) * sigmaOf(byPlaces)));
            all += errors.back().second;
        }
    }
    std::sort(errors.begin(), errors.end());
    double sum = 0;
    for (const auto& [error, weight] : errors) {
        sum += weight;
        if (2 * sum >= all) {
            return std::max(kLeast, kSigmaPerMedian * error);
        }
    }
    return kLeast;
}

/// The mean of both logarithms, by what they are worth.
Gains meanOf(const Factors& factors, const Gains& told, double toldSigma) {
    Gains gains = told;
    for (std::size_t c = 0; c < 3; ++c) {
        if (factors[c].isKnown) {
            const double share = 1 / (1 + std::pow(sigmaOf(factors[c]) / toldSigma, 2));
            const double log = std::log(static_cast<double>(told[c]));
            gains[c] = static_cast<float>(std::exp(log + share * (factors[c].log - log)));
        }
    }
    return gains;
}

const std::uint8_t* nearest(const RgbImage& picture, const Eigen::Vector3d& way) {
    const EquirectSize size{picture.width(), picture.height()};
    const Eigen::Vector2d at = pixel(size, way);
    return picture.at(static_cast<int>(std::floor(at.x() + 0.5)) % size.width,
                      std::clamp(static_cast<int>(std::floor(at.y() + 0.5)), 0, size.height - 1));
}

/// 1 / distance of what a photo shows in a direction; 0 where it is not sure.
double sureInverse(const PhotoDepth& depth, const Eigen::Vector3d& way) {
    const EquirectSize size{depth.inverseM.width(), depth.inverseM.height()};
    const Eigen::Vector2d at = pixel(size, way);
    const int x = static_cast<int>(std::floor(at.x() + 0.5)) % size.width;
    const int y = std::clamp(static_cast<int>(std::floor(at.y() + 0.5)), 0, size.height - 1);
    return *depth.sure.at(x, y) != 0 ? static_cast<double>(*depth.inverseM.at(x, y)) : 0.0;
}

/// Calls with directions that are spread evenly over the sphere.
template <class Call>
void overSphere(int width, Call&& call) {
    const EquirectSize size{width, width / 2};
    double rows = 0; // As many of each row count as its length on the sphere asks for.
    for (int y = 0; y < size.height; ++y) {
        const double length = std::sin(std::numbers::pi * (y + 0.5) / size.height);
        for (int x = 0; x < size.width; ++x) {
            rows += length;
            if (rows >= 1) {
                rows -= 1;
                call(x, y, direction(size, Eigen::Vector2d(x, y)));
            }
        }
    }
}

void addLogs(const std::uint8_t* a, const std::uint8_t* b, std::array<std::vector<double>, 3>& logs) {
    for (std::size_t c = 0; c < 3; ++c) {
        if (isWithin(a[c]) && isWithin(b[c])) {
            logs[c].push_back(std::log(static_cast<double>(a[c]) / b[c]));
        }
    }
}

/// What two photos show of the same places.
class SharedValues {
  public:
    void add(const std::uint8_t* a, const std::uint8_t* b) {
        addLogs(a, b, m_logs);
        for (std::size_t c = 0; c < 3; ++c) {
            // By both, so that noise makes neither photo brighter.
            if (isWithin(a[c]) && isWithin(b[c]) && a[c] * b[c] < kBright * kBright) {
                m_logsOfDarker[c].push_back(m_logs[c].back());
            }
            m_values[c][b[c] * SharedLight::kBins / 256].push_back(a[c]);
        }
    }

    std::optional<SharedLight> light() {
        SharedLight light;
        for (std::size_t c = 0; c < 3; ++c) {
            std::vector<double>& logs = m_logsOfDarker[c].size() < kFewest ? m_logs[c] : m_logsOfDarker[c];
            if (logs.size() < kFewest) {
                return std::nullopt;
            }
            light.gains[c] =
                static_cast<float>(std::exp(std::clamp(quantileInPlace(logs, 0.5), -kMostLog, kMostLog)));
            for (std::size_t bin = 0; bin < SharedLight::kBins; ++bin) {
                std::vector<float>& values = m_values[c][bin];
                light.values[c][bin] = values.size() < kFewestOfBin ? -1 : quantileInPlace(values, 0.5);
            }
        }
        return light;
    }

  private:
    std::array<std::vector<double>, 3> m_logs;
    std::array<std::vector<double>, 3> m_logsOfDarker;
    std::array<std::array<std::vector<float>, SharedLight::kBins>, 3> m_values;
};

/// What the camera's settings tell in place of what is shared. Range: areTold().
SharedLight toldLight(const PosedPicture& photo, const PosedPicture& other) {
    constexpr double kWeight = 0.05; ///< Of places that are shared.
    SharedLight light{.gains = toldGains(photo, other), .weight = kWeight};
    for (auto& values : light.values) {
        values.fill(-1);
    }
    return light;
}

/// The middle of a bin's values that count.
double middleOf(std::size_t bin) {
    constexpr double kLevels = 256.0 / SharedLight::kBins;
    const double first = kLevels * static_cast<double>(bin);
    return 0.5 * (first + std::min<double>(first + kLevels, kBrightest));
}

/// How far values are apart that are made equally bright, and of how many that is.
struct CurveError {
    double sum = 0;
    int values = 0;

    void add(const SharedLight& light, std::size_t channel, double gain, double rolloff) {
        for (std::size_t bin = 0; bin < SharedLight::kBins; ++bin) {
            const auto shown = static_cast<double>(light.values[channel][bin]);
            const double value = middleOf(bin);
            if (shown >= 0 && std::max(value, shown) > kBright) {
                sum += std::min(std::abs(render::exposedValue(value, gain, rolloff) - shown), kMostError);
                ++values;
            }
        }
    }
};

CurveError errorOf(double rolloff, std::span<const Gains> gains, std::span<const ExposureRatio> ratios) {
    constexpr double kDifferent = 1.1;
    CurveError error;
    for (const ExposureRatio& ratio : ratios) {
        for (std::size_t c = 0; c < 3; ++c) {
            const auto gain = static_cast<double>(gains[ratio.other][c] / gains[ratio.photo][c]);
            if (gain > kDifferent || gain < 1 / kDifferent) {
                error.add(ratio.light, c, gain, rolloff);
            }
        }
    }
    return error;
}

Factors factorsTo(const PosedPicture& photo, const PosedPicture& other) {
    const EquirectSize size{kWidth, kWidth / 2};
    const RgbImage own = photo::resized(photo.atLeast(size.width), size.width, size.height);
    const RgbImage its = photo::resized(other.atLeast(size.width), size.width, size.height);
    const Eigen::Matrix3d otherFromPhoto =
        (other.roomFromPhoto.rotation.conjugate() * photo.roomFromPhoto.rotation).toRotationMatrix();
    std::array<std::vector<double>, 3> logs;
    overSphere(kWidth, [&](int x, int y, const Eigen::Vector3d& way) {
        addLogs(own.at(x, y), nearest(its, otherFromPhoto * way), logs);
    });
    return factorsOf(logs);
}

Factors factorsTo(const PosedPicture& photo, const Image<float, 1>& inverseM, const PosedPicture& other) {
    constexpr EquirectSize kPlaces{128, 64};
    const RgbImage own = photo::resized(photo.atLeast(kPlaces.width), kPlaces.width, kPlaces.height);
    const RgbImage its = photo::resized(other.atLeast(kPlaces.width), kPlaces.width, kPlaces.height);
    const Rigid3 otherFromPhoto = other.roomFromPhoto.inverse() * photo.roomFromPhoto;
    std::array<std::vector<double>, 3> logs;
    overSphere(kPlaces.width, [&](int x, int y, const Eigen::Vector3d& way) {
        const auto inverse =
            static_cast<double>(*inverseM.at((2 * x + 1) * inverseM.width() / 2 / kPlaces.width,
                                             (2 * y + 1) * inverseM.height() / 2 / kPlaces.height));
        const Eigen::Vector3d inOther = otherFromPhoto.rotation * (way + inverse * photo.lenses.place(way)) +
                                        inverse * otherFromPhoto.translation;
        addLogs(own.at(x, y), nearest(its, other.lenses.directionTo(inOther, inverse)), logs);
    });
    return factorsOf(logs);
}

} // namespace

std::vector<std::optional<Gains>> toldGains(std::span<const std::optional<double>> stops) {
    constexpr double kPowerOfLight = 1 / 2.2; // about the curve of sRGB
    constexpr double kSameStops = 0.01;
    std::vector<double> known;
    for (const auto& of : stops) {
        known.insert(known.end(), of ? 1 : 0, of.value_or(0));
    }
    std::vector<std::optional<Gains>> gains(stops.size());
    if (known.empty()) {
        return gains;
    }
    const auto [least, most] = std::minmax_element(known.begin(), known.end());
    for (std::size_t i = 0; i < stops.size() && *most - *least > kSameStops; ++i) {
        if (stops[i]) {
            const double log2 = kPowerOfLight * (0.5 * (*least + *most) - *stops[i]);
            const auto gain = static_cast<float>(std::exp2(std::clamp(log2, -kMostLog, kMostLog)));
            gains[i] = Gains{gain, gain, gain};
        }
    }
    return gains;
}

std::vector<Gains> gainsTo(const PosedPicture& photo, std::span<const PosedPicture> others) {
    std::vector<Gains> gains;
    for (const PosedPicture& other : others) {
        gains.push_back(areTold(photo, other) ? toldGains(photo, other)
                                              : gainsOf(factorsTo(photo, other), kPatches));
    }
    return gains;
}

std::vector<Gains> gainsTo(const PosedPicture& photo, const Image<float, 1>& inverseM,
                           std::span<const PosedPicture> others) {
    std::vector<Factors> factors;
    std::vector<ToldFactor> told;
    for (const PosedPicture& other : others) {
        factors.push_back(factorsTo(photo, inverseM, other));
        if (areTold(photo, other)) {
            told.push_back({factors.back()[1], toldGains(photo, other)[1]});
        }
    }
    const double sigma = sigmaOfTold(told);
    std::vector<Gains> gains;
    for (std::size_t i = 0; i < others.size(); ++i) {
        gains.push_back(areTold(photo, others[i]) ? meanOf(factors[i], toldGains(photo, others[i]), sigma)
                                                  : gainsOf(factors[i], kPatchesOfPlaces));
    }
    return gains;
}

std::optional<SharedLight> sharedLight(const KnownPhoto& photo, const KnownPhoto& other) {
    constexpr int kPlaces = 128; // in a row
    constexpr double kAlike = 0.04;
    const Rigid3 otherFromPhoto = other.photo.roomFromPhoto.inverse() * photo.photo.roomFromPhoto;
    SharedValues shared;
    overSphere(kPlaces, [&](int, int, const Eigen::Vector3d& way) {
        const double inverse = sureInverse(*photo.depth, way);
        const Eigen::Vector3d inOther =
            otherFromPhoto.rotation * (way + inverse * photo.photo.lenses.place(way)) +
            inverse * otherFromPhoto.translation;
        const Eigen::Vector3d seen = other.photo.lenses.directionTo(inOther, inverse);
        const double its = sureInverse(*other.depth, seen);
        // The other photo looks at the same place, and not at something before it.
        const double expected = inverse / seen.norm();
        if (inverse > 0 && its > 0 && std::abs(its - expected) < kAlike * std::max(its, expected)) {
            shared.add(nearest(*photo.photo.picture, way), nearest(*other.photo.picture, seen));
        }
    });
    const std::optional<SharedLight> light = shared.light();
    return light || !areTold(photo.photo, other.photo) ? light : toldLight(photo.photo, other.photo);
}

std::vector<Gains> commonGains(std::size_t photos, std::span<const ExposureRatio> ratios) {
    const auto count = static_cast<Eigen::Index>(photos);
    std::vector<Eigen::Triplet<double>> entries;
    for (Eigen::Index i = 0; i < count; ++i) {
        entries.emplace_back(i, i, 1e-9); // each part's mean is 0, and so is what no ratio tells
    }
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(count, 3);
    for (const ExposureRatio& ratio : ratios) {
        const auto a = static_cast<Eigen::Index>(ratio.photo);
        const auto b = static_cast<Eigen::Index>(ratio.other);
        const double weight = ratio.light.weight;
        entries.emplace_back(a, a, weight);
        entries.emplace_back(b, b, weight);
        entries.emplace_back(a, b, -weight);
        entries.emplace_back(b, a, -weight);
        for (std::size_t c = 0; c < 3; ++c) {
            const double log = weight * std::log(ratio.light.gains[c]); // gain of b less gain of a
            right(a, static_cast<Eigen::Index>(c)) -= log;
            right(b, static_cast<Eigen::Index>(c)) += log;
        }
    }
    Eigen::SparseMatrix<double> normal(count, count);
    normal.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(normal);
    std::vector<Gains> gains(photos);
    for (std::size_t c = 0; c < 3; ++c) {
        const Eigen::VectorXd logs = solver.solve(right.col(static_cast<Eigen::Index>(c)));
        for (std::size_t i = 0; i < photos; ++i) {
            gains[i][c] = static_cast<float>(
                std::exp(std::clamp(logs[static_cast<Eigen::Index>(i)], -kMostLog, kMostLog)));
        }
    }
    return gains;
}

double highlightRolloff(std::span<const Gains> gains, std::span<const ExposureRatio> ratios) {
    constexpr int kSteps = 50;
    constexpr double kMost = 0.5;
    constexpr int kFewestValues = 30;
    constexpr double kBetter = 0.9;
    const CurveError cut = errorOf(0, gains, ratios);
    double rolloff = 0;
    double least = kBetter * cut.sum;
    for (int step = 1; step <= kSteps && cut.values >= kFewestValues; ++step) {
        const double tried = kMost * step / kSteps;
        const double error = errorOf(tried, gains, ratios).sum;
        if (error < least) {
            least = error;
            rolloff = tried;
        }
    }
    return rolloff;
}

} // namespace spherewalk::scene

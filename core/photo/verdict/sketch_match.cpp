// SPDX-License-Identifier: GPL-3.0-or-later
#include "verdict/sketch_match.h"

#include "picture/opencv_picture.h"

#include "spherewalk/base/statistics.h"
#include "spherewalk/geometry/equirect.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

namespace spherewalk::photo {

namespace {

constexpr int kReliefTop = kSketchHeight / 6; ///< 60 degrees above the horizon
constexpr int kReliefEnd = kSketchHeight - kReliefTop;
constexpr int kReliefRows = kReliefEnd - kReliefTop;

/// Brightness between 60 degrees above and below the horizon without each row's mean, weighted by the area
/// that a pixel covers, and scaled so that a correlation with itself is 1.
class Relief {
  public:
    explicit Relief(const Sketch& sketch) : m_values(std::size_t{kReliefRows} * kSketchWidth) {
        double sum = 0;
        for (int v = 0; v < kReliefRows; ++v) {
            float* row = at(v);
            double mean = 0;
            for (int u = 0; u < kSketchWidth; ++u) {
                const std::uint8_t* p = sketch.picture.at(u, v + kReliefTop);
                row[u] = brightness(p);
                mean += row[u] / kSketchWidth;
            }
            const double elevation =
                std::numbers::pi / 2 - std::numbers::pi * (v + kReliefTop + 0.5) / kSketchHeight;
            for (int u = 0; u < kSketchWidth; ++u) {
                row[u] = static_cast<float>((row[u] - mean) * std::sqrt(std::cos(elevation)));
                sum += double{row[u]} * row[u];
            }
        }
        const auto scale = static_cast<float>(sum > 0 ? 1 / std::sqrt(sum) : 0);
        for (float& value : m_values) {
            value *= scale;
        }
    }

    void turnUpsideDown() { std::reverse(m_values.begin(), m_values.end()); }

    float* at(int row) { return m_values.data() + std::ptrdiff_t{row} * kSketchWidth; }

    const float* at(int row) const { return m_values.data() + std::ptrdiff_t{row} * kSketchWidth; }

    /// With the other one's columns that lie so far to the right.
    double correlation(const Relief& other, int shift) const {
        double sum = 0;
        for (int v = 0; v < kReliefRows; ++v) {
            sum += product(at(v), other.at(v) + shift, kSketchWidth - shift);
            sum += product(at(v) + (kSketchWidth - shift), other.at(v), shift);
        }
        return sum;
    }

  private:
    static float product(const float* a, const float* b, int count) {
        constexpr int kLanes = 8; // independent sums, so that they are made side by side
        std::array<float, kLanes> sums{};
        int i = 0;
        for (; i + kLanes <= count; i += kLanes) {
            for (int lane = 0; lane < kLanes; ++lane) {
                sums[static_cast<std::size_t>(lane)] += a[i + lane] * b[i + lane];
            }
        }
        float sum = 0;
        for (; i < count; ++i) {
            sum += a[i] * b[i];
        }
        for (const float lane : sums) {
            sum += lane;
        }
        return sum;
    }

    std::vector<float> m_values;
};

struct BestShift {
    int shift = 0;
    double likeness = -1;
};

std::vector<double> likenesses(const Relief& photo, const Relief& other) {
    std::vector<double> all(kSketchWidth);
    for (int shift = 0; shift < kSketchWidth; ++shift) {
        all[static_cast<std::size_t>(shift)] = photo.correlation(other, shift);
    }
    return all;
}

BestShift bestOf(const std::vector<double>& all) {
    const auto best = std::max_element(all.begin(), all.end());
    return {static_cast<int>(best - all.begin()), *best};
}

BestShift bestShift(const Relief& photo, const Relief& other) {
    return bestOf(likenesses(photo, other));
}

Radians turnOfShift(int shift) {
    const double turn = -2 * std::numbers::pi * shift / kSketchWidth;
    return Radians(turn <= -std::numbers::pi ? turn + 2 * std::numbers::pi : turn);
}

std::array<double, 3> gains(const RgbImage& photo, const RgbImage& other, int shift) {
    constexpr int kDark = 12;
    constexpr int kBright = 243;
    std::array<std::vector<float>, 3> ratios;
    for (int v = kReliefTop; v < kReliefEnd; ++v) {
        for (int u = 0; u < kSketchWidth; ++u) {
            const std::uint8_t* p = photo.at(u, v);
            const std::uint8_t* q = other.at((u + shift) % kSketchWidth, v);
            for (std::size_t c = 0; c < 3; ++c) {
                if (std::min(p[c], q[c]) >= kDark && std::max(p[c], q[c]) <= kBright) {
                    ratios[c].push_back(static_cast<float>(p[c]) / q[c]);
                }
            }
        }
    }
    std::array<double, 3> result{1, 1, 1};
    for (std::size_t c = 0; c < 3; ++c) {
        if (!ratios[c].empty()) {
            result[c] = median(std::move(ratios[c]));
        }
    }
    return result;
}

constexpr double kNearestM = 0.4; ///< Things farther from the camera must look alike in both photos.
constexpr int kMostShift = 24;
constexpr int kPatch = 5;
constexpr int kStride = 2; ///< Step of the search; the sketches are softened as much.
constexpr int kSearchTop = kSketchHeight * 20 / 180;   ///< 70 degrees above the horizon
constexpr int kSearchRows = kSketchHeight * 115 / 180; ///< down to 45 degrees below it: then comes the cart
constexpr double kForeign = 14; ///< mean difference of a patch's strongest channel, grey levels
constexpr double kOfActivity = 0.6;

using Planes = std::array<cv::Mat, 3>;

Planes planesOf(const cv::Mat& picture) {
    Planes planes;
    cv::split(picture, planes.data());
    return planes;
}

/// The neighbour in the photo's turn and colours.
cv::Mat alike(const MatchedSketch& neighbour) {
    const RgbImage& picture = neighbour.sketch->picture;
    const int shift = static_cast<int>(
        std::lround(-neighbour.match.turn.value() / (2 * std::numbers::pi) * kSketchWidth + kSketchWidth));
    cv::Mat result(kSketchHeight, kSketchWidth, CV_8UC3);
    for (int v = 0; v < kSketchHeight; ++v) {
        for (int u = 0; u < kSketchWidth; ++u) {
            const std::uint8_t* p = picture.at((u + shift) % kSketchWidth, v);
            auto& q = result.at<cv::Vec3b>(v, u);
            for (int c = 0; c < 3; ++c) {
                q[c] = cv::saturate_cast<std::uint8_t>(p[c] *
                                                       neighbour.match.gains[static_cast<std::size_t>(c)]);
            }
        }
    }
    return result;
}

/// How far parallax may move things, in columns.
int reach(double distanceM) {
    const double columns = std::atan2(distanceM, kNearestM) / (2 * std::numbers::pi) * kSketchWidth;
    return std::clamp(static_cast<int>(std::ceil(columns)) + 1, 3, kMostShift);
}

/// Keeps in `least` how well each patch is found in the neighbour, anywhere within the reach.
void compare(const Planes& photo, const MatchedSketch& neighbour, cv::Mat& least) {
    const int across = reach(neighbour.distanceM);
    const int along = across / 2 + 1;
    cv::Mat wide;
    cv::blur(alike(neighbour), wide, {3, 3});
    cv::copyMakeBorder(wide, wide, 0, 0, across, across, cv::BORDER_WRAP);
    cv::copyMakeBorder(wide, wide, along, along, 0, 0, cv::BORDER_REPLICATE);
    const Planes other = planesOf(wide);
    cv::Mat difference;
    cv::Mat channel;
    for (int y = 0; y <= 2 * along; y += kStride) {
        for (int x = 0; x <= 2 * across; x += kStride) {
            const cv::Rect part(x, y + kSearchTop, kSketchWidth, kSearchRows);
            cv::absdiff(photo[0], other[0](part), difference);
            for (std::size_t c = 1; c < 3; ++c) {
                cv::absdiff(photo[c], other[c](part), channel);
                cv::max(difference, channel, difference);
            }
            cv::blur(difference, channel, {kPatch, kPatch});
            cv::min(least, channel, least);
        }
    }
}

/// How much a patch varies by itself: what is full of detail never fits to the last grey level.
cv::Mat activity(const Planes& photo) {
    cv::Mat most(kSearchRows, kSketchWidth, CV_8U, cv::Scalar(0));
    cv::Mat mean;
    cv::Mat detail;
    for (const cv::Mat& plane : photo) {
        cv::blur(plane, mean, {kPatch, kPatch});
        cv::absdiff(plane, mean, detail);
        cv::blur(detail, detail, {kPatch, kPatch});
        cv::max(most, detail, most);
    }
    return most;
}

/// Connected areas, those across the seam too. Shape: kSearchRows x kSketchWidth.
ForeignArea largestArea(const cv::Mat& mask) {
    cv::Mat twice;
    cv::hconcat(mask, mask, twice);
    cv::Mat labels;
    const int count = cv::connectedComponents(twice, labels, 8);

    struct Sum {
        double area = 0;
        double u = 0;
        double v = 0;
        int left = 2 * kSketchWidth;
        int right = 0;
    };

    std::vector<Sum> sums(static_cast<std::size_t>(count));
    for (int v = 0; v < labels.rows; ++v) {
        const double weight =
            std::cos(std::numbers::pi / 2 - std::numbers::pi * (v + kSearchTop + 0.5) / kSketchHeight);
        for (int u = 0; u < labels.cols; ++u) {
            Sum& sum = sums[static_cast<std::size_t>(labels.at<int>(v, u))];
            sum.area += weight;
            sum.u += weight * u;
            sum.v += weight * v;
            sum.left = std::min(sum.left, u);
            sum.right = std::max(sum.right, u);
        }
    }
    const double sphere =
        2.0 * kSketchWidth * kSketchHeight / std::numbers::pi; // what the weights of a picture add up to
    ForeignArea result;
    for (std::size_t label = 1; label < sums.size(); ++label) {
        const Sum& sum = sums[label];
        const double part =
            std::min(sum.right - sum.left >= kSketchWidth ? sum.area / 2 : sum.area, sphere) / sphere;
        if (part > result.part) {
            const EquirectSize size{kSketchWidth, kSketchHeight};
            const SphericalDirection middle =
                sphericalDirection(direction(size, Eigen::Vector2d(std::fmod(sum.u / sum.area, kSketchWidth),
                                                                   sum.v / sum.area + kSearchTop)));
            result = {part, middle.azimuth, middle.elevation};
        }
    }
    return result;
}

} // namespace

SketchMatch match(const Sketch& photo, const Sketch& other) {
    Relief own(photo);
    const Relief theirs(other);
    SketchMatch result;
    const BestShift upright = bestShift(own, theirs);
    result.likeness = upright.likeness;
    result.turn = turnOfShift(upright.shift);
    result.gains = gains(photo.picture, other.picture, upright.shift);
    own.turnUpsideDown();
    result.upsideDownLikeness = bestShift(own, theirs).likeness;
    return result;
}

std::optional<Radians> turnBetween(const Sketch& photo, const Sketch& other) {
    constexpr double kLeastAlike = 0.35;
    constexpr int kNear = kSketchWidth / 12; // so far around the best turn, others are about as good
    constexpr double kClearly = 0.12;
    std::vector<double> all = likenesses(Relief(photo), Relief(other));
    const BestShift best = bestOf(all);
    for (int by = -kNear; by <= kNear; ++by) {
        all[static_cast<std::size_t>((best.shift + by + kSketchWidth) % kSketchWidth)] = -1;
    }
    const bool isClear = best.likeness >= kLeastAlike && bestOf(all).likeness < best.likeness - kClearly;
    return isClear ? std::optional(turnOfShift(best.shift)) : std::nullopt;
}

double stopsBrighter(const SketchMatch& match) {
    constexpr double kStopsPerOctave = 2.2; // pictures store about the 2.2th root of light
    return kStopsPerOctave * std::log2((match.gains[0] + match.gains[1] + match.gains[2]) / 3);
}

double unexplainedStops(const Sketch& photo, const MatchedSketch& neighbour) {
    const double stops = stopsBrighter(neighbour.match);
    if (!photo.exposureStops || !neighbour.sketch->exposureStops) {
        return stops;
    }
    const double exposed = *photo.exposureStops - *neighbour.sketch->exposureStops;
    return stops > 0 ? stops - std::clamp(exposed, 0.0, stops) : stops - std::clamp(exposed, stops, 0.0);
}

Others matched(const Sketch& photo, std::span<const Neighbour> neighbours) {
    std::vector<const Neighbour*> nearest;
    std::ranges::transform(neighbours, std::back_inserter(nearest),
                           [](const Neighbour& one) { return &one; });
    std::ranges::stable_sort(nearest, {}, &Neighbour::distanceM);
    const auto matchedWith = [&photo](const Neighbour* one) {
        return MatchedSketch{one->sketch, match(photo, *one->sketch), one->distanceM, one->name};
    };
    const auto isFar = [](const Neighbour* one) { return one->distanceM > kNeighbourhoodM; };
    const auto near = std::min(std::ranges::find_if(nearest, isFar) - nearest.begin(),
                               static_cast<std::ptrdiff_t>(kMostNeighbours));
    Others result;
    std::ranges::transform(std::span(nearest).first(static_cast<std::size_t>(near)),
                           std::back_inserter(result.near), matchedWith);
    nearest.erase(nearest.begin(), nearest.begin() + near);
    nearest.resize(std::min(nearest.size(), kMostAround));
    result.around = [=, known = std::make_shared<std::vector<MatchedSketch>>()] {
        if (known->empty()) {
            std::ranges::transform(nearest, std::back_inserter(*known), matchedWith);
        }
        return *known;
    };
    return result;
}

StandsApart standsApart(const Others& others, double limit,
                        const std::function<double(const MatchedSketch&)>& difference) {
    std::vector<double> near;
    std::ranges::transform(others.near, std::back_inserter(near), difference);
    StandsApart result;
    for (const int sign : {1, -1}) {
        const auto differs = [&](double value) { return sign * value >= limit / 2; };
        std::vector<double> differing;
        std::ranges::copy_if(near, std::back_inserter(differing), differs);
        if (2 * differing.size() > near.size() && std::abs(median(differing)) >= limit) {
            result.by = median(differing);
            result.other = static_cast<std::size_t>(std::ranges::find_if(near, differs) - near.begin());
        }
    }
    if (result.by == 0) {
        return {};
    }
    std::vector<double> all = near;
    std::ranges::transform(others.around(), std::back_inserter(all), difference);
    const double half = std::abs(result.by) / 2;
    const auto alike = std::ranges::count_if(all, [&](double one) { return std::abs(one) < half; });
    const auto differing =
        std::ranges::count_if(all, [&](double one) { return one * result.by > 0 && std::abs(one) >= half; });
    const bool isRare = 4 * alike <= std::ssize(all);
    if (differing <= alike || (alike > 1 && !isRare)) {
        return {};
    }
    result.isCertain = isRare && differing > alike + 1;
    return result;
}

ForeignArea foreignArea(const Sketch& photo, std::span<const MatchedSketch> neighbours) {
    if (neighbours.empty()) {
        return {};
    }
    return translated("compare a photo with its neighbours", [&] {
        cv::Mat soft;
        cv::blur(matOver(photo.picture), soft, {3, 3});
        const Planes own = planesOf(soft.rowRange(kSearchTop, kSearchTop + kSearchRows));
        cv::Mat least(kSearchRows, kSketchWidth, CV_8U, cv::Scalar(255));
        for (const MatchedSketch& neighbour : neighbours) {
            compare(own, neighbour, least);
        }
        cv::Mat limit;
        activity(own).convertTo(limit, CV_8U, kOfActivity, kForeign);
        return largestArea(least > limit);
    });
}

} // namespace spherewalk::photo

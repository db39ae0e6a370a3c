// SPDX-License-Identifier: GPL-3.0-or-later
#include "pairs/nearest.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <numeric>

namespace spherewalk::align {

namespace {

constexpr int kSiftBytes = 128;

/// The sum of the differences. It serves as well as their squares and takes one instruction for 16 of them.
int differenceSum(const std::uint8_t* a, const std::uint8_t* b) {
    int sum = 0;
    for (int i = 0; i < kSiftBytes; ++i) {
        sum += std::abs(a[i] - b[i]);
    }
    return sum;
}

/// Number of bits that differ.
int differingBits(const std::uint8_t* a, const std::uint8_t* b, int bytes) {
    int count = 0;
    for (int i = 0; i < bytes; i += 8) {
        std::uint64_t ofA = 0;
        std::uint64_t ofB = 0;
        std::memcpy(&ofA, a + i, 8);
        std::memcpy(&ofB, b + i, 8);
        count += std::popcount(ofA ^ ofB);
    }
    return count;
}

/// The nearest thing seen so far of one thing, each by those of its features that are most alike.
struct Nearest {
    int best = std::numeric_limits<int>::max();
    int second = std::numeric_limits<int>::max(); ///< That of another thing.
    int thing = -1;
    int own = -1;   ///< The feature of this thing.
    int other = -1; ///< That of the nearest.

    void see(int distance, int itsThing, int ofThis, int ofOther) {
        if (distance < best) {
            second = itsThing == thing ? second : best;
            best = distance;
            thing = itsThing;
            own = ofThis;
            other = ofOther;
        } else if (distance < second && itsThing != thing) {
            second = distance;
        }
    }

    bool isClear(double ratio) const { return thing >= 0 && best < ratio * second; }
};

/// b's features sorted by height in a's frame, so that the features near a bearing lie in one run.
class ByHeight {
  public:
    ByHeight(const Features& b, int count, const Eigen::Quaterniond& aFromB)
        : m_order(static_cast<std::size_t>(count)), m_cosines(static_cast<std::size_t>(count)) {
        std::vector<Eigen::Vector3f> turned;
        const Eigen::Matrix3f rotation = aFromB.toRotationMatrix().cast<float>();
        for (int i = 0; i < count; ++i) {
            turned.emplace_back(rotation * b.bearings[static_cast<std::size_t>(i)]);
        }
        std::iota(m_order.begin(), m_order.end(), 0);
        std::stable_sort(m_order.begin(), m_order.end(), [&](int i, int j) {
            return turned[static_cast<std::size_t>(i)].z() < turned[static_cast<std::size_t>(j)].z();
        });
        for (const int i : m_order) {
            m_x.push_back(turned[static_cast<std::size_t>(i)].x());
            m_y.push_back(turned[static_cast<std::size_t>(i)].y());
            m_z.push_back(turned[static_cast<std::size_t>(i)].z());
        }
    }

    /// Calls take(feature of b) for all features within reach.
    template <class Take>
    void near(const Eigen::Vector3f& bearing, double reachRad, const Take& take) {
        const double height = std::asin(std::clamp(static_cast<double>(bearing.z()), -1.0, 1.0));
        const double quarter = std::asin(1.0);
        const auto lowest = static_cast<float>(std::sin(std::max(height - reachRad, -quarter)) - 1e-6);
        const auto highest = static_cast<float>(std::sin(std::min(height + reachRad, quarter)) + 1e-6);
        const auto least = static_cast<float>(std::cos(reachRad));
        const auto begin = std::lower_bound(m_z.begin(), m_z.end(), lowest) - m_z.begin();
        const auto end = std::upper_bound(m_z.begin(), m_z.end(), highest) - m_z.begin();
        const auto count = static_cast<std::size_t>(end - begin);
        const float* x = m_x.data() + begin;
        const float* y = m_y.data() + begin;
        const float* z = m_z.data() + begin;
        float* cosines = m_cosines.data();
        const float ofX = bearing.x();
        const float ofY = bearing.y();
        const float ofZ = bearing.z();
        for (std::size_t i = 0; i < count; ++i) { // A loop by itself does several at a time.
            cosines[i] = x[i] * ofX + y[i] * ofY + z[i] * ofZ;
        }
        for (std::size_t i = 0; i < count; ++i) {
            if (cosines[i] >= least) {
                take(m_order[static_cast<std::size_t>(begin) + i]);
            }
        }
    }

  private:
    std::vector<int> m_order;
    std::vector<float> m_x, m_y, m_z;
    std::vector<float> m_cosines; ///< Memory for one run.
};

template <class Distance>
std::vector<std::pair<int, int>> search(const Features& a, const Features& b, const Search& how,
                                        double ratioOfDistances, const Distance& distance) {
    const int countA = std::min(a.count(), how.most);
    const int countB = std::min(b.count(), how.most);
    std::vector<Nearest> ofA(static_cast<std::size_t>(countA));
    std::vector<Nearest> ofB(static_cast<std::size_t>(countB));
    const auto compare = [&](int i, int j) {
        const int apart = distance(a.descriptor(i), b.descriptor(j));
        ofA[static_cast<std::size_t>(a.thing(i))].see(apart, b.thing(j), i, j);
        ofB[static_cast<std::size_t>(b.thing(j))].see(apart, a.thing(i), j, i);
    };
    if (how.aFromB) {
        ByHeight byHeight(b, countB, *how.aFromB);
        for (int i = 0; i < countA; ++i) {
            byHeight.near(a.bearings[static_cast<std::size_t>(i)], how.reachRad,
                          [&](int j) { compare(i, j); });
        }
    } else {
        for (int i = 0; i < countA; ++i) {
            for (int j = 0; j < countB; ++j) {
                compare(i, j);
            }
        }
    }
    std::vector<std::pair<int, int>> pairs;
    for (int i = 0; i < countA; ++i) {
        const Nearest& nearest = ofA[static_cast<std::size_t>(i)];
        if (nearest.isClear(ratioOfDistances)) {
            const Nearest& back = ofB[static_cast<std::size_t>(nearest.thing)];
            if (back.thing == i && back.isClear(ratioOfDistances)) {
                pairs.emplace_back(nearest.own, nearest.other);
            }
        }
    }
    return pairs;
}

} // namespace

std::vector<std::pair<int, int>> mutualNearest(const Features& a, const Features& b, const Search& how) {
    if (a.descriptorBytes == kSiftBytes) {
        return search(a, b, how, how.mostRatio, differenceSum);
    }
    const int bytes = a.descriptorBytes;
    return search(a, b, how, how.mostRatio, [bytes](const std::uint8_t* x, const std::uint8_t* y) {
        return differingBits(x, y, bytes);
    });
}

} // namespace spherewalk::align

// SPDX-License-Identifier: Apache-2.0
// What simulators take of a light probe: harmonics, a dominant light, and lights from afar.
#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/render/light_probe.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace spherewalk::render {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kMostLights = 65536;
/// What the cosine of a matt surface makes of each order. Source: Ramamoorthi and Hanrahan, equation 8.
constexpr std::array<double, 9> kMatt{kPi,     2 * kPi / 3, 2 * kPi / 3, 2 * kPi / 3, kPi / 4,
                                      kPi / 4, kPi / 4,     kPi / 4,     kPi / 4};

std::array<double, 9> harmonicsAt(const Vector3d& d) {
    const double zeroth = std::sqrt(1 / (4 * kPi));
    const double first = std::sqrt(3 / (4 * kPi));
    const double second = std::sqrt(15 / (4 * kPi));
    return {zeroth,
            first * d.y(),
            first * d.z(),
            first * d.x(),
            second * d.x() * d.y(),
            second * d.y() * d.z(),
            second * std::sqrt(1.0 / 12) * (3 * d.z() * d.z() - 1),
            second * d.x() * d.z(),
            second / 2 * (d.x() * d.x() - d.y() * d.y())};
}

/// Source: ITU-R BT.709.
double luminance(const Vector3d& rgb) {
    return rgb.dot(Vector3d(0.2126, 0.7152, 0.0722));
}

Vector3d colourAt(const RadianceImage& picture, int u, int v) {
    const float* rgb = picture.at(u, v);
    return {rgb[0], rgb[1], rgb[2]};
}

/// The solid angle of each pixel of a row.
double solidAngle(const EquirectSize& size, int v) {
    const double upper = kPi * (0.5 - static_cast<double>(v) / size.height);
    return 2 * kPi / size.width * (std::sin(upper) - std::sin(upper - kPi / size.height));
}

/// A rectangle of pixels, its ends exclusive.
struct Region {
    int left;
    int top;
    int right;
    int bottom;
    double luminance;
};

/// The sums of luminance over rectangles that begin at the first pixel.
class Sums {
  public:
    explicit Sums(const RadianceImage& picture)
        : m_columns(picture.width() + 1),
          m_values(static_cast<std::size_t>(m_columns) * static_cast<std::size_t>(picture.height() + 1)) {
        const EquirectSize size{picture.width(), picture.height()};
        for (int v = 0; v < size.height; ++v) {
            double row = 0;
            for (int u = 0; u < size.width; ++u) {
                row += solidAngle(size, v) * std::max(0.0, luminance(colourAt(picture, u, v)));
                at(u + 1, v + 1) = at(u + 1, v) + row;
            }
        }
    }

    double of(int left, int top, int right, int bottom) {
        return at(right, bottom) - at(left, bottom) - at(right, top) + at(left, top);
    }

  private:
    double& at(int u, int v) {
        return m_values[static_cast<std::size_t>(v) * static_cast<std::size_t>(m_columns) +
                        static_cast<std::size_t>(u)];
    }

    int m_columns;
    std::vector<double> m_values;
};

/// Cuts a region across its longer side into two of about equal luminance. Range: more than one pixel.
std::pair<Region, Region> cut(const Region& region, const EquirectSize& size, Sums& sums) {
    const double middle = kPi * (0.5 - 0.5 * (region.top + region.bottom) / size.height);
    const int columns = region.right - region.left;
    const int rows = region.bottom - region.top;
    const bool isWide = rows < 2 || (columns > 1 && columns * std::cos(middle) >= rows);
    std::pair<Region, Region> best{region, region};
    double least = std::numeric_limits<double>::infinity();
    for (int i = 1; i < (isWide ? columns : rows); ++i) {
        Region first = region;
        Region second = region;
        (isWide ? first.right : first.bottom) = (isWide ? second.left : second.top) =
            (isWide ? region.left : region.top) + i;
        first.luminance = sums.of(first.left, first.top, first.right, first.bottom);
        second.luminance = sums.of(second.left, second.top, second.right, second.bottom);
        if (std::abs(first.luminance - second.luminance) < least) {
            least = std::abs(first.luminance - second.luminance);
            best = {first, second};
        }
    }
    return best;
}

DirectionalLight lightOf(const Region& region, const RadianceImage& picture) {
    const EquirectSize size{picture.width(), picture.height()};
    DirectionalLight light;
    Vector3d sum = Vector3d::Zero();
    for (int v = region.top; v < region.bottom; ++v) {
        for (int u = region.left; u < region.right; ++u) {
            const Vector3d part = solidAngle(size, v) * colourAt(picture, u, v);
            light.irradiance += part;
            sum += luminance(part) * direction(size, Vector2d(u, v));
        }
    }
    light.towards = sum.norm() > 0 ? Vector3d(sum.normalized()) : Vector3d::UnitZ();
    return light;
}

} // namespace

Vector3d LightHarmonics::irradiance(const Vector3d& normal) const {
    const std::array<double, 9> at = harmonicsAt(normal);
    Vector3d sum = Vector3d::Zero();
    for (std::size_t i = 0; i < at.size(); ++i) {
        sum += kMatt[i] * at[i] * coefficients[i];
    }
    return sum;
}

LightHarmonics lightHarmonics(const RadianceImage& radiance) {
    const EquirectSize size{radiance.width(), radiance.height()};
    LightHarmonics result;
    result.coefficients.fill(Vector3d::Zero());
    for (int v = 0; v < size.height; ++v) {
        const double angle = solidAngle(size, v);
        for (int u = 0; u < size.width; ++u) {
            const Vector3d light = angle * colourAt(radiance, u, v);
            const std::array<double, 9> at = harmonicsAt(direction(size, Vector2d(u, v)));
            for (std::size_t i = 0; i < at.size(); ++i) {
                result.coefficients[i] += at[i] * light;
            }
        }
    }
    return result;
}

DominantLight dominantLight(const LightHarmonics& harmonics) {
    constexpr double kEven = 1e-3; // of all light: no direction
    const auto& all = harmonics.coefficients;
    DominantLight light;
    const double zeroth = std::sqrt(1 / (4 * kPi));
    const Vector3d mean(luminance(all[3]), luminance(all[1]), luminance(all[2]));
    const double total = luminance(all[0]) / zeroth;
    light.ambient = (all[0] * zeroth).cwiseMax(0);
    if (!(mean.norm() / std::sqrt(3 / (4 * kPi)) > kEven * total)) {
        return light;
    }
    light.towards = mean.normalized();
    const std::array<double, 9> at = harmonicsAt(light.towards);
    Vector3d above = Vector3d::Zero();
    double below = 0;
    for (std::size_t i = 1; i < at.size(); ++i) {
        above += kMatt[i] * kMatt[i] * at[i] * all[i];
        below += kMatt[i] * kMatt[i] * at[i] * at[i];
    }
    light.irradiance = (above / below).cwiseMax(0);
    light.ambient = (zeroth * (all[0] - zeroth * light.irradiance)).cwiseMax(0);
    const double own = luminance(light.irradiance);
    light.share = own > 0 ? own / (own + kPi * luminance(light.ambient)) : 0;
    return light;
}

std::vector<DirectionalLight> directionalLights(const RadianceImage& radiance, int count) {
    if (count < 1 || count > kMostLights) {
        throw Error(ErrorKind::InvalidInput,
                    text("Light cannot become ", count, " lights; give 1 to ", kMostLights, "."));
    }
    const EquirectSize size{radiance.width(), radiance.height()};
    Sums sums(radiance);
    const auto isDarker = [](const Region& a, const Region& b) { return a.luminance < b.luminance; };
    std::vector<Region> heap;
    std::vector<Region> whole; // of one pixel
    heap.push_back({0, 0, size.width, size.height, sums.of(0, 0, size.width, size.height)});
    while (!heap.empty() && heap.size() + whole.size() < static_cast<std::size_t>(count)) {
        std::pop_heap(heap.begin(), heap.end(), isDarker);
        const Region region = heap.back();
        heap.pop_back();
        if (region.right - region.left < 2 && region.bottom - region.top < 2) {
            whole.push_back(region);
            continue;
        }
        const auto [first, second] = cut(region, size, sums);
        for (const Region& part : {first, second}) {
            heap.push_back(part);
            std::push_heap(heap.begin(), heap.end(), isDarker);
        }
    }
    heap.insert(heap.end(), whole.begin(), whole.end());
    std::vector<DirectionalLight> lights;
    for (const Region& region : heap) {
        const DirectionalLight light = lightOf(region, radiance);
        if (luminance(light.irradiance) > 0) {
            lights.push_back(light);
        }
    }
    return lights;
}

float lightLeft(std::span<const DirectionalLight> lights, const Vector3d& normal,
                const std::function<bool(const Vector3d& towards)>& isHidden) {
    double all = 0;
    double left = 0;
    for (const DirectionalLight& light : lights) {
        const double own = luminance(light.irradiance) * std::max(0.0, normal.dot(light.towards));
        all += own;
        left += own > 0 && !isHidden(light.towards) ? own : 0;
    }
    return all > 0 ? static_cast<float>(std::clamp(left / all, 0.0, 1.0)) : 1.0F;
}

} // namespace spherewalk::render

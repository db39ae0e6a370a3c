// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/render/sensor.h"

#include "sensor/effects.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/render/colour_correction.h"
#include "spherewalk/render/pixel_rays.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace spherewalk::render {

namespace {

constexpr int kRowsAtATime = 16; ///< Rows that a worker takes.
constexpr int kEntryBits = 14;   ///< The tone curve has so many bits of light.
constexpr int kMeteredPixel = 4; ///< Every so many pixels are metered along each axis.
constexpr double kResponseOfWhite = 0.5;

enum Purpose : std::uint64_t { kPictureNoise = 1, kDepthNoise = 2 };

/// What one channel's light is multiplied with. Single precision throughout, in this order.
struct Channel {
    float electrons = 0; ///< Per unit of light and of the vignetting's factor.
    float gain = 0;      ///< To the share of white.
    float balance = 1;
};

std::array<std::uint16_t, 256> lightTable() {
    std::array<std::uint16_t, 256> table{};
    for (std::size_t value = 0; value < table.size(); ++value) {
        table[value] = static_cast<std::uint16_t>(
            std::lround(kWhiteLight * linearLight(static_cast<double>(value) / 255)));
    }
    return table;
}

double toneValue(const std::vector<double>& knots, double at) {
    if (knots.empty()) {
        return at;
    }
    const double scaled = at * static_cast<double>(knots.size() - 1);
    const std::size_t knot = std::min(static_cast<std::size_t>(scaled), knots.size() - 2);
    return knots[knot] + (scaled - static_cast<double>(knot)) * (knots[knot + 1] - knots[knot]);
}

std::vector<std::uint8_t> toneTable(const ToneModel& tone) {
    constexpr int kLast = (1 << kEntryBits) - 1;
    std::vector<std::uint8_t> table(kLast + 1);
    for (int entry = 0; entry <= kLast; ++entry) {
        const double light = static_cast<double>(entry) / kLast;
        const double stored = tone.gamma > 0 ? std::pow(light, 1 / tone.gamma) : storedValue(light);
        table[static_cast<std::size_t>(entry)] =
            static_cast<std::uint8_t>(std::lround(255 * std::clamp(toneValue(tone.knots, stored), 0.0, 1.0)));
    }
    return table;
}

/// The factor of each pixel; empty if it is 1 everywhere.
Image<float, 1> vignettingFactors(const VignettingModel& model, const CameraModel& camera, WorkerPool& pool,
                                  int threads) {
    if (model == VignettingModel()) {
        return {};
    }
    const CameraIntrinsics& lens = camera.intrinsics();
    const double right = std::max(lens.cx, lens.width - 1 - lens.cx);
    const double down = std::max(lens.cy, lens.height - 1 - lens.cy);
    const double cornerSquared = right * right + down * down;
    const PixelRays rays(camera, pool, threads);
    const auto& [a1, a2, a3] = model.radial;
    Image<float, 1> factors(lens.width, lens.height);
    for (int y = 0; y < lens.height; ++y) {
        for (int x = 0; x < lens.width; ++x) {
            const double dx = x - lens.cx;
            const double dy = y - lens.cy;
            const double r2 = cornerSquared > 0 ? (dx * dx + dy * dy) / cornerSquared : 0;
            const double z = std::max(0.0, rays.ray(x, y).z());
            const double natural = 1 - model.natural * (1 - z * z * z * z);
            const double radial = 1 + r2 * (a1 + r2 * (a2 + r2 * a3));
            *factors.at(x, y) = static_cast<float>(natural * std::clamp(radial, 0.0, 1.0));
        }
    }
    return factors;
}

/// The light of a colour. Source: ITU-R BT.709.
double luminance(const std::array<double, 3>& rgb) {
    return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
}

} // namespace

struct Sensor::State {
    State(const SensorModel& wanted, const CameraModel& sharedCamera, int mostThreads)
        : model(checked(wanted)),
          camera(sharedCamera),
          threads(mostThreads),
          pool(mostThreads),
          exposure(model.exposure),
          defocus(model.defocus, std::max(camera.intrinsics().fx, camera.intrinsics().fy)),
          balance(model.whiteBalance.isAutomatic ? std::array<double, 3>{1, 1, 1} : model.whiteBalance.gains),
          vignetting(vignettingFactors(model.vignetting, camera, pool, mostThreads)),
          tone(toneTable(model.tone)) {
        // Only what acts on light makes pictures go through it.
        SensorModel dark = model;
        dark.seed = SensorModel().seed;
        dark.jpegQuality = 0;
        dark.depth = {};
        dark.shutter = {};
        dark.exposure.timeS = dark.exposure.referenceTimeS = 0;
        changesLight = dark != SensorModel() || exposure.timeFactor() != 1;
    }

    static const SensorModel& checked(const SensorModel& model) {
        model.validate();
        return model;
    }

    bool isAutomatic() const { return model.exposure.automatic || model.whiteBalance.isAutomatic; }

    RowTiming timing(const PoseAt& poseAt, double timeS, double& stepPx) const;
    void requireSize(const View& view) const;
    void rows(const std::function<void(int y)>& body);
    void add(const RgbImage& picture, const RowTiming& timing, std::size_t view);
    void toLight(const RgbImage& picture);
    void vignette();
    std::array<Channel, 3> channels() const;
    std::array<double, 3> meter() const;
    void follow(bool isFirst);
    void develop(std::uint64_t frame, RgbImage& picture);
    SensorReport finish(std::uint64_t frame, bool isLight, View& view);

    SensorModel model;
    CameraModel camera;
    int threads;
    WorkerPool pool;
    ExposureControl exposure;
    Defocus defocus;
    std::array<double, 3> balance; ///< The gains.
    Image<float, 1> vignetting;
    std::vector<std::uint8_t> tone;
    std::array<std::uint16_t, 256> lightOf = lightTable();
    bool changesLight = false;
    bool isFirst = true;
    Image<std::uint32_t, 3> sum; ///< Of views, in units of light / RowTiming::kOne.
    LightImage light{camera.width(), camera.height()};
    View other; ///< Views that are not the main one.
};

RowTiming Sensor::State::timing(const PoseAt& poseAt, double timeS, double& stepPx) const {
    const double exposureS = exposure.timeS();
    double stepS = 0;
    stepPx = 0;
    if (exposureS > 0 || model.shutter.lineDelayS > 0) {
        std::tie(stepS, stepPx) = viewStep(poseAt, camera.intrinsics(), timeS, exposureS, model.shutter);
    }
    return RowTiming(camera.height(), timeS, exposureS, model.shutter.lineDelayS, stepS);
}

void Sensor::State::requireSize(const View& view) const {
    if (view.picture.width() != camera.width() || view.picture.height() != camera.height()) {
        throw Error(ErrorKind::InvalidInput, text("A sensor of ", camera.width(), " x ", camera.height(),
                                                  " pixels cannot take a view of ", view.picture.width(),
                                                  " x ", view.picture.height(), "."));
    }
}

void Sensor::State::rows(const std::function<void(int y)>& body) {
    const int height = camera.height();
    pool.run((height + kRowsAtATime - 1) / kRowsAtATime, threads, [&](int band, int) {
        for (int y = band * kRowsAtATime; y < std::min(height, (band + 1) * kRowsAtATime); ++y) {
            body(y);
        }
    });
}

/// Adds a view's share to each row.
void Sensor::State::add(const RgbImage& picture, const RowTiming& timing, std::size_t view) {
    rows([&](int y) {
        const std::uint32_t share = timing.share(y, view);
        const std::span<const std::uint8_t> from = picture.row(y);
        const std::span<std::uint32_t> to = sum.row(y);
        for (std::size_t i = 0; share > 0 && i < from.size(); ++i) {
            to[i] += share * lightOf[from[i]];
        }
    });
}

void Sensor::State::toLight(const RgbImage& picture) {
    rows([&](int y) {
        const std::span<const std::uint8_t> from = picture.row(y);
        std::transform(from.begin(), from.end(), light.row(y).begin(),
                       [this](std::uint8_t value) { return lightOf[value]; });
    });
}

std::array<Channel, 3> Sensor::State::channels() const {
    const double well = model.noise.fullWellE > 0 ? model.noise.fullWellE : 1;
    std::array<Channel, 3> channels;
    for (std::size_t c = 0; c < channels.size(); ++c) {
        channels[c] = {
            static_cast<float>(exposure.timeFactor() * model.whiteBalance.response[c] * well / kWhiteLight),
            static_cast<float>(exposure.gainFactor() / well), static_cast<float>(balance[c])};
    }
    return channels;
}

/// The mean of what each channel records at the present exposure, without noise and gains of colour; white is
/// 1.
std::array<double, 3> Sensor::State::meter() const {
    const std::array<Channel, 3> channels = this->channels();
    const float well = model.noise.fullWellE > 0 ? static_cast<float>(model.noise.fullWellE) : 1.0F;
    std::array<std::uint64_t, 3> sums{};
    std::uint64_t count = 0;
    for (int y = kMeteredPixel / 2; y < light.height() || count == 0; y += kMeteredPixel) {
        for (int x = kMeteredPixel / 2; x < light.width() || count == 0; x += kMeteredPixel) {
            const int column = std::min(x, light.width() - 1);
            const int row = std::min(y, light.height() - 1);
            const float factor = vignetting.empty() ? 1.0F : *vignetting.at(column, row);
            for (std::size_t c = 0; c < 3; ++c) {
                const float electrons =
                    static_cast<float>(light.at(column, row)[c]) * factor * channels[c].electrons;
                const float share = std::min(1.0F, std::min(well, electrons) * channels[c].gain);
                sums[c] += static_cast<std::uint64_t>(share * kWhiteLight + 0.5F);
            }
            ++count;
        }
    }
    std::array<double, 3> means;
    std::transform(sums.begin(), sums.end(), means.begin(), [count](std::uint64_t all) {
        return static_cast<double>(all) / static_cast<double>(count) / kWhiteLight;
    });
    return means;
}

/// Sets exposure and gains of colour by the present light: those of the first frame, or of the next one.
void Sensor::State::follow(bool isFirstFrame) {
    constexpr int kMostTurns = 16; // clipped light tells only that it is too much
    for (int turn = 0; turn < (isFirstFrame ? kMostTurns : 1); ++turn) {
        const double response =
            isFirstFrame || !model.exposure.automatic ? 1 : model.exposure.automatic->response;
        if (!exposure.follow(luminance(meter()), response)) {
            break;
        }
    }
    if (model.whiteBalance.isAutomatic) {
        constexpr double kSteps = 256; // a gain has so many between whole numbers
        const std::array<double, 3> mean = meter();
        for (std::size_t c = 0; c < 3; ++c) {
            const double grey = std::clamp(mean[1] / std::max(mean[c], 1e-4), 0.25, 4.0);
            const double gain = balance[c] + (isFirstFrame ? 1 : kResponseOfWhite) * (grey - balance[c]);
            balance[c] = static_cast<double>(std::lround(gain * kSteps)) / kSteps;
        }
    }
}

/// Light to what the picture stores.
void Sensor::State::develop(std::uint64_t frame, RgbImage& picture) {
    constexpr float kLast = (1 << kEntryBits) - 1;
    const std::array<Channel, 3> channels = this->channels();
    const bool isNoisy = model.noise.fullWellE > 0;
    const float well = isNoisy ? static_cast<float>(model.noise.fullWellE) : 1.0F;
    const auto read = static_cast<float>(model.noise.readE);
    const NormalNoise noise(model.seed, frame, kPictureNoise);
    rows([&](int y) {
        const auto first = static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(picture.width());
        for (int x = 0; x < picture.width(); ++x) {
            const float factor = vignetting.empty() ? 1.0F : *vignetting.at(x, y);
            const NormalNoise::Three normal =
                isNoisy ? noise.at(first + static_cast<std::uint64_t>(x)) : NormalNoise::Three{};
            const std::uint16_t* from = light.at(x, y);
            std::uint8_t* to = picture.at(x, y);
            for (std::size_t c = 0; c < 3; ++c) {
                const Channel& channel = channels[c];
                float electrons = static_cast<float>(from[c]) * factor * channel.electrons;
                if (isNoisy) {
                    electrons += std::sqrt(electrons + read * read) * normal[c];
                }
                const float share = std::min(std::clamp(electrons, 0.0F, well) * channel.gain, 1.0F);
                const float balanced = std::min(share * channel.balance, 1.0F);
                to[c] = tone[static_cast<std::size_t>(balanced * kLast + 0.5F)];
            }
        }
    });
}

SensorReport Sensor::State::finish(std::uint64_t frame, bool isLight, View& view) {
    SensorReport report;
    if (changesLight || isLight || isAutomatic()) {
        if (!isLight) {
            toLight(view.picture);
        }
        if (defocus.isOn()) {
            defocus.apply(light, view.depth, pool, threads);
        }
        if (isFirst && isAutomatic()) {
            follow(true);
        }
        report.meanLight = luminance(meter());
        develop(frame, view.picture);
    }
    if (model.jpegQuality > 0) {
        view.picture = jpeg::decode(jpeg::encode(view.picture, model.jpegQuality), "the sensor's picture");
    }
    report.exposureTimeS = exposure.timeS();
    report.gainDb = exposure.gainDb();
    report.whiteBalance = balance;
    if (isAutomatic()) {
        follow(false);
    }
    isFirst = false;
    return report;
}

Sensor::Sensor(const SensorModel& model, const CameraModel& camera, int threads)
    : m_state(std::make_unique<State>(model, camera, threads)) {
}

Sensor::~Sensor() = default;
Sensor::Sensor(Sensor&&) noexcept = default;
Sensor& Sensor::operator=(Sensor&&) noexcept = default;

std::vector<double> Sensor::times(const PoseAt& poseAt, double timeS) const {
    double stepPx = 0;
    return m_state->timing(poseAt, timeS, stepPx).times();
}

bool Sensor::isAutomatic() const {
    return m_state->isAutomatic();
}

bool Sensor::needsDepth() const {
    return m_state->model.defocus.apertureMm > 0;
}

SensorReport Sensor::take(const MakeView& makeView, const PoseAt& poseAt, double timeS, std::uint64_t frame,
                          View& view) {
    State& state = *m_state;
    if (state.isFirst && state.isAutomatic()) { // its exposure decides when its views are made
        makeView(poseAt(timeS), timeS, true, view);
        state.requireSize(view);
        state.toLight(view.picture);
        state.follow(true);
        state.isFirst = false;
    }
    double stepPx = 0;
    const RowTiming timing = state.timing(poseAt, timeS, stepPx);
    if (timing.times().size() == 1) {
        makeView(poseAt(timeS), timeS, true, view);
        return take(frame, view);
    }
    state.sum = Image<std::uint32_t, 3>(state.camera.width(), state.camera.height());
    double renderMs = 0;
    double decodeMs = 0;
    for (std::size_t i = 0; i < timing.times().size(); ++i) {
        const bool isMain = i == timing.main();
        View& made = isMain ? view : state.other;
        makeView(poseAt(timing.times()[i]), timing.times()[i], isMain, made);
        state.requireSize(made);
        state.add(made.picture, timing, i);
        renderMs += made.report.renderMs;
        decodeMs += made.report.decodeMs;
    }
    view.report.renderMs = renderMs;
    view.report.decodeMs = decodeMs;
    std::transform(state.sum.values().begin(), state.sum.values().end(), state.light.values().begin(),
                   [](std::uint32_t all) {
                       constexpr std::uint32_t kHalf = RowTiming::kOne / 2;
                       return static_cast<std::uint16_t>((all + kHalf) / RowTiming::kOne);
                   });
    SensorReport report = state.finish(frame, true, view);
    report.views = static_cast<int>(timing.times().size());
    report.stepPx = stepPx;
    return report;
}

SensorReport Sensor::take(std::uint64_t frame, View& view) {
    m_state->requireSize(view);
    return m_state->finish(frame, false, view);
}

void Sensor::measureDepth(std::uint64_t frame, DepthImage& depth) {
    const DepthSensorModel& model = m_state->model.depth;
    if (model == DepthSensorModel()) {
        return;
    }
    const NormalNoise noise(m_state->model.seed, frame, kDepthNoise);
    m_state->pool.run(depth.height(), m_state->threads, [&](int y, int) {
        const auto first = static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(depth.width());
        for (int x = 0; x < depth.width(); ++x) {
            float& z = *depth.at(x, y);
            if (!std::isfinite(z)) {
                continue;
            }
            const double exact = static_cast<double>(z);
            const double sigma = model.sigmaM + model.sigmaPerM * exact * exact;
            const double normal = static_cast<double>(noise.at(first + static_cast<std::uint64_t>(x))[0]);
            constexpr float kEndless = std::numeric_limits<float>::infinity();
            z = exact < model.leastM  ? -kEndless
                : exact > model.mostM ? kEndless
                                      : static_cast<float>(std::max(0.0, exact + sigma * normal));
        }
    });
}

Image<std::uint16_t, 1> depthMillimetres(const DepthImage& depth) {
    Image<std::uint16_t, 1> millimetres(depth.width(), depth.height());
    std::transform(depth.values().begin(), depth.values().end(), millimetres.values().begin(), [](float z) {
        const float mm = z * 1000;
        return mm >= 0.5F && mm < 65535.5F ? static_cast<std::uint16_t>(mm + 0.5F) : std::uint16_t{0};
    });
    return millimetres;
}

} // namespace spherewalk::render

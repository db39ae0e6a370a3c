// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/view.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk::render {

/// A sensor that is not perfect, as plain values. Each effect is off by default. Light is linear: 1 is what
/// white of a photo stands for. Source: EMVA Standard 1288 (noise, gain), Kalibr (line delay).

/// Exposure that follows the scene. The light of each frame decides the exposure of the next one; the first
/// frame is exposed as it asks for itself. Steps are 1/16 stop. The time grows before the gain does.
struct AutoExposure {
    double target = 0.18;     ///< The mean light that a frame shall have. Range: (0, 1).
    double leastTimeS = 1e-4; ///< Range: above 0.
    double mostTimeS = 0.02;  ///< Range: leastTimeS to 1.
    double mostGainDb = 24;   ///< Range: 0 to 60.
    double response = 0.5;    ///< The share of what is missing that the next frame gets. Range: (0, 1].

    bool operator==(const AutoExposure&) const = default;
};

struct ExposureModel {
    double timeS = 0; ///< How long each row is exposed: things that move are blurred. Range: 0 to 1.
    /// The time after which the picture is as bright as the photos, at a gain of 0 dB. 0 stands for timeS
    /// itself, so that the time decides the blur alone. Range: 0 to 1.
    double referenceTimeS = 0;
    double gainDb = 0;                          ///< 20 log10 of the factor. Range: -20 to 60.
    std::optional<AutoExposure> automatic = {}; ///< timeS and gainDb are then not used.

    bool operator==(const ExposureModel&) const = default;
};

/// When rows are exposed. A frame's time is the middle of the exposure of its first row.
struct ShutterModel {
    double lineDelayS = 0; ///< From a row to the next one; 0 for a global shutter. Range: 0 to 0.001.
    /// Views during one frame. They are as many as make steps of a pixel for things in the middle of the
    /// picture a metre away, but not more than this. Range: 4 to 1024.
    int mostViews = 64;

    bool operator==(const ShutterModel&) const = default;
};

/// Less light towards the corners. The factors of both laws are multiplied.
struct VignettingModel {
    double natural = 0; ///< The share of the law cos^4 of the angle to the axis. Range: 0 to 1.
    /// 1 + a1 r^2 + a2 r^4 + a3 r^6, where r is 1 in the corner farthest from the principal point. The result
    /// is cut to [0, 1]. Range: -10 to 10.
    std::array<double, 3> radial{};

    bool operator==(const VignettingModel&) const = default;
};

/// Discs instead of points. Their diameter is diameterPx, and more by the thin lens formula: f A |1/s - 1/z|
/// with the focal length f in pixels, the aperture A, the focus s and the depth z.
struct DefocusModel {
    double diameterPx = 0; ///< Range: 0 to 100.
    double apertureMm = 0; ///< The aperture's diameter: focal length / f-number. Range: 0 to 100.
    double focusM = 1;     ///< Range: above 0.

    bool operator==(const DefocusModel&) const = default;
};

/// Shot noise and read noise of each channel of each pixel. The variance of n electrons is n + read^2. Both
/// parts are normal numbers.
struct NoiseModel {
    double fullWellE = 0; ///< Electrons of white at a gain of 0 dB, the most a pixel holds; 0: no noise.
    double readE = 0;     ///< Standard deviation in electrons. Range: 0 to 10000; needs fullWellE.

    bool operator==(const NoiseModel&) const = default;
};

/// What the sensor's channels make of light, and the factors that the camera multiplies them with. Where
/// gains are 1 / response, colours are those of the photos, and red and blue have more noise.
struct WhiteBalanceModel {
    std::array<double, 3> response{1, 1, 1}; ///< Before noise. Range: above 0, to 4.
    std::array<double, 3> gains{1, 1, 1};    ///< After noise. Range: 0 to 16.
    /// Gains that make the frame grey in the mean (grey world), following as AutoExposure does with a
    /// response of 0.5. `gains` are then not used.
    bool isAutomatic = false;

    bool operator==(const WhiteBalanceModel&) const = default;
};

/// From linear light to the value that the picture stores.
struct ToneModel {
    double gamma = 0; ///< value = light^(1 / gamma); 0 stands for sRGB. Range: 0, or 0.1 to 10.
    /// Values at evenly spread knots from 0 to 1, applied to what gamma gives. Straight between them; empty
    /// for the identity. Shape: 0, or 2 to 257. Range: [0, 1], not falling.
    std::vector<double> knots;

    bool operator==(const ToneModel&) const = default;
};

/// The errors of a depth camera, for View::depth.
struct DepthSensorModel {
    double leastM = 0; ///< What is nearer becomes -infinity (REP 117: too close).
    double mostM = std::numeric_limits<double>::infinity(); ///< What is farther becomes +infinity.
    /// The standard deviation is sigmaM + sigmaPerM z^2: that of a depth from disparities grows with z^2.
    double sigmaM = 0;
    double sigmaPerM = 0;

    bool operator==(const DepthSensorModel&) const = default;
};

struct SensorModel {
    std::uint64_t seed = 1; ///< Of all noise.
    ExposureModel exposure;
    ShutterModel shutter;
    VignettingModel vignetting;
    DefocusModel defocus;
    NoiseModel noise;
    WhiteBalanceModel whiteBalance;
    ToneModel tone;
    int jpegQuality = 0; ///< The picture is what is left after a JPEG (4:2:0) of this quality; 0: none.
    DepthSensorModel depth;

    bool operator==(const SensorModel&) const = default;

    /// Errors: InvalidInput, with a sentence that names the value, what it is and its range.
    void validate() const;

    /// The same sensor in a camera of a rig, with noise of its own. index: 0 for the first camera, which has
    /// this one.
    SensorModel ofCamera(std::size_t index) const {
        SensorModel own = *this;
        own.seed += index;
        return own;
    }
};

/// The sensor of a YAML file, as resources/docs/formats.md documents it: the entry `sensor` of the file,
/// which may be the camera-info, or the whole file. Errors: NotFound, Io; InvalidInput, with the file and the
/// entry, for entries that are unknown, too.
SensorModel readSensor(const std::filesystem::path& file);

/// The same from the YAML's text. source: a name of the text for sentences.
SensorModel parseSensor(std::string_view yaml, const std::string& source);

/// A YAML that parseSensor() turns back into the same sensor. Effects that are off are left out.
std::string sensorYaml(const SensorModel& sensor);

/// How a frame was taken.
struct SensorReport {
    double exposureTimeS = 0;
    double gainDb = 0;
    std::array<double, 3> whiteBalance{1, 1, 1}; ///< The gains.
    int views = 1;                               ///< Views that the frame was made of.
    /// How far things in the middle of the picture a metre away move from a view to the next. Above 1, what
    /// moves is shown several times beside each other.
    double stepPx = 0;
    double meanLight = 0; ///< Before the tone curve; white is 1.
};

/// Takes frames of one camera as its sensor does. Exposure and white balance go on from frame to frame where
/// they are automatic; all else depends on the frame alone. The bytes are the same for any number of threads
/// and on any machine. Threads: one at a time.
class Sensor {
  public:
    /// threads: the most to use, 0 for all. Errors: those of SensorModel::validate().
    Sensor(const SensorModel& model, const CameraModel& camera, int threads = 0);
    ~Sensor();
    Sensor(Sensor&&) noexcept;
    Sensor& operator=(Sensor&&) noexcept;

    /// The pose of the camera's optical frame at a time. It is asked for times before and after the frame's.
    using PoseAt = std::function<Rigid3(double timeS)>;
    /// Makes one of a frame's views. isMain: the view at the frame's time, whose depth, trust, and report are
    /// those of the frame. The others need a picture only.
    using MakeView = std::function<void(const Rigid3& roomFromCamera, double timeS, bool isMain, View& view)>;

    /// The times of the views that the next frame would be made of, ascending. One of them is timeS. Range:
    /// finite.
    std::vector<double> times(const PoseAt& poseAt, double timeS) const;

    /// Whether the frame depends on those before it: exposure or white balance is automatic.
    bool isAutomatic() const;

    /// Whether a main view needs View::depth: defocus depends on it.
    bool needsDepth() const;

    /// Takes a frame: View::picture is what the sensor gives. frame: the number of the frame, which decides
    /// its noise. Depth stays as it is; see measureDepth(). Errors: those of makeView.
    SensorReport take(const MakeView& makeView, const PoseAt& poseAt, double timeS, std::uint64_t frame,
                      View& view);

    /// The frame of a camera that does not move, from a finished view of its size.
    SensorReport take(std::uint64_t frame, View& view);

    /// Gives depths the errors of SensorModel::depth. Depths that are not finite stay.
    void measureDepth(std::uint64_t frame, DepthImage& depth);

  private:
    struct State;
    std::unique_ptr<State> m_state;
};

/// Depths as sensor_msgs/Image has them in 16UC1: millimetres, rounded; 0 for what is not finite, below half
/// a millimetre or beyond 65.535 m. Source: REP 118.
Image<std::uint16_t, 1> depthMillimetres(const DepthImage& depth);

} // namespace spherewalk::render

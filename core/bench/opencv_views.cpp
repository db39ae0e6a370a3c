// SPDX-License-Identifier: GPL-3.0-or-later
#include "opencv_views.h"

#include "spherewalk/base/error.h"

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace spherewalk::bench {

using Eigen::Vector3d;

namespace {

template <class Call>
void translated(Call&& call) {
    try {
        call();
    } catch (const cv::Exception& error) {
        throw Error(ErrorKind::Internal,
                    "Could not measure OpenCV: it refused to make a view; please report this.", error.what());
    }
}

} // namespace

struct OpenCvViews::State {
    /// Limits OpenCV to one thread for a lifetime.
    class OneThread {
      public:
        OneThread() : m_before(cv::getNumThreads()) { cv::setNumThreads(1); }

        ~OneThread() { cv::setNumThreads(m_before); }

        OneThread(const OneThread&) = delete;
        OneThread& operator=(const OneThread&) = delete;

      private:
        int m_before;
    };

    struct Maps {
        cv::Mat x;
        cv::Mat y;
    };

    State(const RgbImage& picture, const CameraModel& model, std::optional<double> radius)
        : photo(picture.height(), picture.width(), CV_8UC3, const_cast<std::uint8_t*>(picture.at(0, 0))),
          camera(model.intrinsics()),
          radiusM(radius),
          view(camera.width, camera.height),
          out(camera.height, camera.width, CV_8UC3, view.at(0, 0)) {}

    /// Fills `maps` with one trigonometric function and one square root for each coordinate, and steps along
    /// the row.
    void buildMaps(const Rigid3& photoFromCamera);

    OneThread oneThread;
    const cv::Mat photo; ///< OpenCV has no constant matrices; the photo is only read.
    const CameraIntrinsics& camera;
    std::optional<double> radiusM;
    RgbImage view;
    cv::Mat out; ///< Its pixels are those of `view`.
    Maps maps;
    std::vector<Maps> kept; ///< x holds whole pixels of both axes, y holds fractions.
};

void OpenCvViews::State::buildMaps(const Rigid3& photoFromCamera) {
    const CameraIntrinsics& k = camera;
    maps.x.create(k.height, k.width, CV_32F);
    maps.y.create(k.height, k.width, CV_32F);
    const Eigen::Matrix3d turn = photoFromCamera.rotation.toRotationMatrix();
    const Vector3d from =
        radiusM ? Vector3d(photoFromCamera.translation / *radiusM) : Vector3d(Vector3d::Zero());
    const double room = 1 - from.squaredNorm();
    const double perRadianX = photo.cols / (2 * std::numbers::pi);
    const double perRadianY = photo.rows / std::numbers::pi;
    const Vector3d step = turn.col(0) / k.fx;
    for (int y = 0; y < k.height; ++y) {
        const Vector3d first = turn * Vector3d(-k.cx / k.fx, (y - k.cy) / k.fy, 1);
        auto* toX = maps.x.ptr<float>(y);
        auto* toY = maps.y.ptr<float>(y);
        for (int x = 0; x < k.width; ++x) {
            const double rayX = first.x() + x * step.x();
            const double rayY = first.y() + x * step.y();
            const double rayZ = first.z() + x * step.z();
            const double square = rayX * rayX + rayY * rayY + rayZ * rayZ;
            const double along = from.x() * rayX + from.y() * rayY + from.z() * rayZ;
            const double t = (std::sqrt(along * along + square * room) - along) / square;
            const double dX = from.x() + t * rayX;
            const double dY = from.y() + t * rayY;
            const double dZ = from.z() + t * rayZ;
            toX[x] = static_cast<float>((std::numbers::pi - std::atan2(dY, dX)) * perRadianX - 0.5);
            toY[x] = static_cast<float>((std::numbers::pi / 2 - std::asin(dZ)) * perRadianY - 0.5);
        }
    }
}

OpenCvViews::OpenCvViews(const RgbImage& photo, const CameraModel& camera, std::optional<double> radiusM)
    : m_state(std::make_unique<State>(photo, camera, radiusM)) {
}

OpenCvViews::~OpenCvViews() = default;

const RgbImage& OpenCvViews::mapsAndRemap(const Rigid3& photoFromCamera) {
    State& state = *m_state;
    translated([&] {
        state.buildMaps(photoFromCamera);
        cv::remap(state.photo, state.out, state.maps.x, state.maps.y, cv::INTER_LINEAR, cv::BORDER_WRAP);
    });
    return state.view;
}

void OpenCvViews::keepMaps(const Rigid3& photoFromCamera) {
    State& state = *m_state;
    translated([&] {
        state.buildMaps(photoFromCamera);
        State::Maps& kept = state.kept.emplace_back();
        cv::convertMaps(state.maps.x, state.maps.y, kept.x, kept.y, CV_16SC2);
    });
}

const RgbImage& OpenCvViews::remap(int pose) {
    State& state = *m_state;
    const State::Maps& maps = state.kept[static_cast<std::size_t>(pose) % state.kept.size()];
    // The border that costs least: what is lost is a pixel at the seam.
    translated(
        [&] { cv::remap(state.photo, state.out, maps.x, maps.y, cv::INTER_LINEAR, cv::BORDER_CONSTANT); });
    return state.view;
}

std::string OpenCvViews::version() {
    return CV_VERSION;
}

} // namespace spherewalk::bench

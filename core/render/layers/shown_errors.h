// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dataset/evidence.h"
#include "layers/view_geometry.h"
#include "sphere/exact_view.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace spherewalk::render {

/// How far a pixel's thing may be displaced.
struct ShownError {
    double px = 0;
    bool isFilled = false;
    bool isUnsure = false;
};

/// The errors of a view's pixels. Frames: rays are unit vectors of the camera's optical frame. Owner: all
/// that it is made from must outlive it.
class ShownErrors {
  public:
    ShownErrors(const SceneRays& scene, const ViewGeometry& view, const ViewEvidence& evidence)
        : m_camera(view.rays.camera()), m_scene(scene), m_view(view), m_evidence(evidence) {
        for (const PhotoEvidence& photo : evidence.photos) {
            m_offsets.push_back(view.roomFromCamera.translation - photo.roomFromPhoto.translation);
        }
    }

    ShownError at(int x, int y, const Eigen::Vector3d& ray) const;

  private:
    /// What is known of the thing that a pixel shows.
    struct Thing {
        std::size_t source = 0;     ///< The photo that shows it.
        double inverseM = 0;        ///< 1 / its distance from the camera.
        double residualM = 0;       ///< The error of that.
        Eigen::Vector3d fromCamera; ///< Frames: room.
        bool isFilled = false;
        bool isDoubtful = false;
    };

    double modelInverseM(int x, int y, const Eigen::Vector3d& ray) const {
        if (m_evidence.inverseM) {
            return m_evidence.inverseM(x, y, ray);
        }
        const double distance = m_scene.distanceM(ray);
        return std::isfinite(distance) ? 1 / distance : 0;
    }

    /// The place, in a photo's frame and times any factor, of what lies there from the camera.
    Eigen::Vector3d inPhoto(std::size_t photo, const Eigen::Vector3d& direction, double inverseM) const {
        return m_evidence.photos[photo].roomFromPhoto.rotation.conjugate() *
               (direction + inverseM * m_offsets[photo]);
    }

    Thing shown(const Eigen::Vector3d& direction, double modelInverseM) const;
    Thing ofDepths(const Eigen::Vector3d& direction, double modelInverseM) const;
    Thing ofFirst(const Eigen::Vector3d& direction, double modelInverseM) const;
    void askOthers(Thing& thing) const;

    const CameraModel& m_camera;
    const SceneRays& m_scene;
    const ViewGeometry& m_view;
    const ViewEvidence& m_evidence;
    std::vector<Eigen::Vector3d> m_offsets; ///< The camera minus each photo. Frames: room.
};

} // namespace spherewalk::render

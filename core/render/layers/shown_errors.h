// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dataset/evidence.h"
#include "layers/view_geometry.h"
#include "sphere/exact_view.h"

#include <Eigen/Core>

#include <cstddef>
#include <span>
#include <vector>

namespace spherewalk::render {

/// A pixel of a view that the lens sees.
struct ViewPixel {
    int x = 0;
    int y = 0;
    Eigen::Vector3d ray; ///< A unit vector. Frames: the camera's optical frame.
};

/// How far a pixel's thing may be displaced.
struct ShownError {
    double px = 0;
    bool isFilled = false;
    bool isUnsure = false;
};

/// Directions of any length, each component contiguous, as SIMD reads them.
class Directions {
  public:
    explicit Directions(std::size_t most) : m_pitch(most + kMore), m_values(3 * m_pitch) {}

    void set(std::size_t i, const Eigen::Vector3d& direction) {
        m_values[i] = direction.x();
        m_values[m_pitch + i] = direction.y();
        m_values[2 * m_pitch + i] = direction.z();
    }

    /// One component of all of them. axis: 0 to 2.
    const double* component(std::size_t axis) const { return m_values.data() + axis * m_pitch; }

    static constexpr std::size_t kMore = 16; ///< SIMD reads and writes so many values beyond the last.

  private:
    std::size_t m_pitch;
    std::vector<double> m_values;
};

/// What a photo's depth says in the first `known.size()` directions. They are of any length but zero.
/// photoFrom: the photo from the frame of the directions. The values are the same on every processor.
void look(const DepthEvidence& depth, const Eigen::Matrix3d& photoFrom, const Directions& directions,
          std::span<KnownDepth> known);

/// The errors of a view's pixels. Owner: all that it is made from must outlive it. Threads: const functions
/// may run on any number at a time.
class ShownErrors {
  public:
    ShownErrors(const SceneRays& scene, const ViewGeometry& view, const ViewEvidence& evidence);

    /// The errors of some pixels. Dozens of pixels at a time cost least, since what depths say about pixels
    /// is looked up together.
    std::vector<ShownError> of(std::span<const ViewPixel> pixels) const;

  private:
    /// What is known of the thing that a pixel shows.
    struct Thing {
        std::size_t source = 0;                               ///< The photo that shows it.
        double inverseM = 0;                                  ///< 1 / its distance from the camera.
        double residualM = 0;                                 ///< The error of that.
        Eigen::Vector3d fromCamera = Eigen::Vector3d::Zero(); ///< Frames: room.
        bool isFilled = false;
        bool isDoubtful = false;
    };

    /// A pixel's direction, and the distance that the view's scene model has there.
    struct Modelled {
        Eigen::Vector3d direction; ///< Frames: room.
        double inverseM = 0;
    };

    /// What the other photos' depths say about a thing.
    struct Answers {
        double sum = 0;    ///< Of the disagreements, in 1/m.
        double apartM = 0; ///< The sum of the photos' distances from the thing's photo.
        int asked = 0;
    };

    Modelled modelled(const ViewPixel& pixel) const;

    /// The place, in the room's axes, from a photo and times any factor, of what lies there from the camera.
    Eigen::Vector3d fromPhoto(std::size_t photo, const Eigen::Vector3d& direction, double inverseM) const {
        return direction + inverseM * m_offsets[photo];
    }

    std::vector<Thing> shown(std::span<const Modelled> models) const;
    std::vector<Thing> ofDepths(std::span<const Modelled> models) const;
    bool isShownBy(std::size_t photo, const Modelled& model, const Eigen::Vector3d& place,
                   const KnownDepth& depth, Thing& thing) const;
    std::vector<Thing> ofFirst(std::span<const Modelled> models) const;
    Thing ofPrior(const Modelled& model) const;
    void askOthers(std::span<Thing> things) const;
    void judge(const Answers& answers, Thing& thing) const;
    ShownError error(const ViewPixel& pixel, double modelInverseM, const Thing& thing) const;

    const CameraModel& m_camera;
    const SceneRays& m_scene;
    const ViewGeometry& m_view;
    const ViewEvidence& m_evidence;
    Eigen::Matrix3d m_roomFromCamera;
    std::vector<Eigen::Vector3d> m_offsets;         ///< The camera minus each photo. Frames: room.
    std::vector<Eigen::Vector3d> m_offsetsInCamera; ///< The same. Frames: the camera's.
    std::vector<Eigen::Matrix3d> m_photoFromRoom;   ///< The rotation of each photo.
};

} // namespace spherewalk::render

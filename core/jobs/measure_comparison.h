// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "measure_subjects.h"

#include "spherewalk/measure/displacement.h"

#include <array>
#include <functional>
#include <map>
#include <stop_token>
#include <utility>
#include <vector>

namespace spherewalk::jobs {

using SceneAndSampling = std::pair<render::SceneKind, render::Sampling>;

/// The samplings, cheap to exact; not Auto.
inline constexpr std::array kSamplings{render::Sampling::Nearest, render::Sampling::Bilinear,
                                       render::Sampling::Reduced, render::Sampling::Footprint,
                                       render::Sampling::Bicubic};

/// One view beside its subject.
struct Comparison {
    std::size_t photo = 0; ///< that the view was made from
    double psnrDb = 0;
    double ssim = 0;
    std::vector<int> matched;      ///< displacements of features, hundredths of a pixel
    std::vector<int> exact;        ///< of pixels whose depth is known
    std::vector<SeenThing> things; ///< some of them, to the millimetre
};

/// Displacements that a sampling makes by itself, in hundredths of a pixel: features of a view beside the
/// same view with the best sampling for it.
using SamplingErrors = std::map<render::Sampling, std::vector<int>>;

/// What is known of one subject.
struct Comparisons {
    std::map<SceneAndSampling, Comparison> views;
    SamplingErrors samplings; ///< all or none
};

/// The view that stands for the subject.
render::View viewOf(const Subject& subject, const render::Renderer& renderer, const CameraModel& camera,
                    const SceneAndSampling& with);

/// Compares the views of those scene models that are not known yet. subject: is called if there are some.
/// Returns whether there were. Errors: those of rendering; Stopped, between two
/// views.
bool compareMissing(const std::vector<render::SceneKind>& scenes, render::Sampling sampling,
                    const std::function<Subject()>& subject, const render::Renderer& renderer,
                    const CameraModel& camera, const std::stop_token& stop, Comparisons& known);

/// Of all samplings, in the view that the nearest photo alone gives from there.
SamplingErrors samplingErrors(const Subjects::Place& place, const render::Renderer& renderer,
                              const CameraModel& camera);

/// Comparisons that are kept in files, named after all that they depend on. Threads: any, for different keys.
class ComparisonCache {
  public:
    /// folder: empty for none. Errors: Io.
    ComparisonCache(std::filesystem::path folder, const render::DatasetInfo& info,
                    const CameraIntrinsics& camera);

    /// What is there of this subject; a file that is damaged counts as none.
    Comparisons read(const std::string& subjectKey) const;
    void write(const std::string& subjectKey, const Comparisons& comparisons) const;

  private:
    std::filesystem::path fileOf(const std::string& subjectKey) const;

    std::filesystem::path m_folder;
    std::size_t m_photos;
    std::string m_context;
};

} // namespace spherewalk::jobs

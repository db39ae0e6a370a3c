// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/compare_robot.h"

#include "measure/place_errors.h"
#include "parts/report_parts.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/statistics.h"
#include "spherewalk/base/text.h"
#include "spherewalk/compare/picture_matches.h"
#include "spherewalk/compare/pose_fit.h"
#include "spherewalk/jobs/looks.h"
#include "spherewalk/photo/picture_file.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

namespace spherewalk::jobs {

namespace {

constexpr std::size_t kFewestOfTwoHalves = 4;
constexpr int kShownWidth = 480; ///< pixels
constexpr int kDifferenceTimes = 4;

/// The mean of what there is.
class Mean {
  public:
    void add(const std::optional<double>& value) {
        m_sum += value.value_or(0);
        m_count += value ? 1 : 0;
    }

    std::optional<double> value() const {
        return m_count == 0 ? std::nullopt : std::optional(m_sum / m_count);
    }

  private:
    double m_sum = 0;
    int m_count = 0;
};

/// A picture's likeness, and the errors of its places.
struct LikenessAndErrors {
    PictureLikeness likeness;
    PlaceErrors errors;
};

CompareSummary summary(const std::vector<LikenessAndErrors>& pictures) {
    PlaceErrors all;
    Mean colour;
    std::vector<Looks> looks;
    for (const LikenessAndErrors& picture : pictures) {
        looks.push_back(picture.likeness.looks);
        colour.add(picture.likeness.colourError);
        all.add(picture.errors);
    }
    return {summaryOf(looks), quantilePx(all, 0.5), quantilePx(all, 0.95), all.missedShare(), colour.value()};
}

/// The error of each half's colours after the correction that the other half tells.
std::optional<double> heldOutError(const std::vector<compare::ColourSamples>& samples) {
    if (samples.size() < kFewestOfTwoHalves) {
        return std::nullopt;
    }
    std::array<compare::ColourSamples, 2> halves;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        halves[i % 2].add(samples[i]);
    }
    Mean mean;
    for (std::size_t half = 0; half < 2; ++half) {
        const compare::ColourFit fit = compare::fittedColour(halves[1 - half]);
        if (!fit.correction) {
            return std::nullopt;
        }
        mean.add(compare::colourError(halves[half].samples, *fit.correction));
    }
    return mean.value();
}

class RobotComparison {
  public:
    RobotComparison(const render::Renderer& renderer, const CameraModel& camera,
                    const CompareOptions& options)
        : m_renderer(renderer),
          m_camera(camera),
          m_options(options),
          m_pool(std::max(1, options.view.threads)),
          m_rays(camera, m_pool) {}

    CompareReport run(ProgressSink& progress, const std::stop_token& stop) {
        const std::size_t count = m_options.pictures.size();
        ProgressStep first(progress, 0, 0.7);
        for (std::size_t i = 0; i < count; ++i) {
            throwIfStopped(stop);
            look(m_options.pictures[i], stop);
            first.progress(static_cast<double>(i + 1) / static_cast<double>(count),
                           text("Comparing picture ", i + 1, " of ", count));
        }
        fitColour();
        ProgressStep second(progress, 0.7, 1);
        for (std::size_t i = 0; i < count; ++i) {
            throwIfStopped(stop);
            lookAgain(i);
            second.progress(static_cast<double>(i + 1) / static_cast<double>(count),
                            text("Comparing picture ", i + 1, " of ", count, " again"));
        }
        m_report.before = summary(m_before);
        m_report.after = summary(m_after);
        summariseSteadiness();
        return std::move(m_report);
    }

  private:
    render::View viewFrom(const Rigid3& pose) const {
        render::ViewOptions view = m_options.view;
        view.wantsTrust = true;
        view.correctsColour = false;
        return m_renderer.render(m_camera, pose, view);
    }

    static LikenessAndErrors likeness(const compare::Frame& frame, const RgbImage& picture,
                                      const RgbImage& view, const std::optional<double>& colourError) {
        const PlaceErrors errors = placeErrors(compare::placeDisplacements(frame.truth, frame.view));
        return {{looksOf(picture, compare::straightLines(picture), view), quantilePx(errors, 0.5),
                 quantilePx(errors, 0.95), errors.found.size(), errors.missed, colourError},
                errors};
    }

    /// Compares with the picture before, which is kept until then.
    void follow(ComparedPicture& compared, compare::Frame frame) {
        if (m_last) {
            compared.steadiness = compare::steadiness(*m_last, frame);
        }
        m_last = std::move(frame);
    }

    void summariseSteadiness() {
        std::vector<double> medians;
        std::vector<double> p95s;
        for (const ComparedPicture& picture : m_report.pictures) {
            if (picture.steadiness && picture.steadiness->medianPx) {
                medians.push_back(*picture.steadiness->medianPx);
                p95s.push_back(*picture.steadiness->p95Px);
            }
        }
        if (!medians.empty()) {
            m_report.steadyMedianPx = median(medians);
            m_report.steadyP95Px = median(p95s);
        }
    }

    /// From the given pose; and its refined pose, and its colours.
    void look(const RobotPicture& picture, const std::stop_token& stop) {
        const RgbImage taken = readRobotPicture(picture, m_camera);
        ComparedPicture compared;
        compared.file = picture.file;
        compared.given = picture.roomFromCamera;
        const render::View view = viewFrom(compared.given);
        compared.photo = view.report.file;
        compare::ColourSamples colours = compare::colourSamples(view.picture, view.trust, taken);
        compare::Frame frame{compare::PictureFeatures(taken), compare::PictureFeatures(view.picture)};
        m_before.push_back(likeness(frame, taken, view.picture, compare::colourError(colours.samples)));
        compared.before = m_before.back().likeness;
        if (!m_options.refinesPoses) {
            follow(compared, std::move(frame));
        }
        if (m_options.refinesPoses) {
            compare::PoseRefinementOptions refinement;
            refinement.view = m_options.view;
            compared.refined =
                compare::refinedPose(m_renderer, m_camera, taken, compared.given, refinement, stop);
            m_report.refined += compared.refined->isFitted ? 1 : 0;
        }
        if (m_options.fitsSensor) {
            const std::vector<compare::NoiseSample> noise = compare::noiseSamples(taken);
            m_noise.insert(m_noise.end(), noise.begin(), noise.end());
        }
        if (m_options.fitsColour || m_options.fitsSensor) {
            if (compared.refined && compared.refined->isFitted) {
                const render::View better = viewFrom(compared.used());
                colours = compare::colourSamples(better.picture, better.trust, taken);
            }
            if (!compared.refined || compared.refined->isFitted) {
                m_colours.push_back(std::move(colours));
            }
        }
        m_report.pictures.push_back(std::move(compared));
    }

    /// Colours, and the sensor that takes views in these colours.
    void fitColour() {
        m_report.colour = m_renderer.dataset().info().colour;
        compare::ColourSamples all;
        for (const compare::ColourSamples& samples : m_colours) {
            all.add(samples);
        }
        if (m_options.fitsColour) {
            m_report.fit = compare::fittedColour(all);
            m_report.colour = m_report.fit->correction;
            m_report.heldOutColourError = heldOutError(m_colours);
        }
        if (m_report.colour) {
            m_tables.emplace(*m_report.colour);
            for (compare::ColourSample& sample : all.samples) {
                sample.view = m_report.colour->corrected(sample.view);
            }
        }
        if (m_options.fitsSensor) {
            m_report.sensor = compare::fittedSensor(all.samples, m_noise);
        }
    }

    /// From the pose that was found, in the colours that were found.
    void lookAgain(std::size_t index) {
        ComparedPicture& compared = m_report.pictures[index];
        if (!m_options.refinesPoses && !m_tables && !isShown(index)) {
            m_after.push_back(m_before[index]);
            compared.after = compared.before;
            return;
        }
        const RgbImage taken = readRobotPicture(m_options.pictures[index], m_camera);
        render::View view = viewFrom(compared.used());
        const compare::ColourSamples colours = compare::colourSamples(view.picture, view.trust, taken);
        if (m_tables) {
            m_tables->apply(view.picture, m_rays, m_pool);
        }
        compare::Frame frame{compare::PictureFeatures(taken), compare::PictureFeatures(view.picture)};
        m_after.push_back(likeness(frame, taken, view.picture,
                                   m_report.colour ? compare::colourError(colours.samples, *m_report.colour)
                                                   : compare::colourError(colours.samples)));
        compared.after = m_after.back().likeness;
        if (m_options.refinesPoses) {
            follow(compared, std::move(frame));
        }
        if (isShown(index)) {
            show(taken, view.picture, compared);
        }
    }

    void show(const RgbImage& taken, const RgbImage& after, const ComparedPicture& compared) {
        const auto small = [&](const RgbImage& picture) {
            return picture.width() <= kShownWidth
                       ? picture
                       : photo::resized(picture, kShownWidth,
                                        std::max(1, kShownWidth * picture.height() / picture.width()));
        };
        m_report.shown.push_back({compared.file.filename().string(), small(taken),
                                  small(viewFrom(compared.given).picture), small(after),
                                  small(difference(after, taken, kDifferenceTimes))});
    }

    bool isShown(std::size_t index) const {
        const std::size_t all = m_options.pictures.size();
        const std::size_t shown = std::min(all, m_options.shown);
        return (index + 1) * shown / all > index * shown / all;
    }

    const render::Renderer& m_renderer;
    const CameraModel& m_camera;
    const CompareOptions& m_options;
    WorkerPool m_pool;
    render::PixelRays m_rays;
    std::vector<compare::ColourSamples> m_colours; ///< of pictures whose pose is good
    std::vector<compare::NoiseSample> m_noise;
    std::optional<render::ColourTables> m_tables;
    std::vector<LikenessAndErrors> m_before; ///< one a picture, as in the report
    std::vector<LikenessAndErrors> m_after;
    std::optional<compare::Frame> m_last;
    CompareReport m_report;
};

} // namespace

CompareReport compareRobot(const render::Renderer& renderer, const CameraModel& camera,
                           const CompareOptions& options, ProgressSink& progress,
                           const std::stop_token& stop) {
    if (options.pictures.empty()) {
        throw Error(ErrorKind::InvalidInput, "There are no robot's pictures to compare with.");
    }
    const auto begin = std::chrono::steady_clock::now();
    CompareOptions posed = options;
    ProgressStep registering(progress, 0, 0.1);
    std::vector<TagRegistered> registered =
        registerPictures(renderer, camera, options.view, posed.pictures, registering, stop);
    if (posed.pictures.empty()) {
        throw Error(ErrorKind::InvalidInput,
                    text("No picture has a pose, and tags give none. ",
                         registered.front().file.filename().string(), ": ", registered.front().why));
    }
    ProgressStep comparing(progress, registered.empty() ? 0 : 0.1, 1);
    CompareReport report = RobotComparison(renderer, camera, posed).run(comparing, stop);
    report.registered = std::move(registered);
    report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return report;
}

} // namespace spherewalk::jobs

// SPDX-License-Identifier: Apache-2.0
#include "bindings.h"
#include "path_caster.h"

#include "spherewalk/base/enum_names.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/trajectory.h"
#include "spherewalk/render/light_probe.h"
#include "spherewalk/render/sensor.h"
#include "spherewalk/render/view_stream.h"

#include <filesystem>
#include <mutex>
#include <unistd.h>

namespace spherewalk::python {

namespace {

using render::Renderer;
using render::VerifyPhotos;
using render::View;
using render::ViewOptions;
using render::ViewStream;

constexpr EnumNames<VerifyPhotos, 2> kPhotoVerifications{
    {{VerifyPhotos::BeforeUse, "before_use"}, {VerifyPhotos::InBackground, "in_background"}}};

/// Of a process: threads do not come along into a process that is forked, as multiprocessing does by default.
class OwnProcess {
  public:
    /// Errors: Busy in another process.
    void check() const {
        if (getpid() != m_process) {
            throw Error(ErrorKind::Busy,
                        "This renderer was made by the process that this one was forked from, and "
                        "its threads stayed there: make a renderer in each process.");
        }
    }

  private:
    pid_t m_process = getpid();
};

struct OwnRenderer {
    Renderer renderer;
    OwnProcess process = {};
};

/// What one thread may use at a time. what: "stream", for sentences.
struct OneAtATime {
    const char* what;
    std::mutex inUse = {};
    OwnProcess process = {};

    /// Errors: Busy.
    std::unique_lock<std::mutex> lock() {
        process.check();
        std::unique_lock lock(inUse, std::try_to_lock);
        if (!lock) {
            throw Error(ErrorKind::Busy,
                        text("Another thread is using this ", what, "; make one for each thread."));
        }
        return lock;
    }
};

struct OwnStream : OneAtATime {
    OwnStream(const CameraModel& model, ViewStream made)
        : OneAtATime{"stream"}, camera(model), stream(std::move(made)) {}

    CameraModel camera;
    ViewStream stream;
};

struct OwnSensor : OneAtATime {
    explicit OwnSensor(render::Sensor made) : OneAtATime{"sensor"}, sensor(std::move(made)) {}

    render::Sensor sensor;
};

OwnRenderer makeRenderer(const OpenDataset& dataset, std::uint64_t cacheBytes,
                         const std::string& verifyPhotos) {
    VerifyPhotos verify = valueOf(kPhotoVerifications, "The verification of photos", verifyPhotos);
    verify = dataset.isVerified ? VerifyPhotos::AtOpen : verify;
    return {Renderer(dataset.dataset, {cacheBytes, verify})};
}

View render(const OwnRenderer& self, const CameraModel& camera, const py::object& pose, ViewOptions options,
            const py::object& overlays, const std::string& frame) {
    self.process.check();
    const Rigid3 roomFromCamera = opticalPose(pose, frame);
    const std::vector<render::Overlay> laidIn = overlaysFrom(overlays, camera.intrinsics());
    options.overlays = laidIn;
    const py::gil_scoped_release unlocked;
    return self.renderer.render(camera, roomFromCamera, options);
}

/// So that Ctrl-C ends a long call. Threads: any; only Python's main thread hears signals.
void raiseIfInterrupted() {
    const py::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0) {
        throw py::error_already_set();
    }
}

std::vector<View> renderAll(const OwnRenderer& self, const CameraModel& camera,
                            const std::vector<Rigid3>& poses, ViewOptions options) {
    std::vector<View> views(poses.size());
    const int threads = std::exchange(options.threads, 1);
    parallelFor(static_cast<int>(poses.size()), 1, threads, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            const auto at = static_cast<std::size_t>(i);
            self.renderer.render(camera, poses[at], options, views[at]);
            raiseIfInterrupted();
        }
    });
    return views;
}

py::list renderMany(const OwnRenderer& self, const CameraModel& camera, const py::object& poses,
                    const ViewOptions& options, const std::string& frame) {
    self.process.check();
    const std::vector<Rigid3> path = opticalPoses(poses, frame);
    std::vector<View> views;
    {
        const py::gil_scoped_release unlocked;
        views = renderAll(self, camera, path, options);
    }
    py::list result;
    for (View& view : views) {
        result.append(std::move(view));
    }
    return result;
}

std::unique_ptr<OwnStream> makeStream(const OwnRenderer& renderer, const CameraModel& camera,
                                      const std::string& late, double prefetchS, double passageM) {
    renderer.process.check();
    const render::StreamOptions options{render::latePolicy(late), prefetchS, passageM};
    return std::make_unique<OwnStream>(camera, ViewStream(renderer.renderer, camera, options));
}

View next(OwnStream& self, const py::object& pose, double timeS, ViewOptions options,
          const py::object& overlays, const std::string& frame) {
    const Rigid3 roomFromCamera = opticalPose(pose, frame);
    const std::vector<render::Overlay> laidIn = overlaysFrom(overlays, self.camera.intrinsics());
    options.overlays = laidIn;
    const auto lock = self.lock();
    const py::gil_scoped_release unlocked;
    return self.stream.next(roomFromCamera, timeS, options);
}

std::unique_ptr<OwnSensor> makeSensor(const render::SensorModel& model, const CameraModel& camera) {
    return std::make_unique<OwnSensor>(render::Sensor(model, camera));
}

/// Errors: InvalidInput for other counts of times and poses, none, and times that do not ascend.
std::vector<TimedPose> pathFrom(const py::object& times, const py::object& poses, const std::string& frame) {
    const Numbers numbers = numbersFrom(times, "times");
    const std::vector<Rigid3> at = opticalPoses(poses, frame);
    if (numbers.ndim() != 1 || static_cast<std::size_t>(numbers.size()) != at.size() || at.empty()) {
        throw Error(ErrorKind::InvalidInput,
                    text("A frame needs as many times as poses, and at least one; these are ", numbers.size(),
                         " and ", at.size(), "."));
    }
    std::vector<TimedPose> path;
    for (const Rigid3& pose : at) {
        const double timeS = numbers.data()[path.size()];
        if (!path.empty() && !(timeS > path.back().timeS)) {
            throw Error(ErrorKind::InvalidInput, text("The times of poses must ascend, and ", timeS,
                                                      " is not later than ", path.back().timeS, "."));
        }
        path.push_back({timeS, pose});
    }
    return path;
}

View take(OwnStream& self, OwnSensor& by, const py::object& times, const py::object& poses, double timeS,
          std::uint64_t number, const ViewOptions& options, const std::string& frame) {
    const std::vector<TimedPose> path = pathFrom(times, poses, frame);
    const auto lock = self.lock();
    const auto sensorLock = by.lock();
    const py::gil_scoped_release unlocked;
    View view;
    by.sensor.take(
        [&](const Rigid3& pose, double at, bool isMain, View& made) {
            ViewOptions of = options;
            of.wantsDepth = isMain && (options.wantsDepth || by.sensor.needsDepth());
            of.wantsTrust = isMain && options.wantsTrust;
            self.stream.next(pose, at, of, made);
        },
        [&path](double at) { return poseAt(path, at); }, timeS, number, view);
    by.sensor.measureDepth(number, view.depth);
    return view;
}

void bindSensor(py::module_& module) {
    py::class_<OwnSensor>(module, "Sensor",
                          "A sensor that is not perfect: noise, exposure, blur and other effects, for one "
                          "camera. Where exposure or white balance is automatic, each frame depends on those "
                          "before. One thread at a time.")
        .def_static(
            "read",
            [](const std::filesystem::path& file, const CameraModel& camera) {
                return makeSensor(render::readSensor(file), camera);
            },
            py::arg("file"), py::arg("camera"),
            "The sensor of a YAML file, or of the entry sensor of a camera-info YAML.")
        .def_static(
            "parse",
            [](const std::string& yaml, const CameraModel& camera) {
                return makeSensor(render::parseSensor(yaml, "from memory"), camera);
            },
            py::arg("yaml"), py::arg("camera"), "The same from the YAML's text.");
}

render::LightProbe probeOf(const OwnRenderer& self, const py::object& place, int width,
                           const std::string& scene, int threads, bool correctColour) {
    self.process.check();
    const Numbers at = numbersFrom(place, "place");
    if (at.ndim() != 1 || at.size() != 3) {
        throw Error(ErrorKind::InvalidInput,
                    text("A place in the room has three numbers, x y z; its shape is ", shapeText(at), "."));
    }
    render::ProbeOptions options{width, {}, threads, correctColour};
    if (scene != "auto") {
        options.scene = render::sceneKind(scene);
    }
    const Eigen::Vector3d pInRoom(at.data());
    const py::gil_scoped_release unlocked;
    return render::lightProbe(self.renderer, pInRoom, options);
}

py::array_t<double> arrayOf(const Eigen::Vector3d& values) {
    return py::array_t<double>(3, values.data());
}

/// The harmonics of a probe. Shape: (9, 3).
py::array_t<double> harmonicsOf(const render::LightProbe& probe) {
    const render::LightHarmonics harmonics = render::lightHarmonics(probe.radiance);
    return py::array_t<double>({9, 3}, harmonics.coefficients.front().data());
}

py::dict dominantOf(const render::LightProbe& probe) {
    const render::DominantLight light = render::dominantLight(render::lightHarmonics(probe.radiance));
    py::dict result;
    result["towards"] = arrayOf(light.towards);
    result["irradiance"] = arrayOf(light.irradiance);
    result["ambient"] = arrayOf(light.ambient);
    result["share"] = light.share;
    return result;
}

py::tuple lightsOf(const render::LightProbe& probe, int count) {
    const std::vector<render::DirectionalLight> lights = render::directionalLights(probe.radiance, count);
    const auto rows = static_cast<py::ssize_t>(lights.size());
    py::array_t<double> towards({rows, py::ssize_t{3}});
    py::array_t<double> irradiance({rows, py::ssize_t{3}});
    for (std::size_t i = 0; i < lights.size(); ++i) {
        std::copy_n(lights[i].towards.data(), 3, towards.mutable_data() + 3 * i);
        std::copy_n(lights[i].irradiance.data(), 3, irradiance.mutable_data() + 3 * i);
    }
    return py::make_tuple(towards, irradiance);
}

void bindProbe(py::module_& module) {
    using render::LightProbe;
    const auto shared = [](auto member) {
        return
            [member](const py::object& self) { return sharedArray(self.cast<LightProbe&>().*member, self); };
    };
    py::class_<LightProbe>(module, "LightProbe", "The light that comes to a place from all directions.")
        .def_property_readonly("radiance", shared(&LightProbe::radiance),
                               "Linear red, green, blue, 1 is the photo's white; equirectangular, the centre "
                               "along the room's x. "
                               "Shape: (width / 2, width, 3) float32.")
        .def_property_readonly("clipped", shared(&LightProbe::clipped),
                               "255 where the light was too bright for all photos. Shape: (width / 2, width) "
                               "uint8.")
        .def_readonly("clipped_share", &LightProbe::clippedShare, "Of all directions.")
        .def_readonly("recovered_share", &LightProbe::recoveredShare,
                      "Of all directions, whose light a darker photo showed.")
        .def_readonly("report", &LightProbe::report, "Of the view along the room's x that it is made with.")
        .def_property_readonly("harmonics", &harmonicsOf,
                               "Spherical harmonics of the radiance up to order 2. Shape: (9, 3).")
        .def_property_readonly("dominant", &dominantOf,
                               "One light and an even one: towards (unit vector), irradiance (on a surface "
                               "that faces it), ambient (radiance), and share of what falls on that surface.")
        .def(
            "lights", &lightsOf, py::arg("count"),
            "Lights from afar that stand for all light: unit vectors towards them, and what each throws on a "
            "surface that faces it. Shapes: (n, 3), (n, 3); n is at most count.")
        .def(
            "write",
            [](const LightProbe& self, const std::filesystem::path& file) {
                writeFile(file, render::radianceFile(self.radiance));
            },
            py::arg("file"), "Writes the radiance as a Radiance file (.hdr).");
}

void bindRenderer(py::module_& module) {
    py::class_<OwnRenderer>(
        module, "Renderer",
        "Answers \"what does my camera see from here?\" from a dataset. Any number of threads; "
        "the interpreter's lock is free while a view is made. Make one in each process.")
        .def(py::init(&makeRenderer), py::arg("dataset"), py::kw_only(),
             py::arg("cache_bytes") = render::RendererOptions().cacheBytes,
             py::arg("verify_photos") = "before_use",
             "cache_bytes: for decoded pixels; verify_photos: compare a photo's hash \"before_use\" or, in "
             "streams, "
             "\"in_background\". A dataset that was opened with verify=\"hashes\" is not verified again.")
        .def("render", &render, py::arg("camera"), py::arg("pose"),
             py::arg_v("options", ViewOptions(), "ViewOptions()"), py::kw_only(),
             py::arg("overlays") = py::tuple(), py::arg("frame") = "optical",
             "One view. pose: room_from_camera as (4, 4), or x y z qx qy qz qw, metres; frame: which frame "
             "it is the "
             "pose of, \"optical\" (z forward) or \"body\" (x forward).")
        .def("render_many", &renderMany, py::arg("camera"), py::arg("poses"),
             py::arg_v("options", ViewOptions(), "ViewOptions()"), py::kw_only(),
             py::arg("frame") = "optical",
             "A view of each pose, (n, 4, 4) or (n, 7), several at a time, each by one thread; "
             "options.threads at "
             "once. The pixels are those of render(). Ctrl-C ends it between views.")
        .def("light_probe", &probeOf, py::arg("place"), py::kw_only(),
             py::arg("width") = render::ProbeOptions().width, py::arg("scene") = "auto",
             py::arg("threads") = 0, py::arg("correct_colour") = true,
             "The light at a place, x y z in metres. What is clipped comes from darker photos, if there are "
             "any.");
}

void bindStream(py::module_& module) {
    using render::StreamCounters;
    py::class_<StreamCounters>(module, "StreamCounters", "Views of a stream, since it was made.")
        .def_readonly("views", &StreamCounters::views)
        .def_readonly("late", &StreamCounters::late)
        .def_readonly("waited", &StreamCounters::waited, "Late ones that waited.")
        .def_readonly("coarse", &StreamCounters::coarse, "Made from a thumbnail.")
        .def_readonly("previous", &StreamCounters::previous, "Made from the photo of the view before.");
    py::class_<OwnStream>(
        module, "ViewStream",
        "The views of one moving camera in turn: what it will see next is decoded ahead. One "
        "thread at a time; several streams of one renderer run beside each other.")
        .def(py::init(&makeStream), py::arg("renderer"), py::arg("camera"), py::kw_only(),
             py::arg("late") = "wait", py::arg("prefetch_s") = render::StreamOptions().prefetchSeconds,
             py::arg("passage_m") = render::StreamOptions().passageM,
             "late: what a view is made from when its photo is not decoded yet, \"wait\" for it, \"coarse\" "
             "(the thumbnail), or \"previous\" (the photo before); prefetch_s: seconds of motion to decode "
             "ahead; passage_m: the way along which a view with depth passes from one photo to the next, 0 "
             "if it "
             "jumps.")
        .def("next", &next, py::arg("pose"), py::arg("time_s"),
             py::arg_v("options", ViewOptions(), "ViewOptions()"), py::kw_only(),
             py::arg("overlays") = py::tuple(), py::arg("frame") = "optical",
             "The view at a time, on any clock; what is not later than the view before is a new start.")
        .def("take", &take, py::arg("sensor"), py::arg("times"), py::arg("poses"), py::arg("time_s"),
             py::arg("number"), py::arg_v("options", ViewOptions(), "ViewOptions()"), py::kw_only(),
             py::arg("frame") = "optical",
             "The frame that a sensor takes at a time. times: seconds, (n,), ascending; poses: of the camera "
             "at "
             "these times, (n, 4, 4) or (n, 7), between which it moves evenly, and goes on so before and "
             "after; "
             "time_s: the middle of the exposure of the first row; number: of the frame, which decides its "
             "noise.")
        .def_property_readonly("counters",
                               [](OwnStream& self) {
                                   const auto lock = self.lock();
                                   return self.stream.counters();
                               })
        .def(
            "wait_for_prefetch",
            [](OwnStream& self) {
                const auto lock = self.lock();
                const py::gil_scoped_release unlocked;
                self.stream.waitForPrefetch();
            },
            "Returns when all that was predicted is decoded.");
}

} // namespace

void bindRenderers(py::module_& module) {
    bindProbe(module);
    bindRenderer(module);
    bindSensor(module);
    bindStream(module);
}

} // namespace spherewalk::python

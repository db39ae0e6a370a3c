// SPDX-License-Identifier: Apache-2.0
#include "bindings.h"
#include "path_caster.h"

#include "spherewalk/base/enum_names.h"

#include <pybind11/functional.h>

namespace spherewalk::python {

namespace {

using render::Dataset;
using render::DatasetPhoto;
using render::Verify;

constexpr EnumNames<Verify, 2> kVerifications{{{Verify::Sizes, "sizes"}, {Verify::Hashes, "hashes"}}};

/// Tells a Python function how far a call is, and ends the call when the function raises or Ctrl-C is
/// pressed. Threads: used without the interpreter's lock.
class PythonProgress : public ProgressSink {
  public:
    explicit PythonProgress(py::object function) : m_function(std::move(function)) {}

    void progress(double fraction, std::string_view activity) override {
        const py::gil_scoped_acquire lock;
        if (m_raised) {
            return;
        }
        try {
            if (PyErr_CheckSignals() != 0) {
                throw py::error_already_set();
            }
            if (!m_function.is_none()) {
                m_function(fraction, std::string(activity));
            }
        } catch (py::error_already_set& raised) {
            m_raised.emplace(std::move(raised));
            m_stop.request_stop();
        }
    }

    void warning(std::string_view /*sentence*/) override {}

    std::stop_token stop() const { return m_stop.get_token(); }

    /// With the interpreter's lock.
    void rethrow() {
        if (m_raised) {
            throw std::move(*m_raised);
        }
    }

  private:
    py::object m_function;
    std::optional<py::error_already_set> m_raised;
    std::stop_source m_stop;
};

OpenDataset open(const std::filesystem::path& folder, const std::string& verify, const py::object& progress) {
    const Verify much = valueOf(kVerifications, "The verification", verify);
    PythonProgress sink(progress);
    try {
        const py::gil_scoped_release unlocked;
        return {std::make_shared<const Dataset>(Dataset::open(folder, much, sink, sink.stop())),
                much == Verify::Hashes};
    } catch (const Error&) {
        sink.rethrow();
        throw;
    }
}

py::array_t<double> pointsOf(const Polygon& polygon) {
    py::array_t<double> points({static_cast<py::ssize_t>(polygon.size()), py::ssize_t{2}});
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        std::copy_n(polygon[i].data(), 2, points.mutable_data(static_cast<py::ssize_t>(i)));
    }
    return points;
}

void bindPhoto(py::module_& module) {
    py::class_<DatasetPhoto>(module, "Photo", "A spherical photo of a dataset, and where it was taken.")
        .def_readonly("file", &DatasetPhoto::file, "Relative to the dataset.")
        .def_readonly("station", &DatasetPhoto::station, "What people call its place.")
        .def_readonly("width", &DatasetPhoto::width, "Pixels.")
        .def_readonly("height", &DatasetPhoto::height, "Pixels.")
        .def_readonly("rotation_source", &DatasetPhoto::rotationSource,
                      "\"imported\", \"aligned\", \"metadata\", or \"unknown\".")
        .def_property_readonly(
            "room_from_photo", [](const DatasetPhoto& self) { return matrixOf(self.roomFromPhoto); },
            "Of the panorama frame: x forward (the picture's centre), y left, z up. Shape: (4, 4).")
        .def("__repr__", [](const DatasetPhoto& self) {
            return text("<spherewalk.Photo ", printable(self.file), ", ", self.width, " x ", self.height,
                        ">");
        });
}

py::list photosOf(const py::object& self) {
    py::list photos;
    for (const DatasetPhoto& photo : self.cast<const OpenDataset&>().dataset->info().photos) {
        photos.append(py::cast(&photo, py::return_value_policy::reference_internal, self));
    }
    return photos;
}

py::dict camerasOf(const OpenDataset& self) {
    py::dict cameras;
    for (const render::SuggestedCamera& camera : self.dataset->info().cameras) {
        cameras[py::str(camera.name)] = CameraModel(camera.intrinsics);
    }
    return cameras;
}

std::size_t nearestPhoto(const OpenDataset& self, const py::object& position) {
    const Numbers p = numbersFrom(position, "position");
    if (p.ndim() != 1 || p.shape(0) != 3) {
        throw Error(ErrorKind::InvalidInput,
                    text("The position has the shape ", shapeText(p), "; it must be (3,)."));
    }
    return self.dataset->nearestPhoto({p.at(0), p.at(1), p.at(2)});
}

py::list scenesOf(const OpenDataset& self) {
    py::list scenes;
    for (const render::SceneKind kind : render::scenesOf(self.dataset->info())) {
        scenes.append(std::string(render::name(kind)));
    }
    return scenes;
}

template <class Member>
auto ofInfo(Member member) {
    return [member](const OpenDataset& self) { return std::invoke(member, self.dataset->info()); };
}

void bindRoom(py::class_<OpenDataset>& dataset) {
    using Info = render::DatasetInfo;
    dataset
        .def_property_readonly(
            "outline", [](const OpenDataset& self) { return pointsOf(self.dataset->info().outline); },
            "The walls on the floor, metres; empty if unknown. Shape: (n, 2).")
        .def_property_readonly(
            "obstacles",
            [](const OpenDataset& self) {
                py::list obstacles;
                for (const Polygon& obstacle : self.dataset->info().obstacles) {
                    obstacles.append(pointsOf(obstacle));
                }
                return obstacles;
            },
            "What stands on the floor, each as outline.")
        .def_property_readonly("ceiling_m", ofInfo(&Info::ceilingM), "0 if it is not known.")
        .def_property_readonly("step_m", ofInfo(&Info::stepM), "Of the planned grid; 0 if there was none.");
}

} // namespace

void bindDatasets(py::module_& module) {
    bindPhoto(module);
    py::class_<OpenDataset> dataset(
        module, "Dataset", "An exported dataset on disk, opened and checked. Any number of threads.");
    dataset
        .def_static(
            "open", &open, py::arg("folder"), py::arg("verify") = "sizes", py::arg("progress") = py::none(),
            "folder: that dataset.json is in; verify: \"sizes\" (every file is there and has its size; the "
            "hash of a photo is compared when it is first used) or \"hashes\" (of all photos now); "
            "progress: called with a fraction in [0, 1] and what is being done; what it raises, and "
            "Ctrl-C, ends the call.")
        .def_property_readonly("folder",
                               [](const OpenDataset& self) { return self.dataset->folder().string(); })
        .def_property_readonly("id", ofInfo(&render::DatasetInfo::id))
        .def_property_readonly("name", ofInfo(&render::DatasetInfo::name))
        .def_property_readonly("photos", &photosOf, "In the order that ViewReport.photo counts in.")
        .def_property_readonly("cameras", &camerasOf, "Those that it suggests, by name.")
        .def_property_readonly(
            "scenes", &scenesOf,
            "The scene models that it has for some photo, cheap to exact; \"none\" always.")
        .def_property_readonly(
            "has_colour_correction",
            [](const OpenDataset& self) { return self.dataset->info().colour.has_value(); },
            "Whether views have colours like those of the robot's camera.")
        .def("nearest_photo", &nearestPhoto, py::arg("position"),
             "Index of the photo whose position is nearest to a point of the room, (3,) metres.")
        .def("__repr__", [](const OpenDataset& self) {
            return text("<spherewalk.Dataset ", printable(self.dataset->folder().string()), ", ",
                        self.dataset->info().photos.size(), " photos>");
        });
    bindRoom(dataset);
}

} // namespace spherewalk::python

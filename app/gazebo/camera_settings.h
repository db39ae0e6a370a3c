// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "program/render_options.h"
#include "published_camera.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace spherewalk::gazebo {

/// What a user says of a camera in Gazebo: to the program as options (--overlay-wait 1), to the plugin as
/// elements of SDF (<overlay_wait>1</overlay_wait>).
class CameraSettings {
  public:
    /// pace: that of a user who names none.
    explicit CameraSettings(simulator::Pace pace = simulator::Pace::Newest);

    /// Declares the dataset, --camera and --rig and how views are made, the topics but those of poses,
    /// --frame-id, --rate, --pace, --mount, --room-from-world, the overlay's options, --sensor and --depth.
    void declare(const program::Command& command);

    /// All but the dataset. frame: whose poses will come, with its scopes; without --frame-id, it names the
    /// optical frame. Errors: InvalidInput for what does not fit together; those of render::readCameraInfo()
    /// and render::readRig().
    CameraSetup setup(const std::string& frame) const;

    const program::RenderOptions& render() const { return m_render; }

  private:
    void declareTopics(const program::Command& command);
    void declareOverlay(const program::Command& command);
    simulator::CameraOptions options() const;

    program::RenderOptions m_render;
    program::StreamOptions m_stream;
    Topics m_topics;
    std::string m_frameId;
    double m_rateHz = simulator::CameraOptions().rateHz;
    std::string m_pace;
    std::string m_mount = "0 0 0 0 0 0 1";
    std::string m_roomFromWorld = "0 0 0 0 0 0 1";
    std::string m_objectsBy = "labels";
    std::vector<int> m_roomLabels = {1};
    double m_overlayWaitS = 0.5;
    std::string m_overlayCamera;
    std::string m_sensor;
    bool m_wantsDepth = false;
};

/// Elements of SDF: their names and texts, in their order.
using Elements = std::vector<std::pair<std::string, std::string>>;

/// The elements within one of SDF. Element: a pointer to sdf::Element, of any version of sdformat.
template <class Element>
Elements elementsOf(const Element& parent) {
    Elements elements;
    for (auto child = parent->GetFirstElement(); child; child = child->GetNextElement()) {
        elements.emplace_back(child->GetName(), child->template Get<std::string>());
    }
    return elements;
}

/// The command line that says the same as the elements of a plugin: --overlay-wait=1. Paths are taken from
/// `folder`, that of the world's file.
std::vector<std::string> wordsOf(const Elements& elements, const std::filesystem::path& folder);

/// A sentence about options, for those who wrote elements: <overlay_wait> in place of --overlay-wait.
std::string aboutElements(std::string_view sentence);

} // namespace spherewalk::gazebo

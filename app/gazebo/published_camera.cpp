// SPDX-License-Identifier: GPL-3.0-or-later
#include "published_camera.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/statistics.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace spherewalk::gazebo {

using simulator::OverlayPart;
using simulator::Refusal;

void failWith(const std::string& what, const std::string& topic) {
    throw Error(ErrorKind::Network,
                text("Could not ", what, " the topic ", printable(topic),
                     "; check the network that Gazebo's transport uses (IGN_IP, GZ_IP)."));
}

void requireTopic(const std::string& name) {
    if (!transport::TopicUtils::IsValidTopic(name)) {
        throw Error(ErrorKind::InvalidInput, text("\"", printable(name), "\" cannot be a topic's name."));
    }
}

std::string Topics::beside(const std::string& name) const {
    return image.substr(0, image.rfind('/') + 1) + name;
}

Topics Topics::of(const std::string& camera) const {
    Topics topics = *this;
    for (std::string* topic :
         {&topics.image, &topics.overlayColour, &topics.overlayDepth, &topics.overlayLabels}) {
        if (!topic->empty() && !camera.empty()) {
            const std::size_t last = topic->rfind('/');
            topic->insert(last == std::string::npos ? 0 : last + 1, camera + "/");
        }
    }
    return topics;
}

void Topics::validate() const {
    requireTopic(image);
    for (const std::string& topic : {overlayColour, overlayDepth, overlayLabels}) {
        if (!topic.empty()) {
            requireTopic(topic);
        }
    }
    const std::size_t last = image.rfind('/');
    if (last == std::string::npos || last == 0) {
        throw Error(ErrorKind::InvalidInput,
                    text("The image's topic \"", printable(image),
                         "\" has one level, so that its camera_info would be that of all such cameras; give "
                         "it two, like /robot/image."));
    }
}

void Latencies::add(std::chrono::duration<double, std::milli> latency) {
    if (m_latest.size() < kKept) {
        m_latest.push_back(latency.count());
    } else {
        m_latest[m_next] = latency.count();
        m_next = (m_next + 1) % kKept;
    }
}

double Latencies::quantile(double share) const {
    return m_latest.empty() ? 0 : spherewalk::quantile(m_latest, share);
}

std::string summary(const simulator::CameraCounters& counters, const Latencies& latencies) {
    std::string words = text("Gave ", counters.frames, " frames from ", counters.poses, " poses, in ",
                             fixed(latencies.quantile(0.5), 1), " ms from pose to picture (99 of 100 in ",
                             fixed(latencies.quantile(0.99), 1), " ms).");
    const auto add = [&](std::uint64_t count, const char* what) {
        words += count == 0 ? "" : text("\n", count, " ", what);
    };
    add(counters.dropped, "frames were left out since newer ones were due.");
    add(counters.stream.late, "photos were not decoded in time.");
    add(counters.overlaysMissing,
        "frames went without the simulator's objects, whose pictures did not come.");
    add(counters.overlaysUnused, "pictures of objects fitted no frame.");
    add(counters.outside, "frames were from outside of the room.");
    add(counters.restarts, "times the simulation's time went back.");
    for (std::size_t i = 0; i < counters.refused.size(); ++i) {
        const std::string kind = text("inputs were refused: ", name(static_cast<simulator::Refusal>(i)), ".");
        add(counters.refused[i], kind.c_str());
    }
    return words;
}

Json toJson(const simulator::CameraCounters& counters, const Latencies& latencies) {
    Json refused = Json::object();
    for (std::size_t i = 0; i < counters.refused.size(); ++i) {
        refused[std::string(name(static_cast<simulator::Refusal>(i)))] = counters.refused[i];
    }
    return {{"poses", counters.poses},
            {"frames", counters.frames},
            {"dropped", counters.dropped},
            {"restarts", counters.restarts},
            {"outside", counters.outside},
            {"overlays_laid", counters.overlaysLaid},
            {"overlays_missing", counters.overlaysMissing},
            {"overlays_unused", counters.overlaysUnused},
            {"late", counters.stream.late},
            {"refused", refused},
            {"latency_median_ms", latencies.quantile(0.5)},
            {"latency_99_ms", latencies.quantile(0.99)}};
}

namespace {

std::vector<simulator::MountedCamera> mounted(const std::vector<render::RigCamera>& cameras) {
    const std::vector<Rigid3> places = render::placesOnRig(cameras, "of this program");
    std::vector<simulator::MountedCamera> result;
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        result.push_back({CameraModel(cameras[i].camera), places[i]});
    }
    return result;
}

} // namespace

PublishedCamera::PublishedCamera(const render::Renderer& renderer, const CameraSetup& setup,
                                 simulator::Refusals::Tell tell)
    : m_hasOverlay(setup.options.overlay.has_value()),
      m_hasDepth(setup.options.wantsDepth),
      m_camera(
          renderer, mounted(setup.cameras), setup.options,
          [this](const simulator::Frame& frame) { publish(frame); }, std::move(tell)) {
    setup.topics.validate();
    for (const render::RigCamera& camera : setup.cameras) {
        m_outgoing.push_back(advertised(setup.topics.of(camera.name), camera.frameId));
    }
}

PublishedCamera::~PublishedCamera() {
    end();
}

void PublishedCamera::end() {
    m_camera.setListening(false);
    m_camera.waitUntilIdle();
}

PublishedCamera::Outgoing PublishedCamera::advertised(const Topics& topics, const std::string& frameId) {
    const auto checked = [](transport::Node::Publisher publisher, const std::string& topic) {
        if (!publisher) {
            failWith("advertise", topic);
        }
        return publisher;
    };
    Outgoing outgoing;
    outgoing.topics = topics;
    outgoing.frameId = frameId;
    outgoing.image = checked(m_node.Advertise<msgs::Image>(topics.image), topics.image);
    if (m_hasDepth) {
        outgoing.depth = checked(m_node.Advertise<msgs::Image>(topics.beside("depth_image")),
                                 topics.beside("depth_image"));
    }
    if (m_hasOverlay) {
        outgoing.labels =
            checked(m_node.Advertise<msgs::Image>(topics.beside("labels")), topics.beside("labels"));
        outgoing.boxes = checked(m_node.Advertise<msgs::AnnotatedAxisAligned2DBox_V>(topics.beside("boxes")),
                                 topics.beside("boxes"));
    }
    outgoing.info = checked(m_node.Advertise<msgs::CameraInfo>(topics.beside("camera_info")),
                            topics.beside("camera_info"));
    outgoing.report =
        checked(m_node.Advertise<msgs::Param>(topics.beside("report")), topics.beside("report"));
    return outgoing;
}

void PublishedCamera::subscribeToOverlay() {
    const auto subscribe = [this](const std::string& topic, OverlayPart part, std::size_t camera) {
        std::function<void(const msgs::Image&)> take = [this, part, camera](const msgs::Image& message) {
            takePicture(part, message, camera);
        };
        if (!topic.empty() && !m_node.Subscribe(topic, take)) {
            failWith("subscribe to", topic);
        }
    };
    for (std::size_t camera = 0; camera < m_outgoing.size(); ++camera) {
        const Topics& topics = m_outgoing[camera].topics;
        subscribe(topics.overlayColour, OverlayPart::Colour, camera);
        subscribe(topics.overlayDepth, OverlayPart::Depth, camera);
        subscribe(topics.overlayLabels, OverlayPart::Labels, camera);
    }
}

void PublishedCamera::unsubscribeFromOverlay() {
    for (const Outgoing& of : m_outgoing) {
        const Topics& topics = of.topics;
        for (const std::string& topic : {topics.overlayColour, topics.overlayDepth, topics.overlayLabels}) {
            if (!topic.empty()) {
                m_node.Unsubscribe(topic);
            }
        }
    }
}

void PublishedCamera::takePicture(OverlayPart part, const msgs::Image& message, std::size_t camera) {
    try {
        m_camera.takeOverlay(part, stampOf(message.header()), pictureOf(message), camera);
    } catch (const Error& error) {
        m_camera.refuse(Refusal::Time, error.sentence());
    }
}

bool PublishedCamera::hasListeners() const {
    return std::any_of(m_outgoing.begin(), m_outgoing.end(), [this](const Outgoing& of) {
        return of.image.HasConnections() || of.info.HasConnections() || of.report.HasConnections() ||
               (m_hasDepth && of.depth.HasConnections()) ||
               (m_hasOverlay && (of.labels.HasConnections() || of.boxes.HasConnections()));
    });
}

void PublishedCamera::followListeners() {
    const bool isListening = hasListeners();
    m_camera.setListening(isListening);
    if (m_hasOverlay && isListening != m_isOverlaySubscribed) {
        isListening ? subscribeToOverlay() : unsubscribeFromOverlay();
        m_isOverlaySubscribed = isListening;
    }
}

void PublishedCamera::publish(const simulator::Frame& frame) {
    Outgoing& outgoing = m_outgoing[frame.index];
    for (msgs::Header* header :
         {m_image.mutable_header(), m_depth.mutable_header(), m_labels.mutable_header(),
          m_boxes.mutable_header(), m_info.mutable_header(), m_report.mutable_header()}) {
        setHeader(*header, frame.stamp, outgoing.frameId, m_sequence);
    }
    m_sequence += frame.index + 1 == m_outgoing.size() ? 1 : 0; // the same for all cameras
    setCameraInfo(m_info, render::stereoCalibration(frame.camera, frame.baselineM));
    setImage(m_image, frame.view.picture);
    outgoing.info.Publish(m_info);
    outgoing.image.Publish(m_image);
    if (m_hasDepth && !frame.view.depth.empty()) {
        setDepth(m_depth, frame.view.depth);
        outgoing.depth.Publish(m_depth);
    }
    if (m_hasOverlay && !frame.view.labels.empty()) {
        setLabels(m_labels, frame.view.labels);
        outgoing.labels.Publish(m_labels);
        if (outgoing.boxes.HasConnections()) {
            setBoxes(m_boxes, frame.view.labels);
            outgoing.boxes.Publish(m_boxes);
        }
    }
    const std::chrono::duration<double, std::milli> latency =
        std::chrono::steady_clock::now() - frame.poseTakenAt;
    m_latencies.add(latency);
    setReport(m_report, frame, latency.count());
    outgoing.report.Publish(m_report);
}

} // namespace spherewalk::gazebo

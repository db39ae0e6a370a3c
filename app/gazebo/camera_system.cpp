// SPDX-License-Identifier: GPL-3.0-or-later
// The camera as a system of Gazebo: the simulation itself moves it, and waits for its pictures.
#include "camera_settings.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_set>
#include <utility>

// One name for Gazebo's simulation and its console, as messages.h has for transport and messages.
#ifdef SPHEREWALK_IGNITION
#include <ignition/common/Console.hh>
#include <ignition/gazebo/EntityComponentManager.hh>
#include <ignition/gazebo/System.hh>
#include <ignition/gazebo/Util.hh>
#include <ignition/gazebo/components/Name.hh>
#include <ignition/gazebo/components/ParentEntity.hh>
#include <ignition/gazebo/components/World.hh>
#include <ignition/plugin/Register.hh>

namespace spherewalk::gazebo {
namespace sim = ignition::gazebo;
} // namespace spherewalk::gazebo

#define gzerr ignerr
#define gzwarn ignwarn
#define gzmsg ignmsg
#else
#include <gz/common/Console.hh>
#include <gz/plugin/Register.hh>
#include <gz/sim/EntityComponentManager.hh>
#include <gz/sim/System.hh>
#include <gz/sim/Util.hh>
#include <gz/sim/components/Name.hh>
#include <gz/sim/components/ParentEntity.hh>
#include <gz/sim/components/World.hh>

namespace spherewalk::gazebo {
namespace sim = gz::sim;
} // namespace spherewalk::gazebo
#endif

namespace spherewalk::gazebo {

namespace {

using SharedRenderer = std::shared_ptr<const render::Renderer>;

/// Cameras of one dataset share its renderer, with the photos in memory. Errors: those of
/// render::Dataset::open().
SharedRenderer rendererOf(const program::RenderOptions& options) {
    static std::mutex mutex;
    static std::map<std::filesystem::path, std::weak_ptr<const render::Renderer>> all;
    const std::scoped_lock lock(mutex);
    std::weak_ptr<const render::Renderer>& known = all[std::filesystem::weakly_canonical(options.folder())];
    SharedRenderer renderer = known.lock();
    if (!renderer) {
        renderer = std::make_shared<const render::Renderer>(options.renderer(noProgress(), {}));
        known = renderer;
    }
    return renderer;
}

/// Name of an entity with its scopes below the world: "robot::base::camera"; "" for the world.
std::string scopedNameOf(sim::Entity entity, const sim::EntityComponentManager& ecm) {
    std::string scoped;
    while (ecm.Component<sim::components::World>(entity) == nullptr) {
        const auto* name = ecm.Component<sim::components::Name>(entity);
        scoped = text(name != nullptr ? name->Data() : "", scoped.empty() ? "" : "::", scoped);
        const auto* parent = ecm.Component<sim::components::ParentEntity>(entity);
        if (parent == nullptr) { // Gazebo lays a model into its world after its plugins
            break;
        }
        entity = parent->Data();
    }
    return scoped;
}

} // namespace

/// A camera of a world. Threads: those of Gazebo, which calls one function at a time.
class CameraSystem : public sim::System,
                     public sim::ISystemConfigure,
#ifndef SPHEREWALK_IGNITION
                     public sim::ISystemReset,
#endif
                     public sim::ISystemPostUpdate {
  public:
    ~CameraSystem() override;

    void Configure(const sim::Entity& entity, const std::shared_ptr<const sdf::Element>& element,
                   sim::EntityComponentManager& ecm, sim::EventManager& events) override;
    void PostUpdate(const sim::UpdateInfo& info, const sim::EntityComponentManager& ecm) override;
#ifndef SPHEREWALK_IGNITION
    /// A camera that stays sees by itself that time went back; without this, Gazebo makes another one.
    void Reset(const sim::UpdateInfo& info, sim::EntityComponentManager& ecm) override;
#endif

  private:
    void configure(const sim::EntityComponentManager& ecm, const sdf::Element& element);
    void move(simulator::Stamp stamp, const sim::EntityComponentManager& ecm);
    bool hasPlace(const sim::EntityComponentManager& ecm);

    sim::Entity m_carrier = sim::kNullEntity; ///< What has the plugin.
    sim::Entity m_place = sim::kNullEntity;   ///< What the camera sits on.
    std::string m_frame;                      ///< Its name below the carrier; "" for the carrier itself.
    bool m_isMissed = false;                  ///< The place was looked for in vain, and this was said.
    bool m_waits = false;                     ///< The simulation waits for the pictures.
    std::optional<simulator::Stamp> m_given;  ///< The newest pose.
    SharedRenderer m_renderer;
    std::unique_ptr<PublishedCamera> m_camera; ///< None if its settings were wrong.
};

CameraSystem::~CameraSystem() {
    if (m_camera) {
        if (m_waits) {
            m_camera->camera().waitUntilIdle();
        }
        m_camera->end();
        gzmsg << summary(m_camera->counters(), m_camera->latencies()) << std::endl;
    }
}

void CameraSystem::Configure(const sim::Entity& entity, const std::shared_ptr<const sdf::Element>& element,
                             sim::EntityComponentManager& ecm, sim::EventManager& /*events*/) {
    m_carrier = entity;
    try {
        configure(ecm, *element);
    } catch (const std::exception& error) {
        const auto* ours = dynamic_cast<const Error*>(&error);
        gzerr << text("The camera of Spherewalk at ", printable(scopedNameOf(entity, ecm)), " was not made. ",
                      aboutElements(ours != nullptr ? ours->sentence() : error.what()))
              << std::endl;
    }
}

void CameraSystem::configure(const sim::EntityComponentManager& ecm, const sdf::Element& element) {
    CameraSettings settings(simulator::Pace::Every);
    program::CommandLine line("", "spherewalk-gz-system", "");
    settings.declare(line.program());
    line.program().option("--frame", m_frame, "");
    line.parse(wordsOf(elementsOf(&element), std::filesystem::path(element.FilePath()).parent_path()));
    std::string frame = scopedNameOf(m_carrier, ecm);
    frame += frame.empty() || m_frame.empty() ? m_frame : "::" + m_frame;
    const CameraSetup setup = settings.setup(frame);
    m_waits = setup.options.pace == simulator::Pace::Every;
    m_renderer = rendererOf(settings.render());
    m_camera = std::make_unique<PublishedCamera>(
        *m_renderer, setup, [](const std::string& sentence) { gzwarn << sentence << std::endl; });
    gzmsg << text("Pictures of ", frame, " go to ", setup.topics.image, ".") << std::endl;
}

/// Models come and go while the simulation runs.
bool CameraSystem::hasPlace(const sim::EntityComponentManager& ecm) {
    if (m_frame.empty()) {
        m_place = m_carrier;
    }
    if (m_frame.empty() || ecm.HasEntity(m_place)) {
        return ecm.HasEntity(m_place);
    }
    if (m_isMissed && !ecm.HasNewEntities()) {
        return false;
    }
    const auto places = sim::entitiesFromScopedName(m_frame, ecm, m_carrier);
    m_place = places.size() == 1 ? *places.begin() : sim::kNullEntity;
    const bool isMissedBefore = std::exchange(m_isMissed, places.size() != 1);
    if (m_isMissed && !isMissedBefore) {
        gzerr << text("The camera of Spherewalk waits, since ",
                      places.empty() ? "nothing" : "more than one thing", " is called ", printable(m_frame),
                      " below ", printable(scopedNameOf(m_carrier, ecm)), "; correct <frame>.")
              << std::endl;
    }
    return !m_isMissed;
}

void CameraSystem::PostUpdate(const sim::UpdateInfo& info, const sim::EntityComponentManager& ecm) {
    if (!m_camera || !hasPlace(ecm)) {
        return;
    }
    try {
        m_camera->followListeners();
        move(info.simTime, ecm);
    } catch (const Error& error) {
        gzerr << error.sentence() << std::endl;
        m_camera.reset();
    }
}

void CameraSystem::move(simulator::Stamp stamp, const sim::EntityComponentManager& ecm) {
    simulator::SimulatedCamera& camera = m_camera->camera();
    const bool isDue = camera.isDue(stamp);
    if (stamp == m_given && !isDue) { // the simulation stands still
        return;
    }
    if (m_waits && isDue) {
        camera.waitUntilIdle();
    }
    m_given = stamp;
    const auto pose = sim::worldPose(m_place, ecm);
    const auto& [at, q] = std::pair(pose.Pos(), pose.Rot());
    camera.takePose(stamp, {{q.W(), q.X(), q.Y(), q.Z()}, {at.X(), at.Y(), at.Z()}});
}

#ifndef SPHEREWALK_IGNITION
void CameraSystem::Reset(const sim::UpdateInfo& /*info*/, sim::EntityComponentManager& /*ecm*/) {
    m_place = sim::kNullEntity;
}
#endif

} // namespace spherewalk::gazebo

#ifdef SPHEREWALK_IGNITION
IGNITION_ADD_PLUGIN(spherewalk::gazebo::CameraSystem, ignition::gazebo::System,
                    spherewalk::gazebo::CameraSystem::ISystemConfigure,
                    spherewalk::gazebo::CameraSystem::ISystemPostUpdate)
#else
GZ_ADD_PLUGIN(spherewalk::gazebo::CameraSystem, gz::sim::System,
              spherewalk::gazebo::CameraSystem::ISystemConfigure,
              spherewalk::gazebo::CameraSystem::ISystemReset,
              spherewalk::gazebo::CameraSystem::ISystemPostUpdate)
#endif

// SPDX-License-Identifier: GPL-3.0-or-later
// How the device takes pictures, and what it tells about them.
#include "device/fault_plan.h"
#include "device/osc_device.h"
#include "photo/exposure.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/fixed_random.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"

#include <algorithm>

namespace spherewalk::practice {

namespace {

constexpr std::size_t kKeptCaptures = 64;

Json inProgress(std::string_view id) {
    Json body;
    body["name"] = "camera.takePicture";
    body["id"] = id;
    body["state"] = "inProgress";
    body["progress"] = {{"completion", 0.0}};
    return body;
}

/// Whether both settings give the same picture.
bool showTheSame(const ExposureSettings& a, const ExposureSettings& b) {
    return a.shot == b.shot && a.standing == b.standing && a.levelled == b.levelled &&
           a.nominalPositionM == b.nominalPositionM;
}

PhotoDefect defectOf(const std::optional<Fault>& fault) {
    if (!fault) {
        return PhotoDefect::None;
    }
    switch (fault->kind) {
    case FaultKind::EmptyPhoto:
        return PhotoDefect::Empty;
    case FaultKind::SmallPhoto:
        return PhotoDefect::Small;
    case FaultKind::NoMakerNote:
        return PhotoDefect::NoMakerNote;
    default:
        return PhotoDefect::HostileMakerNote;
    }
}

} // namespace

std::uint64_t LivePreview::begin() {
    const std::scoped_lock lock(m_mutex);
    return ++m_current;
}

bool LivePreview::isCurrent(std::uint64_t preview) const {
    const std::scoped_lock lock(m_mutex);
    return preview == m_current;
}

std::shared_ptr<const Bytes> LivePreview::picture(const ExposureSettings& settings, const EquirectSize& size,
                                                  const std::stop_token& stop) {
    {
        const std::scoped_lock lock(m_mutex);
        const bool isSameSize = m_shownSize.width == size.width && m_shownSize.height == size.height;
        if (m_shown && isSameSize && showTheSame(m_shownSettings, settings)) {
            return m_shown;
        }
    }
    auto drawn = std::make_shared<const Bytes>(m_exposer.preview(settings, size, stop));
    const std::scoped_lock lock(m_mutex);
    m_shownSettings = settings;
    m_shownSize = size;
    m_shown = drawn;
    return drawn;
}

OscDevice::Capture* OscDevice::capture(const std::string& id) {
    const auto found =
        std::find_if(m_captures.begin(), m_captures.end(), [&](const Capture& one) { return one.id == id; });
    return found == m_captures.end() ? nullptr : &*found;
}

OscReply OscDevice::takePicture() {
    if (m_settings.value("captureMode") != "image") {
        throw OscError(OscCode::DisabledCommand);
    }
    if (m_phase) {
        throw OscError(m_options.whenBusy == PracticeCameraOptions::WhenBusy::DeviceBusy ? OscCode::DeviceBusy
                       : m_options.whenBusy == PracticeCameraOptions::WhenBusy::ServiceUnavailable
                           ? OscCode::ServiceUnavailable
                           : OscCode::DisabledCommand);
    }
    if (m_condition.hasPlugin || m_condition.isHot) {
        throw OscError(OscCode::DisabledCommand);
    }
    if (remainingPictures() == 0) {
        m_condition.isOutOfRoom = true;
        changed();
        throw OscError(OscCode::DisabledCommand);
    }
    if (m_stop.stop_requested()) {
        throw OscError(OscCode::ServiceUnavailable);
    }
    ExposureSettings settings = settingsOfNewShot();
    settings.defect = defectOf(m_faults.take(
        {FaultKind::EmptyPhoto, FaultKind::SmallPhoto, FaultKind::NoMakerNote, FaultKind::HostileMakerNote},
        "camera.takePicture"));
    const std::string id = std::to_string(m_nextId++);
    while (m_captures.size() >= kKeptCaptures) {
        m_captures.erase(m_captures.begin());
    }
    m_captures.emplace_back().id = id;
    const double countdown = m_settings.value("exposureDelay").get<double>();
    m_phase = countdown > 0 ? Phase::Countdown : Phase::Shooting;
    m_countdown = {};
    m_preview.end();
    changed();
    const double busy = busySeconds(settings);
    m_worker = std::jthread([this, id, settings, countdown, busy](const std::stop_token& stop) {
        run(stop, id, settings, countdown, busy);
    });
    return {200, inProgress(id)};
}

ExposureSettings OscDevice::settingsOfNewShot() {
    ExposureSettings settings = settingsNow(m_storage.takeShotNumber());
    m_standing = settings.standing;
    return settings;
}

ExposureSettings OscDevice::settingsNow(int shot) const {
    ExposureSettings settings;
    settings.shot = shot;
    settings.standing = m_standing == 0 ? shot : m_standing;
    settings.nominalPositionM = m_position;
    settings.time = now();
    settings.levelled = m_settings.value("_topBottomCorrection") != "Disapply";
    settings.program = m_settings.value("exposureProgram").get<int>();
    settings.exposureTimeS = m_settings.value("shutterSpeed").get<double>();
    settings.isoSpeed = m_settings.value("iso").get<int>();
    settings.options = m_settings.exposure();
    settings.exposureBias = m_settings.value("exposureCompensation").get<double>();
    settings.hasFixedWhiteBalance = m_settings.value("whiteBalance") != "auto";
    return settings;
}

double OscDevice::busySeconds(const ExposureSettings& settings) const {
    FixedRandom random(m_options.seed, static_cast<std::uint64_t>(settings.shot));
    const Json& filter = m_settings.value("_filter");
    const double plain = filter == "hdr" || filter == "Hh hdr" ? 9 : filter == "Noise Reduction" ? 8 : 3.5;
    return plain + random.uniform(-0.5, 0.5) + 2 * settings.exposureTimeS;
}

void OscDevice::run(const std::stop_token& stop, const std::string& id, const ExposureSettings& settings,
                    double countdownS, double busyS) {
    try {
        if (countdownS > 0) {
            std::stop_token countdown;
            {
                const std::scoped_lock lock(m_mutex);
                countdown = m_countdown.get_token();
            }
            const std::chrono::duration<double> wait(countdownS * m_options.timeScale);
            m_clock.sleep(std::chrono::duration_cast<Clock::Duration>(wait), countdown);
            if (countdown.stop_requested()) {
                finish(id, Outcome::Failed, OscCode::CanceledShooting, "The self-timer was stopped.");
                return;
            }
            const std::scoped_lock lock(m_mutex);
            m_phase = Phase::Shooting;
            changed();
        }
        shoot(stop, id, settings, busyS);
    } catch (const Error& failure) {
        finish(id, Outcome::Failed, OscCode::Unexpected, failure.sentence());
    } catch (const std::exception& failure) {
        finish(id, Outcome::Failed, OscCode::Unexpected, failure.what());
    }
}

void OscDevice::shoot(const std::stop_token& stop, const std::string& id, const ExposureSettings& settings,
                      double busyS) {
    const Clock::TimePoint begin = m_clock.now();
    const auto waitUntil = [&](double share) {
        const std::chrono::duration<double> due(share * busyS * m_options.timeScale);
        const std::chrono::duration<double> left = due - (m_clock.now() - begin);
        if (left.count() > 0) {
            m_clock.sleep(std::chrono::duration_cast<Clock::Duration>(left), stop);
        }
        throwIfStopped(stop);
    };
    ExposedPhoto photo = m_exposer.expose(settings, stop);
    if (!survives("exposing")) {
        return;
    }
    waitUntil(0.8);
    {
        const std::scoped_lock lock(m_mutex);
        store(photo, settings);
        if (Capture* own = capture(id)) { // not forgotten
            own->urlPath = photo.truth.urlPath;
        }
    }
    if (!survives("written")) {
        return;
    }
    waitUntil(1);
    finish(id, Outcome::Done, OscCode::Unexpected, {});
}

void OscDevice::store(ExposedPhoto& photo, const ExposureSettings& settings) {
    photo.truth.file = m_storage.fileName(settings.shot);
    photo.truth.urlPath = m_storage.urlPath(photo.truth.file);
    TruthFile(m_truthFile).append(photo.truth); // before anybody can see the file
    m_storage.add(photo.truth.file, photo.jpeg, settings.time);
    ++m_exposures;
    changed();
}

void OscDevice::finish(const std::string& id, Outcome outcome, OscCode code, const std::string& failure) {
    const std::scoped_lock lock(m_mutex);
    if (Capture* own = capture(id)) {
        own->outcome = outcome;
        own->code = code;
        own->failure = failure;
    }
    m_phase.reset();
    changed();
}

OscReply OscDevice::status(const std::string& body, const std::string& baseUrl) {
    std::string id;
    try {
        const Json request = parseJson(body, "the request");
        if (!request.is_object() || !request.contains("id")) {
            return refusal("unknown", OscCode::MissingParameter);
        }
        id = request["id"].is_string() ? request["id"].get<std::string>() : request["id"].dump();
    } catch (const Error&) { // not JSON: the camera refuses it as such
        return refusal("unknown", OscCode::InvalidParameterValue);
    }
    const std::scoped_lock lock(m_mutex);
    meetStatusFaults();
    Capture* const found = capture(id);
    if (found == nullptr) {
        return refusal("unknown", OscCode::InvalidParameterValue);
    }
    const Capture asked = *found;
    if (asked.outcome == Outcome::Running || asked.isStuck) {
        return {200, inProgress(id)};
    }
    if (m_options.doneAnswers > 0 && ++found->answers >= m_options.doneAnswers) {
        std::erase_if(m_captures, [&](const Capture& one) { return one.id == id; });
    }
    if (asked.outcome == Outcome::Done) {
        return done("camera.takePicture", doneResults(asked, baseUrl));
    }
    OscReply reply = refusal("camera.takePicture", asked.code);
    if (asked.code == OscCode::Unexpected) {
        reply.body["error"]["message"] = asked.failure;
    }
    return reply;
}

void OscDevice::meetStatusFaults() {
    constexpr std::string_view kCall = "/osc/commands/status";
    if (m_faults.take(FaultKind::ForgetIds, kCall)) {
        m_captures.clear();
    }
    if (m_faults.take(FaultKind::StuckInProgress, kCall)) {
        for (Capture& running : m_captures) {
            running.isStuck = true;
        }
    }
}

Json OscDevice::doneResults(const Capture& capture, const std::string& baseUrl) {
    const auto fault =
        m_faults.take({FaultKind::DoneWithoutUrl, FaultKind::UrlOfOtherHost}, "/osc/commands/status");
    if (fault && fault->kind == FaultKind::DoneWithoutUrl) {
        return Json::object();
    }
    if (m_level == 1) {
        return {{"fileUri", capture.urlPath.substr(m_storage.urlFolder().size())}};
    }
    return {{"fileUrl", (fault ? "http://192.0.2.1:81" : baseUrl) + capture.urlPath}};
}

OscReply OscDevice::stopSelfTimer() {
    if (m_phase != Phase::Countdown) {
        throw OscError(OscCode::DisabledCommand);
    }
    m_countdown.request_stop();
    return done("camera._stopSelfTimer");
}

} // namespace spherewalk::practice

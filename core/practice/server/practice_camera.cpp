// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/practice/practice_camera.h"

#include "server/camera_server.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"

#include <cmath>
#include <utility>

namespace spherewalk::practice {

namespace {

void require(bool isGood, const std::string& sentence) {
    if (!isGood) {
        throw Error(ErrorKind::InvalidInput, "Could not make the practice camera: " + sentence);
    }
}

} // namespace

void PracticeCameraOptions::validate() const {
    require(!host.empty(), "it needs an address to listen on, such as 127.0.0.1.");
    require(port >= 0 && port <= 65535, text("the port must be between 0 and 65535, not ", port, "."));
    require(timeScale >= 0 && timeScale <= 100,
            text("the time scale must be between 0 (no waiting) and 100, not ", timeScale, "."));
    require(width >= 512 && width <= 16384 && width % 2 == 0,
            text("the photos' width must be an even number between 512 and 16384, not ", width, "."));
    require(jpegQuality >= 1 && jpegQuality <= 100,
            text("the JPEG quality must be between 1 and 100, not ", jpegQuality, "."));
    require(doneAnswers >= 0, text("an id must answer 0 (for ever) or more times, not ", doneAnswers, "."));
    require(threads >= 0, text("the number of threads must be 0 (all) or more, not ", threads, "."));
    require(positionM.allFinite(), "the cart's position must be three finite numbers.");
    require(photoFolder.empty() == photos.empty(),
            "a folder of photos needs a list of their positions, and the other way round.");
    for (const PlacedPhoto& photo : photos) {
        require(
            isSafeRelativePath(photo.file) && photo.positionM.allFinite(),
            text("the photo \"", printable(photo.file), "\" needs a path inside its folder and a position."));
    }
    require(digestUser.empty() == digestPassword.empty(),
            "digest authentication needs a user and a password.");
    require(nonceRequests >= 0,
            text("a nonce must be good for 0 (for ever) or more requests, not ", nonceRequests, "."));
    errors.validate();
    flaws.validate();
    room.validate();
}

struct PracticeCamera::State {
    State(PracticeCameraOptions given, Clock& clock)
        : options(std::move(given)), device(options, faults, clock), server(device, faults, options) {}

    PracticeCameraOptions options;
    FaultPlan faults;
    OscDevice device;
    CameraServer server;
};

PracticeCamera::PracticeCamera(PracticeCameraOptions options, Clock& clock) {
    options.validate();
    m_state = std::make_unique<State>(std::move(options), clock);
}

PracticeCamera::~PracticeCamera() = default;

void PracticeCamera::start() {
    m_state->server.start();
}

void PracticeCamera::stop() {
    m_state->server.finish();
}

int PracticeCamera::port() const {
    return m_state->server.port();
}

std::string PracticeCamera::url() const {
    return text("http://", m_state->options.host, ":", port());
}

void PracticeCamera::setPosition(const Eigen::Vector3d& positionM) {
    require(positionM.allFinite(), "the cart's position must be three finite numbers.");
    m_state->device.setPosition(positionM);
}

void PracticeCamera::arm(const Fault& fault) {
    m_state->faults.arm(fault);
}

void PracticeCamera::befall(const Fault& fault) {
    fault.validate();
    require(isOfCamera(fault.kind),
            text("\"", name(fault.kind), "\" happens to requests, not to the camera."));
    m_state->device.meet(fault);
}

void PracticeCamera::disarm() {
    m_state->faults.clear();
    m_state->device.meet({FaultKind::NoMoreTrouble, ""});
}

PracticeCameraStats PracticeCamera::stats() const {
    return m_state->server.stats();
}

std::filesystem::path PracticeCamera::truthFile() const {
    return m_state->device.truthFile();
}

std::filesystem::path PracticeCamera::storageFolder() const {
    return m_state->device.storageFolder();
}

} // namespace spherewalk::practice

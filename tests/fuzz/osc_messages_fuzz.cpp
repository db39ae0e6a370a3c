// SPDX-License-Identifier: GPL-3.0-or-later
// Input: a camera's answer. Whatever it says, it is read, or refused as Corrupt; what was read keeps to the
// ranges that the header states.
#include "spherewalk/base/bytes.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/json.h"
#include "spherewalk/camera/osc_error.h"
#include "spherewalk/camera/osc_messages.h"

#include <cstdlib>

using namespace spherewalk;

namespace {

void require(bool holds) {
    if (!holds) {
        std::abort();
    }
}

/// False if it was refused.
template <class Read>
bool isRead(const Read& read) {
    try {
        read();
        return true;
    } catch (const Error& error) {
        require(error.kind() == ErrorKind::Corrupt && !error.sentence().empty());
        return false;
    }
}

void readAll(const Json& json) {
    isRead([&] {
        const camera::CameraInfo info = camera::parseCameraInfo(json);
        require(!info.model.empty() && !info.serialNumber.empty());
        info.hasApiLevel(2);
    });
    isRead([&] {
        const camera::CameraState state = camera::parseCameraState(json);
        require(!state.batteryFraction || (*state.batteryFraction >= 0 && *state.batteryFraction <= 1));
        state.isIdle();
        for (const std::string& code : state.errors) {
            require(!camera::describeCameraError(code).sentence.empty());
        }
    });
    isRead([&] {
        const camera::CommandReply reply = camera::parseCommandReply(json);
        require(reply.state != camera::CommandReply::State::InProgress || !reply.id.empty());
        reply.fileUrl();
        require(!camera::refusal("ask the camera", reply.error, reply.errorMessage).sentence().empty());
        isRead([&] { camera::parseFileList(reply.results); });
    });
    isRead([&] {
        for (const camera::FileEntry& entry : camera::parseFileList(json).entries) {
            require(!entry.fileUrl.empty() && entry.width >= 0 && entry.height >= 0);
        }
    });
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const ByteView bytes(data, size);
    Json json;
    if (isRead([&] { json = parseJson(textOf(bytes), "the camera's answer"); })) {
        readAll(json);
    }
    return 0;
}

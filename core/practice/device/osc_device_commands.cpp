// SPDX-License-Identifier: GPL-3.0-or-later
// The commands that the device knows, level by level, and its options.
#include "device/osc_device.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/json.h"

namespace spherewalk::practice {

namespace {

const Json& noParameters() {
    static const Json none = Json::object();
    return none;
}

} // namespace

OscReply OscDevice::execute(const Json& request, const std::string& baseUrl) {
    const std::string command = request.is_object() && request.contains("name") && request["name"].is_string()
                                    ? request["name"].get<std::string>()
                                    : "unknown";
    try {
        const Json& parameters =
            request.is_object() && request.contains("parameters") ? request["parameters"] : noParameters();
        if (!parameters.is_object()) {
            throw OscError(OscCode::InvalidParameterValue);
        }
        const std::scoped_lock lock(m_mutex);
        return m_level == 1 ? executeLevelOne(command, parameters)
                            : executeLevelTwo(command, parameters, baseUrl);
    } catch (const OscError& error) {
        return refusal(error.code() == OscCode::UnknownCommand ? "unknown" : command, error.code());
    } catch (const Error& failure) {
        OscReply reply = refusal(command, OscCode::Unexpected);
        reply.body["error"]["message"] = failure.sentence();
        return reply;
    }
}

OscReply OscDevice::executeLevelTwo(const std::string& command, const Json& parameters,
                                    const std::string& baseUrl) {
    if (command == "camera.listFiles") {
        return done(command, listedFiles(m_storage, parameters, baseUrl));
    }
    if (command == "camera.delete") {
        deleteFiles(m_storage, parameters);
        m_condition.isOutOfRoom = false;
        changed();
        return done(command);
    }
    if (command == "camera.reset") {
        m_settings.reset();
        changed();
        return done(command);
    }
    return executeAnyLevel(command, parameters);
}

OscReply OscDevice::executeLevelOne(const std::string& command, const Json& parameters) {
    if (command == "camera.startSession" || command == "camera.listImages") {
        if (parameters.contains("sessionId")) {
            throw OscError(OscCode::InvalidParameterName);
        }
        if (command == "camera.listImages") {
            return done(command, listedImages(m_storage, parameters));
        }
        const std::string id = m_session.start();
        m_preview.end();
        return done(command, {{"sessionId", id}, {"timeout", OscSession::kTimeoutS}});
    }
    if (command == "camera.listFiles" || command == "camera.reset") { // of level 2
        throw OscError(OscCode::UnknownCommand);
    }
    m_session.use(parameters);
    if (command == "camera.updateSession") {
        return done(command, {{"sessionId", m_session.id()}, {"timeout", OscSession::kTimeoutS}});
    }
    if (command == "camera.closeSession") {
        m_session.end();
        return done(command);
    }
    return executeAnyLevel(command, parameters);
}

OscReply OscDevice::executeAnyLevel(const std::string& command, const Json& parameters) {
    if (command == "camera.takePicture") {
        return takePicture();
    }
    if (command == "camera.getOptions") {
        return getOptions(parameters);
    }
    if (command == "camera.setOptions") {
        return setOptions(parameters);
    }
    if (command == "camera._stopSelfTimer") {
        return stopSelfTimer();
    }
    throw OscError(OscCode::UnknownCommand);
}

OscReply OscDevice::getOptions(const Json& parameters) const {
    const Json& names = required(parameters, "optionNames");
    if (!names.is_array() || names.size() > 256) {
        throw OscError(OscCode::InvalidParameterValue);
    }
    const ZonedTime time = now();
    const std::map<std::string, Json> readOnly = {
        {"aperture", 2.0},
        {"apertureSupport", Json::array({2.0})},
        {"_latestEnabledExposureDelayTime", 5},
        {"remainingPictures", remainingPictures()},
        {"remainingSpace", remainingBytes()},
        {"totalSpace", m_options.storageBytes},
        {"remainingVideoSeconds", remainingBytes() / 7'000'000},
        {"dateTimeZone", exifTime(time) + zoneText(time.zone)},
        {"_networkType", "AP"},
    };
    Json values = m_settings.get(names, readOnly);
    if (m_condition.saysUnknownThings) {
        values["_newThing"] = {{"d", true}};
    }
    return done("camera.getOptions", Json{{"options", values}});
}

OscReply OscDevice::setOptions(const Json& parameters) {
    const Json& options = required(parameters, "options");
    if (!options.is_object() || options.empty()) {
        throw OscError(OscCode::InvalidParameterValue);
    }
    if (options.contains("clientVersion") && m_level == 1) {
        if (m_options.model == CameraModel::LevelOne) {
            throw OscError(OscCode::InvalidParameterName);
        }
        m_settings.set(options);
        m_level = 2;
        m_session.end();
        changed();
        return done("camera.setOptions");
    }
    m_settings.set(options);
    if (options.contains("captureMode") || options.contains("previewFormat")) {
        m_preview.end();
    }
    if (options.contains("dateTimeZone")) {
        const ZonedTime set = *parseDateTimeZone(options["dateTimeZone"].get<std::string>());
        m_clockOffset = set.utc - m_clock.utc();
        m_zone = set.zone;
        m_condition.isClockUnset = false;
    }
    changed();
    return done("camera.setOptions");
}

} // namespace spherewalk::practice

// SPDX-License-Identifier: Apache-2.0
#include "c/interface.h"

#include "c/enums.h"

#include "spherewalk/geometry/rotation.h"

#include <exception>
#include <filesystem>
#include <new>
#include <string_view>

namespace spherewalk::render {

namespace {

/// A sentence in memory that exists already, as there may be none left.
struct Sentence {
    static constexpr std::size_t kMost = 4000;
    std::array<char, kMost + 1> characters{};

    void keep(std::string_view sentence) noexcept {
        if (sentence.size() > kMost) {
            std::size_t end = kMost;
            while (end > 0 && (static_cast<unsigned char>(sentence[end]) & 0xc0) == 0x80) {
                --end; // to where a character of several bytes begins
            }
            sentence = sentence.substr(0, end);
        }
        std::copy(sentence.begin(), sentence.end(), characters.begin());
        characters.at(sentence.size()) = '\0';
    }
};

thread_local Sentence lastError;

/// of: the conversion from the number. The names of enumerations are literals, which end with NUL.
template <class Enum>
const char* nameOfNumber(Enum (*of)(std::int32_t), std::int32_t number) noexcept {
    try {
        return name(of(number)).data();
    } catch (const Error&) {
        return "unknown";
    }
}

spherewalk_status keep(spherewalk_status status, std::string_view sentence) noexcept {
    lastError.keep(sentence);
    return status;
}

} // namespace

spherewalk_status failure() noexcept {
    try {
        throw;
    } catch (const Error& error) {
        return keep(cStatus(error.kind()), error.sentence());
    } catch (const std::bad_alloc&) {
        return keep(SPHEREWALK_FULL, "There is not enough memory; ask for a smaller view, or give the "
                                     "renderer fewer cache_bytes.");
    } catch (const std::filesystem::filesystem_error& error) {
        return keep(SPHEREWALK_IO, error.what());
    } catch (const std::exception& error) {
        return keep(SPHEREWALK_INTERNAL, error.what());
    } catch (...) {
        return keep(SPHEREWALK_INTERNAL, "A function that the caller gave has thrown what is no error.");
    }
}

void checkGiven(const void* pointer, const char* name) {
    if (pointer == nullptr) {
        throw Error(ErrorKind::InvalidInput, text("The argument ", name, " is NULL, which it must not be."));
    }
}

void checkReserved(std::int32_t reserved) {
    if (reserved != 0) {
        throw Error(ErrorKind::InvalidInput,
                    text("A member that is reserved for later versions is ", reserved, ", and must be 0."));
    }
}

Rigid3 rigid3(const spherewalk_pose& pose) {
    return {Eigen::Quaterniond(pose.qw, pose.qx, pose.qy, pose.qz), {pose.x, pose.y, pose.z}};
}

spherewalk_pose cPose(const Rigid3& pose) {
    const auto& [rotation, position] = pose;
    return {position.x(), position.y(), position.z(), rotation.w(), rotation.x(), rotation.y(), rotation.z()};
}

extern "C" {

const char* spherewalk_version(void) {
    static const std::string version =
        text(SPHEREWALK_VERSION_MAJOR, ".", SPHEREWALK_VERSION_MINOR, ".", SPHEREWALK_VERSION_PATCH);
    return version.c_str();
}

int32_t spherewalk_version_number(void) {
    return SPHEREWALK_VERSION_NUMBER;
}

const char* spherewalk_status_name(spherewalk_status status) {
    if (status == SPHEREWALK_OK) {
        return "ok";
    }
    const auto kind = errorKindOf(status);
    return kind ? name(*kind).data() : "unknown";
}

const char* spherewalk_last_error(void) {
    return lastError.characters.data();
}

spherewalk_status spherewalk_optical_pose(const spherewalk_pose* room_from_body,
                                          spherewalk_pose* room_from_camera) {
    return guarded([&] {
        const auto [x, y, z, qw, qx, qy, qz] = given(room_from_body, "room_from_body");
        spherewalk_pose& result = given(room_from_camera, "room_from_camera");
        const Eigen::Quaterniond roomFromBody = checkedQuaternion(qw, qx, qy, qz, "the body");
        result = cPose({(roomFromBody * bodyFromOptical()).normalized(), {x, y, z}});
    });
}

const char* spherewalk_scene_name(int32_t scene) {
    const auto known = [](std::int32_t number) { return sceneOf(number).value(); };
    return scene == SPHEREWALK_SCENE_BEST ? "best" : nameOfNumber<SceneKind>(known, scene);
}

const char* spherewalk_sampling_name(int32_t sampling) {
    return nameOfNumber(samplingOf, sampling);
}

const char* spherewalk_origin_name(int32_t origin) {
    return nameOfNumber(originOf, origin);
}

const char* spherewalk_late_name(int32_t late) {
    return nameOfNumber(lateOf, late);
}

} // extern "C"

} // namespace spherewalk::render

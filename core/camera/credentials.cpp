// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/camera/credentials.h"

#include <memory>
#include <utility>

namespace spherewalk::camera {

void CredentialsMemory::set(const Credentials& credentials) {
    const std::scoped_lock lock(m_mutex);
    m_credentials = credentials;
    ++m_revision;
}

std::optional<Credentials> CredentialsMemory::newer(int& given) const {
    const std::scoped_lock lock(m_mutex);
    return std::exchange(given, m_revision) < m_revision ? m_credentials : std::nullopt;
}

CredentialsSource rememberingCredentials(CredentialsSource ask) {
    struct Shared {
        std::mutex asking;
        CredentialsMemory memory;
    };

    return [ask = std::move(ask), shared = std::make_shared<Shared>(), given = 0]() mutable {
        const std::scoped_lock lock(shared->asking);
        if (auto known = shared->memory.newer(given)) {
            return known;
        }
        if (const auto said = ask()) {
            shared->memory.set(*said);
        }
        return shared->memory.newer(given);
    };
}

} // namespace spherewalk::camera

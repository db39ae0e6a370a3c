// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json.h"
#include "spherewalk/camera/endpoint.h"

#include <filesystem>

namespace spherewalk::camera {

/// The session of API level 1 that this user's programs have with the camera of an address, kept in a file
/// until it is closed. A program that was killed leaves the note to the next. A note that cannot be kept is
/// missed only then, so no function throws for that.
class SessionNote {
  public:
    explicit SessionNote(const Endpoint& endpoint);

    void write(const Json& session) const;
    void clear() const;
    /// Null without a note, and while the program that wrote the note runs, unless it is this one.
    Json read() const;

  private:
    std::filesystem::path m_file;
};

} // namespace spherewalk::camera

// SPDX-License-Identifier: GPL-3.0-or-later
#include "service_browser.h"

namespace spherewalk::camera {

BrowseReport browseForCameras(std::chrono::milliseconds /*time*/, const std::stop_token& /*stop*/) {
    return {{},
            "Announcements on the network were not listened for, as this program was built without Avahi."};
}

} // namespace spherewalk::camera

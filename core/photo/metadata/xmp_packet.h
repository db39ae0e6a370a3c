// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/bytes.h"
#include "spherewalk/jpeg/jpeg.h"

#include <exiv2/xmp_exiv2.hpp>

#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk::photo {

/// What an APP1 segment's content begins with when it holds Exif or XMP.
std::string_view exifSignature();
std::string_view xmpSignature();

/// The first APP1 segment with this signature, or null.
const jpeg::Segment* findApp1(const std::vector<jpeg::Segment>& segments, ByteView jpeg,
                              std::string_view signature);

/// The use of exiv2's XMP toolkit by one thread at a time. The toolkit keeps a global registry of namespaces
/// and takes into it whatever a packet declares, under the prefix that the packet chose; each session begins
/// with a clean one, so that no photo can spoil the reading of the next. Threads: a second session waits for
/// the first to end, so keep it short and never nest two.
class XmpSession {
  public:
    /// Errors: Internal if exiv2 cannot be initialised.
    XmpSession();
    ~XmpSession() = default;
    XmpSession(const XmpSession&) = delete;
    XmpSession& operator=(const XmpSession&) = delete;

    /// The properties of an XMP packet. Errors: Corrupt; also for XML that nests deep, defines entities, or
    /// takes our prefix or GPano's for another namespace, none of which a camera does.
    Exiv2::XmpData decoded(ByteView packet, std::string_view source) const;

    /// A packet of these properties, as XML elements. Range: properties of this session. Errors: Internal.
    std::string encoded(const Exiv2::XmpData& properties) const;

    /// The value of a property as text, nothing if it is missing.
    std::optional<std::string> value(const Exiv2::XmpData& properties, const std::string& key) const;

  private:
    std::unique_lock<std::mutex> m_lock;
};

/// Makes exiv2 ready for use from any thread, its log silent. Every function that calls exiv2 without an
/// XmpSession begins with it; all but the first call cost nothing.
void prepareExiv2();

} // namespace spherewalk::photo

// SPDX-License-Identifier: GPL-3.0-or-later
#include "metadata/xmp_packet.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/photo/position_tag.h"

#include <exiv2/error.hpp>
#include <exiv2/properties.hpp>

#include <algorithm>
#include <exception>
#include <mutex>

namespace spherewalk::photo {

namespace {

using namespace std::string_view_literals;

constexpr int kMaxDepth = 64;

/// exiv2 does not promise that its XMP toolkit can be used by two threads at a time.
std::mutex& toolkitMutex() {
    static std::mutex mutex;
    return mutex;
}

void lockNamespaces(void*, bool lock) {
    static std::mutex mutex;
    if (lock) {
        mutex.lock();
    } else {
        mutex.unlock();
    }
}

bool initialiseExiv2() {
    Exiv2::LogMsg::setLevel(Exiv2::LogMsg::mute);
    return Exiv2::XmpParser::initialize(lockNamespaces, nullptr);
}

bool hasPrefixesOfItsOwn() {
    return Exiv2::XmpProperties::ns("spherewalk") == kTagNamespace &&
           Exiv2::XmpProperties::ns("GPano") == "http://ns.google.com/photos/1.0/panorama/";
}

/// How far the first '<' of the rest leads: 1 into an element, -1 out of one, 0 neither; nothing if it must
/// not be there. The rest then begins behind the tag.
std::optional<int> takeTag(std::string_view& rest) {
    const auto passOver = [&](std::string_view end) {
        const std::size_t at = rest.find(end);
        rest = at == std::string_view::npos ? std::string_view() : rest.substr(at + end.size());
    };
    if (rest.starts_with("<!--")) {
        passOver("-->");
        return 0;
    }
    if (rest.starts_with("<!")) {
        return std::nullopt; // DOCTYPE, ENTITY, CDATA
    }
    if (rest.starts_with("<?")) {
        passOver("?>");
        return 0;
    }
    const bool isEnd = rest.starts_with("</");
    char quote = 0;
    for (std::size_t i = 1; i < rest.size(); ++i) {
        if (quote == 0 && rest[i] == '>') {
            const bool isEmpty = rest[i - 1] == '/';
            rest.remove_prefix(i + 1);
            return isEnd ? -1 : isEmpty ? 0 : 1;
        }
        if (rest[i] == quote) {
            quote = 0;
        } else if (quote == 0 && !isEnd && (rest[i] == '"' || rest[i] == '\'')) {
            quote = rest[i];
        }
    }
    rest = {};
    return 0;
}

/// True if a recursive parser survives the packet: UTF-8, no entities, not deep.
bool isHarmless(std::string_view packet) {
    if (packet.find('\0') != std::string_view::npos) {
        return false; // UTF-16 or UTF-32, or no text at all
    }
    int depth = 0;
    for (;;) {
        const std::size_t tag = packet.find('<');
        if (tag == std::string_view::npos) {
            return true;
        }
        packet.remove_prefix(tag);
        const std::optional<int> step = takeTag(packet);
        if (!step) {
            return false;
        }
        depth += *step;
        if (depth > kMaxDepth) {
            return false;
        }
    }
}

} // namespace

void prepareExiv2() {
    static const bool isReady = initialiseExiv2();
    if (!isReady) {
        throw Error(ErrorKind::Internal,
                    "The XMP toolkit of exiv2 could not be initialised; check its installation.");
    }
}

std::string_view exifSignature() {
    return "Exif\0\0"sv;
}

std::string_view xmpSignature() {
    return "http://ns.adobe.com/xap/1.0/\0"sv;
}

const jpeg::Segment* findApp1(const std::vector<jpeg::Segment>& segments, ByteView jpeg,
                              std::string_view signature) {
    const auto found = std::ranges::find_if(segments, [&](const jpeg::Segment& segment) {
        return segment.marker == jpeg::kApp1 && textOf(segment.content(jpeg)).starts_with(signature);
    });
    return found == segments.end() ? nullptr : &*found;
}

XmpSession::XmpSession() : m_lock(toolkitMutex()) {
    prepareExiv2();
    try {
        Exiv2::XmpProperties::unregisterNs();
        Exiv2::XmpProperties::registerNs(std::string(kTagNamespace), "spherewalk");
    } catch (const std::exception& error) {
        throw Error(ErrorKind::Internal,
                    "The namespaces of exiv2 could not be set up; check its installation.",
                    printable(error.what()));
    }
}

Exiv2::XmpData XmpSession::decoded(ByteView packet, std::string_view source) const {
    const auto fail = [&](std::string_view why) {
        throw Error(ErrorKind::Corrupt, text("Could not read the XMP of ", source, ": ", why, "."));
    };
    std::string_view xml = textOf(packet);
    while (xml.ends_with('\0')) {
        xml.remove_suffix(1); // some programs pad with NULs
    }
    if (!isHarmless(xml)) {
        fail("it is no plain XML of a reasonable depth");
    }
    Exiv2::XmpData properties;
    try {
        if (Exiv2::XmpParser::decode(properties, std::string(xml)) != 0) {
            fail("it is damaged");
        }
        if (!hasPrefixesOfItsOwn()) {
            fail("it takes the prefix of a known namespace for another");
        }
    } catch (const Error&) {
        throw;
    } catch (const std::exception& error) {
        fail(printable(error.what()));
    }
    return properties;
}

std::string XmpSession::encoded(const Exiv2::XmpData& properties) const {
    // Elements, as Ricoh writes them, and little padding: nobody edits the packet in place.
    constexpr std::uint16_t kElements = 0;
    constexpr std::uint32_t kPadding = 16;
    std::string packet;
    std::string reason;
    try {
        if (Exiv2::XmpParser::encode(packet, properties, kElements, kPadding) == 0) {
            return packet;
        }
    } catch (const std::exception& error) {
        reason = error.what();
    }
    throw Error(ErrorKind::Internal, "Could not write XMP; please report this with the photo.",
                printable(reason));
}

std::optional<std::string> XmpSession::value(const Exiv2::XmpData& properties, const std::string& key) const {
    try {
        const auto found = properties.findKey(Exiv2::XmpKey(key));
        return found == properties.end() ? std::nullopt : std::optional(found->toString());
    } catch (const std::exception& error) {
        // The key's namespace is built in or registered above, so that this is a defect, not the photo's
        // fault.
        throw Error(ErrorKind::Internal, text("The XMP property ", key, " cannot be looked up."),
                    printable(error.what()));
    }
}

} // namespace spherewalk::photo

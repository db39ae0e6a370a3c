// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/photo/integrity.h"

#include "spherewalk/base/digest.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/photo/metadata.h"

#include <algorithm>
#include <array>

namespace spherewalk::photo {

namespace {

// A Theta X writes some 12 MB; this leaves room for larger cameras.
constexpr std::uint64_t kMostPhotoBytes = 512ULL << 20;

[[noreturn]] void fail(std::string_view source, std::string_view defect,
                       std::string_view cure = "fetch it from the camera again") {
    throw Error(ErrorKind::Corrupt, text("The photo ", source, " is not usable: ", defect, "; ", cure, "."));
}

/// How files of another kind begin.
struct FileKind {
    std::string_view name;
    std::size_t at = 0;
    std::string_view begins;
};

/// The kind of picture that the file is instead of a JPEG; "" for an unknown one.
std::string_view otherKind(ByteView file) {
    using namespace std::string_view_literals;
    constexpr std::array kKinds{FileKind{"a PNG", 0, "\x89PNG"sv},
                                FileKind{"a HEIF picture", 4, "ftyphei"sv},
                                FileKind{"a HEIF picture", 4, "ftypmif"sv},
                                FileKind{"an AVIF picture", 4, "ftypavi"sv},
                                FileKind{"an MP4 video", 4, "ftyp"sv},
                                FileKind{"a TIFF or a raw picture", 0, "II*\0"sv},
                                FileKind{"a TIFF or a raw picture", 0, "MM\0*"sv},
                                FileKind{"a WebP picture", 8, "WEBP"sv}};
    const std::string head(textOf(file.first(std::min<std::size_t>(file.size(), 16))));
    for (const FileKind& kind : kKinds) {
        if (head.size() >= kind.at && head.compare(kind.at, kind.begins.size(), kind.begins) == 0) {
            return kind.name;
        }
    }
    return "";
}

/// Without the zeros or ones that some cameras fill the last block with.
ByteView withoutPadding(ByteView jpeg) {
    while (!jpeg.empty() && (jpeg.back() == 0x00 || jpeg.back() == 0xFF)) {
        jpeg = jpeg.first(jpeg.size() - 1);
    }
    return jpeg;
}

void checkBytes(ByteView jpeg, std::string_view source, const PhotoExpectation& expectation,
                const std::string& sha256) {
    if (expectation.sizeBytes && jpeg.size() != *expectation.sizeBytes) {
        fail(source, text("it has ", jpeg.size(), " bytes instead of ", *expectation.sizeBytes));
    }
    if (jpeg.size() < 4 || jpeg[0] != 0xFF || jpeg[1] != jpeg::kSoi) {
        const std::string_view kind = otherKind(jpeg);
        if (!kind.empty()) {
            fail(source, text("it is ", kind, " and not a JPEG"), "save it as a JPEG of the same size");
        }
        fail(source, "it is not a JPEG");
    }
    const ByteView whole = withoutPadding(jpeg);
    if (whole.size() < 4 || whole[whole.size() - 2] != 0xFF || whole.back() != jpeg::kEoi) {
        fail(source, "its end is missing");
    }
    if (expectation.sha256 && sha256 != *expectation.sha256) {
        fail(source, "its bytes are not those that were recorded (the SHA-256 differs)");
    }
}

[[noreturn]] void failShape(ByteView jpeg, const jpeg::Info& info, std::string_view source) {
    const std::string size = text(info.width, " x ", info.height, " pixels");
    const PhotoMetadata metadata = readMetadata(jpeg, source);
    const auto& panorama = metadata.panorama;
    if (panorama && panorama->fullWidth && panorama->fullHeight &&
        (*panorama->fullWidth > info.width || *panorama->fullHeight > info.height)) {
        fail(source,
             text("it is a part of a panorama, ", size, " of ", *panorama->fullWidth, " x ",
                  *panorama->fullHeight),
             "export the whole sphere");
    }
    if (info.height == 2 * info.width) {
        fail(source, text("it lies on its side, with ", size), "turn it upright and save it again");
    }
    fail(source, text("it is not spherical, its ", size, " are not twice as wide as high"),
         "take or export it as a whole stitched sphere");
}

void checkShape(ByteView jpeg, const jpeg::Info& info, std::string_view source,
                const PhotoExpectation& expectation) {
    if (info.width != 2 * info.height) {
        failShape(jpeg, info, source);
    }
    if (info.width < expectation.minWidth) {
        fail(source, text("it is only ", info.width, " pixels wide, as a preview is; at least ",
                          expectation.minWidth, " are needed"));
    }
}

} // namespace

PhotoFacts checkPhoto(ByteView jpeg, std::string_view source, const PhotoExpectation& expectation) {
    PhotoFacts facts;
    facts.sizeBytes = jpeg.size();
    facts.sha256 = sha256Hex(jpeg);
    checkBytes(jpeg, source, expectation, facts.sha256);
    const jpeg::Info info = jpeg::readInfo(jpeg, source);
    checkShape(jpeg, info, source, expectation);
    jpeg::decode(jpeg, source, 8);
    facts.width = info.width;
    facts.height = info.height;
    return facts;
}

PhotoFacts checkPhotoFile(const std::filesystem::path& file, const PhotoExpectation& expectation) {
    return checkPhoto(readFile(file, kMostPhotoBytes), file.string(), expectation);
}

} // namespace spherewalk::photo

// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/photo/integrity.h"

#include "spherewalk/base/digest.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jpeg/jpeg.h"

namespace spherewalk::photo {

namespace {

// A Theta X writes some 12 MB; this leaves room for larger cameras.
constexpr std::uint64_t kMostPhotoBytes = 512ULL << 20;

[[noreturn]] void fail(std::string_view source, std::string_view defect) {
    throw Error(ErrorKind::Corrupt,
                text("The photo ", source, " is not usable: ", defect, "; fetch it from the camera again."));
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

void checkShape(const jpeg::Info& info, std::string_view source, const PhotoExpectation& expectation) {
    if (info.width != 2 * info.height) {
        fail(source, text("it is not spherical, its ", info.width, " x ", info.height,
                          " pixels are not twice as wide as high"));
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
    checkShape(info, source, expectation);
    jpeg::decode(jpeg, source, 8);
    facts.width = info.width;
    facts.height = info.height;
    return facts;
}

PhotoFacts checkPhotoFile(const std::filesystem::path& file, const PhotoExpectation& expectation) {
    return checkPhoto(readFile(file, kMostPhotoBytes), file.string(), expectation);
}

} // namespace spherewalk::photo

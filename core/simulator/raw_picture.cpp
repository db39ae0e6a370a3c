// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/simulator/raw_picture.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <initializer_list>

namespace spherewalk::simulator {

namespace {

static_assert(std::endian::native == std::endian::little, "Pictures are taken as little-endian machines do.");

/// How the bytes of a pixel lie.
struct Layout {
    std::string_view encoding;
    std::size_t bytesPerPixel;
    std::array<std::size_t, 3> from; ///< the bytes of the pixel's values in turn
};

const Layout& layoutOf(const RawPicture& picture, std::string_view whose,
                       const std::initializer_list<Layout>& known) {
    std::string list;
    for (const Layout& layout : known) {
        if (layout.encoding == picture.encoding) {
            return layout;
        }
        list += text(list.empty() ? "" : ", ", layout.encoding);
    }
    throw Error(ErrorKind::Unsupported, text("A ", whose, " picture came as \"", printable(picture.encoding),
                                             "\" and was not used; it can be ", list, "."));
}

void checkSize(const RawPicture& picture, std::string_view whose, const CameraIntrinsics& camera,
               std::size_t bytesPerPixel) {
    if (picture.width != camera.width || picture.height != camera.height) {
        throw Error(ErrorKind::InvalidInput,
                    text("A ", whose, " picture of ", picture.width, " x ", picture.height,
                         " pixels came and was not used; the camera has ", camera.width, " x ", camera.height,
                         ". Give the simulator's camera the same size."));
    }
    const std::size_t row = static_cast<std::size_t>(camera.width) * bytesPerPixel;
    const std::size_t step = picture.stepBytes == 0 ? row : picture.stepBytes;
    const auto before = static_cast<std::size_t>(camera.height - 1); // rows
    if (step < row || step > picture.bytes.size() || picture.bytes.size() < row ||
        (before > 0 && step > (picture.bytes.size() - row) / before)) {
        throw Error(ErrorKind::InvalidInput,
                    text("A ", whose, " picture of ", picture.bytes.size(), " bytes in rows of ", step,
                         " came and was not used; ", camera.width, " x ", camera.height, " pixels of ",
                         bytesPerPixel, " bytes do not fit."));
    }
}

const std::uint8_t* rowOf(const RawPicture& picture, int y, std::size_t rowBytes) {
    return picture.bytes.data() +
           static_cast<std::size_t>(y) * (picture.stepBytes == 0 ? rowBytes : picture.stepBytes);
}

template <class Picture>
Picture bytesOf(const RawPicture& picture, const CameraIntrinsics& camera, const Layout& layout) {
    Picture result(camera.width, camera.height);
    const std::size_t rowBytes = static_cast<std::size_t>(camera.width) * layout.bytesPerPixel;
    for (int y = 0; y < camera.height; ++y) {
        const std::uint8_t* from = rowOf(picture, y, rowBytes);
        std::uint8_t* to = result.at(0, y);
        for (int x = 0; x < camera.width; ++x, from += layout.bytesPerPixel, to += Picture::kChannels) {
            for (std::size_t c = 0; c < Picture::kChannels; ++c) {
                to[c] = from[layout.from[c]];
            }
        }
    }
    return result;
}

template <class Value>
DepthImage scaledOf(const RawPicture& picture, const CameraIntrinsics& camera, float metres) {
    DepthImage result(camera.width, camera.height);
    const std::size_t rowBytes = static_cast<std::size_t>(camera.width) * sizeof(Value);
    for (int y = 0; y < camera.height; ++y) {
        const std::uint8_t* from = rowOf(picture, y, rowBytes);
        for (float& depth : result.row(y)) {
            Value value;
            std::memcpy(&value, from, sizeof value);
            from += sizeof value;
            depth = metres * static_cast<float>(value);
        }
    }
    return result;
}

} // namespace

RgbImage colourOf(const RawPicture& picture, const CameraIntrinsics& camera) {
    const Layout& layout = layoutOf(
        picture, "colour",
        {{"rgb8", 3, {0, 1, 2}}, {"bgr8", 3, {2, 1, 0}}, {"rgba8", 4, {0, 1, 2}}, {"bgra8", 4, {2, 1, 0}}});
    checkSize(picture, "colour", camera, layout.bytesPerPixel);
    return bytesOf<RgbImage>(picture, camera, layout);
}

DepthImage depthOf(const RawPicture& picture, const CameraIntrinsics& camera) {
    const Layout& layout = layoutOf(picture, "depth", {{"32FC1", 4, {}}, {"16UC1", 2, {}}});
    checkSize(picture, "depth", camera, layout.bytesPerPixel);
    if (picture.isBigEndian) {
        throw Error(ErrorKind::Unsupported, "A depth picture came with its highest bytes first and was not "
                                            "used; publish it as little-endian machines do.");
    }
    return layout.bytesPerPixel == 4 ? scaledOf<float>(picture, camera, 1.0F)
                                     : scaledOf<std::uint16_t>(picture, camera, 0.001F);
}

MaskImage labelsOf(const RawPicture& picture, const CameraIntrinsics& camera) {
    const Layout& layout =
        layoutOf(picture, "label", {{"mono8", 1, {}}, {"8UC1", 1, {}}, {"rgb8", 3, {}}, {"8UC3", 3, {}}});
    checkSize(picture, "label", camera, layout.bytesPerPixel);
    return bytesOf<MaskImage>(picture, camera, layout);
}

} // namespace spherewalk::simulator

// SPDX-License-Identifier: Apache-2.0
#include "c_view.h"

#include "c_enums.h"
#include "c_interface.h"

#include <cmath>

namespace spherewalk::render {

namespace {

constexpr int kMostThreads = 4096;

/// Errors: InvalidInput if rows of so many bytes do not fit; what: the buffer, for the sentence. No product
/// here can exceed 64 bits unnoticed.
void checkBuffer(const spherewalk_buffer& buffer, std::uint64_t rowBytes, int height, const char* what) {
    const auto [data, sizeBytes, stride] = buffer;
    if (data == nullptr) {
        throw Error(ErrorKind::InvalidInput, text("The buffer ", what, " of the view has no data."));
    }
    if (stride < rowBytes) {
        throw Error(ErrorKind::InvalidInput, text("The rows of the buffer ", what, " are ", stride,
                                                  " bytes apart, and one needs ", rowBytes, "."));
    }
    const auto gaps = static_cast<std::uint64_t>(height - 1);
    if (sizeBytes < rowBytes || sizeBytes > PTRDIFF_MAX ||
        (gaps > 0 && stride > (sizeBytes - rowBytes) / gaps)) {
        throw Error(ErrorKind::InvalidInput,
                    text("The buffer ", what, " of ", sizeBytes, " bytes cannot hold ", height, " rows of ",
                         rowBytes, " bytes that are ", stride, " bytes apart."));
    }
}

template <class Value, int kChannels>
void copyRows(const Image<Value, kChannels>& from, const spherewalk_buffer& into) {
    for (int y = 0; y < from.height(); ++y) {
        std::memcpy(static_cast<char*>(into.data) + static_cast<std::uint64_t>(y) * into.row_stride_bytes,
                    from.at(0, y), from.row(y).size_bytes());
    }
}

spherewalk_report cReport(const ViewReport& source) {
    auto result = CStruct<spherewalk_report>::defaults();
    result.photo = source.photo;
    result.scene = cScene(source.scene);
    result.sampling = cSampling(source.sampling);
    result.origin = cOrigin(source.origin);
    result.is_late = source.isLate ? 1 : 0;
    result.is_verified = source.isVerified ? 1 : 0;
    result.is_whole_decode = source.isWholeDecode ? 1 : 0;
    result.offset_m = source.offsetM;
    result.parallax_px = source.parallaxPx;
    result.blur_px = source.blurPx;
    result.trust = source.trust;
    result.decode_ms = source.decodeMs;
    result.render_ms = source.renderMs;
    result.decoded_tiles = source.decodedTiles;
    return result;
}

} // namespace

ViewOptions viewOptions(const spherewalk_view_options* options) {
    const auto source = takenOrDefaults(options);
    if (source.threads < 0 || source.threads > kMostThreads) {
        throw Error(ErrorKind::InvalidInput, text("A view cannot be made by ", source.threads,
                                                  " threads; give 0 for all, or up to ", kMostThreads, "."));
    }
    if (!std::isfinite(source.tolerance_db)) {
        throw Error(ErrorKind::InvalidInput, "The tolerance_db of a view is not a number.");
    }
    ViewOptions result;
    result.scene = sceneOf(source.scene);
    result.threads = source.threads;
    result.sampling = samplingOf(source.sampling);
    result.toleranceDb = source.tolerance_db;
    result.exact = source.is_exact != 0;
    return result;
}

ViewTarget::ViewTarget(const spherewalk_view* view, spherewalk_report* report, PictureSize size)
    : m_view(taken(view)), m_report(report), m_size(size) {
    if (report != nullptr) {
        checkedSize(report);
    }
    checkBuffer(m_view.rgb, std::uint64_t{RgbImage::kChannels} * static_cast<std::uint64_t>(size.width),
                size.height, "rgb");
}

void ViewTarget::fill(const View& view) const {
    copyRows(view.picture, m_view.rgb);
    if (m_report != nullptr) {
        give(cReport(view.report), m_report);
    }
}

} // namespace spherewalk::render

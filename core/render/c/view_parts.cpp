// SPDX-License-Identifier: Apache-2.0
#include "c/enums.h"
#include "c/handles.h"
#include "c/interface.h"

#include "spherewalk/base/image.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace spherewalk::render {

namespace {

constexpr int kMostThreads = 4096;
constexpr std::uint64_t kMostOverlays = 1000;

/// Checks memory of the caller for so many rows of so many bytes. what: the memory's name for sentences.
/// Errors: InvalidInput for memory that is too small or NULL. Range: height > 0.
void checkRows(const spherewalk_source& source, std::uint64_t rowBytes, int height, std::string_view what) {
    const auto [data, sizeBytes, stride] = source;
    if (data == nullptr) {
        throw Error(ErrorKind::InvalidInput,
                    text("The memory for ", what, " is NULL, which it must not be."));
    }
    if (stride < rowBytes) {
        throw Error(ErrorKind::InvalidInput, text("The rows of ", what, " are ", stride,
                                                  " bytes apart, and one of them has ", rowBytes, "."));
    }
    const auto steps = static_cast<std::uint64_t>(height - 1);
    const bool fits =
        sizeBytes >= rowBytes && sizeBytes <= PTRDIFF_MAX &&
        (steps == 0 || stride <= (sizeBytes - rowBytes) / steps); // a product may need more bits
    if (!fits) {
        throw Error(ErrorKind::InvalidInput,
                    text("The memory for ", what, ", ", sizeBytes, " bytes, cannot hold ", height,
                         " rows of ", rowBytes, " bytes that are ", stride, " bytes apart."));
    }
}

/// what: "view", for sentences.
void checkThreads(std::int32_t threads, const char* what) {
    if (threads < 0 || threads > kMostThreads) {
        throw Error(ErrorKind::InvalidInput, text("A ", what, " cannot be made by ", threads,
                                                  " threads; give 0 for all, or up to ", kMostThreads, "."));
    }
}

spherewalk_source asSource(const spherewalk_buffer& buffer) {
    return {buffer.data, buffer.size_bytes, buffer.row_stride_bytes};
}

template <class Picture>
constexpr std::uint64_t rowBytes(int width) {
    using Value = typename decltype(Picture().values())::value_type;
    return sizeof(Value) * std::uint64_t{Picture::kChannels} * static_cast<std::uint64_t>(width);
}

/// Copies the picture to memory that checkRows() found fit for it.
template <class Picture>
void copyRows(const Picture& from, const spherewalk_buffer& into) {
    for (int y = 0; y < from.height(); ++y) {
        std::memcpy(static_cast<char*>(into.data) + static_cast<std::uint64_t>(y) * into.row_stride_bytes,
                    from.at(0, y), from.row(y).size_bytes());
    }
}

/// Copies a picture of this size, whose memory is used again if it has it. Errors: as checkRows().
template <class Picture>
void copyRows(const spherewalk_source& from, int width, int height, std::string_view what, Picture& into) {
    checkRows(from, rowBytes<Picture>(width), height, what);
    if (into.width() != width || into.height() != height) {
        into = Picture(width, height);
    }
    for (int y = 0; y < height; ++y) {
        std::memcpy(into.at(0, y),
                    static_cast<const char*>(from.data) +
                        static_cast<std::uint64_t>(y) * from.row_stride_bytes,
                    into.row(y).size_bytes());
    }
}

// The flags of pixels are handed over as they are.
static_assert(SPHEREWALK_PIXEL_UNSEEN == static_cast<int>(PixelFlag::Unseen));
static_assert(SPHEREWALK_PIXEL_POLE == static_cast<int>(PixelFlag::Pole));
static_assert(SPHEREWALK_PIXEL_STITCHING == static_cast<int>(PixelFlag::Stitching));
static_assert(SPHEREWALK_PIXEL_SEAM == static_cast<int>(PixelFlag::Seam));
static_assert(SPHEREWALK_PIXEL_COARSE == static_cast<int>(PixelFlag::Coarse));
static_assert(SPHEREWALK_PIXEL_OVERLAY == static_cast<int>(PixelFlag::Overlay));
static_assert(SPHEREWALK_PIXEL_FILLED == static_cast<int>(PixelFlag::Filled));
static_assert(SPHEREWALK_PIXEL_UNSURE == static_cast<int>(PixelFlag::Unsure));

void take(const spherewalk_overlay* overlay, const CameraIntrinsics& camera, Overlay& into) {
    const spherewalk_overlay source = taken(overlay);
    checkReserved(source.reserved);
    into.alpha = alphaOf(source.alpha);
    into.camera = source.camera == nullptr ? camera : intrinsicsOf(source.camera);
    into.camera.validate();
    const auto [width, height] = std::pair(into.camera.width, into.camera.height);
    copyRows(source.rgba, width, height, "the rgba of an overlay", into.picture);
    copyRows(source.depth, width, height, "the depth of an overlay", into.depth);
    const auto copyIfGiven = [&size = into.camera](const spherewalk_source& from, const char* what,
                                                   Image<float, 1>& to) {
        if (from.data == nullptr) {
            to = {};
        } else {
            copyRows(from, size.width, size.height, what, to);
        }
    };
    copyIfGiven(source.room_depth, "the room_depth of an overlay", into.roomDepth);
    copyIfGiven(source.shadow, "the shadow of an overlay", into.shadow);
}

void takeOverlays(const spherewalk_view_options& options, const CameraIntrinsics& camera,
                  std::vector<Overlay>& into) {
    if (options.overlay_count > kMostOverlays) {
        throw Error(ErrorKind::InvalidInput, text("A view cannot have ", options.overlay_count,
                                                  " overlays; give it up to ", kMostOverlays, "."));
    }
    if (options.overlay_count > 0) {
        checkGiven(options.overlays, "overlays");
    }
    into.resize(static_cast<std::size_t>(options.overlay_count));
    for (std::size_t i = 0; i < into.size(); ++i) {
        take(options.overlays[i], camera, into[i]);
    }
}

/// Fills the buffer, if there is one, with the picture, or with one value if there is no picture.
template <class Picture, class Value>
void fillBuffer(const spherewalk_buffer& buffer, const Picture& picture, int width, int height,
                Value otherwise) {
    if (buffer.data == nullptr) {
        return;
    }
    if (!picture.empty()) {
        copyRows(picture, buffer);
        return;
    }
    Picture row(width, 1);
    std::fill(row.values().begin(), row.values().end(), otherwise);
    for (int y = 0; y < height; ++y) {
        std::memcpy(static_cast<char*>(buffer.data) + static_cast<std::uint64_t>(y) * buffer.row_stride_bytes,
                    row.at(0, 0), row.row(0).size_bytes());
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
    result.is_outside = source.isOutside ? 1 : 0;
    result.sees_place = source.seesPlace ? 1 : 0;
    result.seen_share = source.seenShare;
    result.filled_share = source.filledShare;
    return result;
}

} // namespace

ViewOptions viewOptions(const spherewalk_view_options* options, const CameraIntrinsics& camera,
                        std::vector<Overlay>& overlays) {
    const auto source = takenOrDefaults(options);
    if (source.photo_colours != 0 && source.photo_colours != 1) {
        throw Error(ErrorKind::InvalidInput, "The photo_colours of a view must be 0 or 1.");
    }
    checkThreads(source.threads, "view");
    if (!std::isfinite(source.tolerance_db)) {
        throw Error(ErrorKind::InvalidInput, "The tolerance_db of a view is not a number.");
    }
    ViewOptions result;
    result.scene = sceneOf(source.scene);
    result.threads = source.threads;
    result.sampling = samplingOf(source.sampling);
    result.toleranceDb = source.tolerance_db;
    result.exact = source.is_exact != 0;
    result.correctsColour = source.photo_colours == 0;
    result.compose = {source.overlay_tolerance_m, source.overlay_tolerance_share,
                      edgesOf(source.overlay_edges)};
    takeOverlays(source, camera, overlays);
    result.overlays = overlays;
    return result;
}

ViewTarget::ViewTarget(const spherewalk_view* view, spherewalk_report* report, const CameraIntrinsics& camera)
    : m_view(taken(view)), m_report(report), m_width(camera.width), m_height(camera.height) {
    if (report != nullptr) {
        checkedSize(report);
    }
    checkRows(asSource(m_view.rgb), rowBytes<RgbImage>(m_width), m_height, "the rgb of a view");
    const auto check = [&](const spherewalk_buffer& buffer, std::uint64_t bytes, const char* what) {
        if (buffer.data != nullptr) {
            checkRows(asSource(buffer), bytes, m_height, what);
        }
    };
    check(m_view.depth, rowBytes<DepthImage>(m_width), "the depth of a view");
    check(m_view.error_px, rowBytes<DepthImage>(m_width), "the error_px of a view");
    check(m_view.flags, rowBytes<MaskImage>(m_width), "the flags of a view");
    check(m_view.overlaid, rowBytes<MaskImage>(m_width), "the overlaid of a view");
}

void ViewTarget::want(ViewOptions& options) const {
    options.wantsDepth = m_view.depth.data != nullptr;
    options.wantsTrust = m_view.error_px.data != nullptr || m_view.flags.data != nullptr;
}

void ViewTarget::fill(const View& view) const {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    copyRows(view.picture, m_view.rgb);
    fillBuffer(m_view.depth, view.depth, m_width, m_height, kInfinity);
    fillBuffer(m_view.error_px, view.trust.errorPx, m_width, m_height, kInfinity);
    fillBuffer(m_view.flags, view.trust.flags, m_width, m_height, std::uint8_t{0});
    fillBuffer(m_view.overlaid, view.overlaid, m_width, m_height, std::uint8_t{0});
    if (m_report != nullptr) {
        give(cReport(view.report), m_report);
    }
}

ProbeOptions probeOptions(const spherewalk_probe_options* options) {
    const auto source = takenOrDefaults(options);
    if (source.photo_colours != 0 && source.photo_colours != 1) {
        throw Error(ErrorKind::InvalidInput, "The photo_colours of a probe must be 0 or 1.");
    }
    checkThreads(source.threads, "probe");
    const ProbeOptions result{source.width, sceneOf(source.scene), source.threads, source.photo_colours == 0};
    result.validate();
    return result;
}

ProbeTarget::ProbeTarget(const spherewalk_probe* probe, spherewalk_light* light, int width)
    : m_probe(takenOrDefaults(probe)), m_light(light) {
    if (light != nullptr) {
        checkedSize(light);
    }
    if (m_probe.radiance.data != nullptr) {
        checkRows(asSource(m_probe.radiance), rowBytes<RadianceImage>(width), width / 2,
                  "the radiance of a probe");
    }
    if (m_probe.clipped.data != nullptr) {
        checkRows(asSource(m_probe.clipped), rowBytes<MaskImage>(width), width / 2, "the clipped of a probe");
    }
}

void ProbeTarget::fill(const LightProbe& probe) const {
    if (m_probe.radiance.data != nullptr) {
        copyRows(probe.radiance, m_probe.radiance);
    }
    if (m_probe.clipped.data != nullptr) {
        copyRows(probe.clipped, m_probe.clipped);
    }
    if (m_light == nullptr) {
        return;
    }
    auto light = CStruct<spherewalk_light>::defaults();
    light.photo = probe.report.photo;
    light.is_outside = probe.report.isOutside ? 1 : 0;
    light.sees_place = probe.report.seesPlace ? 1 : 0;
    light.clipped_share = probe.clippedShare;
    light.recovered_share = probe.recoveredShare;
    const LightHarmonics harmonics = lightHarmonics(probe.radiance);
    const DominantLight dominant = dominantLight(harmonics);
    std::copy_n(dominant.towards.data(), 3, light.towards);
    std::copy_n(dominant.irradiance.data(), 3, light.irradiance);
    std::copy_n(dominant.ambient.data(), 3, light.ambient);
    light.share = dominant.share;
    for (std::size_t i = 0; i < harmonics.coefficients.size(); ++i) {
        std::copy_n(harmonics.coefficients[i].data(), 3, light.harmonics[i]);
    }
    give(light, m_light);
}

} // namespace spherewalk::render

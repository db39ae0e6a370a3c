// SPDX-License-Identifier: Apache-2.0
#include "c/enums.h"

#include "spherewalk/base/text.h"

#include <array>
#include <utility>

namespace spherewalk::render {

namespace {

template <class Enum, std::size_t kCount>
using Numbers = std::array<std::pair<std::int32_t, Enum>, kCount>;

constexpr Numbers<ErrorKind, 12> kStatusNumbers{{{SPHEREWALK_INVALID_INPUT, ErrorKind::InvalidInput},
                                                 {SPHEREWALK_NOT_FOUND, ErrorKind::NotFound},
                                                 {SPHEREWALK_EXISTS, ErrorKind::Exists},
                                                 {SPHEREWALK_IO, ErrorKind::Io},
                                                 {SPHEREWALK_NETWORK, ErrorKind::Network},
                                                 {SPHEREWALK_TIMEOUT, ErrorKind::Timeout},
                                                 {SPHEREWALK_STOPPED, ErrorKind::Stopped},
                                                 {SPHEREWALK_CORRUPT, ErrorKind::Corrupt},
                                                 {SPHEREWALK_UNSUPPORTED, ErrorKind::Unsupported},
                                                 {SPHEREWALK_BUSY, ErrorKind::Busy},
                                                 {SPHEREWALK_FULL, ErrorKind::Full},
                                                 {SPHEREWALK_INTERNAL, ErrorKind::Internal}}};

constexpr Numbers<Verify, 2> kVerifyNumbers{
    {{SPHEREWALK_VERIFY_SIZES, Verify::Sizes}, {SPHEREWALK_VERIFY_HASHES, Verify::Hashes}}};

constexpr Numbers<VerifyPhotos, 2> kVerifyPhotosNumbers{
    {{SPHEREWALK_VERIFY_PHOTOS_BEFORE_USE, VerifyPhotos::BeforeUse},
     {SPHEREWALK_VERIFY_PHOTOS_IN_BACKGROUND, VerifyPhotos::InBackground}}};

constexpr Numbers<LensModel, 4> kLensNumbers{
    {{SPHEREWALK_LENS_PINHOLE, LensModel::Pinhole},
     {SPHEREWALK_LENS_PLUMB_BOB, LensModel::PlumbBob},
     {SPHEREWALK_LENS_RATIONAL_POLYNOMIAL, LensModel::RationalPolynomial},
     {SPHEREWALK_LENS_EQUIDISTANT, LensModel::Equidistant}}};

constexpr Numbers<SceneKind, 5> kSceneNumbers{{{SPHEREWALK_SCENE_NONE, SceneKind::None},
                                               {SPHEREWALK_SCENE_SPHERE, SceneKind::Sphere},
                                               {SPHEREWALK_SCENE_ROOM, SceneKind::Room},
                                               {SPHEREWALK_SCENE_DEPTH, SceneKind::Depth},
                                               {SPHEREWALK_SCENE_BLEND, SceneKind::Blend}}};

constexpr Numbers<Sampling, 7> kSamplingNumbers{{{SPHEREWALK_SAMPLING_NEAREST, Sampling::Nearest},
                                                 {SPHEREWALK_SAMPLING_BILINEAR, Sampling::Bilinear},
                                                 {SPHEREWALK_SAMPLING_REDUCED, Sampling::Reduced},
                                                 {SPHEREWALK_SAMPLING_FOOTPRINT, Sampling::Footprint},
                                                 {SPHEREWALK_SAMPLING_BICUBIC, Sampling::Bicubic},
                                                 {SPHEREWALK_SAMPLING_AUTO, Sampling::Auto},
                                                 {SPHEREWALK_SAMPLING_BEST, Sampling::Best}}};

constexpr Numbers<ViewOrigin, 3> kOriginNumbers{{{SPHEREWALK_ORIGIN_PHOTO, ViewOrigin::Photo},
                                                 {SPHEREWALK_ORIGIN_THUMBNAIL, ViewOrigin::Thumbnail},
                                                 {SPHEREWALK_ORIGIN_PREVIOUS, ViewOrigin::PreviousPhoto}}};

constexpr Numbers<Alpha, 2> kAlphaNumbers{
    {{SPHEREWALK_ALPHA_STRAIGHT, Alpha::Straight}, {SPHEREWALK_ALPHA_PREMULTIPLIED, Alpha::Premultiplied}}};

constexpr Numbers<Edges, 2> kEdgeNumbers{
    {{SPHEREWALK_EDGES_SOFT, Edges::Soft}, {SPHEREWALK_EDGES_HARD, Edges::Hard}}};

constexpr Numbers<LatePolicy, 3> kPolicyNumbers{{{SPHEREWALK_LATE_WAIT, LatePolicy::Wait},
                                                 {SPHEREWALK_LATE_COARSE, LatePolicy::Coarse},
                                                 {SPHEREWALK_LATE_PREVIOUS, LatePolicy::Previous}}};

template <class Enum, std::size_t kCount>
Enum valueNumbered(const Numbers<Enum, kCount>& numbers, const char* what, std::int32_t number) {
    for (const auto& [known, value] : numbers) {
        if (known == number) {
            return value;
        }
    }
    throw Error(ErrorKind::InvalidInput, text("There is no ", what, " with the number ", number,
                                              "; use the constants of spherewalk.h."));
}

template <class Enum, std::size_t kCount>
std::int32_t numberOf(const Numbers<Enum, kCount>& numbers, Enum value) {
    for (const auto& [number, known] : numbers) {
        if (known == value) {
            return number;
        }
    }
    throw Error(ErrorKind::Internal, "A value of the library has no number in its C interface.");
}

} // namespace

spherewalk_status cStatus(ErrorKind kind) {
    return numberOf(kStatusNumbers, kind);
}

std::optional<ErrorKind> errorKindOf(spherewalk_status status) {
    for (const auto& [number, kind] : kStatusNumbers) {
        if (number == status) {
            return kind;
        }
    }
    return std::nullopt;
}

Verify verifyOf(std::int32_t number) {
    return valueNumbered(kVerifyNumbers, "check of a dataset", number);
}

VerifyPhotos verifyPhotosOf(std::int32_t number) {
    return valueNumbered(kVerifyPhotosNumbers, "check of photos", number);
}

LensModel lensOf(std::int32_t number) {
    return valueNumbered(kLensNumbers, "lens model", number);
}

std::int32_t cLens(LensModel lens) {
    return numberOf(kLensNumbers, lens);
}

std::optional<SceneKind> sceneOf(std::int32_t number) {
    if (number == SPHEREWALK_SCENE_BEST) {
        return std::nullopt;
    }
    return valueNumbered(kSceneNumbers, "scene model", number);
}

std::int32_t cScene(SceneKind scene) {
    return numberOf(kSceneNumbers, scene);
}

Sampling samplingOf(std::int32_t number) {
    return number == SPHEREWALK_SAMPLING_DEFAULT ? ViewOptions{}.sampling
                                                 : valueNumbered(kSamplingNumbers, "sampling", number);
}

std::int32_t cSampling(Sampling sampling) {
    return numberOf(kSamplingNumbers, sampling);
}

ViewOrigin originOf(std::int32_t number) {
    return valueNumbered(kOriginNumbers, "origin of a view", number);
}

std::int32_t cOrigin(ViewOrigin origin) {
    return numberOf(kOriginNumbers, origin);
}

Alpha alphaOf(std::int32_t number) {
    return valueNumbered(kAlphaNumbers, "kind of alpha", number);
}

Edges edgesOf(std::int32_t number) {
    return valueNumbered(kEdgeNumbers, "kind of edges", number);
}

LatePolicy lateOf(std::int32_t number) {
    return valueNumbered(kPolicyNumbers, "policy for late views", number);
}

std::int32_t cLate(LatePolicy policy) {
    return numberOf(kPolicyNumbers, policy);
}

} // namespace spherewalk::render
